// Runs whole systems on one room, and checks their answers.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engines/scene_engine.hpp"
#include "harness/differences.hpp"

namespace ecods::bench {

struct SystemRun {
    std::string name;
    bool is_ecods = false;
    std::vector<double> ms = {};  // per frame, the mean over the frames after the first; one for each repetition
    double calls = 0;             // of the two-body test, per frame
    Errors errors = {};
    std::string failure = {};  // when it crashed, hung or threw
};

// The colliding pairs of each frame: the oracle's for the first `judged_count` frames, those of ECoDS for the others.
struct SystemTruth {
    std::vector<std::vector<IndexPair>> hits;
    std::size_t judged_count = 0;
    std::size_t wrong_count = 0;  // pairs on which ECoDS and the oracle differ
    double hits_per_frame() const;
};
SystemTruth find_hits(const scenes::Scene& scene, std::size_t judged_count, const std::string& label);

// Engines take turns, each in a process of its own, with a fresh scene in each turn. The first turn checks the
// answers, too.
std::vector<SystemRun> measure_systems(const scenes::Scene& scene, const SystemTruth& truth,
                                       const std::vector<SceneMaker>& makers, std::size_t repetition_count);

}  // namespace ecods::bench
