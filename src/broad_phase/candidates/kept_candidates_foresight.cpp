// Predicts how boxes move: if they move together, how far, and for how many updates margins can last.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "broad_phase/candidates/kept_candidates.hpp"

namespace ecods {
namespace {

struct Step {
    std::array<double, 3> down, up;  // steps of the lower and upper ends, by axis
    double extent;

    // Returns the largest step of an end relative to the common step, as a share of the extent; at most 1.
    double relative(const Vec3& common) const noexcept {
        double step = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double all = common[static_cast<Eigen::Index>(axis)];
            step = std::max({step, std::abs(down[axis] - all), std::abs(up[axis] - all)});
        }
        return step < extent ? step / extent : 1;
    }
};

Step step_of(const PackedBox& before, const Aabb& now) noexcept {
    Step step{.down = {}, .up = {}, .extent = (now.max - now.min).maxCoeff()};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<Eigen::Index>(axis);
        step.down[axis] = now.min[k] - double_of(before.ends[axis]);
        step.up[axis] = now.max[k] - double_of(~before.ends[axis + 3]);
    }
    return step;
}

// Returns a quantile of the values: about the given share of the values does not exceed it. There must be a value.
double quantile(std::vector<double> values, double share) {
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size()));
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

double relative_step(std::span<const Step> steps, const Vec3& common, double share) {
    std::vector<double> relative;
    for (const Step& step : steps) relative.push_back(step.relative(common));
    return quantile(std::move(relative), share);
}

// Returns the median step of the lower ends, by axis.
Vec3 common_step(std::span<const Step> steps) {
    constexpr double middle = 0.5;
    Vec3 common;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::vector<double> values;
        for (const Step& step : steps) values.push_back(std::isfinite(step.down[axis]) ? step.down[axis] : 0);
        common[static_cast<Eigen::Index>(axis)] = quantile(std::move(values), middle);
    }
    return common;
}

// Returns the number of updates that the widest margin of a fast box lasts. If margins were meant to last longer, fast
// boxes would escape before the others, and would be looked up one by one.
double lifetime_of_fast(std::span<const Step> steps, const Vec3& common) {
    constexpr double fast_share = 0.9;
    const double fast = relative_step(steps, common, fast_share);
    return fast > 0 ? Margins::widest / fast : std::numeric_limits<double>::infinity();
}

// Returns the share of boxes that get no margin, because they would leave any margin within a few steps.
double share_without_margins(std::span<const Step> steps, const Vec3& common) {
    const auto leaves = [&](const Step& step) { return Margins::steps_min * step.relative(common) > Margins::widest; };
    return static_cast<double>(std::ranges::count_if(steps, leaves)) / static_cast<double>(steps.size());
}

// Visits a sample of the indices less than `count`. Uses multiples of a large prime, so that regular patterns in the
// order of the boxes do not bias the sample.
template <class Visit>
void for_some_of(std::size_t count, const Visit& visit) {
    constexpr std::size_t sample_max = 128, prime = 2654435761;
    for (std::size_t i = 0; i < std::min(count, sample_max); ++i) visit(i * prime % count);
}

}  // namespace

// Makes a forecast from a sample of the boxes that moved. Also returns the common step, and the lifetime of fast boxes.
KeptCandidates::Foresight KeptCandidates::foresee(const ProxyTable& table, const ProxyChanges& changes) const {
    KeepingRule::Forecast forecast{.boxes = table.size(),
                                   .moved = changes.moved.size(),
                                   .came = changes.added.size(),
                                   .jumping = 0,
                                   .step = 0,
                                   .lifetime_max = Lookahead::guess(keeping_.pairs(), table.size())};
    Vec3 common = Vec3::Zero();
    if (changes.moved.empty()) return {forecast, common, forecast.lifetime_max};
    std::vector<Step> steps;
    for_some_of(changes.moved.size(), [&](std::size_t place) {
        const ProxyIndex proxy = changes.moved[place];
        steps.push_back(step_of(slots_.lines()[slots_.slot_of(proxy)], table.boxes()[proxy]));
    });
    double middle = relative_step(steps, common, 0.5);
    // Moves the frame along only if this removes most of the step of nearly all boxes, since a moving frame takes a
    // pass over all boxes in each update.
    if (changes.moved.size() + changes.added.size() == table.size()) {
        constexpr double nearly_all = 0.875, most = 0.25;
        const Vec3 of_all = common_step(steps);
        if (relative_step(steps, of_all, nearly_all) < most * middle) {
            common = of_all;
            middle = relative_step(steps, common, 0.5);
        }
    }
    forecast.step = middle;
    forecast.jumping = static_cast<double>(changes.moved.size()) * share_without_margins(steps, common);
    const double limit = lifetime_of_fast(steps, common);
    forecast.lifetime_max = std::min(forecast.lifetime_max, limit);
    return {forecast, common, limit};
}

// Returns lifetime_of_fast() of a sample of the boxes that escaped. Call only if many escaped at once.
double KeptCandidates::lifetime_of_escaped(const ProxyTable& table) const {
    std::vector<Step> steps;
    for_some_of(escaped_.size(), [&](std::size_t place) {
        const EscapedBox& escaped = escaped_[place];
        steps.push_back(step_of(escaped.before, table.boxes()[slots_.proxies()[escaped.slot]]));
    });
    return lifetime_of_fast(steps, margins_.frame().went());
}

}  // namespace ecods
