// Names beside the marks of a chart.
#pragma once

#include <vector>

#include "report/chart.hpp"

namespace ecods::bench {

// Where a name stands: from its mark, in gnuplot's characters and lines, and which of its ends is there.
struct NamePlace {
    double across = 0;
    double up = 0;
    const char* alignment = "center";
};

// One place for each curve of a panel that has names and explicit ranges, so that no name covers a mark or another
// name: the first free one of right, left, above, below, and the same farther away. Above, where none is free.
std::vector<NamePlace> place_names(const Panel& panel, double width, double height);

}  // namespace ecods::bench
