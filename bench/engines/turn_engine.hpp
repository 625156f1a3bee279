// When does a mesh that turns rigidly first touch one at rest?
#pragma once

#include <algorithm>
#include <limits>

#include "engines/engine.hpp"
#include "scenes/turn_workloads.hpp"

namespace ecods::bench {

// Names what an engine is asked.
enum class TurnAnswer {
    time,      // of the first contact, as include/ecods/turn.hpp has it, or NaN if there is none
    share,     // the same as a share of the angle: of engines that turn at a constant speed
    straight,  // the time of another motion: the straight one to the same end, to compare the cost with
};

struct Turns {
    using Workload = scenes::TurnWorkload;
    using Answer = double;
    using Engine = QueryEngine<Turns>;
    struct Traits {
        TurnAnswer answer = TurnAnswer::time;
        // The most triangles of a mesh: of larger ones it is not asked, for the time.
        std::size_t triangle_max = std::numeric_limits<std::size_t>::max();
    };

    static bool is_asked(const Traits& traits, const Workload& workload) {
        return std::ranges::all_of(workload.meshes, [&](const scenes::NamedMesh& named) {
            return named.mesh->triangles().size() <= traits.triangle_max;
        });
    }
};

using TurnMaker = Maker<Turns>;

std::vector<TurnMaker> ecods_turns();
std::vector<TurnMaker> fcl_turns();

// All of the above. Ratios are taken to the straight cast of ECoDS and to FCL's conservative advancement.
std::vector<TurnMaker> turn_engines();
constexpr const char* turn_yardstick = "FCL advancement";
constexpr const char* own_straight_cast = "ECoDS, straight";

}  // namespace ecods::bench
