// What every engine of the broad phase offers: boxes are taken in once, then frames of moves are run one by one.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "ecods/broad_phase.hpp"
#include "scenes/moving_boxes.hpp"

namespace ecods::bench {

class BroadEngine {
  public:
    virtual ~BroadEngine() = default;

    // Applies the moves and leaves the complete list of pairs of which the closed boxes overlap. This is what is timed.
    virtual void run_frame(std::span<const scenes::BoxMove> moves) = 0;

    // Of the last frame: a < b, in any order.
    virtual std::span<const ProxyPair> pairs() const = 0;
};

struct BroadMaker {
    std::string name;
    std::string use;  // how it is used: for the page
    bool is_ecods = false;
    std::size_t count_max = std::numeric_limits<std::size_t>::max();  // of boxes, in runs of the usual length
    // With the boxes at rest. Not timed.
    std::function<std::unique_ptr<BroadEngine>(const scenes::MovingBoxes& boxes)> set_up;
    std::chrono::seconds limit{300};  // for a turn, by the clock on the wall: one that takes longer hangs
};

std::unique_ptr<BroadEngine> set_up_broad_ecods(BroadPhaseKind kind, const scenes::MovingBoxes& boxes);
std::unique_ptr<BroadEngine> set_up_broad_scratch(const scenes::MovingBoxes& boxes);
std::unique_ptr<BroadEngine> set_up_broad_scratch_unsorted(const scenes::MovingBoxes& boxes);
std::unique_ptr<BroadEngine> set_up_broad_fcl_tree(const scenes::MovingBoxes& boxes);
std::unique_ptr<BroadEngine> set_up_broad_fcl_tree_moved(const scenes::MovingBoxes& boxes);
std::unique_ptr<BroadEngine> set_up_broad_fcl_array(const scenes::MovingBoxes& boxes);
std::unique_ptr<BroadEngine> set_up_broad_fcl_sweep(const scenes::MovingBoxes& boxes);
std::unique_ptr<BroadEngine> set_up_broad_bullet_dbvt(const scenes::MovingBoxes& boxes);
std::unique_ptr<BroadEngine> set_up_broad_bullet_sweep(const scenes::MovingBoxes& boxes);
std::unique_ptr<BroadEngine> set_up_broad_ode(const scenes::MovingBoxes& boxes);
std::unique_ptr<BroadEngine> set_up_broad_embree(const scenes::MovingBoxes& boxes);
std::unique_ptr<BroadEngine> set_up_broad_cgal(const scenes::MovingBoxes& boxes);

// All of the above that this build has, ECoDS once for each kind: those of the main job, then the others. The one that
// ratios are taken to is FCL DynamicAABBTree.
std::vector<BroadMaker> broad_engines();
std::vector<BroadMaker> main_broad_engines();
std::vector<BroadMaker> more_broad_engines();
constexpr const char* broad_yardstick = "FCL DynamicAABBTree";
constexpr const char* broad_scratch = "ECoDS, from scratch";
constexpr const char* broad_scratch_unsorted = "ECoDS, from scratch, unsorted";
constexpr const char* broad_fcl_sweep = "FCL SaP (unsound)";

// The pairs of closed boxes that overlap, ascending, by CGAL's box intersection: for checking large scenes.
std::vector<ProxyPair> overlapping_pairs_by_cgal(std::span<const Aabb> boxes);

}  // namespace ecods::bench
