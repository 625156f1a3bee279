#include "world/collisions.hpp"

#include <algorithm>

#include "base/bytes_of.hpp"
#include "base/make_room.hpp"

namespace ecods {

// What ended goes first: where a body's slot was used again, the same pair of slots may end and begin.
void Collisions::take_over(const PairEvents& events, const Bodies& bodies) {
    verdicts_.reserve(verdicts_.size() + events.began.size(), bodies.end());
    make_room(lost_, events.ended.size());
    // Nothing below throws.
    for (const ProxyPair pair : events.ended) {
        const Verdict verdict = verdicts_.remove(pair);
        if (verdict.is_colliding) lost_.push_back(verdict.bodies);
    }
    for (const ProxyPair pair : events.began) verdicts_.add(bodies.ids_of(pair));
    overlapping_is_stale_ |= !events.empty();
}

// Each pair once. A pair that began has a body that changed. When much changed, all pairs are passed over in the order
// in which they lie; otherwise each body's list is followed.
void Collisions::collect(const Bodies& bodies, Changes& changes, std::uint64_t& visited_pairs) {
    tests_.clear();
    if (changes.bodies().size() >= bodies.end() / 4) {
        visited_pairs += verdicts_.size();
        for (VerdictIndex index = 0; index < verdicts_.size(); ++index) {
            if (changes.any_of(verdicts_[index].proxies())) collect_pair(index, bodies, changes);
        }
    } else {
        for (const ProxyIndex proxy : changes.bodies()) {
            for (auto index = verdicts_.first(proxy); index != no_verdict; index = verdicts_.next(index, proxy)) {
                ++visited_pairs;
                const ProxyPair pair = verdicts_[index].proxies();
                const ProxyIndex partner = pair.a == proxy ? pair.b : pair.a;
                if (changes.of(partner) == Change::none || proxy < partner) collect_pair(index, bodies, changes);
            }
        }
    }
    changes.sort_switched();
    visited_pairs += changes.switched().size();
    for (const ProxyPair pair : changes.switched()) {
        const VerdictIndex index = verdicts_.find(pair);
        if (index != no_verdict && !changes.any_of(pair)) collect_pair(index, bodies, changes);
    }
}

// Nothing is asked of a pair that is filtered out, nor of one that was tested before and whose bodies are as they were.
void Collisions::collect_pair(VerdictIndex index, const Bodies& bodies, const Changes& changes) {
    const Verdict& verdict = verdicts_[index];
    const ProxyPair pair = verdict.proxies();
    if (!bodies.is_enabled(pair)) {
        if (verdict.is_enabled) tests_.push_back({index, Answer::filtered_out});
        return;
    }
    if (changes.voids_verdict_of(pair) || !verdict.is_enabled) tests_.push_back({index, Answer::none});
}

std::size_t Collisions::commit() {
    next_began_.clear();
    next_ended_ = lost_;
    std::size_t test_count = 0;
    for (const PairTest& done : tests_) {
        const Verdict& verdict = verdicts_[done.verdict];
        test_count += done.answer != Answer::filtered_out;
        const bool is_colliding = done.answer == Answer::colliding;
        if (is_colliding != verdict.is_colliding) (is_colliding ? next_began_ : next_ended_).push_back(verdict.bodies);
    }
    std::ranges::sort(next_began_);
    std::ranges::sort(next_ended_);
    // A pair that lost its box overlap and found it again while updates failed has both ended and begun: it went on.
    cancel_common(next_began_, next_ended_);
    make_room(colliding_, next_began_.size());
    // Nothing below throws.
    for (const PairTest& done : tests_) {
        const bool is_enabled = done.answer != Answer::filtered_out;
        overlapping_is_stale_ |= is_enabled != verdicts_[done.verdict].is_enabled;
        verdicts_.set(done.verdict, is_enabled, done.answer == Answer::colliding);
    }
    remove_sorted(colliding_, next_ended_);
    add_sorted(colliding_, next_began_);
    began_.swap(next_began_);
    ended_.swap(next_ended_);
    lost_.clear();
    return test_count;
}

void Collisions::clear_events() noexcept {
    began_.clear();
    ended_.clear();
}

const BodyPairs& Collisions::overlapping() {
    if (overlapping_is_stale_) {
        list_overlapping(overlapping_);
        overlapping_is_stale_ = false;
    }
    return overlapping_;
}

// Body by body, so that short lists are sorted, and none of all pairs.
void Collisions::list_overlapping(BodyPairs& list) const {
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

std::size_t Collisions::memory_bytes() const noexcept {
    return bytes_of(tests_, lost_, overlapping_, colliding_, began_, ended_, next_began_, next_ended_) +
           verdicts_.memory_bytes();
}

void Collisions::validate() const {
    verdicts_.validate();
    std::vector<BodyPair> overlapping, colliding;
    for (VerdictIndex index = 0; index < verdicts_.size(); ++index) {
        const Verdict& verdict = verdicts_[index];
        if (verdict.is_enabled) overlapping.push_back(verdict.bodies);
        if (verdict.is_colliding) colliding.push_back(verdict.bodies);
    }
    std::ranges::sort(overlapping);
    std::ranges::sort(colliding);
    const auto require = [](bool holds, const char* what) {
        if (!holds) throw BrokenInvariant(what);
    };
    require(overlapping_is_stale_ || overlapping == overlapping_, "the list of overlapping pairs is wrong");
    require(colliding == colliding_, "the list of colliding pairs is not that of the verdicts");
}

}  // namespace ecods
