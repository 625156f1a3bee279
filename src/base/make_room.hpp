// Space in vectors is reserved before an operation that must not fail, and given back afterwards.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <new>
#include <type_traits>
#include <vector>

namespace ecods {

// Reserves space for `count` more elements by geometric growth: vector::reserve alone may copy everything at each small
// step. Growth by a quarter copies an element four times on average and leaves at most a fifth of the space unused.
template <class T>
void make_room(std::vector<T>& list, std::size_t count = 1) {
    const std::size_t needed = list.size() + count, grown = list.capacity() + list.capacity() / 4;
    if (needed > list.capacity()) list.reserve(std::max({needed, grown, std::size_t{8}}));
}

// Resizes the list, and grows its space like make_room.
template <class T>
void grow_to(std::vector<T>& list, std::size_t size) {
    if (size > list.size()) make_room(list, size - list.size());
    list.resize(size);
}

// Gives back unused space if it is more than a sixteenth of the list, but keeps space for `reserved` elements. Keeps
// all space if memory for a copy is lacking.
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
