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

// Edge i of triangle 0 or 1.
IntegerVector3 edge(const SixCorners& corners, std::size_t triangle, std::size_t i) {
    return minus(corners[3 * triangle + (i + 1) % 3], corners[3 * triangle + i]);
}

IntegerVector3 coordinate_axis(std::size_t k) {
    IntegerVector3 axis;
    axis[k] = Integer(std::int64_t{1});
    return axis;
}

// (e.e) w - (w.e) e
IntegerVector3 across(const IntegerVector3& w, const IntegerVector3& e) {
    const Integer ee = dot(e, e), we = dot(w, e);
    return {ee * w[0] - we * e[0], ee * w[1] - we * e[1], ee * w[2] - we * e[2]};
}

struct Reach {
    Integer low, high;
};

Reach reach_of(const IntegerVector3& n, const IntegerVector3* corners) {
    Reach reach{dot(n, corners[0]), {}};
    reach.high = reach.low;
    for (std::size_t c = 1; c < 3; ++c) {
        Integer x = dot(n, corners[c]);
        if (compare(x, reach.low) < 0) reach.low = x;
        if (compare(x, reach.high) > 0) reach.high = std::move(x);
    }
    return reach;
}

bool is_apart(const IntegerVector3& n, const SixCorners& corners, ApartBy apart) {
    const Reach a = reach_of(n, &corners[0]);
    if (apart == ApartBy::half_open) {
        const Integer from = dot(n, corners[3]), to = dot(n, corners[4]);
        return (compare(a.high, from) < 0 && compare(a.high, to) <= 0) ||
               (compare(a.low, from) > 0 && compare(a.low, to) >= 0);
    }
    const Reach b = reach_of(n, &corners[3]);
    const int least = apart == ApartBy::weakly ? 0 : 1;
    return compare(b.low, a.high) >= least || compare(a.low, b.high) >= least;
}

}  // namespace

IntegerVector3 normal_of(const AxisFormula& f, const SixCorners& corners) {
    switch (f.kind) {
        case Kind::normal_a:
            return cross(edge(corners, 0, 0), edge(corners, 0, 1));
        case Kind::normal_b:
            return cross(edge(corners, 1, 0), edge(corners, 1, 1));
        case Kind::edges:
            return cross(edge(corners, 0, f.i), edge(corners, 1, f.j));
        case Kind::edge_a:
            return cross(edge(corners, 0, f.i), coordinate_axis(f.j));
        case Kind::edge_b:
            return cross(edge(corners, 1, f.i), coordinate_axis(f.j));
        case Kind::coordinate:
            return coordinate_axis(f.i);
        case Kind::vertices:
            return minus(corners[3 + f.j], corners[f.i]);
        case Kind::vertex_a_edge:
            return across(minus(corners[f.i], corners[3 + f.j]), edge(corners, 1, f.j));
        case Kind::vertex_b_edge:
            return across(minus(corners[3 + f.i], corners[f.j]), edge(corners, 0, f.j));
    }
    return {};
}

bool is_axis(const AxisFormula& formula, const SixCorners& corners, ApartBy apart) {
    const IntegerVector3 n = normal_of(formula, corners);
    return !is_zero(n) && is_apart(n, corners, apart);
}

std::optional<AxisFormula> find_axis(const SixCorners& corners, ApartBy apart) {
    for (const AxisFormula& formula : formulas) {
        if (is_axis(formula, corners, apart)) return formula;
    }
    return std::nullopt;
}

}  // namespace ecods
