#include "broad_phase/proxy_table.hpp"

#include <algorithm>
#include <cstdint>
#include <string>

#include "base/inline.hpp"
#include "base/misuse.hpp"
#include "broad_phase/bytes_of.hpp"

namespace ecods {
namespace {

typedef std::int64_t Two __attribute__((vector_size(16), may_alias, aligned(8)));

// Bits, not numbers: a move from 0.0 to -0.0 changes what box() returns, and finds the same pairs again.
ECODS_ALWAYS_INLINE bool is_same(const Aabb& a, const Aabb& b) {
    static_assert(sizeof(Aabb) == 3 * sizeof(Two));
    const Two* x = reinterpret_cast<const Two*>(a.min.data());
    const Two* y = reinterpret_cast<const Two*>(b.min.data());
    const Two different = (x[0] ^ y[0]) | (x[1] ^ y[1]) | (x[2] ^ y[2]);
    return (different[0] | different[1]) == 0;
}

}  // namespace

void ProxyTable::require_present(ProxyIndex proxy) const {
    if (!is_present(proxy)) throw_misuse(Error("proxy " + std::to_string(proxy) + " is not present"));
}

void ProxyTable::enqueue(ProxyIndex proxy) {
    if (has(proxy, queued)) return;
    queue_.push_back(proxy);
    states_[proxy] |= queued;
}

void ProxyTable::reserve(std::size_t count) {
    states_.reserve(count);
    boxes_.reserve(count);
    queue_.reserve(count);
    changes_.moved.reserve(count);
}

void ProxyTable::add(ProxyIndex proxy, const Aabb& box) {
    if (is_present(proxy)) throw_misuse(Error("proxy " + std::to_string(proxy) + " is present already"));
    if (proxy >= limit) throw_misuse(Error("proxy " + std::to_string(proxy) + " is out of range"));
    if (proxy >= end()) {
        const std::size_t count = std::size_t{proxy} + 1;
        boxes_.resize(count);
        states_.resize(count);
    }
    enqueue(proxy);
    states_[proxy] |= present;
    boxes_[proxy] = box;
    ++size_;
}

void ProxyTable::move(ProxyIndex proxy, const Aabb& box) {
    if (!is_present(proxy)) [[unlikely]] {
        require_present(proxy);
        return;
    }
    Aabb& current = boxes_[proxy];
    if (is_same(current, box)) return;
    std::uint8_t& state = states_[proxy];
    if ((state & queued) == 0) {
        queue_.push_back(proxy);
        state |= queued;
    }
    current = box;
}

void ProxyTable::remove(ProxyIndex proxy) {
    require_present(proxy);
    if (has(proxy, settled)) {
        changes_.removed.push_back(proxy);
        states_[proxy] |= removed;
    }
    states_[proxy] &= static_cast<std::uint8_t>(~(present | settled));
    --size_;
}

const Aabb& ProxyTable::box(ProxyIndex proxy) const {
    require_present(proxy);
    return boxes_[proxy];
}

std::size_t ProxyTable::bytes() const noexcept {
    return bytes_of(states_, boxes_, queue_, changes_.added, changes_.moved, changes_.removed);
}

const ProxyChanges& ProxyTable::collect() {
    changes_.added.clear();
    changes_.moved.resize(queue_.size());
    ProxyIndex* moved = changes_.moved.data();
    for (const ProxyIndex proxy : queue_) {
        *moved = proxy;
        const unsigned state = states_[proxy] & (present | settled);
        if (state == (present | settled)) [[likely]] {
            ++moved;
        } else if (state == present) {
            changes_.added.push_back(proxy);
        }
    }
    changes_.moved.resize(static_cast<std::size_t>(moved - changes_.moved.data()));
    return changes_;
}

void ProxyTable::settle() {
    for (const ProxyIndex proxy : changes_.removed) states_[proxy] &= static_cast<std::uint8_t>(~removed);
    for (const ProxyIndex proxy : queue_) {
        states_[proxy] = has(proxy, present) ? present | settled : 0;
    }
    queue_.clear();
    changes_.removed.clear();
}

}  // namespace ecods
