// Numbers that are not finite are found by their bits, so the result does not depend on the floating-point environment.
#pragma once

#include <bit>
#include <cstdint>
#include <optional>

#include "base/double_key.hpp"
#include "ecods/pose.hpp"
#include "ecods/primitives.hpp"
#include "simd/vec.hpp"

namespace ecods {

constexpr bool is_finite(double x) noexcept {
    constexpr std::uint64_t exponent_mask = std::uint64_t{0x7ff} << 52;
    return (std::bit_cast<std::uint64_t>(x) & exponent_mask) != exponent_mask;
}

// Returns true if all entries of [R t] are finite. Tests two entries at a time: an exponent is all ones if and only if
// adding one to it carries into the sign bit.
inline bool is_finite(const Pose& pose) noexcept {
    using Two = Vec<std::uint64_t, 2>;
    constexpr std::uint64_t exponent_mask = std::uint64_t{0x7ff} << 52, exponent_one = std::uint64_t{1} << 52;
    Two carries{};
    const auto add_entries = [&](const double* entries, int count) {
        const auto* const bits = reinterpret_cast<const std::uint64_t*>(entries);  // vectors may alias doubles
        for (int i = 0; i < count; i += 2) carries |= (load_anywhere<Two>(bits + i) & exponent_mask) + exponent_one;
    };
    add_entries(pose.R.data(), 8);
    add_entries(pose.R.data() + 7, 2);
    add_entries(pose.t.data(), 2);
    add_entries(pose.t.data() + 1, 2);
    return (any_bits(carries) >> 63) == 0;
}

struct InvalidEntry {
    int row;
    int column;
    double value;
};

// Returns the first entry of [R t], row by row, that is not finite; nullopt if all are finite.
inline std::optional<InvalidEntry> find_invalid(const Pose& pose) {
    if (is_finite(pose)) return std::nullopt;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 4; ++column) {
            const double value = column == 3 ? pose.t[row] : pose.R(row, column);
            if (!is_finite(value)) return InvalidEntry{row, column, value};
        }
    }
    return std::nullopt;
}

// Returns true if v is zero. Looks at the bits, so a vector of subnormal numbers is not zero even if the processor
// takes them for zero.
inline bool is_zero(const Vec3& v) noexcept {
    const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
    return (bits(v[0]) | bits(v[1]) | bits(v[2])) << 1 == 0;
}

// Throws InvalidArgument if a coordinate of the vector is not finite.
void validate_motion(const Vec3& motion);

}  // namespace ecods
