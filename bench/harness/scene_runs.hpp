// Runs engines on the frames of one scene, and times them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engines/scene_engine.hpp"

namespace ecods::bench {

// What one engine did on one scene.
struct SceneRun {
    std::string name;
    bool is_ecods = false;
    std::vector<double> frame_ms = {};              // [frame]: the median over the repetitions
    std::vector<std::vector<IndexPair>> hits = {};  // [frame], ascending
    std::size_t candidate_count = 0;                // summed over all frames
    std::optional<Statistics> statistics = {};      // of one repetition

    double mean_ms() const;  // over the frames after the first
};

// Frame 0 is the rest; the frames of the scene follow. In each repetition the engines run one after the other, each
// freshly set up, so that a change of the machine's pace meets all of them. Frame 0 includes what an engine builds when
// it is first asked, and is left out of mean_ms(). Throws std::logic_error when an engine repeats itself differently.
std::vector<SceneRun> measure_scene(const scenes::Scene& scene, const std::vector<SceneMaker>& engines,
                                    std::size_t repetition_count, const std::string& label);

}  // namespace ecods::bench
