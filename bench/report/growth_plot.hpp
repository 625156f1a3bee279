// How things grow: curves over the number of bodies, both axes logarithmic.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "report/page.hpp"

namespace ecods::bench {

struct GrowthCurve {
    std::string name;
    std::vector<double> x;
    std::vector<double> y;  // points at 0, which have no logarithm, are left out
};

struct GrowthPanel {
    std::string x_label;
    std::string y_label;
    std::vector<GrowthCurve> curves;
};

// Panels side by side, a key below each. Curves differ in marks and dashes, not in colour alone.
Picture plot_growth(std::span<const GrowthPanel> panels, const std::filesystem::path& folder, const std::string& name,
                    const std::string& caption);

}  // namespace ecods::bench
