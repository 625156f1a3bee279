#include "report/error_panel.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ecods::bench {

namespace {

// Height of a share: 0 for none, 1 for 0.1 %, 4 for 100 %. Smaller shares than 0.1 % of some hundred queries do not
// occur, but would be drawn between the two lowest lines.
double height(double share) {
    return share <= 0 ? 0 : std::max(0.5, std::log10(share) + 4);
}

// Of units in the last place: 0 for none, 1 for 1, 2 for 1000, and so on.
double height_of_ulps(double ulps) {
    return ulps <= 0 ? 0 : std::max(0.5, std::log10(ulps) / 3 + 1);
}

const Axis& share_axis() {
    static const Axis axis{.title = "wrong answers",
                           .tics = {{"none", 0}, {"0.1 %", 1}, {"1 %", 2}, {"10 %", 3}, {"100 %", 4}},
                           .low = -0.35,
                           .high = 4.15};
    return axis;
}

const Axis& ulp_axis() {
    static const Axis axis{
        .title = "median error, units in the last place",
        .tics = {{"none", 0}, {"1", 1}, {"10³", 2}, {"10⁶", 3}, {"10⁹", 4}, {"10¹²", 5}, {"10¹⁵", 6}},
        .low = -0.35,
        .high = 6.3};
    return axis;
}

}  // namespace

std::string percent_text(double share) {
    return share == 0 ? "none" : fmt::format("{:.3g} %", 100 * share);
}

Panel error_panel(const std::string& title, const std::string& time_unit, const std::vector<ErrorPoint>& points,
                  ErrorScale scale) {
    const bool is_shares = scale == ErrorScale::shares;
    Panel panel{.title = title,
                .x = {.title = "time, " + time_unit, .is_logarithmic = true},
                .y = is_shares ? share_axis() : ulp_axis(),
                .curves = {},
                .is_folded = std::ranges::all_of(points, [](const ErrorPoint& point) { return point.error <= 0; })};
    for (const ErrorPoint& point : points) {
        const std::string error = is_shares ? percent_text(point.error) + " wrong"
                                            : fmt::format("median error {:.3g} units in the last place", point.error);
        panel.curves.push_back({point.engine,
                                {{point.time, is_shares ? height(point.error) : height_of_ulps(point.error),
                                  fmt::format("{}: {:.3g} {}, {}", point.engine, point.time, time_unit, error)}}});
    }
    return panel;
}

Chart error_chart(const std::string& name, std::vector<Panel> panels, const std::string& caption) {
    return {name, std::move(panels), caption, "where every engine is right"};
}

}  // namespace ecods::bench
