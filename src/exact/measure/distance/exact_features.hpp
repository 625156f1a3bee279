// Whether two features of two triangles hold closest points, and how far these are from each other, in integers.
//
// Points x of the first triangle and y of the second, n = y - x not zero, are closest if and only if no corner of the
// first triangle is beyond x along n, and none of the second before y: the product with n is a linear function, and
// a triangle is the hull of its corners. So a pair of features is decided by a handful of signs: that the foot is in
// the features, and that no other corner is on the wrong side. All may be zero: other features then hold points that
// are as close, and these are closest all the same.
//
// Disjoint triangles always have such features, and triangles that meet have none but those at distance zero. Let x and
// y be closest. If each is in the relative interior of an edge or face of which the other's is parallel, both can be
// moved along it by the same vector, until one is at the end of its edge or on the border of its face. What remains are
// a vertex and anything, and two edges that are not parallel.
//
// Widths. Let differences of coordinates be below 2^k. Below, the exponent counts twice what a sum of several products
// needs: products of two differences 2k, and one or two bits more for a sum of two or three.
//     w.u, u.u           2k + 2       w x u, u x v        2k + 1
//     n.w                3k + 3       n.n, (w x v).n      4k + 4
//     (u.u) w - (w.u) u  3k + 3       its product with a difference  4k + 5
//     numerators: w.w 2k + 2; (w x u)^2 4k + 4; (n.w)^2 6k + 6; denominators u.u, n.n
// Integers of two's complement need one bit more for the sign.
#pragma once

#include <array>
#include <cstdint>

#include "exact/measure/distance/feature_pair.hpp"
#include "exact/measure/round/limb_vectors.hpp"
#include "exact/measure/round/squared_distance.hpp"
#include "exact/number/limbs.hpp"

namespace ecods::exact {

// What a pair of features is to the closest points.
enum class Standing : std::uint8_t {
    none,    // it does not hold any
    border,  // it holds two on the border of a feature, which are in features of lower dimension
    inside,  // it holds two inside both features; others may be as close
    only,    // it holds the only two, inside both features
};

template <int L>
class ExactFeatures {
  public:
    // Of coordinates with their sign.
    static constexpr int coordinate_bits = 64 * L - 3;
    using Point = std::array<Limbs<L>, 3>;

    explicit ExactFeatures(const std::array<Point, 6>& points) noexcept : points_(points) {}

    Standing standing(const FeaturePair& f) const noexcept {
        switch (f.kind) {
            case FeatureKind::vertex_vertex:
                return of_vertices(f);
            case FeatureKind::vertex_edge:
                return of_vertex_and_edge(f);
            case FeatureKind::vertex_face:
                return of_vertex_and_face(f);
            default:
                return of_edges(f);
        }
    }

    // Calls use(v, is_turned) with a vector along which the closest points of the features are apart, from the first
    // triangle to the second, or from the second to the first where it is turned. Not where they meet.
    template <class Use>
    auto with_direction(const FeaturePair& f, Use&& use) const;

    // Whether the features have one point in common, being vertices or not parallel: `inside` both, or on the border of
    // one; `none` otherwise.
    Standing meeting(const FeaturePair& f) const noexcept;

    // The squared distance of features that hold closest points; `exponent` is left alone.
    void measure(const FeaturePair& f, SquaredDistance& result) const noexcept;

    using Vector = LimbVector<L>;

    // A corner, counted from where all are.
    Vector position(std::size_t side, std::size_t i) const noexcept { return difference<L>(corner(side, i), Point{}); }
    // Corner i + to less corner i.
    Vector from(std::size_t side, std::size_t i, std::size_t to) const noexcept {
        return difference<L>(corner(side, i + to), corner(side, i));
    }
    // Of a face, or at right angles to two edges.
    LimbVector<2 * L> normal(const FeaturePair& f) const noexcept {
        if (f.kind == FeatureKind::edge_edge) return cross<L>(from(0, f.a, 1), from(1, f.b, 1));
        const std::size_t of = 1 - f.vertex_side;
        return cross<L>(from(of, 0, 1), from(of, 0, 2));
    }
    // The corner of the second triangle that a feature is named by, less that of the first.
    Vector between(const FeaturePair& f) const noexcept { return difference<L>(corner(1, f.b), corner(0, f.a)); }

  private:
    static constexpr int k = coordinate_bits + 1;
    static_assert(2 * k + 2 < 64 * (2 * L));
    static_assert(3 * k + 3 < 64 * (3 * L));
    static_assert(4 * k + 5 < 64 * (4 * L));
    static_assert(6 * k + 6 <= 64 * (6 * L));

    // A conjunction of weak signs, which knows whether all of them were strict.
    struct Signs {
        bool hold = true;
        bool are_strict = true;
        void positive(int sign) noexcept {
            hold &= sign >= 0;
            are_strict &= sign > 0;
        }
    };

    const Point& corner(std::size_t side, std::size_t i) const noexcept { return points_[3 * side + i % 3]; }

    // n points from the first triangle to the second, or the other way where `turned`. Of `side`, corner i + to.
    template <int M>
    void outward(Signs& signs, const LimbVector<M>& n, bool turned, std::size_t side, std::size_t i,
                 std::size_t to) const noexcept {
        if (!signs.hold) return;
        const int s = sign<M + L>(dot<M, L>(n, from(side, i, to)));
        signs.positive((side == 0) != turned ? -s : s);
    }

    // (u.u) w - (w.u) u
    static LimbVector<3 * L> across_edge(const Vector& w, const Vector& u, const Magnitude<2 * L>& uu,
                                         const Magnitude<2 * L>& wu) noexcept {
        LimbVector<3 * L> n;
        for (std::size_t i = 0; i < 3; ++i) {
            Limbs<3 * L> sum{};
            add_product<L, 2 * L>(sum, w[i], uu);
            add_product<L, 2 * L>(sum, u[i], wu, all_ones);
            n[i] = magnitude<3 * L>(sum);
        }
        return n;
    }

    // Whether the foot of a vertex is on an edge or a face, or the feet of two edges on each other. n is the normal, nn
    // its square; of an edge, `uu` is its square and `along` its product with the vertex less its beginning.
    Signs foot_on_edge(const Magnitude<2 * L>& uu, const Magnitude<2 * L>& along) const noexcept;
    Signs foot_on_face(const FeaturePair& f, const LimbVector<2 * L>& n, const Magnitude<4 * L>& nn) const noexcept;
    Signs feet_on_edges(const FeaturePair& f, const LimbVector<2 * L>& n, const Magnitude<4 * L>& nn) const noexcept;

    static Standing standing(const Signs& inside, const Signs& outside) noexcept {
        if (!inside.hold || !outside.hold) return Standing::none;
        if (!inside.are_strict) return Standing::border;
        return outside.are_strict ? Standing::only : Standing::inside;
    }

    Standing of_vertices(const FeaturePair& f) const noexcept;
    Standing of_vertex_and_edge(const FeaturePair& f) const noexcept;
    Standing of_vertex_and_face(const FeaturePair& f) const noexcept;
    Standing of_edges(const FeaturePair& f) const noexcept;

    const std::array<Point, 6>& points_;
};

template <int L>
Standing ExactFeatures<L>::of_vertices(const FeaturePair& f) const noexcept {
    const Vector w = between(f);
    Signs outside;
    for (std::size_t to = 1; to < 3; ++to) {
        outward<L>(outside, w, false, 0, f.a, to);
        outward<L>(outside, w, false, 1, f.b, to);
    }
    return standing(Signs{}, outside);
}

template <int L>
Standing ExactFeatures<L>::of_vertex_and_edge(const FeaturePair& f) const noexcept {
    const std::size_t side = f.vertex_side, of = 1 - side;
    const std::size_t vertex = f.corner(side), edge = f.corner(of);
    const Vector w = between(f), u = from(of, edge, 1);
    const auto uu = dot<L, L>(u, u);
    const auto wu = dot<L, L>(w, u);
    if (is_zero<2 * L>(uu.limbs)) return Standing::none;
    // The product of u with the vertex less the edge's beginning.
    const Magnitude<2 * L> along = of == 1 ? negated<2 * L>(wu) : wu;
    const Signs inside = foot_on_edge(uu, along);
    if (!inside.hold) return Standing::none;
    const LimbVector<3 * L> n = across_edge(w, u, uu, wu);
    Signs outside;
    outward<3 * L>(outside, n, false, side, vertex, 1);
    outward<3 * L>(outside, n, false, side, vertex, 2);
    outward<3 * L>(outside, n, false, of, edge, 2);
    return standing(inside, outside);
}

template <int L>
Standing ExactFeatures<L>::of_vertex_and_face(const FeaturePair& f) const noexcept {
    const std::size_t side = f.vertex_side, vertex = f.corner(side);
    const LimbVector<2 * L> n = normal(f);
    const Magnitude<4 * L> nn = dot<2 * L, 2 * L>(n, n);
    if (is_zero<4 * L>(nn.limbs)) return Standing::none;
    // The face is at right angles to the gap: only the other corners of the vertex's triangle can be on the wrong side.
    // At height zero the points are one.
    const int gap = sign<3 * L>(dot<2 * L, L>(n, between(f)));
    Signs outside;
    if (gap != 0) {
        const bool turned = gap < 0;
        outward<2 * L>(outside, n, turned, side, vertex, 1);
        outward<2 * L>(outside, n, turned, side, vertex, 2);
        if (!outside.hold) return Standing::none;
    }
    return standing(foot_on_face(f, n, nn), outside);
}

template <int L>
Standing ExactFeatures<L>::of_edges(const FeaturePair& f) const noexcept {
    const LimbVector<2 * L> n = normal(f);
    const Magnitude<4 * L> nn = dot<2 * L, 2 * L>(n, n);
    if (is_zero<4 * L>(nn.limbs)) return Standing::none;
    const int gap = sign<3 * L>(dot<2 * L, L>(n, between(f)));
    Signs outside;
    if (gap != 0) {
        outward<2 * L>(outside, n, gap < 0, 0, f.a, 2);
        outward<2 * L>(outside, n, gap < 0, 1, f.b, 2);
        if (!outside.hold) return Standing::none;
    }
    return standing(feet_on_edges(f, n, nn), outside);
}

template <int L>
auto ExactFeatures<L>::foot_on_edge(const Magnitude<2 * L>& uu, const Magnitude<2 * L>& along) const noexcept -> Signs {
    Signs inside;
    inside.positive(sign<2 * L>(along));
    inside.positive(sign<2 * L>(minus<2 * L>(uu, along)));
    return inside;
}

template <int L>
auto ExactFeatures<L>::foot_on_face(const FeaturePair& f, const LimbVector<2 * L>& n,
                                    const Magnitude<4 * L>& nn) const noexcept -> Signs {
    const std::size_t side = f.vertex_side, of = 1 - side;
    const Vector u = from(of, 0, 1), v = from(of, 0, 2);
    const Vector foot = difference<L>(corner(side, f.corner(side)), corner(of, 0));
    const auto s = dot<2 * L, 2 * L>(cross<L>(foot, v), n);
    const auto t = dot<2 * L, 2 * L>(cross<L>(u, foot), n);
    Signs inside;
    inside.positive(sign<4 * L>(s));
    inside.positive(sign<4 * L>(t));
    inside.positive(sign<4 * L>(minus<4 * L>(minus<4 * L>(nn, s), t)));
    return inside;
}

template <int L>
auto ExactFeatures<L>::feet_on_edges(const FeaturePair& f, const LimbVector<2 * L>& n,
                                     const Magnitude<4 * L>& nn) const noexcept -> Signs {
    const Vector w = between(f), u = from(0, f.a, 1), v = from(1, f.b, 1);
    const auto s = dot<2 * L, 2 * L>(cross<L>(w, v), n);
    const auto t = dot<2 * L, 2 * L>(cross<L>(w, u), n);
    Signs inside;
    inside.positive(sign<4 * L>(s));
    inside.positive(sign<4 * L>(t));
    inside.positive(sign<4 * L>(minus<4 * L>(nn, s)));
    inside.positive(sign<4 * L>(minus<4 * L>(nn, t)));
    return inside;
}

template <int L>
Standing ExactFeatures<L>::meeting(const FeaturePair& f) const noexcept {
    const Vector w = between(f);
    const auto of = [](const Signs& signs) {
        return !signs.hold ? Standing::none : signs.are_strict ? Standing::inside : Standing::border;
    };
    if (f.kind == FeatureKind::vertex_vertex) {
        return is_zero<2 * L>(dot<L, L>(w, w).limbs) ? Standing::inside : Standing::none;
    }
    if (f.kind == FeatureKind::vertex_edge) {
        const std::size_t edge_of = 1 - f.vertex_side;
        const Vector u = from(edge_of, f.corner(edge_of), 1);
        const auto uu = dot<L, L>(u, u);
        const auto wu = dot<L, L>(w, u);
        if (is_zero<2 * L>(uu.limbs) || !is_parallel<L>(w, u)) return Standing::none;
        return of(foot_on_edge(uu, edge_of == 1 ? negated<2 * L>(wu) : wu));
    }
    const LimbVector<2 * L> n = normal(f);
    if (!is_zero<3 * L>(dot<2 * L, L>(n, w).limbs)) return Standing::none;
    const Magnitude<4 * L> nn = dot<2 * L, 2 * L>(n, n);
    if (is_zero<4 * L>(nn.limbs)) return Standing::none;
    return of(f.kind == FeatureKind::vertex_face ? foot_on_face(f, n, nn) : feet_on_edges(f, n, nn));
}

template <int L>
template <class Use>
auto ExactFeatures<L>::with_direction(const FeaturePair& f, Use&& use) const {
    const Vector w = between(f);
    if (f.kind == FeatureKind::vertex_vertex) return use(w, false);
    if (f.kind == FeatureKind::vertex_edge) {
        const Vector u = from(1 - f.vertex_side, f.corner(1 - f.vertex_side), 1);
        return use(across_edge(w, u, dot<L, L>(u, u), dot<L, L>(w, u)), false);
    }
    const LimbVector<2 * L> n = normal(f);
    return use(n, sign<3 * L>(dot<2 * L, L>(n, w)) < 0);
}

template <int L>
void ExactFeatures<L>::measure(const FeaturePair& f, SquaredDistance& result) const noexcept {
    const Vector w = between(f);
    if (f.kind == FeatureKind::vertex_vertex) {
        result.num.assign(dot<L, L>(w, w).limbs);
        result.den = Natural<denominator_limbs>(1);
    } else if (f.kind == FeatureKind::vertex_edge) {
        const Vector u = from(1 - f.vertex_side, f.corner(1 - f.vertex_side), 1);
        const LimbVector<2 * L> c = cross<L>(w, u);
        result.num.assign(dot<2 * L, 2 * L>(c, c).limbs);
        result.den.assign(dot<L, L>(u, u).limbs);
    } else {
        const LimbVector<2 * L> n = normal(f);
        const Magnitude<3 * L> height = dot<2 * L, L>(n, w);
        result.num.assign(multiply<3 * L, 3 * L>(height.limbs, height.limbs));
        result.den.assign(dot<2 * L, 2 * L>(n, n).limbs);
    }
}

}  // namespace ecods::exact
