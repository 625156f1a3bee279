// find_crossing() computes in fixed precision the parameter at which an edge crosses another one, in a plane of two
// coordinates.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "exact/measure/round/fixed_vector.hpp"

namespace ecods::exact {

// A FixedParameter is a parameter along an edge, 0 at its beginning and 1 at its end, in units of 2^-digits.
struct FixedParameter {
    static constexpr int digits = 105;

    // Returns u times this parameter. |u| must be below 2^122, and is off by at most `error`, below 2^20.
    FixedNumber times(Int128 u, std::uint64_t error) const noexcept;

    Int128 value = 0;
    std::uint64_t error = 0;
};

// Returns the parameter on u at which the edges p + s u and q + r v cross, where 0 <= s <= 1 is known. d is q - p,
// below 2^123 and off by less than 2^60; coordinates of u and v are as in FixedParameter. Returns nullopt if the
// parameter may be far off, as for edges that are nearly parallel.
std::optional<FixedParameter> find_crossing(const std::array<FixedNumber, 2>& d, const std::array<Int128, 2>& u,
                                            const std::array<Int128, 2>& v, std::uint64_t error) noexcept;

}  // namespace ecods::exact
