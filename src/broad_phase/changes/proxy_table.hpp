// The boxes that are present, and the changes since the last update: the bookkeeping that every broad phase shares.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ecods/broad_phase.hpp"

namespace ecods {

// The changes since the last update. A proxy that is removed and added again counts as both: the old box is in
// `removed`, the new one in `added`.
struct ProxyChanges {
    std::vector<ProxyIndex> added;      // present now, but not at the last update
    std::span<const ProxyIndex> moved;  // present at both times, with another box now
    std::vector<ProxyIndex> removed;    // present at the last update, and removed since

    bool empty() const noexcept { return added.empty() && moved.empty() && removed.empty(); }
};

class ProxyTable {
  public:
    // Exclusive upper bound of proxies: one of 32 bits marks which end of a box it is.
    static constexpr ProxyIndex limit = ProxyIndex{1} << 31;

    // The functions promise the same as the functions of BroadPhase with these names.
    void reserve(std::size_t count);
    void add(ProxyIndex proxy, const Aabb& box);
    void move(ProxyIndex proxy, const Aabb& box);
    void move(std::span<const ProxyIndex> proxies, std::span<const Aabb> boxes);
    void remove(ProxyIndex proxy);
    const Aabb& box(ProxyIndex proxy) const;
    std::size_t size() const noexcept { return size_; }
    std::size_t bytes() const noexcept;

    // Returns the changes since the last settle(). Cost: constant if nothing was called since, otherwise proportional
    // to the number of calls.
    const ProxyChanges& collect();

    // Makes the present boxes those of the last update.
    void settle();

    // Returns an exclusive upper bound of the proxies in use.
    ProxyIndex end() const noexcept { return static_cast<ProxyIndex>(states_.size()); }

    bool is_present(ProxyIndex proxy) const noexcept { return has(proxy, present); }
    bool is_removed(ProxyIndex proxy) const noexcept { return has(proxy, removed); }

    // Returns the boxes by proxy; unspecified for proxies that are not present.
    const std::vector<Aabb>& boxes() const noexcept { return boxes_; }

    // Returns the proxies that are present, ascending.
    std::vector<ProxyIndex> present_proxies() const;

    // Calls visit(proxy, box) for each present proxy, ascending.
    template <class Visit>
    void for_each(const Visit& visit) const {
        for (ProxyIndex proxy = 0; proxy < end(); ++proxy) {
            if (is_present(proxy)) visit(proxy, boxes_[proxy]);
        }
    }

  private:
    enum : std::uint8_t {
        present = 1,  // a box with this number is present
        settled = 2,  // that box was present at the last update
        removed = 4,  // a box with this number was present at the last update, and was removed since
    };

    bool has(ProxyIndex proxy, unsigned flag) const noexcept {
        return proxy < states_.size() && (states_[proxy] & flag) != 0;
    }
    void require_present(ProxyIndex proxy) const {
        if (!is_present(proxy)) [[unlikely]]
            refuse_absent(proxy);
    }
    [[noreturn]] static void refuse_absent(ProxyIndex proxy);
    void enqueue(ProxyIndex proxy) {
        if (queued_at_[proxy] == turn_) return;
        queue_.push_back(proxy);
        queued_at_[proxy] = turn_;
    }

    // Indexed by proxy.
    std::vector<std::uint8_t> states_;
    std::vector<Aabb> boxes_;
    std::vector<std::uint32_t> queued_at_;  // the turn in which it was last put into queue_

    // Number of the turn; a turn ends with settle(). Most turns have moves only, and then need no work per move.
    std::uint32_t turn_ = 1;
    bool has_moves_only_ = true;
    std::vector<ProxyIndex> queue_;  // proxies added or moved in this turn, each once
    std::vector<ProxyIndex> moved_;  // proxies in queue_ that moved; used unless has_moves_only_
    ProxyChanges changes_;           // `removed` is kept up to date by remove(), the rest is set by collect()
    std::size_t size_ = 0;
    std::size_t reserved_ = 0;
};

}  // namespace ecods
