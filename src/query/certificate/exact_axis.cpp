#include "query/certificate/exact_axis.hpp"

#include <utility>

namespace ecods {

using exact::Integer;

namespace {

using Kind = AxisFormula::Kind;

constexpr std::array<AxisFormula, 32> formulas = [] {
    std::array<AxisFormula, 32> result{};
    std::size_t count = 0;
    result[count++] = {Kind::normal_a};
    result[count++] = {Kind::normal_b};
    for (const Kind kind : {Kind::edges, Kind::edge_a, Kind::edge_b}) {
        for (std::uint8_t i = 0; i < 3; ++i) {
            for (std::uint8_t j = 0; j < 3; ++j) result[count++] = {kind, i, j};
        }
    }
    for (std::uint8_t i = 0; i < 3; ++i) result[count++] = {Kind::coordinate, i};
    return result;
}();

bool is_apart(const exact::LongVector& n, const SixCorners& corners, ApartBy apart) {
    const ExactReach a = reach_of(n, &corners[0]);
    if (apart == ApartBy::half_open) {
        const Integer from = dot(n, corners[3]), to = dot(n, corners[4]);
        return (compare(a.high, from) < 0 && compare(a.high, to) <= 0) ||
               (compare(a.low, from) > 0 && compare(a.low, to) >= 0);
    }
    const ExactReach b = reach_of(n, &corners[3]);
    const int least = apart == ApartBy::weakly ? 0 : 1;
    return compare(b.low, a.high) >= least || compare(a.low, b.high) >= least;
}

}  // namespace

ExactReach reach_of(const exact::LongVector& n, const exact::LongVector* corners) {
    ExactReach reach{dot(n, corners[0]), {}};
    reach.high = reach.low;
    for (std::size_t c = 1; c < 3; ++c) {
        Integer x = dot(n, corners[c]);
        if (compare(x, reach.low) < 0) reach.low = x;
        if (compare(x, reach.high) > 0) reach.high = std::move(x);
    }
    return reach;
}

bool is_axis(const AxisFormula& formula, const SixCorners& corners, ApartBy apart) {
    const exact::LongVector n = vector_of(formula, corners);
    return !is_zero(n) && is_apart(n, corners, apart);
}

std::optional<AxisFormula> find_axis(const SixCorners& corners, ApartBy apart) {
    for (const AxisFormula& formula : formulas) {
        if (is_axis(formula, corners, apart)) return formula;
    }
    return std::nullopt;
}

}  // namespace ecods
