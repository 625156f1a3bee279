// The vectors that README.md names by formulas in the corners of two triangles, for either kind of number.
#pragma once

#include <vector>

#include "certificate.hpp"
#include "numbers.hpp"

namespace certificate_checker {

// `corner(side, k)` is corner k of a's (side 0) or b's (side 1) triangle.
template <class Number, class Corner>
Vector<Number> vector_of(const Formula& formula, const Corner& corner) {
    const std::size_t i = formula.i, j = formula.j;
    const auto edge = [&](std::size_t side, std::size_t k) { return corner(side, (k + 1) % 3) - corner(side, k); };
    const auto unit = [](std::size_t c) {
        Vector<Number> axis{};
        axis[c] = Number{1};
        return axis;
    };
    // In the plane of the edge e of one triangle and the corner p of the other, normal to e.
    const auto to_edge = [&](std::size_t side, std::size_t k, const Vector<Number>& p) {
        const Vector<Number> e = edge(side, k), w = p - corner(side, k);
        return dot(e, e) * w - dot(w, e) * e;
    };
    switch (formula.kind) {
        case Kind::na:
            return cross(edge(0, 0), edge(0, 1));
        case Kind::nb:
            return cross(edge(1, 0), edge(1, 1));
        case Kind::x:
            return cross(edge(0, i), edge(1, j));
        case Kind::ea:
            return cross(edge(0, i), unit(j));
        case Kind::eb:
            return cross(edge(1, i), unit(j));
        case Kind::c:
            return unit(i);
        case Kind::vv:
            return corner(1, j) - corner(0, i);
        case Kind::va:
            return to_edge(1, j, corner(0, i));
        case Kind::vb:
            return to_edge(0, j, corner(1, i));
        case Kind::given:
            break;
    }
    return {};
}

// The 32 formulas of which one separates two triangles whenever anything does (README.md, section 2).
inline const std::vector<Formula>& separating_formulas() {
    static const std::vector<Formula> all = [] {
        std::vector<Formula> list = {{Kind::na, 0, 0}, {Kind::nb, 0, 0}};
        for (std::uint32_t i = 0; i < 3; ++i) {
            list.push_back({Kind::c, i, 0});
            for (std::uint32_t j = 0; j < 3; ++j) {
                for (const Kind kind : {Kind::x, Kind::ea, Kind::eb}) list.push_back({kind, i, j});
            }
        }
        return list;
    }();
    return all;
}

}  // namespace certificate_checker
