#include "broad_phase/changes/proxy_table.hpp"

#include <algorithm>
#include <cstdint>
#include <string>

#include "base/bytes_of.hpp"
#include "base/make_room.hpp"
#include "base/misuse.hpp"
#include "simd/vec.hpp"

namespace ecods {
namespace {

// Returns true if both boxes have the same bits. Compares bits, not numbers, since a move from 0.0 to -0.0 changes the
// result of box(), though it changes no pair.
ECODS_ALWAYS_INLINE bool is_same(const Aabb& a, const Aabb& b) {
    using Two = Vec<std::int64_t, 2>;
    static_assert(sizeof(Aabb) == 3 * sizeof(Two));
    const auto* x = reinterpret_cast<const std::int64_t*>(a.min.data());  // read as vectors, which may alias
    const auto* y = reinterpret_cast<const std::int64_t*>(b.min.data());
    const auto different = [&](int k) -> Two { return load_anywhere<Two>(x + 2 * k) ^ load_anywhere<Two>(y + 2 * k); };
    return any_bits(different(0) | different(1) | different(2)) == 0;
}

}  // namespace

void ProxyTable::refuse_absent(ProxyIndex proxy) {
    throw_misuse(Error("proxy " + std::to_string(proxy) + " is not present"));
}

void ProxyTable::reserve(std::size_t count) {
    reserved_ = count;
    states_.reserve(count);
    boxes_.reserve(count);
    queued_at_.reserve(count);
    queue_.reserve(count);
}

void ProxyTable::add(ProxyIndex proxy, const Aabb& box) {
    if (is_present(proxy)) throw_misuse(Error("proxy " + std::to_string(proxy) + " is present already"));
    if (proxy >= limit) throw_misuse(Error("proxy " + std::to_string(proxy) + " is out of range"));
    // NOLINTNEXTLINE(performance-unnecessary-copy-initialization): `box` may be one of boxes_, which growing frees.
    const Aabb added = box;
    if (proxy >= end()) {
        const std::size_t count = std::size_t{proxy} + 1;
        grow_to(boxes_, count);
        grow_to(queued_at_, count);
        grow_to(states_, count);  // last: if memory runs out earlier, end() is unchanged
    }
    enqueue(proxy);
    has_moves_only_ = false;
    states_[proxy] |= present;
    boxes_[proxy] = added;
    ++size_;
}

void ProxyTable::move(ProxyIndex proxy, const Aabb& box) {
    if (!is_present(proxy)) [[unlikely]] {
        require_present(proxy);
        return;
    }
    Aabb& current = boxes_[proxy];
    if (is_same(current, box)) return;
    enqueue(proxy);
    current = box;
}

void ProxyTable::move(std::span<const ProxyIndex> proxies, std::span<const Aabb> boxes) {
    if (proxies.size() != boxes.size()) {
        throw_misuse(
            Error(std::to_string(proxies.size()) + " proxies, and " + std::to_string(boxes.size()) + " boxes"));
    }
    for (const ProxyIndex proxy : proxies) require_present(proxy);
    make_room(queue_, proxies.size());
    // Nothing below throws.
    constexpr std::size_t ahead = 8;
    for (std::size_t i = 0; i < proxies.size(); ++i) {
        if (i + ahead < proxies.size()) __builtin_prefetch(&boxes_[proxies[i + ahead]], 1);
        Aabb& current = boxes_[proxies[i]];
        if (is_same(current, boxes[i])) continue;
        enqueue(proxies[i]);
        current = boxes[i];
    }
}

void ProxyTable::remove(ProxyIndex proxy) {
    require_present(proxy);
    if (has(proxy, settled)) {
        changes_.removed.push_back(proxy);
        states_[proxy] |= removed;
    }
    states_[proxy] &= static_cast<std::uint8_t>(~(present | settled));
    --size_;
    has_moves_only_ = false;
}

const Aabb& ProxyTable::box(ProxyIndex proxy) const {
    require_present(proxy);
    return boxes_[proxy];
}

std::vector<ProxyIndex> ProxyTable::present_proxies() const {
    std::vector<ProxyIndex> proxies;
    proxies.reserve(size_);
    for_each([&](ProxyIndex proxy, const Aabb&) { proxies.push_back(proxy); });
    return proxies;
}

std::size_t ProxyTable::bytes() const noexcept {
    return bytes_of(states_, boxes_, queued_at_, queue_, moved_, changes_.added, changes_.removed);
}

const ProxyChanges& ProxyTable::collect() {
    changes_.added.clear();
    changes_.moved = queue_;
    if (has_moves_only_) return changes_;
    moved_.clear();
    for (const ProxyIndex proxy : queue_) {
        const unsigned state = states_[proxy] & (present | settled);
        if (state == (present | settled)) {
            moved_.push_back(proxy);
        } else if (state == present) {
            changes_.added.push_back(proxy);
        }
    }
    changes_.moved = moved_;
    return changes_;
}

void ProxyTable::settle() {
    if (!has_moves_only_) {
        for (const ProxyIndex proxy : changes_.removed) states_[proxy] &= static_cast<std::uint8_t>(~removed);
        for (const ProxyIndex proxy : queue_) {
            states_[proxy] = has(proxy, present) ? present | settled : 0;
        }
        changes_.removed.clear();
        has_moves_only_ = true;
        // Frees spare memory after many boxes were added, since new boxes mostly do not move for a while. Trimming
        // takes a pass over all boxes, which is amortized over the boxes that were added.
        if (8 * changes_.added.size() > size_) {
            release(changes_.added, queue_, moved_);
            trim(states_, reserved_);
            trim(boxes_, reserved_);
            trim(queued_at_, reserved_);
        }
    }
    constexpr std::size_t few = 64;
    few* queue_.size() < queue_.capacity() ? release(queue_) : queue_.clear();
    changes_.moved = {};
    if (++turn_ == 0) {  // turn_ overflowed: old numbers of turns must not be taken for new ones
        std::fill(queued_at_.begin(), queued_at_.end(), 0);
        turn_ = 1;
    }
}

}  // namespace ecods
