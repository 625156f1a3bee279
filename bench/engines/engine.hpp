// What every engine that is compared offers: a scene is set up once, then its frames are run one by one.
#pragma once

#include <compare>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ecods/broad_phase.hpp"
#include "ecods/mesh.hpp"
#include "ecods/statistics.hpp"
#include "scenes/scene.hpp"

namespace ecods::bench {

// Two bodies by their indices in the scene, a < b.
struct IndexPair {
    std::size_t a = 0;
    std::size_t b = 0;

    friend constexpr auto operator<=>(const IndexPair&, const IndexPair&) = default;
};

inline IndexPair ordered(std::size_t i, std::size_t j) {
    return i < j ? IndexPair{i, j} : IndexPair{j, i};
}

class Engine {
  public:
    virtual ~Engine() = default;

    // Applies the moves and finds all colliding pairs. This is what is timed.
    virtual void run_frame(std::span<const scenes::Move> moves) = 0;

    // Of the last frame. Not timed. Hits are ascending.
    virtual std::vector<IndexPair> hits() const = 0;
    virtual std::size_t candidate_count() const = 0;  // pairs given to the two-body test, or excused by a cache

    // What an ECoDS world counted since it was made.
    virtual std::optional<Statistics> statistics() const { return std::nullopt; }
};

// An engine of the comparison: its name, and how to set it up with the bodies of a scene at rest. Setting up is not
// timed.
struct EngineMaker {
    std::string name;
    bool is_ecods = false;  // its answers must be the oracle's
    std::function<std::unique_ptr<Engine>(const scenes::Scene& scene)> set_up;
};

std::unique_ptr<Engine> set_up_world(const scenes::Scene& scene, BroadPhaseKind kind);  // ecods::World
std::unique_ptr<Engine> set_up_ecods_all_pairs(const scenes::Scene& scene);  // ecods::intersects for every pair
std::unique_ptr<Engine> set_up_fcl_tree(const scenes::Scene& scene);         // DynamicAABBTree manager, OBBRSS meshes
std::unique_ptr<Engine> set_up_fcl_all_pairs(const scenes::Scene& scene);    // fcl::collide for every pair

// All of the above, the world once for each broad phase.
std::vector<EngineMaker> all_engines();

// Without those that ask about all pairs of ECoDS, which is too slow for many ships.
std::vector<EngineMaker> system_engines();
constexpr const char* scene_yardstick = "FCL, DynamicAABBTree";

}  // namespace ecods::bench
