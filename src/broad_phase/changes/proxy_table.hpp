// Which boxes are present, and what changed since the last update: the bookkeeping that every broad phase shares.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ecods/broad_phase.hpp"

namespace ecods {

// A proxy that is removed and added again between two updates is both: the old one is in `removed`, the new one
// in `added`.
struct ProxyChanges {
    std::vector<ProxyIndex> added;      // present, and not so at the last update
    std::span<const ProxyIndex> moved;  // present at both times, and given another box in between
    std::vector<ProxyIndex> removed;    // present at the last update, and gone since

    bool empty() const noexcept { return added.empty() && moved.empty() && removed.empty(); }
};

class ProxyTable {
  public:
    // Numbers from here on are refused: one bit of 32 is for which end of a box it is.
    static constexpr ProxyIndex limit = ProxyIndex{1} << 31;

    // What BroadPhase promises of the calls of these names.
    void reserve(std::size_t count);
    void add(ProxyIndex proxy, const Aabb& box);
    void move(ProxyIndex proxy, const Aabb& box);
    void move(std::span<const ProxyIndex> proxies, std::span<const Aabb> boxes);
    void remove(ProxyIndex proxy);
    const Aabb& box(ProxyIndex proxy) const;
    std::size_t size() const noexcept { return size_; }
    std::size_t bytes() const noexcept;

    // What differs from the last settle(). Constant when nothing was called since, otherwise proportional to the calls.
    const ProxyChanges& collect();

    // Takes what is here now as what the last update saw.
    void settle();

    // Numbers in use are below this.
    ProxyIndex end() const noexcept { return static_cast<ProxyIndex>(states_.size()); }

    bool is_present(ProxyIndex proxy) const noexcept { return has(proxy, present); }
    bool is_removed(ProxyIndex proxy) const noexcept { return has(proxy, removed); }

    // By proxy; of those that are not present, anything.
    const std::vector<Aabb>& boxes() const noexcept { return boxes_; }

    // The proxies that are present, ascending.
    std::vector<ProxyIndex> present_proxies() const;

    // Calls visit(proxy, box) with each of them, in that order.
    template <class Visit>
    void for_each(const Visit& visit) const {
        for (ProxyIndex proxy = 0; proxy < end(); ++proxy) {
            if (is_present(proxy)) visit(proxy, boxes_[proxy]);
        }
    }

  private:
    enum : std::uint8_t {
        present = 1,  // a box of this number is here
        settled = 2,  // and the last update saw it
        removed = 4,  // the last update saw a box of this number that is gone
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

    // By proxy.
    std::vector<std::uint8_t> states_;
    std::vector<Aabb> boxes_;
    std::vector<std::uint32_t> queued_at_;  // the turn in which it was put into queue_ last

    // Turns end with settle(). In most there are moves and nothing else, and nothing is done for each of them then.
    std::uint32_t turn_ = 1;
    bool has_moves_only_ = true;
    std::vector<ProxyIndex> queue_;  // added or moved in this turn, each once
    std::vector<ProxyIndex> moved_;  // those of them that moved, where there are others
    ProxyChanges changes_;           // `removed` is kept as it happens, the others are made by collect()
    std::size_t size_ = 0;
    std::size_t reserved_ = 0;
};

}  // namespace ecods
