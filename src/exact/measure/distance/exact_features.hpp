// ExactFeatures decides in integers if two features of two triangles contain closest points, and computes their
// distance.
//
// Let x be a point of the first triangle and y of the second, with n = y - x not zero. x and y are closest if and only
// if no corner of the first triangle is beyond x along n, and no corner of the second is before y: the dot product with
// n is a linear function, and a triangle is the convex hull of its corners. So a few signs decide whether a pair of
// features contains closest points: the signs show if the feet are in the features, and if no other corner is on the
// wrong side. Any of these signs may be zero: then other features contain points that are equally close, and x and y
// are still closest.
//
// For disjoint triangles some pair of features passes this test; for triangles that meet, only pairs at distance zero
// pass. Let x and y be closest. If each is in the relative interior of an edge or face, and these two features are
// parallel to a common direction, both points can be moved along it by the same vector, until one is at the end of its
// edge or on the border of its face. The pairs that remain are a vertex and any feature, and two edges that are not
// parallel.
//
// Widths. Let differences of coordinates be below 2^k. The table has the exponents of upper bounds: a product of two
// differences has 2k, and a sum of two or three products has one or two more.
//     w.u, u.u           2k + 2       w x u, u x v        2k + 1
//     n.w                3k + 3       n.n, (w x v).n      4k + 4
//     (u.u) w - (w.u) u  3k + 3       its product with a difference  4k + 5
//     numerators: w.w 2k + 2; (w x u)^2 4k + 4; (n.w)^2 6k + 6; denominators u.u, n.n
// Integers in two's complement need one bit more for the sign.
#pragma once

#include <array>
#include <cstdint>

#include "exact/measure/distance/feature_pair.hpp"
#include "exact/measure/round/limb_vectors.hpp"
#include "exact/measure/round/squared_distance.hpp"
#include "exact/number/limbs.hpp"
#include "exact/point/pose_terms.hpp"

namespace ecods::exact {

// A Standing classifies a pair of features by the closest points x and y of the triangles that the features contain.
enum class Standing : std::uint8_t {
    none,    // it contains none
    border,  // x or y is on the border of its feature, so in a feature of lower dimension
    inside,  // x and y are each inside its own feature; other points may be equally close
    only,    // x and y are each inside its own feature; no other points are equally close
};

template <int L>
class ExactFeatures {
  public:
    // Coordinates have at most this many bits, and a sign.
    static constexpr int coordinate_bits = 64 * L - 3;
    using Point = std::array<Limbs<L>, 3>;

    explicit ExactFeatures(const std::array<Point, 6>& points) noexcept : points_(points) {}

    Standing standing(const FeaturePair& f) const noexcept {
        switch (f.kind) {
            case FeatureKind::vertex_vertex:
                return of_vertices(f);
            case FeatureKind::vertex_edge:
                return of_vertex_and_edge(f);
            default:
                return of_plane(f);
        }
    }

    // Calls use(v, is_turned), where v is parallel to the segment between the closest points of the features. v points
    // from the first triangle to the second; if is_turned, from the second to the first. The features must not meet.
    template <class Use>
    auto with_direction(const FeaturePair& f, Use&& use) const;

    // Returns `inside` if the features have exactly one common point and this point is inside both features, `border`
    // if the point is on the border of a feature, and `none` if the features do not have exactly one common point. The
    // features must not be parallel, unless one is a vertex.
    Standing meeting(const FeaturePair& f) const noexcept;

    // Sets all members of `result` except `exponent` to the squared distance of the features, which must contain
    // closest points.
    void measure(const FeaturePair& f, SquaredDistance& result) const noexcept;

    using Vector = LimbVector<L>;

    // Returns corner i of triangle `side`, relative to the origin of all points.
    Vector position(std::size_t side, std::size_t i) const noexcept { return difference<L>(corner(side, i), Point{}); }
    // Returns corner i + to minus corner i (modulo 3) of triangle `side`.
    Vector from(std::size_t side, std::size_t i, std::size_t to) const noexcept {
        return difference<L>(corner(side, i + to), corner(side, i));
    }
    // Returns the normal of the face, if f is a vertex and a face; the cross product of the edges, if f is two edges.
    LimbVector<2 * L> normal(const FeaturePair& f) const noexcept {
        if (f.kind == FeatureKind::edge_edge) return cross<L>(from(0, f.a, 1), from(1, f.b, 1));
        const std::size_t of = 1 - f.vertex_side;
        return cross<L>(from(of, 0, 1), from(of, 0, 2));
    }
    // Returns w: the corner that names the second triangle's feature minus the corner that names the first triangle's
    // feature.
    Vector between(const FeaturePair& f) const noexcept { return difference<L>(corner(1, f.b), corner(0, f.a)); }

    // The foot of a vertex on the line of an edge is the edge's beginning plus (s / den) u.
    struct FootOnEdge {
        Vector w, u;  // between(f), and the vector of the edge
        Magnitude<2 * L> s, den;
    };
    FootOnEdge foot_on_edge(const FeaturePair& f) const noexcept {
        const std::size_t of = 1 - f.vertex_side;
        FootOnEdge foot{between(f), from(of, f.corner(of), 1), {}, {}};
        const Magnitude<2 * L> along = dot<L, L>(foot.w, foot.u);
        foot.s = of == 1 ? negated<2 * L>(along) : along;
        foot.den = dot<L, L>(foot.u, foot.u);
        return foot;
    }

    // For a vertex and a face: the foot of the vertex on the face's plane is corner 0 plus (s / den) e1 + (t / den) e2,
    // where e1 and e2 are the face's edges from corner 0. For two edges: the feet of their lines on each other are at s
    // / den and t / den of the edges. `n` is normal(f).
    struct Feet {
        Magnitude<4 * L> s, t, den;
    };
    Feet feet(const FeaturePair& f, const LimbVector<2 * L>& n) const noexcept {
        const auto along = [&](const Vector& x, const Vector& y) { return dot<2 * L, 2 * L>(cross<L>(x, y), n); };
        const Magnitude<4 * L> den = dot<2 * L, 2 * L>(n, n);
        if (f.kind == FeatureKind::edge_edge) {
            const Vector w = between(f);
            return {along(w, from(1, f.b, 1)), along(w, from(0, f.a, 1)), den};
        }
        const std::size_t side = f.vertex_side, of = 1 - side;
        const Vector w = difference<L>(corner(side, f.corner(side)), corner(of, 0));
        return {along(w, from(of, 0, 2)), along(from(of, 0, 1), w), den};
    }

  private:
    static constexpr int k = coordinate_bits + 1;
    static_assert(2 * k + 2 < 64 * (2 * L));
    static_assert(3 * k + 3 < 64 * (3 * L));
    static_assert(4 * k + 5 < 64 * (4 * L));
    static_assert(6 * k + 6 <= 64 * (6 * L));

    // Signs combines signs that must be >= 0: `hold` is true if all signs are >= 0, and `are_strict` if all are > 0.
    struct Signs {
        bool hold = true;
        bool are_strict = true;
        void positive(int sign) noexcept {
            hold &= sign >= 0;
            are_strict &= sign > 0;
        }
    };

    const Point& corner(std::size_t side, std::size_t i) const noexcept { return points_[3 * side + i % 3]; }

    // Adds to `signs` the condition that corner i + to of triangle `side` is not beyond corner i along n. n points from
    // the first triangle to the second; if `turned`, from the second to the first.
    template <int M>
    void outward(Signs& signs, const LimbVector<M>& n, bool turned, std::size_t side, std::size_t i,
                 std::size_t to) const noexcept {
        if (!signs.hold) return;
        const int s = sign<M + L>(dot<M, L>(n, from(side, i, to)));
        signs.positive((side == 0) != turned ? -s : s);
    }

    // Returns (u.u) w - (w.u) u for a vertex and an edge u: the gap between the vertex and the edge's line, times u.u.
    LimbVector<3 * L> across_edge(const FeaturePair& f, const FootOnEdge& foot) const noexcept {
        const Magnitude<2 * L> along = f.vertex_side == 0 ? negated<2 * L>(foot.s) : foot.s;
        LimbVector<3 * L> n;
        for (std::size_t i = 0; i < 3; ++i) {
            Limbs<3 * L> sum{};
            add_product<L, 2 * L>(sum, foot.w[i], foot.den);
            add_product<L, 2 * L>(sum, foot.u[i], along, all_ones);
            n[i] = magnitude<3 * L>(sum);
        }
        return n;
    }

    // Return the signs that decide if the feet are inside the features.
    static Signs are_inside(const FootOnEdge& foot) noexcept {
        Signs inside;
        inside.positive(sign<2 * L>(foot.s));
        inside.positive(sign<2 * L>(minus<2 * L>(foot.den, foot.s)));
        return inside;
    }
    static Signs are_inside(FeatureKind kind, const Feet& feet) noexcept {
        const Magnitude<4 * L> rest = minus<4 * L>(feet.den, feet.s);
        Signs inside;
        inside.positive(sign<4 * L>(feet.s));
        inside.positive(sign<4 * L>(feet.t));
        if (kind == FeatureKind::edge_edge) {
            inside.positive(sign<4 * L>(rest));
            inside.positive(sign<4 * L>(minus<4 * L>(feet.den, feet.t)));
        } else {
            inside.positive(sign<4 * L>(minus<4 * L>(rest, feet.t)));
        }
        return inside;
    }

    static Standing standing(const Signs& inside, const Signs& outside) noexcept {
        if (!inside.hold || !outside.hold) return Standing::none;
        if (!inside.are_strict) return Standing::border;
        return outside.are_strict ? Standing::only : Standing::inside;
    }

    Standing of_vertices(const FeaturePair& f) const noexcept;
    Standing of_vertex_and_edge(const FeaturePair& f) const noexcept;
    Standing of_plane(const FeaturePair& f) const noexcept;

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
    const FootOnEdge foot = foot_on_edge(f);
    if (is_zero<2 * L>(foot.den.limbs)) return Standing::none;
    const Signs inside = are_inside(foot);
    if (!inside.hold) return Standing::none;
    const LimbVector<3 * L> n = across_edge(f, foot);
    Signs outside;
    outward<3 * L>(outside, n, false, side, f.corner(side), 1);
    outward<3 * L>(outside, n, false, side, f.corner(side), 2);
    outward<3 * L>(outside, n, false, of, f.corner(of), 2);
    return standing(inside, outside);
}

// Returns standing() for a vertex and a face, or for two edges. Corners of the face or the edges are in planes
// perpendicular to the gap, so these corners need no test. If the gap is zero, the two points are equal.
template <int L>
Standing ExactFeatures<L>::of_plane(const FeaturePair& f) const noexcept {
    const LimbVector<2 * L> n = normal(f);
    if (is_zero_vector<2 * L>(n)) return Standing::none;
    const int gap = sign<3 * L>(dot<2 * L, L>(n, between(f)));
    Signs outside;
    if (gap != 0) {
        const bool turned = gap < 0;
        if (f.kind == FeatureKind::edge_edge) {
            outward<2 * L>(outside, n, turned, 0, f.a, 2);
            outward<2 * L>(outside, n, turned, 1, f.b, 2);
        } else {
            outward<2 * L>(outside, n, turned, f.vertex_side, f.corner(f.vertex_side), 1);
            outward<2 * L>(outside, n, turned, f.vertex_side, f.corner(f.vertex_side), 2);
        }
        if (!outside.hold) return Standing::none;
    }
    return standing(are_inside(f.kind, feet(f, n)), outside);
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
        const FootOnEdge foot = foot_on_edge(f);
        return is_parallel<L>(w, foot.u) && !is_zero<2 * L>(foot.den.limbs) ? of(are_inside(foot)) : Standing::none;
    }
    const LimbVector<2 * L> n = normal(f);
    if (is_zero_vector<2 * L>(n) || !is_zero<3 * L>(dot<2 * L, L>(n, w).limbs)) return Standing::none;
    return of(are_inside(f.kind, feet(f, n)));
}

template <int L>
template <class Use>
auto ExactFeatures<L>::with_direction(const FeaturePair& f, Use&& use) const {
    const Vector w = between(f);
    if (f.kind == FeatureKind::vertex_vertex) return use(w, false);
    if (f.kind == FeatureKind::vertex_edge) return use(across_edge(f, foot_on_edge(f)), false);
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
        const std::size_t of = 1 - f.vertex_side;
        const Vector u = from(of, f.corner(of), 1);
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

// Instances for all numbers of limbs are compiled in exact_features.cpp.
extern template class ExactFeatures<1>;
extern template class ExactFeatures<2>;
extern template class ExactFeatures<4>;
extern template class ExactFeatures<8>;
extern template class ExactFeatures<20>;
extern template class ExactFeatures<limb_count_max>;

}  // namespace ecods::exact
