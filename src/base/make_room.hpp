// Vectors reserve space before an operation that must not fail, and free unused space afterwards.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <new>
#include <type_traits>
#include <vector>

namespace ecods {

// Reserves space for `count` more elements. Capacity grows geometrically, by a quarter: an element is copied four times
// on average, and at most a fifth of the space is unused. (vector::reserve alone may copy all elements at each small
// step.)
template <class T>
void make_room(std::vector<T>& list, std::size_t count = 1) {
    const std::size_t needed = list.size() + count, grown = list.capacity() + list.capacity() / 4;
    if (needed > list.capacity()) list.reserve(std::max({needed, grown, std::size_t{8}}));
}

// Resizes the list. If the list must grow, make_room() grows its space.
template <class T>
void grow_to(std::vector<T>& list, std::size_t size) {
    if (size > list.size()) make_room(list, size - list.size());
    list.resize(size);
}

// Frees the list's unused space if it is more than a sixteenth of the list's size; keeps space for at least `reserved`
// elements. If memory for the smaller copy cannot be allocated, the list keeps all its space.
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

// Empties lists and frees their memory; assigning {} would keep it.
template <class... T>
void release(std::vector<T>&... lists) noexcept {
    (std::vector<T>().swap(lists), ...);
}

}  // namespace ecods
