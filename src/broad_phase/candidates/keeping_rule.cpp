#include "broad_phase/candidates/keeping_rule.hpp"

namespace ecods {
namespace {

// Updates of slow boxes that search for nothing: 13 a box with 0.3 candidates each, 31 with 4, of which 5 a box are not
// the finder's.
constexpr double filter_work = 3, move_work = 8;

// 500 of 10,000 that come take 1600 each, for 160 tests.
constexpr double lookup_work = 800, tree_test_work = 5.3;

// Of a box that comes or goes, before its tests are counted.
constexpr double foreseen_lookup_work = 3000;

}  // namespace

// Margins are paid for when all boxes get them, and when boxes escape: all that moved do so once in their lifetime.
bool KeepingRule::pays(const Forecast& forecast) noexcept {
    constexpr double updates_planned = 16;  // that pay for the search which begins it
    constexpr double share = 0.8;           // of the other work: what is foreseen is not certain
    const auto boxes = static_cast<double>(forecast.boxes);
    const double moved = static_cast<double>(forecast.moved);
    const double moving_share = boxes > 0 ? moved / boxes : 0;
    const double candidates = pairs_ * forecast.growth;
    const double search = search_work(boxes, candidates);
    const double kept = search / updates_planned + moving_share * search / std::max(forecast.lifetime, 1.0) +
                        move_work * moved + filter_work * candidates * std::min(1.0, 2 * moving_share) +
                        foreseen_lookup_work * static_cast<double>(forecast.looked_up);
    const bool is_new = forecast.looked_up == forecast.boxes;  // boxes that were just placed will hardly be replaced
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
    if (kept.searched_all) {
        work += search_work(boxes, static_cast<double>(kept.candidates));
    } else {
        work +=
            lookup_work * static_cast<double>(kept.looked_up) + tree_test_work * static_cast<double>(kept.tree_tests);
    }
    lost_ = std::max(lost_ + work - scratch, -searches_won_max * scratch);
    if (lost_ <= -searches_won_max * scratch) trial_patience_ = patience_min;
    if (lost_ <= searches_lost_max * scratch) return;
    is_scratch_ = true;
    updates_to_trial_ = trial_patience_;
    trial_patience_ = std::min(2 * trial_patience_, patience_max);
}

}  // namespace ecods
