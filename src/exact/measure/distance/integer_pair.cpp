#include "exact/measure/distance/integer_pair.hpp"

#include "exact/measure/round/scaled_vector.hpp"
#include "exact/point/vectors.hpp"

namespace ecods::exact {

Points<6> to_doubles(const IntegerPair& pair) noexcept {
    std::array<IntegerVector, 6> vectors;
    Uint128 digits = 0;
    vectors[0] = {0, 0, 0};
    for (std::size_t i = 1; i < 6; ++i) {
        vectors[i] = difference(pair.at[i], pair.at[0]);
        digits |= digits_of(vectors[i]);
    }
    const int shift = shift_of(digits);
    Points<6> points;
    for (std::size_t i = 0; i < 6; ++i) points[i] = shifted(vectors[i], shift);
    return points;
}

std::size_t blunt_corner(const IntegerPair& pair, std::size_t side) noexcept {
    std::array<IntegerVector, 3> edges;
    Uint128 digits = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        edges[i] = difference(pair.at[3 * side + (i + 2) % 3], pair.at[3 * side + (i + 1) % 3]);
        digits |= digits_of(edges[i]);
    }
    const int shift = shift_of(digits);
    std::array<double, 3> squares;
    for (std::size_t i = 0; i < 3; ++i) {
        const Point x = shifted(edges[i], shift);
        squares[i] = dot(x, x);
    }
    return greatest_of(squares[0], squares[1], squares[2]);
}

}  // namespace ecods::exact
