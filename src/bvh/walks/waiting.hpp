// Waiting is a priority queue of items that wait to be visited.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

#include "simd/inline.hpp"

namespace ecods {

// Waiting is a binary heap with the first item at the front. Order()(a, b) returns true if a comes before b; since its
// result is unpredictable, it is best written without branches. All functions are inlined, so that walks can be
// compiled for an instruction set.
template <class Item, class Order = std::less<Item>>
class Waiting {
  public:
    explicit Waiting(std::size_t capacity = 0) { items_.reserve(capacity); }

    void clear() noexcept { items_.clear(); }
    bool is_empty() const noexcept { return items_.empty(); }
    const Item& front() const noexcept { return items_.front(); }

    ECODS_ALWAYS_INLINE void push(const Item& item) {
        std::size_t at = items_.size();
        items_.push_back(item);
        for (; at > 0 && comes_first(item, items_[(at - 1) / 2]); at = (at - 1) / 2) items_[at] = items_[(at - 1) / 2];
        items_[at] = item;
    }
    ECODS_ALWAYS_INLINE Item pop() noexcept {
        const Item first = items_.front(), last = items_.back();
        items_.pop_back();
        if (!items_.empty()) replace_front(last);
        return first;
    }
    ECODS_ALWAYS_INLINE void replace_front(const Item& item) noexcept {
        Item* const items = items_.data();
        const std::size_t size = items_.size();
        std::size_t at = 0;
        for (std::size_t child = 1; child < size; child = 2 * at + 1) {
            child += static_cast<std::size_t>((child + 1 < size) &
                                              comes_first(items[std::min(child + 1, size - 1)], items[child]));
            if (!comes_first(items[child], item)) break;
            items[at] = items[child];
            at = child;
        }
        items[at] = item;
    }

  private:
    ECODS_ALWAYS_INLINE static bool comes_first(const Item& a, const Item& b) noexcept { return Order()(a, b); }

    std::vector<Item> items_;
};

}  // namespace ecods
