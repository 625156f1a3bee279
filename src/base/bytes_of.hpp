// bytes_of returns the number of bytes that vectors have allocated.
#pragma once

#include <cstddef>
#include <vector>

namespace ecods {

template <class... Elements>
std::size_t bytes_of(const std::vector<Elements>&... lists) noexcept {
    return (std::size_t{0} + ... + (lists.capacity() * sizeof(Elements)));
}

}  // namespace ecods
