#include "world/pair_verdicts.hpp"

#include <algorithm>

#include "base/bytes_of.hpp"
#include "base/make_room.hpp"
#include "world/cached_pairs.hpp"

namespace ecods {

// Applies the tracker's events twice: before the tracker's update, the events that an earlier failed update left; after
// it, the new events.
void PairVerdicts::follow(OverlapTracker& tracker, const Bodies& bodies, std::uint64_t& visited_pairs) {
    const auto take_over_events = [&] {
        const PairEvents& events = tracker.events();
        take_over(events, bodies);
        visited_pairs += events.began.size() + events.ended.size();
        tracker.clear_events();
    };
    if (!tracker.events().empty()) take_over_events();
    CachedPairs pairs(verdicts_);
    tracker.update(pairs);
    take_over_events();
}

// Applies the events. Pairs that ended are removed before others are added: if a slot was given to another body, the
// same pair of slots may both end and begin.
void PairVerdicts::take_over(const PairEvents& events, const Bodies& bodies) {
    verdicts_.reserve(verdicts_.size() + events.began.size(), bodies.end());
    make_room(lost_, events.ended.size());
    // Nothing below throws.
    for (const ProxyPair pair : events.ended) {
        const Verdict verdict = verdicts_.remove(pair);
        if (verdict.is_positive) lost_.push_back(verdict.bodies);
    }
    for (const ProxyPair pair : events.began) verdicts_.add(bodies.ids_of(pair));
    overlapping_is_stale_ |= !events.empty();
}

// Collects each pair with a changed body once. (A pair that began has a changed body.) If at least a quarter of the
// bodies changed, it passes over all pairs in the order in which they are stored; otherwise it follows the list of
// pairs of each changed body.
void PairVerdicts::collect(const Bodies& bodies, Changes& changes, bool all_are_void, std::uint64_t& visited_pairs) {
    tests_.clear();
    const auto collect_changed = [&](VerdictIndex index, ProxyPair pair) {
        collect_pair(index, bodies, all_are_void || changes.voids_verdict_of(pair));
    };
    if (all_are_void || changes.bodies().size() >= bodies.end() / 4) {
        visited_pairs += verdicts_.size();
        for (VerdictIndex index = 0; index < verdicts_.size(); ++index) {
            const ProxyPair pair = verdicts_[index].proxies();
            if (all_are_void || changes.any_of(pair)) collect_changed(index, pair);
        }
        if (all_are_void) return;
    } else {
        for (const ProxyIndex proxy : changes.bodies()) {
            for (auto index = verdicts_.first(proxy); index != no_verdict; index = verdicts_.next(index, proxy)) {
                ++visited_pairs;
                const ProxyPair pair = verdicts_[index].proxies();
                const ProxyIndex partner = pair.a == proxy ? pair.b : pair.a;
                if (changes.of(partner) == Change::none || proxy < partner) collect_changed(index, pair);
            }
        }
    }
    changes.sort_switched();
    visited_pairs += changes.switched().size();
    for (const ProxyPair pair : changes.switched()) {
        const VerdictIndex index = verdicts_.find(pair);
        if (index != no_verdict && !changes.any_of(pair)) collect_pair(index, bodies, false);
    }
}

// Adds the pair to tests_. Skips it if it was filtered out and still is, or if it was enabled, still is, and its
// verdict holds.
void PairVerdicts::collect_pair(VerdictIndex index, const Bodies& bodies, bool is_void) {
    const Verdict& verdict = verdicts_[index];
    const bool is_enabled = bodies.is_enabled(verdict.proxies());
    if (!is_enabled ? !verdict.is_enabled : verdict.is_enabled && !is_void) return;
    tests_.push_back(index);
    verdicts_.answer(index) = is_enabled ? Answer::none : Answer::filtered_out;
}

void PairVerdicts::prepare() {
    next_began_.clear();
    next_ended_ = lost_;
    for (const VerdictIndex index : tests_) {
        const Verdict& verdict = verdicts_[index];
        const bool is_positive = verdict.answer == Answer::yes;
        if (is_positive != verdict.is_positive) (is_positive ? next_began_ : next_ended_).push_back(verdict.bodies);
    }
    std::ranges::sort(next_began_);
    std::ranges::sort(next_ended_);
    // If boxes parted and overlapped again while updates failed, their pair is in both lists; its collision never
    // ended.
    cancel_common(next_began_, next_ended_);
    make_room(positive_, next_began_.size());
}

std::size_t PairVerdicts::commit() noexcept {
    std::size_t test_count = 0;
    for (const VerdictIndex index : tests_) {
        const Answer answer = verdicts_[index].answer;
        const bool is_enabled = answer != Answer::filtered_out;
        test_count += is_enabled;
        overlapping_is_stale_ |= is_enabled != verdicts_[index].is_enabled;
        verdicts_.set(index, is_enabled, answer == Answer::yes);
    }
    remove_sorted(positive_, next_ended_);
    add_sorted(positive_, next_began_);
    began_.swap(next_began_);
    ended_.swap(next_ended_);
    lost_.clear();
    return test_count;
}

void PairVerdicts::clear_events() noexcept {
    began_.clear();
    ended_.clear();
}

void PairVerdicts::end_all() noexcept {
    verdicts_ = VerdictCache();
    tests_.clear();
    lost_.clear();
    began_.clear();
    ended_.swap(positive_);
    positive_.clear();
    overlapping_is_stale_ = true;
}

const BodyPairs& PairVerdicts::overlapping() {
    if (overlapping_is_stale_) {
        list_overlapping(overlapping_);
        overlapping_is_stale_ = false;
    }
    return overlapping_;
}

// Lists the enabled pairs body by body, because sorting many short lists is faster than sorting one long list.
void PairVerdicts::list_overlapping(BodyPairs& list) const {
    list.clear();
    list.reserve(verdicts_.enabled_count());
    for (ProxyIndex proxy = 0; proxy < verdicts_.proxy_end(); ++proxy) {
        const auto old_size = static_cast<std::ptrdiff_t>(list.size());
        for (auto index = verdicts_.first(proxy); index != no_verdict; index = verdicts_.next(index, proxy)) {
            const Verdict& verdict = verdicts_[index];
            if (verdict.is_enabled && verdict.proxies().a == proxy) list.push_back(verdict.bodies);
        }
        std::sort(list.begin() + old_size, list.end());
    }
}

std::size_t PairVerdicts::memory_bytes() const noexcept {
    return bytes_of(tests_, lost_, overlapping_, positive_, began_, ended_, next_began_, next_ended_) +
           verdicts_.memory_bytes();
}

void PairVerdicts::validate() const {
    verdicts_.validate();
    std::vector<BodyPair> overlapping, positive;
    for (VerdictIndex index = 0; index < verdicts_.size(); ++index) {
        const Verdict& verdict = verdicts_[index];
        if (verdict.is_enabled) overlapping.push_back(verdict.bodies);
        if (verdict.is_positive) positive.push_back(verdict.bodies);
    }
    std::ranges::sort(overlapping);
    std::ranges::sort(positive);
    const auto require = [](bool holds, const char* what) {
        if (!holds) throw BrokenInvariant(what);
    };
    require(overlapping_is_stale_ || overlapping == overlapping_, "the list of overlapping pairs is wrong");
    require(positive == positive_, "the list of positive pairs is not that of the verdicts");
}

}  // namespace ecods
