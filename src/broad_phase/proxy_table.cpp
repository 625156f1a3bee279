#include "broad_phase/proxy_table.hpp"

#include <algorithm>
#include <bit>
#include <string>

#include "base/misuse.hpp"
#include "broad_phase/bytes_of.hpp"

namespace ecods {
namespace {

// Bits, not numbers: a move from 0.0 to -0.0 changes what box() returns, and finds the same pairs again.
bool is_same(const Aabb& a, const Aabb& b) {
    std::uint64_t different = 0;
    for (int k = 0; k < 3; ++k) {
        different |= std::bit_cast<std::uint64_t>(a.min[k]) ^ std::bit_cast<std::uint64_t>(b.min[k]);
        different |= std::bit_cast<std::uint64_t>(a.max[k]) ^ std::bit_cast<std::uint64_t>(b.max[k]);
    }
    return different == 0;
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
    require_present(proxy);
    if (is_same(boxes_[proxy], box)) return;
    enqueue(proxy);
    boxes_[proxy] = box;
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
    changes_.moved.clear();
    for (const ProxyIndex proxy : queue_) {
        if (!has(proxy, present)) continue;
        (has(proxy, settled) ? changes_.moved : changes_.added).push_back(proxy);
    }
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
