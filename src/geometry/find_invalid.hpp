// Finding what is not finite. The tests look at bits, so that no floating-point environment can hide a NaN.
#pragma once

#include <bit>
#include <cstdint>
#include <optional>

#include "ecods/pose.hpp"

namespace ecods {

constexpr bool is_finite(double x) noexcept {
    constexpr std::uint64_t exponent_mask = std::uint64_t{0x7ff} << 52;
    return (std::bit_cast<std::uint64_t>(x) & exponent_mask) != exponent_mask;
}

struct InvalidEntry {
    int row;
    int column;
    double value;
};

// The first entry of [R t], row by row, that is not finite.
inline std::optional<InvalidEntry> find_invalid(const Pose& pose) {
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 4; ++column) {
            const double value = column == 3 ? pose.t[row] : pose.R(row, column);
            if (!is_finite(value)) return InvalidEntry{row, column, value};
        }
    }
    return std::nullopt;
}

}  // namespace ecods
