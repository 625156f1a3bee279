// Computes points of the unit circle.
#pragma once

#include <array>
#include <cstdint>

namespace ecods::builders {

// Returns the cosine and the sine of 2 pi k / n in fixed point, for k < n < 2^32, within a few units. Points that are
// mirror images in an axis or a diagonal have the same digits.
std::array<std::int64_t, 2> on_circle(std::uint32_t k, std::uint32_t n) noexcept;

}  // namespace ecods::builders
