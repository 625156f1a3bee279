// Vectors, and the formulas of README.md for them.
#pragma once

#include "certificate.hpp"
#include "numbers.hpp"

namespace certificate_checker {

template <class Number>
using Vector = std::array<Number, 3>;

template <class Number>
Vector<Number> operator-(const Vector<Number>& a, const Vector<Number>& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
template <class Number>
Vector<Number> operator*(const Number& s, const Vector<Number>& a) {
    return {s * a[0], s * a[1], s * a[2]};
}
template <class Number>
Number dot(const Vector<Number>& a, const Vector<Number>& b) {
    Number sum = a[0] * b[0];
    sum += a[1] * b[1];
    sum += a[2] * b[2];
    return sum;
}
template <class Number>
Vector<Number> cross(const Vector<Number>& a, const Vector<Number>& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// The limbs of the longest coordinate.
inline std::uint64_t limbs(const Vector<Integer>& v) {
    return std::max({limbs(v[0]), limbs(v[1]), limbs(v[2])});
}

// `corner(side, k)` is corner k (modulo 3) of a's (side 0) or b's (side 1) triangle.
template <class Number, class Corner>
Vector<Number> vector_of(const Formula& formula, const Corner& corner) {
    const std::size_t i = formula.i, j = formula.j;
    const auto edge = [&](std::size_t side, std::size_t k) { return corner(side, k + 1) - corner(side, k); };
    Vector<Number> x_i{}, x_j{};  // coordinate axes
    x_i[i] = x_j[j] = Number{1};
    // In the plane of edge k of one triangle and the corner p of the other, normal to the edge.
    const auto to_edge = [&](std::size_t side, std::size_t k, const Vector<Number>& p) {
        const Vector<Number> e = edge(side, k), w = p - corner(side, k);
        return dot(e, e) * w - dot(w, e) * e;
    };
    if (formula.kind == Kind::na) return cross(edge(0, 0), edge(0, 1));
    if (formula.kind == Kind::nb) return cross(edge(1, 0), edge(1, 1));
    if (formula.kind == Kind::x) return cross(edge(0, i), edge(1, j));
    if (formula.kind == Kind::ea) return cross(edge(0, i), x_j);
    if (formula.kind == Kind::eb) return cross(edge(1, i), x_j);
    if (formula.kind == Kind::vv) return corner(1, j) - corner(0, i);
    if (formula.kind == Kind::va) return to_edge(1, j, corner(0, i));
    if (formula.kind == Kind::vb) return to_edge(0, j, corner(1, i));
    return x_i;
}

// The 32 formulas of which one separates two triangles whenever anything does (README.md, section 2).
inline std::vector<Formula> separating_formulas() {
    std::vector<Formula> list = {{Kind::na}, {Kind::nb}, {Kind::c, 0}, {Kind::c, 1}, {Kind::c, 2}};
    for (std::uint32_t k = 0; k < 9; ++k) {
        for (const Kind kind : {Kind::x, Kind::ea, Kind::eb}) list.push_back({kind, k / 3, k % 3});
    }
    return list;
}

}  // namespace certificate_checker
