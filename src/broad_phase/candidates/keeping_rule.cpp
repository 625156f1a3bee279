#include "broad_phase/candidates/keeping_rule.hpp"

#include <algorithm>
#include <bit>

namespace ecods {
namespace {

// Estimates the work for a tested candidate, and for a moved box. In updates of slow boxes that search for nothing, the
// measured work per box is 13 with 0.3 candidates a box, and 31 with 4. In both cases, 5 of this work is spent outside
// the finder.
constexpr double filter_work = 3, move_work = 8;

// Estimates the work for a pair that begins or ceases to overlap: a mispredicted branch, sorting, and the update of the
// list of pairs. If boxes move by a tenth of their size in an update, a fifth of their pairs begin or cease to overlap;
// the share is proportional to the step.
constexpr double event_work = 55, events_by_step = 1.9;

// Estimates the work for looking up a box, and for each of its tests in trees. Measured for 10,000 boxes of which 500
// are added in an update: if the other boxes move, a look-up costs 1600, with 160 tests; if they are at rest and have
// no margins, a look-up costs 1000.
constexpr double lookup_work = 800, tree_test_work = 5.3;

// Estimates the work for looking up a box in a forecast, which does not know the number of the look-up's tests.
constexpr double foreseen_lookup_work = 3000;

// Returns the factor by which look-ups cost more work in large scenes. Look-ups access memory in random order, searches
// from scratch mostly in sequence. The numbers above hold for 10,000 boxes. Relative to a search, a look-up among
// 100,000 boxes costs 1.75 times as much.
double lookup_factor(std::size_t boxes) noexcept {
    constexpr unsigned cached_bits = 14;  // 2^cached_bits boxes fit in a cache
    constexpr double for_twice_as_many = 0.25;
    return 1 + for_twice_as_many * static_cast<double>(std::bit_width(boxes >> cached_bits));
}

}  // namespace

// Returns the work of an update with margins that last for `lifetime` updates. Margins cost work when all boxes get
// them at first, and when boxes escape: each box that moves escapes once in a lifetime.
double KeepingRule::kept_work(const Forecast& forecast, double lifetime) const noexcept {
    constexpr double updates_planned = 16;  // number of updates that share the cost of the first search
    // For the estimate of candidates, each box is taken to grow along each axis by this share of the margin. The share
    // was measured. A fat box reaches ahead by the margin and behind by a part of it, and few boxes move along an axis
    // of the coordinates.
    constexpr double growth_by_margin = 0.5;
    const auto boxes = static_cast<double>(forecast.boxes);
    const double moved = static_cast<double>(forecast.moved);
    const double moving_share = boxes > 0 ? moved / boxes : 0;
    const double growth = 1 + growth_by_margin * lifetime * forecast.step;
    const double candidates = static_cast<double>(pairs_) * growth * growth * growth;
    const double search = search_work(boxes, candidates);
    return search / updates_planned + moving_share * search / std::max(lifetime, 1.0) + move_work * moved +
           filter_work * candidates * std::min(1.0, 2 * moving_share) +
           event_work * events_by_step * forecast.step * moving_share * static_cast<double>(pairs_) +
           lookup_factor(forecast.boxes) * foreseen_lookup_work *
               (static_cast<double>(forecast.came) + forecast.jumping);
}

bool KeepingRule::pays(const Forecast& forecast) noexcept {
    constexpr double share = 0.8;  // of the work from scratch; less than 1, as the forecast is uncertain
    constexpr double shorter = 0.75, lifetime_min = 2;
    const auto boxes = static_cast<double>(forecast.boxes);
    lifetime_ = forecast.lifetime_max;
    double kept = kept_work(forecast, lifetime_);
    for (double lifetime = shorter * lifetime_; lifetime >= lifetime_min; lifetime *= shorter) {
        const double work = kept_work(forecast, lifetime);
        if (work >= kept) break;
        kept = work;
        lifetime_ = lifetime;
    }
    const bool is_new = forecast.came == forecast.boxes;  // if all boxes were just added, most will stay
    if (updates_to_trial_ > 0) --updates_to_trial_;
    is_scratch_ = !is_new && (updates_to_trial_ > 0 || !(kept < share * scratch_work(boxes)));
    // The first search with margins is an investment, and does not count as lost.
    if (!is_scratch_) lost_ = 0;
    return !is_scratch_;
}

void KeepingRule::note_kept(const Kept& kept) noexcept {
    constexpr double searches_lost_max = 2, searches_won_max = 2;
    constexpr std::uint32_t patience_min = 4, patience_max = 64;
    const auto boxes = static_cast<double>(kept.boxes);
    const double scratch = scratch_work(boxes);
    double work = move_work * static_cast<double>(kept.moved) + filter_work * static_cast<double>(kept.filtered);
    work += event_work * static_cast<double>(kept.events);
    if (kept.searched_all) {
        work += search_work(boxes, static_cast<double>(kept.candidates));
    } else {
        work += lookup_factor(kept.boxes) * (lookup_work * static_cast<double>(kept.looked_up) +
                                             tree_test_work * static_cast<double>(kept.tree_tests));
    }
    lost_ = std::max(lost_ + work - scratch, -searches_won_max * scratch);
    if (lost_ <= -searches_won_max * scratch) trial_patience_ = patience_min;
    if (lost_ <= searches_lost_max * scratch) return;
    is_scratch_ = true;
    updates_to_trial_ = trial_patience_;
    trial_patience_ = std::min(2 * trial_patience_, patience_max);
}

}  // namespace ecods
