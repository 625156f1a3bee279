// An AxisFormula defines an axis by a formula in the corners of two triangles, one of body a and one of body b (FORMULA
// in verify/certificates/README.md).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "ecods/pose.hpp"
#include "query/certificate/exact_points.hpp"

namespace ecods {

struct AxisFormula {
    enum class Kind : std::uint8_t {
        normal_a,
        normal_b,
        edges,          // a's edge i  x  b's edge j
        edge_a,         // a's edge i  x  coordinate axis j
        edge_b,         // b's edge i  x  coordinate axis j
        coordinate,     // coordinate axis i
        vertices,       // b's corner j - a's corner i
        vertex_a_edge,  // from b's edge j to a's corner i, perpendicular to the edge
        vertex_b_edge,  // from a's edge j to b's corner i, perpendicular to the edge
    };

    Kind kind = Kind::normal_a;
    std::uint8_t i = 0;
    std::uint8_t j = 0;

    friend bool operator==(const AxisFormula&, const AxisFormula&) = default;
};

// Corners holds the corners of a triangle of body a, then the corners of a triangle of body b. The corners are exact if
// Vector has integers, and rounded if Vector has doubles.
template <class Vector>
using Corners = std::array<Vector, 6>;
using SixCorners = Corners<exact::LongVector>;

inline Vec3 minus(const Vec3& a, const Vec3& b) {
    return a - b;
}
inline Vec3 cross(const Vec3& a, const Vec3& b) {
    return a.cross(b);
}
inline double dot(const Vec3& a, const Vec3& b) {
    return a.dot(b);
}

template <class Vector>
Vector vector_of(const AxisFormula& f, const Corners<Vector>& corners) {
    using Kind = AxisFormula::Kind;
    using Number = std::remove_cvref_t<decltype(corners[0][0])>;
    const Vector *a = &corners[0], *b = &corners[3];
    const auto edge = [](const Vector* of, std::size_t i) -> Vector { return minus(of[(i + 1) % 3], of[i]); };
    const auto normal = [](const Vector* of) -> Vector { return cross(minus(of[1], of[0]), minus(of[2], of[0])); };
    const auto unit = [](std::size_t k) -> Vector {
        return {Number(std::int64_t{k == 0}), Number(std::int64_t{k == 1}), Number(std::int64_t{k == 2})};
    };
    // Returns (e . e) w - (w . e) e: the part of w that is perpendicular to e, multiplied by e . e.
    const auto across = [](const Vector& w, const Vector& e) -> Vector {
        const Number ee = dot(e, e), we = dot(w, e);
        return {ee * w[0] - we * e[0], ee * w[1] - we * e[1], ee * w[2] - we * e[2]};
    };
    switch (f.kind) {
        case Kind::normal_a:
            return normal(a);
        case Kind::normal_b:
            return normal(b);
        case Kind::edges:
            return cross(edge(a, f.i), edge(b, f.j));
        case Kind::edge_a:
            return cross(edge(a, f.i), unit(f.j));
        case Kind::edge_b:
            return cross(edge(b, f.i), unit(f.j));
        case Kind::coordinate:
            return unit(f.i);
        case Kind::vertices:
            return minus(b[f.j], a[f.i]);
        case Kind::vertex_a_edge:
            return across(minus(a[f.i], b[f.j]), edge(b, f.j));
        case Kind::vertex_b_edge:
            break;
    }
    return across(minus(b[f.i], a[f.j]), edge(a, f.j));
}

}  // namespace ecods
