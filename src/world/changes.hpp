// What changed since the last update that succeeded.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/bytes_of.hpp"
#include "base/make_room.hpp"
#include "ecods/broad_phase.hpp"

namespace ecods {

// What happened to a body.
enum class Change : std::uint8_t {
    none = 0,
    filter = 1,  // its filter alone: verdicts hold where the pair was not filtered out and is not now
    test = 2,    // the test of its kind: its verdicts are void, though it did not move
    body = 3,    // itself: its verdicts are void, or it is gone
};

class Changes {
  public:
    // ---- before what must not fail
    void reserve(std::size_t body_count) {
        changes_.reserve(body_count);
        changed_.reserve(body_count);
    }
    void make_room_for(std::size_t count) { make_room(changed_, count); }
    void make_room_for_all() { changed_.reserve(changes_.size()); }
    void make_room_for_switch() { make_room(switched_); }
    void add_slots_below(ProxyIndex end) {
        if (changes_.size() < end) changes_.resize(end);
    }

    void mark(ProxyIndex proxy, Change change) noexcept {
        Change& known = changes_[proxy];
        if (known == Change::none) changed_.push_back(proxy);
        known = std::max(known, change);
    }
    void mark_switched(ProxyPair pair) noexcept { switched_.push_back(pair); }

    bool empty() const noexcept { return changed_.empty() && switched_.empty(); }

    Change of(ProxyIndex proxy) const noexcept { return changes_[proxy]; }
    bool any_of(ProxyPair pair) const noexcept {
        return changes_[pair.a] != Change::none || changes_[pair.b] != Change::none;
    }
    bool voids_verdict_of(ProxyPair pair) const noexcept {
        return changes_[pair.a] >= Change::test || changes_[pair.b] >= Change::test;
    }

    // Each body once, also those that were destroyed since.
    std::span<const ProxyIndex> bodies() const noexcept { return changed_; }

    // Pairs that were switched on or off: ascending and each once, after sort_switched().
    void sort_switched() noexcept {
        std::ranges::sort(switched_);
        switched_.erase(std::unique(switched_.begin(), switched_.end()), switched_.end());
    }
    std::span<const ProxyPair> switched() const noexcept { return switched_; }

    // An update succeeded.
    void clear() noexcept {
        for (const ProxyIndex proxy : changed_) changes_[proxy] = Change::none;
        changed_.clear();
        switched_.clear();
    }

    std::size_t memory_bytes() const noexcept { return bytes_of(changes_, changed_, switched_); }

  private:
    std::vector<Change> changes_;  // by proxy; if not none, listed in changed_
    std::vector<ProxyIndex> changed_;
    std::vector<ProxyPair> switched_;
};

}  // namespace ecods
