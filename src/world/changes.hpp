// Records the changes of bodies and pairs since the last update that succeeded.
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

// A Change says what happened to a body since the last update. If several changes happened to one body, the greatest is
// stored.
enum class Change : std::uint8_t {
    none = 0,
    filter = 1,  // only its collision filter changed: verdicts of its pairs hold unless their filtering changed
    test = 2,    // a two-body test of its kind was replaced: verdicts of its pairs are void, though it did not move
    body = 3,    // it was moved, reshaped, created or destroyed: verdicts of its pairs are void
};

class Changes {
  public:
    // The functions down to add_slots_below() reserve memory. Call these functions before a change that must not fail.
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

    // Returns the changed bodies, each once; bodies that were destroyed are included.
    std::span<const ProxyIndex> bodies() const noexcept { return changed_; }

    // Sorts the pairs that were switched on or off, and removes duplicates.
    void sort_switched() noexcept {
        std::ranges::sort(switched_);
        switched_.erase(std::unique(switched_.begin(), switched_.end()), switched_.end());
    }
    std::span<const ProxyPair> switched() const noexcept { return switched_; }

    // Forgets all changes. Call it after an update that succeeded.
    void clear() noexcept {
        for (const ProxyIndex proxy : changed_) changes_[proxy] = Change::none;
        changed_.clear();
        switched_.clear();
    }

    std::size_t memory_bytes() const noexcept { return bytes_of(changes_, changed_, switched_); }

  private:
    std::vector<Change> changes_;  // by proxy; a proxy is in changed_ unless its value is `none`
    std::vector<ProxyIndex> changed_;
    std::vector<ProxyPair> switched_;
};

}  // namespace ecods
