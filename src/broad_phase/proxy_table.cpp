#include "broad_phase/proxy_table.hpp"

#include <string>

#include "base/misuse.hpp"

namespace ecods {

void ProxyTable::require_present(ProxyIndex proxy) const {
    if (!is_present(proxy)) throw_misuse(Error("proxy " + std::to_string(proxy) + " is not present"));
}

void ProxyTable::enqueue(ProxyIndex proxy) {
    if (has(proxy, queued)) return;
    queue_.push_back(proxy);
    states_[proxy] |= queued;
}

void ProxyTable::add(ProxyIndex proxy, const Aabb& box) {
    if (is_present(proxy)) throw_misuse(Error("proxy " + std::to_string(proxy) + " is present already"));
    if (proxy >= limit) throw_misuse(Error("proxy " + std::to_string(proxy) + " is out of range"));
    if (proxy >= end()) {
        const std::size_t count = std::size_t{proxy} + 1;
        now_.resize(count);
        before_.resize(count);
        boxes_.resize(count);
        states_.resize(count);
    }
    enqueue(proxy);
    states_[proxy] |= present;
    now_[proxy] = key_box(box);
    boxes_[proxy] = box;
    ++size_;
}

void ProxyTable::move(ProxyIndex proxy, const Aabb& box) {
    require_present(proxy);
    const KeyBox keys = key_box(box);
    if (!(keys == now_[proxy])) {
        enqueue(proxy);
        now_[proxy] = keys;
    }
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

const ProxyChanges& ProxyTable::collect() {
    changes_.added.clear();
    changes_.moved.clear();
    for (const ProxyIndex proxy : queue_) {
        if (is_added(proxy)) {
            changes_.added.push_back(proxy);
        } else if (is_present(proxy) && !(now_[proxy] == before_[proxy])) {
            changes_.moved.push_back(proxy);
        }
    }
    return changes_;
}

void ProxyTable::settle() {
    for (const ProxyIndex proxy : changes_.removed) states_[proxy] &= static_cast<std::uint8_t>(~removed);
    for (const ProxyIndex proxy : queue_) {
        states_[proxy] &= static_cast<std::uint8_t>(~queued);
        if (!is_present(proxy)) continue;
        states_[proxy] |= settled;
        before_[proxy] = now_[proxy];
    }
    queue_.clear();
    changes_.removed.clear();
}

}  // namespace ecods
