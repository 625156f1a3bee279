// When does a mesh on its way first touch another one?
#pragma once

#include <algorithm>
#include <limits>

#include "engines/engine.hpp"
#include "scenes/cast_workloads.hpp"

namespace ecods::bench {

// What the engine is asked.
enum class CastAnswer {
    time,      // of the first contact, or NaN if there is none
    distance,  // no cast: the distance at the end of the motion, to compare the cost with
};

struct Casts {
    using Workload = scenes::CastWorkload;
    using Answer = double;
    using Engine = QueryEngine<Casts>;
    struct Traits {
        CastAnswer answer = CastAnswer::time;
        bool is_for_hulls = false;  // moves convex hulls only, by translations
        // The most triangles of a mesh: of larger ones it is not asked, for the time.
        std::size_t triangle_max = std::numeric_limits<std::size_t>::max();
    };

    static bool is_asked(const Traits& traits, const Workload& workload) {
        return (!traits.is_for_hulls || (workload.is_hull && workload.is_translation)) &&
               std::ranges::all_of(workload.meshes, [&](const scenes::NamedMesh& named) {
                   return named.mesh->triangles().size() <= traits.triangle_max;
               });
    }
};

using CastMaker = Maker<Casts>;

std::vector<CastMaker> ecods_casts();
std::vector<CastMaker> fcl_casts();
std::vector<CastMaker> bullet_casts();

// All of the above. Ratios are taken to FCL's conservative advancement.
std::vector<CastMaker> cast_engines();
constexpr const char* cast_yardstick = "FCL advancement";
constexpr const char* own_end_distance = "ECoDS distance";

}  // namespace ecods::bench
