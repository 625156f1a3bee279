// The neighbours of a double are computed from its bits, so they do not depend on the floating-point environment.
#pragma once

#include <bit>
#include <cstdint>

#include "base/arithmetic.hpp"

namespace ecods {

// Returns the least double above x; infinity if x is infinity. x must not be NaN.
constexpr double next_up(double x) noexcept {
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
    if (bits == 0x7ff0000000000000u) return x;
    if (bits << 1 == 0) return std::bit_cast<double>(std::uint64_t{1});
    return std::bit_cast<double>(bits >> 63 ? bits - 1 : bits + 1);
}

// Returns the greatest double below x; -infinity if x is -infinity. x must not be NaN.
constexpr double next_down(double x) noexcept {
    const auto flip = [](double y) {
        return std::bit_cast<double>(std::bit_cast<std::uint64_t>(y) ^ (std::uint64_t{1} << 63));
    };
    return flip(next_up(flip(x)));
}

}  // namespace ecods
