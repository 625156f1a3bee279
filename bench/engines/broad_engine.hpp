// Which boxes overlap, while they move?
#pragma once

#include <chrono>
#include <limits>

#include "ecods/broad_phase.hpp"
#include "engines/engine.hpp"
#include "engines/frame_engine.hpp"
#include "scenes/moving_boxes.hpp"

namespace ecods::bench {

// The boxes at rest are taken in untimed. A frame leaves the complete list of pairs whose closed boxes overlap, a < b.
struct Boxes {
    using Workload = scenes::MovingBoxes;
    using Engine = FrameEngine<scenes::BoxMove, ProxyPair>;
    struct Traits {
        std::size_t count_max = std::numeric_limits<std::size_t>::max();  // of boxes, in runs of the usual length
        std::chrono::seconds limit{300};  // for a turn, by the clock on the wall: one that takes longer hangs
    };
};

using BroadEngine = Boxes::Engine;
using BroadMaker = Maker<Boxes>;

std::vector<BroadMaker> ecods_broad();    // once for each kind
std::vector<BroadMaker> scratch_broad();  // ECoDS's search from scratch
std::vector<BroadMaker> fcl_broad();      // its tree, the one that ratios are taken to
std::vector<BroadMaker> bullet_broad();   // Dbvt
std::vector<BroadMaker> more_fcl_broad();
std::vector<BroadMaker> more_bullet_broad();
std::vector<BroadMaker> ode_broad();
std::vector<BroadMaker> embree_broad();
std::vector<BroadMaker> cgal_broad();

// All of the above that this build has: those of the main job, then the others.
std::vector<BroadMaker> broad_engines();
std::vector<BroadMaker> main_broad_engines();
constexpr const char* broad_yardstick = "FCL DynamicAABBTree";
constexpr const char* broad_scratch = "ECoDS, from scratch";
constexpr const char* broad_scratch_unsorted = "ECoDS, from scratch, unsorted";
constexpr const char* broad_fcl_sweep = "FCL SaP (unsound)";

// The pairs of closed boxes that overlap, ascending, by CGAL's box intersection: for checking large scenes.
std::vector<ProxyPair> overlapping_pairs_by_cgal(std::span<const Aabb> boxes);

}  // namespace ecods::bench
