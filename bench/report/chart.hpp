// A chart as data: what a suite hands over, what is saved, and what the page draws.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace ecods::bench {

struct ChartPoint {
    double x = 0;
    double y = 0;
    std::string text;  // shown over the mark; nothing when empty
};

struct Curve {
    std::string name;  // of an engine, mostly: it decides colour, mark and dashes (engine_style.hpp)
    std::vector<ChartPoint> points;
};

struct Axis {
    std::string title;
    bool is_logarithmic = false;                            // points at 0 or below are left out
    std::vector<std::pair<std::string, double>> tics = {};  // gnuplot's choice when empty
    double low = 0, high = 0;                               // the range of the data when equal
};

struct Panel {
    std::string title;
    Axis x, y;
    std::vector<Curve> curves;
    bool has_lines = false;  // between the points of a curve
    bool has_names = false;  // beside the first point of each curve; both axes have ranges
    bool is_folded = false;  // nothing to see unless one wants to: all engines are right
};

// Panels have one key.
struct Chart {
    std::string name;  // of files
    std::vector<Panel> panels;
    std::string caption;
    std::string fold = {};  // says what the folded panels are
};

}  // namespace ecods::bench
