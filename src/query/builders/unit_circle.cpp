#include "query/builders/unit_circle.hpp"

#include "query/builders/fixed_point.hpp"

namespace ecods::builders {
namespace {

constexpr std::int64_t quarter_pi = 0x0c90fdaa22168c23;  // pi / 4, rounded down

std::int64_t times(std::int64_t a, std::int64_t b) noexcept {
    return static_cast<std::int64_t>(multiply_fixed(a, b));
}

// Returns the sum of Taylor's series 1 - y / (f (f + 1)) + y^2 / (f (f + 1) (f + 2) (f + 3)) - ..., where y = x^2. For
// f = 1 it is the cosine of x, and for f = 2 the sine of x over x. For y <= (pi / 4)^2, the term of y^11 is below
// 2^-70.
std::int64_t series(std::int64_t y, int f) noexcept {
    std::int64_t sum = fixed_one;
    for (int k = f + 20; k >= f; k -= 2) sum = fixed_one - times(y, sum) / (k * (k + 1));
    return sum;
}

}  // namespace

std::array<std::int64_t, 2> on_circle(std::uint32_t k, std::uint32_t n) noexcept {
    const std::uint64_t eighths = 8 * std::uint64_t{k};
    const std::uint64_t octant = eighths / n, rest = eighths % n;
    // from_axis is the angle from the nearest axis, in units of 2 pi / (8 n); it is at most pi / 4.
    const std::uint64_t from_axis = octant % 2 == 0 ? rest : n - rest;
    const auto x = static_cast<std::int64_t>(exact::Int128{quarter_pi} * from_axis / n);
    const std::int64_t y = times(x, x), c = series(y, 1), s = times(x, series(y, 2));
    switch (octant) {
        case 0:
            return {c, s};
        case 1:
            return {s, c};
        case 2:
            return {-s, c};
        case 3:
            return {-c, s};
        case 4:
            return {-c, -s};
        case 5:
            return {-s, -c};
        case 6:
            return {s, -c};
        default:
            return {c, -s};
    }
}

}  // namespace ecods::builders
