// Updates that search for everything, and compare what they find with the pairs there were: nothing that is kept is
// asked for.
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "broad_phase/candidates/kept_candidates.hpp"
#include "broad_phase/scratch/list_pairs.hpp"

namespace ecods {
namespace {

struct Step {
    std::array<double, 3> down, up;  // of the lower and of the upper end
    double extent;

    // As a share of the extent, beside what all do; at most 1.
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
        step.up[axis] = now.max[k] - double_of(~before.ends[axis + 4]);
    }
    return step;
}

// The value that a share of them does not exceed.
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

// By axis, what the middle one of them does.
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

}  // namespace

// From a sample of the boxes that moved.
KeptCandidates::Foresight KeptCandidates::foresee(const ProxyTable& table, const ProxyChanges& changes) const {
    constexpr std::size_t sample_max = 128;
    constexpr double margin_max = 0.5;
    KeepingRule::Forecast forecast{.boxes = table.size(),
                                   .moved = changes.moved.size(),
                                   .looked_up = changes.added.size(),
                                   .lifetime = margins_.lookahead().updates(),
                                   .growth = 1};
    Vec3 common = Vec3::Zero();
    if (changes.moved.empty()) return {forecast, common};
    std::vector<Step> steps;
    const std::size_t count = std::min(changes.moved.size(), sample_max);
    for (std::size_t i = 0; i < count; ++i) {
        // By multiples of a large prime, lest all have something in common.
        const ProxyIndex proxy = changes.moved[i * std::size_t{2654435761} % changes.moved.size()];
        steps.push_back(step_of(slots_.lines()[slots_.slot_of(proxy)], table.boxes()[proxy]));
    }
    double middle = relative_step(steps, common, 0.5);
    // A frame that goes along takes a pass over all boxes in each update, and must spare nearly all most of what they
    // do.
    if (changes.moved.size() + changes.added.size() == table.size()) {
        constexpr double nearly_all = 0.875, most = 0.25;
        const Vec3 of_all = common_step(steps);
        if (relative_step(steps, of_all, nearly_all) < most * middle) {
            common = of_all;
            middle = relative_step(steps, common, 0.5);
        }
    }
    if (middle > 0) forecast.lifetime = std::min(margins_.lookahead().updates(), margin_max / middle);
    // Boxes grow ahead, and by a part of that behind; each of a pair does. Measured: 1.5 times the margin on each axis.
    const double growth = 1 + 1.5 * forecast.lifetime * middle;
    forecast.growth = growth * growth * growth;
    return {forecast, common};
}

// An update that keeps nothing but boxes, and decides whether they have margins from now on.
void KeptCandidates::replace_everything(const FindingUpdate& finding) {
    const auto& [table, changes, keeper, events, counts] = finding;
    const auto [forecast, common_step] = foresee(table, changes);
    const bool had_margins = std::exchange(has_margins_, keeping_.pays(forecast));
    for (const ProxyIndex proxy : changes.removed) {
        forest_.remove(slots_.slot_of(proxy));
        slots_.remove(slots_.slot_of(proxy));
    }
    drop_candidates();
    MovingFrame& frame = margins_.frame();
    if (!has_margins_) frame = {};
    frame.start(has_margins_ ? common_step : Vec3::Zero());
    if (has_margins_) {
        if (!had_margins) slots_.drop_margins();
        for (const ProxyIndex proxy : changes.moved) slots_.wake(slots_.slot_of(proxy));
        slots_.move(changes.moved, table, frame, escaped_);
        counts.escaped += escaped_.size();
    } else {
        slots_.put_all_to_sleep();
        slots_.take(changes.moved, table);
    }
    for (const ProxyIndex proxy : changes.added) add(proxy, table);
    search_everything(table, false, counts);
    ++counts.rebuilds;
    if (has_margins_) margins_.lookahead().guess(pairs_.size(), slots_.used_count());
    if (has_margins_ && changes.moved.empty() && RebuildRule::are_many(changes.added.size(), table.size())) {
        forest_.refresh(slots_.fat_lines());  // which the first one to move or to come would wait for
    }
}

void KeptCandidates::drop_candidates() {
    candidates_.clear();
    slots_.forget_changes();
}

// Makes `pairs_` the pairs of boxes, and the candidates those of fat boxes, where there are any. Boxes that escaped get
// new ones.
void KeptCandidates::search_everything(const ProxyTable& table, bool must_sort, BroadPhaseCounts& counts) {
    std::vector<CandidateList::SlotPair>& found = candidates_.found();
    if (has_margins_) {
        fatten_everything(table, must_sort);
        counts.box_tests += search_.find_pairs(slots_.fat_lines(), found) + found.size();
        std::vector<std::array<ProxyIndex, 2>> overlapping;
        candidates_.settle(slots_, overlapping);
        slots_.settle_all_escaped();
        list_pairs(overlapping, table.end(), pairs_);
    } else {
        forest_.forget();
        counts.box_tests += search_.find_pairs(slots_.lines(), found) + found.size();
        for (auto& [a, b] : found) a = slots_.proxies()[a], b = slots_.proxies()[b];
        list_pairs(found, table.end(), pairs_);
        candidates_.clear();
    }
    keeping_.note_pairs(pairs_.size());
    escaped_.clear();
}

// Gives the boxes that escaped, or would soon, other fat boxes. Puts neighbours beside each other where they are not,
// or leaves the forest behind.
void KeptCandidates::fatten_everything(const ProxyTable& table, bool must_sort) {
    const std::vector<SlotIndex> far = fatten_escaped(table);
    for (SlotIndex slot = 0; slot < slots_.size(); ++slot) {
        if (!slots_.has(slot, SlotTable::awake) || slots_.has(slot, SlotTable::escaped)) continue;
        PackedBox fat = slots_.fat_lines()[slot];
        if (margins_.renew(slot, table.boxes()[slots_.proxies()[slot]], slots_.lines()[slot], fat)) {
            slots_.set_fat(slot, fat);
        }
    }
    const auto came = static_cast<std::size_t>(std::count_if(
        escaped_.begin(), escaped_.end(), [](const EscapedBox& escaped) { return escaped.old_fat.is_empty(); }));
    if (rebuild_.is_order_due(escaped_.size(), came, table.size()) || must_sort) {
        sort_slots(table);
    } else {
        forest_.leave_behind();
        forest_.add(far, slots_.fat_lines());
    }
}

// Puts everything that is kept by slot in the order in which the search goes through boxes.
void KeptCandidates::sort_slots(const ProxyTable& table) {
    double sum = 0;
    for (SlotIndex slot = 0; slot < slots_.size(); ++slot) {
        if (slots_.is_free(slot)) continue;
        const Aabb& box = table.boxes()[slots_.proxies()[slot]];
        const double extent = (box.max - box.min).maxCoeff();
        if (extent < std::numeric_limits<double>::max()) sum += extent / static_cast<double>(table.size());
    }
    margins_.set_mean_extent(sum);
    std::vector<SlotIndex> order;
    order.reserve(table.size());
    search_.append_order(slots_.fat_lines(), order);
    slots_.reorder(order);
    margins_.reorder(order);
    rebuild_.note_order();
    forest_.forget();
}

}  // namespace ecods
