// Speed against error: each engine a point, time across, up the share of wrong answers, or the error in units in the
// last place.
#pragma once

#include <string>
#include <vector>

#include "report/chart.hpp"

namespace ecods::bench {

struct ErrorPoint {
    std::string engine;
    double time = 0;   // positive
    double error = 0;  // a share from 0 to 1, or units in the last place
};

enum class ErrorScale { shares, ulps };

// Time is logarithmic, and so is the error; no error at all has a line of its own at the bottom. The panel is folded
// when no engine has an error.
Panel error_panel(const std::string& title, const std::string& time_unit, const std::vector<ErrorPoint>& points,
                  ErrorScale scale = ErrorScale::shares);

// A chart of such panels.
Chart error_chart(const std::string& name, std::vector<Panel> panels, const std::string& caption);

// "0.01 %", "37 %" of a share.
std::string percent_text(double share);

}  // namespace ecods::bench
