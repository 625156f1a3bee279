// Speed against error: each engine a point, time across, up the share of wrong answers, or the error in units in the
// last place.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "report/page.hpp"

namespace ecods::bench {

struct ErrorPoint {
    std::size_t engine_index = 0;
    double time = 0;   // positive
    double error = 0;  // a share from 0 to 1, or units in the last place
};

struct ErrorPanel {
    std::string title;
    std::vector<ErrorPoint> points;
};

// Panels in rows of three, one key for all. Time is logarithmic. Up goes the logarithm of the share, and no errors at
// all have a line of their own at the bottom, apart from the smallest share. Engines differ in marks, not in colour
// alone.
Picture plot_errors(std::span<const ErrorPanel> panels, std::span<const std::string> engines,
                    const std::string& time_label, const std::filesystem::path& folder, const std::string& name,
                    const std::string& caption);

// The same for errors in units in the last place; no error at all has a line of its own at the bottom, too.
Picture plot_ulps(std::span<const ErrorPanel> panels, std::span<const std::string> engines,
                  const std::string& time_label, const std::filesystem::path& folder, const std::string& name,
                  const std::string& caption);

}  // namespace ecods::bench
