// Space in vectors: made before what must not fail, and given back.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <new>
#include <type_traits>
#include <vector>

namespace ecods {

// Space for `count` more, by geometric growth: vector::reserve alone may copy everything at each small step. By a
// quarter, so that an element is copied four times on the average, and that at most a fifth is held for nothing.
template <class T>
void make_room(std::vector<T>& list, std::size_t count = 1) {
    const std::size_t needed = list.size() + count, grown = list.capacity() + list.capacity() / 4;
    if (needed > list.capacity()) list.reserve(std::max({needed, grown, std::size_t{8}}));
}

// Resizes by growth like that.
template <class T>
void grow_to(std::vector<T>& list, std::size_t size) {
    if (size > list.size()) make_room(list, size - list.size());
    list.resize(size);
}

// Gives back what is held for nothing, where that is more than a sixteenth and than `reserved` elements ask for; or
// keeps it, where memory for a copy is lacking.
template <class T>
void trim(std::vector<T>& list, std::size_t reserved) noexcept {
    static_assert(std::is_nothrow_move_constructible_v<T>);
    if (list.capacity() <= std::max(reserved, list.size() + list.size() / 16)) return;
    try {
        std::vector<T> exact;
        exact.reserve(std::max(reserved, list.size()));
        std::move(list.begin(), list.end(), std::back_inserter(exact));
        list.swap(exact);
    } catch (const std::bad_alloc&) {
    }
}

// Assigning {} would leave a vector its memory.
template <class... T>
void release(std::vector<T>&... lists) noexcept {
    (std::vector<T>().swap(lists), ...);
}

}  // namespace ecods
