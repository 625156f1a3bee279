// Time per frame as a curve for each engine.
#pragma once

#include <span>
#include <string>

#include "harness/scene_runs.hpp"
#include "report/chart.hpp"

namespace ecods::bench {

// Frame 0 is left out. Every twelfth of the frames has a mark with its time.
Chart time_chart(std::span<const SceneRun> runs, const std::string& name, const std::string& caption);

}  // namespace ecods::bench
