#include "broad_phase/candidates/keeping_rule.hpp"

#include <algorithm>
#include <bit>

namespace ecods {
namespace {

// Updates of slow boxes that search for nothing: 13 a box with 0.3 candidates each, 31 with 4, of which 5 a box are not
// the finder's.
constexpr double filter_work = 3, move_work = 8;

// A pair that begins or ceases to overlap: no processor foretells it, and it is sorted and put into the list of pairs.
// Boxes that move by a tenth of their size see a fifth of their pairs do so in an update, and others in proportion.
constexpr double event_work = 55, events_by_step = 1.9;

// 500 of 10,000 that come, while the others move, take 1600 each, for 160 tests; at rest, where they meet no margins,
// 1000.
constexpr double lookup_work = 800, tree_test_work = 5.3;

// Of a box that comes or goes, before its tests are counted.
constexpr double foreseen_lookup_work = 3000;

// Looking up goes through memory in no order, and searches from scratch mostly in order: beside those it costs as much
// for 10,000 boxes as the numbers above say, and 1.75 times as much for 100,000.
double lookup_factor(std::size_t boxes) noexcept {
    constexpr unsigned cached_bits = 14;  // fewer boxes are in a cache
    constexpr double for_twice_as_many = 0.25;
    return 1 + for_twice_as_many * static_cast<double>(std::bit_width(boxes >> cached_bits));
}

}  // namespace

// What an update costs with margins that last so long. They are paid for when all boxes get them, and when boxes
// escape: all that moved do so once in their lifetime.
double KeepingRule::kept_work(const Forecast& forecast, double lifetime) const noexcept {
    constexpr double updates_planned = 16;  // that pay for the search which begins it
    // Boxes grow ahead, and by a part of that behind; each of a pair does, and few along an axis. Measured: half of the
    // margin on each axis.
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
    constexpr double share = 0.8;  // of the other work: what is foreseen is not certain
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
    const bool is_new = forecast.came == forecast.boxes;  // boxes that were just placed will hardly be replaced
    if (updates_to_trial_ > 0) --updates_to_trial_;
    is_scratch_ = !is_new && (updates_to_trial_ > 0 || !(kept < share * scratch_work(boxes)));
    // The search that begins it is an investment.
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
