// Updates that search for everything, and compare what they find with the pairs there were: nothing that is kept is
// asked for.
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "broad_phase/candidates/kept_candidates.hpp"
#include "broad_phase/candidates/kept_candidates_loops.hpp"
#include "broad_phase/scratch/list_pairs.hpp"
#include "simd/dispatch.hpp"

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
                                   .lifetime = lookahead_,
                                   .growth = 1};
    Vec3 common = Vec3::Zero();
    if (changes.moved.empty()) return {forecast, common};
    std::vector<Step> steps;
    const std::size_t count = std::min(changes.moved.size(), sample_max);
    for (std::size_t i = 0; i < count; ++i) {
        // By multiples of a large prime, lest all have something in common.
        const ProxyIndex proxy = changes.moved[i * std::size_t{2654435761} % changes.moved.size()];
        steps.push_back(step_of(lines_[slots_[proxy]], table.boxes()[proxy]));
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
    if (middle > 0) forecast.lifetime = std::min(lookahead_, margin_max / middle);
    // Boxes grow ahead, and by a part of that behind; each of a pair does. Measured: 1.5 times the margin on each axis.
    const double growth = 1 + 1.5 * forecast.lifetime * middle;
    forecast.growth = growth * growth * growth;
    return {forecast, common};
}

void KeptCandidates::find_everything(const FindingUpdate& finding) {
    const auto& [table, changes, keeper, events, counts] = finding;
    const auto [forecast, common_step] = foresee(table, changes);
    const bool keeps = rule_.pays(forecast);
    for (const SlotIndex slot : changed_slots_) clear_flag(slot, changed);
    changed_slots_.clear();
    candidates_.clear();
    for (const ProxyIndex proxy : changes.removed) drop(proxy);
    if (keeps && !has_margins_) fat_lines_ = lines_;
    if (!keeps) frame_ = {};
    frame_.start(keeps ? common_step : Vec3::Zero());
    has_margins_ = keeps;
    if (keeps) {
        order_slots(give_margins(finding), table);
    } else {
        take_as_they_are(table, changes);
        is_forest_behind_ = is_forest_renumbered_ = true;
    }
    const std::vector<Candidate>& found = candidates_;
    counts.box_tests += search_.find_pairs(keeps ? fat_lines_ : lines_, candidates_) + found.size();
    ++counts.rebuilds;
    if (keeps) {
        mark_overlapping();
        guess_lookahead(pairs_.size());
    } else {
        pairs_.resize(found.size());
        for (Candidate& pair : candidates_) pair = {proxies_[pair[0]], proxies_[pair[1]]};
        list_pairs(candidates_, table.end(), pairs_);
        candidates_.clear();
    }
    rule_.note_pairs(pairs_.size());
    escaped_.clear();
    keeper.compare(table, changes, pairs_, events);
    const bool many_came = 8 * changes.added.size() > table.size();
    if (!many_came) return;
    search_ = {};  // its memory: they may be at rest from now on
    pairs_ = {};
    if (keeps && changes.moved.empty()) refresh_forest(table);  // which the first one to move or to come would wait for
}

// Frees the slot of a removed box at once: no candidate is left that names it.
void KeptCandidates::drop(ProxyIndex proxy) {
    const SlotIndex slot = slots_[proxy];
    if (!is_forest_renumbered_) forest_.remove(slot);
    lines_[slot] = {};
    fat_lines_[slot] = {};
    slots_[proxy] = no_slot;
    --used_count_;
    if (has_flag(slot, awake)) --awake_count_;
    flags_[slot] = 0;
    free_slots_.push_back(slot);
}

// Boxes that moved are awake and have new fat boxes where they left theirs.
std::vector<BoxForest::Item> KeptCandidates::give_margins(const FindingUpdate& finding) {
    const auto& [table, changes, keeper, events, counts] = finding;
    for (const ProxyIndex proxy : changes.moved) {
        const SlotIndex slot = slots_[proxy];
        if (!has_flag(slot, awake)) ++awake_count_;
        set_flag(slot, awake | moved);
    }
    move_some(changes.moved, table);
    counts.escaped += escaped_.size();
    add(changes.added, table);
    std::vector<BoxForest::Item> unsorted = fatten_escaped(table);
    fatten_used_up(table);
    return unsorted;
}

// Boxes have no fat boxes, and none is awake.
void KeptCandidates::take_as_they_are(const ProxyTable& table, const ProxyChanges& changes) {
    add(changes.added, table);
    if (awake_count_ > 0) std::fill(flags_.begin(), flags_.end(), std::uint8_t{0});
    awake_count_ = 0;
    if (2 * changes.moved.size() > proxies_.size()) {
        dispatch<Loops::take_all_lines>(*this, table);
    } else {
        for (const ProxyIndex proxy : changes.moved) make_packed_box(table.boxes()[proxy], lines_[slots_[proxy]]);
    }
}

// Makes `pairs_` the pairs of boxes among those of fat boxes that were found, and these the candidates.
void KeptCandidates::mark_overlapping() {
    std::vector<Candidate> overlapping;
    dispatch<Loops::mark_overlapping>(*this, overlapping);
    list_pairs(overlapping, slots_.size(), pairs_);
    for (std::uint8_t& flags : flags_) flags &= static_cast<std::uint8_t>(~(searching | changed));
}

}  // namespace ecods
