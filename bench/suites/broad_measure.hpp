// Runs the engines of the broad phase on one workload, and compares their pairs with the exact ones.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engines/broad_engine.hpp"
#include "harness/differences.hpp"

namespace ecods::bench {

struct BroadRun {
    const BroadMaker* maker = nullptr;
    std::vector<double> ns = {};        // per box and frame, the mean over the frames; one for each repetition
    std::vector<double> frame_ns = {};  // per box, by frame: the least of the repetitions
    std::size_t frame_count = 0;        // of each repetition
    Errors errors = {};                 // of pairs, over the frames that are checked
    std::string failure = {};           // when it crashed, hung or threw
};

// The exact pairs of some frames: of the first, the middle and the last. Up to 10,000 boxes by comparing all of them,
// above that by CGAL.
struct BroadTruth {
    std::vector<std::pair<std::size_t, std::vector<ProxyPair>>> frames;  // ascending; pairs ascending
    double pair_count = 0;                                               // the mean over these frames
};
BroadTruth find_pairs(const scenes::MovingBoxes& boxes);

struct BroadEffort {
    std::size_t repetition_count = 1;
    double turn_seconds = 2;  // of processor time
};

// Engines take turns, each in a process of its own. A turn sets the engine up with the boxes at rest, runs a frame in
// which nothing moves, and times all the others: what an engine has to do once, when boxes begin to move, is part of
// its time. The first turn compares the pairs, too. An engine that needs longer for its first turn than it may runs
// fewer frames, but three, and has one turn only; its pairs are compared in the last frame that it runs, too. The
// yardstick may take three times as long, and has all its turns, over the frames of its first.
std::vector<BroadRun> measure_broad(const scenes::MovingBoxes& boxes, const BroadTruth& truth,
                                    const std::vector<BroadMaker>& makers, const BroadEffort& effort);

}  // namespace ecods::bench
