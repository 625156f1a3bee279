// Time per frame as a curve for each engine, drawn by gnuplot.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "harness/measure.hpp"
#include "report/page.hpp"

namespace ecods::bench {

// Writes NAME.svg, and NAME.gnuplot and NAME.txt that it was made from, into the folder. Curves differ in dashes and
// marks, not in colour alone. Frame 0 is left out.
Picture plot_times(std::span<const Run> runs, const std::filesystem::path& folder, const std::string& name,
                   const std::string& caption);

}  // namespace ecods::bench
