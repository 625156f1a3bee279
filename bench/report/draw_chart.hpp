// Charts drawn by gnuplot, as SVG that a page can contain.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/chart.hpp"

namespace ecods::bench {

struct Drawing {
    std::string marks;                // <defs> with what the panels use, the same for all charts
    std::vector<std::string> panels;  // <svg> each, in the order of the chart's panels
    std::string failure;              // why there are none, if there are none
};

// Colours are the variables of engine_style.hpp, so that the page decides on light or dark; texts of points are the
// titles of their marks, which browsers show. The scripts are left in the folder, which must exist.
Drawing draw_chart(const Chart& chart, const std::filesystem::path& folder);

// The names of all curves, in the order of their first appearance.
std::vector<std::string> names_of(const Chart& chart);

// A chart of one panel as a file that stands for itself, in light and dark. Throws std::runtime_error when it cannot be
// drawn or written.
void write_svg(const Chart& chart, const std::filesystem::path& file);

// The bytes of a file. Throws std::runtime_error when it cannot be read.
std::string read_all(const std::filesystem::path& file);

}  // namespace ecods::bench
