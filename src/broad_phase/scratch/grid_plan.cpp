#include "broad_phase/scratch/grid_plan.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace ecods {
namespace {

constexpr double largest = std::numeric_limits<double>::max() / 8;

// Describes the distribution of a sample of boxes on one axis.
struct AxisSample {
    double low = 0;  // nearly all centers are between low and high
    double high = 0;
    double extent = 0;  // average extent of a box; at most high - low

    double range() const noexcept { return high - low; }
};

double clamp_finite(double x) noexcept {
    return std::clamp(x, -largest, largest);
}

AxisSample look_at_axis(std::span<const PackedBox> sample, std::size_t axis) {
    std::vector<double> centers;
    centers.reserve(sample.size());
    for (const PackedBox& line : sample) {
        centers.push_back(0.5 * clamp_finite(double_of(line.ends[axis])) +
                          0.5 * clamp_finite(double_of(~line.ends[axis + 3])));
    }
    // Ignores a twentieth of the centers at each end: outliers would make the cells too wide for the other boxes.
    const std::size_t few = centers.size() / 20;
    const auto place = [&](std::size_t rank) { return centers.begin() + static_cast<std::ptrdiff_t>(rank); };
    std::nth_element(centers.begin(), place(few), centers.end());
    const double low = centers[few];
    std::nth_element(centers.begin(), place(centers.size() - 1 - few), centers.end());
    const double high = centers[centers.size() - 1 - few];
    const double beyond = few == 0 ? 0 : 0.08 * (high - low);
    AxisSample result{.low = low - beyond, .high = high + beyond};
    double sum = 0;
    for (const PackedBox& line : sample) {
        const double extent = clamp_finite(double_of(~line.ends[axis + 3])) - clamp_finite(double_of(line.ends[axis]));
        sum += std::min(extent, result.range()) / static_cast<double>(sample.size());
    }
    result.extent = sum;
    return result;
}

// Returns the estimated share of all boxes that overlap one box on this axis: a sweep along this axis tests the box
// against these boxes.
double passed(const AxisSample& axis) noexcept {
    return axis.range() > 0 ? std::min(1.0, axis.extent / axis.range()) : 1;
}

// Returns the estimated cost per box, in box tests, of a search among `count` boxes in cells_1 * cells_2 cells.
// `shares` has the shares of the boxes that overlap one box on the axis of the sweep and on the axes of the cells. A
// box is entered into each cell that it reaches, and is tested there against the boxes that overlap it on the axis of
// the sweep. Entering a box into a cell costs about as much as entry_cost tests, visiting a cell as much as cell_cost
// tests. The estimates affect nothing but the speed.
double cost(double count, const std::array<double, 3>& shares, double cells_1, double cells_2) noexcept {
    constexpr double entry_cost = 40, cell_cost = 80;
    const double entries = (1 + shares[1] * cells_1) * (1 + shares[2] * cells_2);
    const double cells = cells_1 * cells_2;
    const double tests = count * entries / cells * shares[0];
    return entries * (entry_cost + tests) + cells / count * cell_cost;
}

// Lists the numbers of cells per axis to try: powers of two, and the numbers half way between.
constexpr std::array<std::uint32_t, 16> cell_counts = {1,  2,  3,  4,  6,  8,   12,  16,
                                                       24, 32, 48, 64, 96, 128, 192, GridPlan::cells_max};

}  // namespace

void RankMap::set(std::size_t axis, double from, double to) noexcept {
    // The largest product, rounded up, must be less than rank_end: the factor 1 - 2^-40 leaves more than the error of
    // two roundings.
    constexpr double ranks = rank_end * (1 - 0x1p-40);
    const double per_unit = ranks / (to - from);
    low[axis] = from;
    // If the ends are too close together or too far apart, all coordinates get rank 0. With rounding downward, the
    // difference of equal numbers is -0, and the quotient negative.
    constexpr double number_max = std::numeric_limits<double>::max();
    if (!(per_unit > 0) || !(per_unit <= number_max) || !(to - from <= number_max)) return;
    width[axis] = to - from;
    ranks_per_unit[axis] = per_unit;
}

GridPlan plan_grid(std::span<const PackedBox> lines) {
    constexpr std::size_t sample_max = 1024;
    const std::size_t wanted = std::min(64 + lines.size() / 64, sample_max);
    const std::size_t stride = lines.size() / wanted + 1;
    std::vector<PackedBox> sample;
    sample.reserve(lines.size() / stride + 1);
    for (std::size_t i = 0; i < lines.size(); i += stride) {
        if (!lines[i].is_empty()) sample.push_back(lines[i]);
    }
    GridPlan plan;
    if (sample.empty()) return plan;
    std::array<AxisSample, 3> axes;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        axes[axis] = look_at_axis(sample, axis);
        plan.map.set(axis, axes[axis].low, axes[axis].high);
    }
    std::sort(plan.axes.begin(), plan.axes.end(), [&](std::size_t a, std::size_t b) {
        return passed(axes[a]) < passed(axes[b]) || (passed(axes[a]) == passed(axes[b]) && a < b);
    });
    const auto count = static_cast<double>(lines.size());
    const std::array<double, 3> shares = {passed(axes[plan.axes[0]]), passed(axes[plan.axes[1]]),
                                          passed(axes[plan.axes[2]])};
    double least = std::numeric_limits<double>::infinity();
    for (const std::uint32_t first : cell_counts) {
        for (const std::uint32_t second : cell_counts) {
            if (std::size_t{first} * second > lines.size()) break;
            const double tests = cost(count, shares, first, second);
            if (tests >= least) continue;
            least = tests;
            plan.cells = {first, second};
        }
    }
    return plan;
}

}  // namespace ecods
