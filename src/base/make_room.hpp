// Space in a vector before what must not fail.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace ecods {

// Space for `count` more, by geometric growth: vector::reserve alone may copy everything at each small step.
template <class T>
void make_room(std::vector<T>& list, std::size_t count = 1) {
    const std::size_t needed = list.size() + count;
    if (needed > list.capacity()) list.reserve(std::max({needed, 2 * list.capacity(), std::size_t{8}}));
}

}  // namespace ecods
