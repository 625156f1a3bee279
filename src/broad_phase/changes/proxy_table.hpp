// Holds the boxes that are present, and the changes since the last update; all broad phases share this bookkeeping.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ecods/broad_phase.hpp"

namespace ecods {

// Lists the changes since the last update. A proxy that was removed and then added again is in both lists: in `removed`
// for its old box, in `added` for its new one.
struct ProxyChanges {
    std::vector<ProxyIndex> added;      // present now, but not at the last update
    std::span<const ProxyIndex> moved;  // present at both times, with another box now
    std::vector<ProxyIndex> removed;    // present at the last update, and removed since

    bool empty() const noexcept { return added.empty() && moved.empty() && removed.empty(); }
};

class ProxyTable {
  public:
    // Bounds the proxies (exclusively): an Endpoint uses one of 32 bits to mark which end of a box it is.
    static constexpr ProxyIndex limit = ProxyIndex{1} << 31;

    // Functions without a comment promise what the functions of the same names promise in BroadPhase.
    void reserve(std::size_t count);
    void add(ProxyIndex proxy, const Aabb& box);
    void move(ProxyIndex proxy, const Aabb& box);
    void move(std::span<const ProxyIndex> proxies, std::span<const Aabb> boxes);
    void remove(ProxyIndex proxy);
    const Aabb& box(ProxyIndex proxy) const;
    std::size_t size() const noexcept { return size_; }
    std::size_t bytes() const noexcept;

    // Returns the changes since the last settle(). Cost: constant if no box was added or removed since then, otherwise
    // proportional to the number of boxes added or moved.
    const ProxyChanges& collect();

    // Ends an update: from now on, changes are relative to the boxes that are present now.
    void settle();

    // Returns an exclusive upper bound of the proxies in use.
    ProxyIndex end() const noexcept { return static_cast<ProxyIndex>(states_.size()); }

    bool is_present(ProxyIndex proxy) const noexcept { return has(proxy, present); }
    bool is_removed(ProxyIndex proxy) const noexcept { return has(proxy, removed); }

    // Returns the boxes, indexed by proxy. Boxes of proxies that are not present are unspecified.
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

    // The next three vectors are indexed by proxy.
    std::vector<std::uint8_t> states_;
    std::vector<Aabb> boxes_;
    std::vector<std::uint32_t> queued_at_;  // turn in which the proxy was last put into queue_

    // Numbers the turns: a turn lasts from one settle() to the next. In most turns boxes only move, and then collect()
    // returns queue_ as it is.
    std::uint32_t turn_ = 1;
    bool has_moves_only_ = true;
    std::vector<ProxyIndex> queue_;  // proxies added or moved in this turn, each once
    std::vector<ProxyIndex> moved_;  // proxies in queue_ that moved; used unless has_moves_only_
    ProxyChanges changes_;           // `removed` is kept up to date by remove(), the rest is set by collect()
    std::size_t size_ = 0;
    std::size_t reserved_ = 0;
};

}  // namespace ecods
