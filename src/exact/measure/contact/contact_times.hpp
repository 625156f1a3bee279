// ContactTimes computes in integers the first time s at which two triangles share a point, if the first triangle is
// translated by s m for a vector m.
//
// Triangles A + s m and B share a point if and only if s m is in the Minkowski difference D = B - A. D is convex and
// closed, so these s form a closed interval [s0, s1], or none do. m is not zero, so the interval is bounded.
//
// Features that determine the ends. At s0 the triangles share a convex set; let x be a corner of it. x is in the
// relative interior of one feature of each triangle, and these two features have no other common point
// (shared_corners.hpp): one feature is a vertex, or both are edges that cross, or an edge goes through a face. The two
// features shared no point just before s0. This excludes an edge through a face. Each remaining pair shares a point
// only at s0, since features that move within one plane or line and share a point in both relative interiors do so just
// before, too. At s1 the same holds with "after" for "before". So s0 and s1 are times of such pairs. With w = y - x for
// the first corners of the two features, u and v edges and n a normal, the times are:
//     vertex and face  n.m != 0, s = n.w / n.m          edges  n = u x v, n.m != 0, s = n.w / n.m
//     vertex and edge  m x u != 0, s (m x u) = w x u    vertices  w x m = 0, s m = w
// Conversely, every time at which such a pair shares a point, borders of features included, is in the interval. Hence
// s0 and s1 are the least and the greatest of these times.
//
// Features that must be tested. `sides_` holds the signs of all determinants of m, an edge, and the difference of a
// corner of the other triangle and an end of that edge: seen along m, on which side of the edge the corner is. If all
// of them are zero, faces are parallel to m, and so are planes through two edges. Then vertices and edges determine the
// ends; if all edges are parallel to m, vertices do. If not all of them are zero, faces and pairs of edges determine
// the ends. For if D has an interior, an end of the interval is on a facet of D whose plane is not parallel to m, since
// otherwise the line would go on in D. A facet is the difference of the features of B and A that are extreme along its
// normal. It is covered by differences of a vertex and a face, and of two edges: each of its points is a corner of the
// intersection of two features in one plane (as above). If D is in a plane that is not parallel to m, that plane takes
// the place of the facet: a vertex of A in a segment B is the end of two edges of A, and at least one of these is not
// parallel to B. If D is in a plane or line parallel to m and not all determinants are zero, 0 + s m is not in D for
// any s, and no pair shares a point.
//
// Widths are derived as in exact_features.hpp. With differences below 2^k, determinants, n.w and n.m are below
// 2^(3k + 3), and the product of two below 2^(6k + 6).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "exact/measure/distance/exact_features.hpp"
#include "exact/measure/distance/feature_pair.hpp"
#include "exact/measure/round/fraction.hpp"
#include "exact/measure/round/limb_vectors.hpp"
#include "exact/number/limbs.hpp"

namespace ecods::exact {

// TranslatedPair holds two triangles and a motion: `points` are the three corners of the first triangle, which is
// translated, and then the corners of the second; `m` is the motion, which must not be zero.
template <int L>
struct TranslatedPair {
    std::array<std::array<Limbs<L>, 3>, 6> points;
    LimbVector<L> m;
};

template <int L>
class ContactTimes {
  public:
    using Vector = LimbVector<L>;
    using Time = Ratio<3 * L>;

    explicit ContactTimes(const TranslatedPair<L>& pair) noexcept : features_(pair.points), m_(pair.m) {
        const auto& points = pair.points;
        for (std::size_t side = 0; side < 2; ++side) {
            for (std::size_t i = 0; i < 3; ++i) {
                const LimbVector<2 * L> c = cross<L>(m_, features_.from(side, i, 1));
                is_parallel_[side][i] = is_zero_vector<2 * L>(c);
                all_edges_are_parallel_ &= is_parallel_[side][i];
                for (std::size_t j = 0; j < 3; ++j) {
                    const Vector w =
                        side == 0 ? difference<L>(points[3 + j], points[i]) : difference<L>(points[j], points[3 + i]);
                    const int s = sign<3 * L>(dot<2 * L, L>(c, w));
                    sides_[side][i][j] = static_cast<std::int8_t>(s);
                    all_sides_are_zero_ &= s == 0;
                }
            }
        }
    }

    // An Interval holds the times s0 and s1, of either sign, between which the triangles share a point.
    struct Interval {
        Time first, last;
    };
    // Returns all times at which the triangles share a point; nullopt if they share none at any time.
    std::optional<Interval> interval() const noexcept {
        Time least{}, greatest{};
        bool is_known = false;
        for (const FeaturePair& f : feature_pairs) {
            if (!decides(f.kind)) continue;
            Time t{};
            if (meeting(f, t) == Standing::none) continue;
            if (!is_known || compare(t, least) < 0) least = t;
            if (!is_known || compare(t, greatest) > 0) greatest = t;
            is_known = true;
        }
        return is_known ? std::optional(Interval{least, greatest}) : std::nullopt;
    }

    // Returns the first time from 0 to 1 at which the triangles share a point; nullopt if there is none.
    std::optional<Time> first() const noexcept {
        std::optional<Interval> times = interval();
        if (!times || times->last.sign() < 0) return std::nullopt;
        if (times->first.sign() < 0) times->first.num = {};
        return is_by_one(times->first) ? std::optional(times->first) : std::nullopt;
    }

    // Returns true if, seen along m, the interiors of the triangles overlap: the line through the origin along m meets
    // the relative interior of D, and no plane contains both. Then a triangle goes properly into or through the other
    // one.
    //
    // Seen along m, D is a convex polygon in the plane. The origin is inside unless all of D is on the outer side of
    // the line of one of D's sides. Each side of D is the difference of an edge of one triangle, say A, and the vertex
    // of B that is furthest out. If A's third corner is not on the line of the edge, it is on the inner side; a corner
    // of B must be there, too. If A is seen as a segment, both sides of the line are outer sides.
    bool meets_properly() const noexcept {
        if (all_edges_are_parallel_) return false;
        for (std::size_t side = 0; side < 2; ++side) {
            // `own` is the side of each edge on which the triangle's third corner lies: the sign of m x e0 . e1 = m .
            // n.
            const int own = sign<3 * L>(dot<2 * L, L>(normal_of(side), m_));
            for (std::size_t i = 0; i < 3; ++i) {
                if (is_parallel_[side][i]) continue;
                bool has_positive = false, has_negative = false;
                for (const std::int8_t s : sides_[side][i]) {
                    has_positive |= s > 0;
                    has_negative |= s < 0;
                }
                if ((own >= 0 && !has_positive) || (own <= 0 && !has_negative)) return false;
            }
        }
        return true;
    }

    // Returns true if edge `edge` of triangle `side` is in the plane of the other triangle, and this plane is parallel
    // to m. The other triangle must have an area.
    bool slides_in_plane(std::size_t side, std::size_t edge) const noexcept {
        const LimbVector<2 * L> n = normal_of(1 - side);
        if (sign<3 * L>(dot<2 * L, L>(n, m_)) != 0) return false;
        const auto is_in_plane = [&](std::size_t corner) {
            FeaturePair f{};  // this corner, and corner 0 of the other triangle
            (side == 0 ? f.a : f.b) = static_cast<decltype(f.a)>(corner);
            return sign<3 * L>(dot<2 * L, L>(n, features_.between(f))) == 0;
        };
        return is_in_plane(edge) && is_in_plane((edge + 1) % 3);
    }

    // Returns true if time <= 1. The time must not be negative.
    static bool is_by_one(const Time& time) noexcept { return compare(time.size(), 1.0) <= 0; }

    // Returns the first pair of features, in the order of feature_pairs, whose relative interiors share a point at time
    // `first`. `first` is the result of first(), and not 0.
    FeaturePair first_features(const Time& first) const noexcept {
        for (const FeaturePair& f : feature_pairs) {
            Time t{};
            if (meeting(f, t) == Standing::inside && compare(t, first) == 0) return f;
        }
        ECODS_ASSERT(false);  // excluded by the proof above
        return {};
    }

    // Returns the time at which a vertex and a face, or two edges, share a point. There must be exactly one such time.
    static Time time_of(const FeaturePair& f, const TranslatedPair<L>& pair) noexcept {
        const ExactFeatures<L> features(pair.points);
        Time time{};
        [[maybe_unused]] const bool is_set = set_height(features, pair.m, f, time);
        ECODS_ASSERT(is_set);
        return time;
    }

    // Sets `time` to the only time at which the features share a point. Returns `inside` if that point is in both
    // relative interiors, and `border` if it is on the border of a feature. Returns `none`, and `time` has no meaning,
    // if there is no such time or more than one.
    Standing meeting(const FeaturePair& f, Time& time) const noexcept {
        switch (f.kind) {
            case FeatureKind::vertex_vertex:
                return of_vertices(f, time);
            case FeatureKind::vertex_edge:
                return of_vertex_and_edge(f, time);
            case FeatureKind::vertex_face:
                return of_vertex_and_face(f, time);
            default:
                return of_edges(f, time);
        }
    }

  private:
    LimbVector<2 * L> normal_of(std::size_t side) const noexcept {
        return cross<L>(features_.from(side, 0, 1), features_.from(side, 0, 2));
    }

    static constexpr int k = ExactFeatures<L>::coordinate_bits + 1;
    static_assert(3 * k + 3 < 64 * (3 * L));
    static_assert(6 * k + 6 <= 64 * (6 * L));

    bool decides(FeatureKind kind) const noexcept {
        if (!all_sides_are_zero_) return kind == FeatureKind::vertex_face || kind == FeatureKind::edge_edge;
        return kind == (all_edges_are_parallel_ ? FeatureKind::vertex_vertex : FeatureKind::vertex_edge);
    }

    template <int M>
    static void set(const Magnitude<M>& num, const Magnitude<M>& den, Time& time) noexcept {
        time = {widened<3 * L>(num), widened<3 * L>(den)};
    }

    // Sets `time` to n.w / n.m and returns true; if n.m is zero, sets nothing and returns false.
    static bool set_height(const ExactFeatures<L>& features, const Vector& m, const FeaturePair& f,
                           Time& time) noexcept {
        const LimbVector<2 * L> n = features.normal(f);
        const Magnitude<3 * L> den = dot<2 * L, L>(n, m);
        if (is_zero<3 * L>(den.limbs)) return false;
        set(dot<2 * L, L>(n, features.between(f)), den, time);
        return true;
    }
    bool set_height(const FeaturePair& f, Time& time) const noexcept { return set_height(features_, m_, f, time); }

    // Returns the result of meeting() for a vertex and a face. Seen along m, the vertex is in the face if it is on the
    // same side of all three edges; the sum of the three determinants is n.m.
    Standing of_vertex_and_face(const FeaturePair& f, Time& time) const noexcept {
        const std::size_t face = 1 - f.vertex_side, vertex = f.corner(f.vertex_side);
        int positive = 0, negative = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            positive += sides_[face][i][vertex] > 0;
            negative += sides_[face][i][vertex] < 0;
        }
        if ((positive > 0) == (negative > 0) || !set_height(f, time)) return Standing::none;
        return positive + negative == 3 ? Standing::inside : Standing::border;
    }

    // Returns the result of meeting() for two edges. Seen along m, the edges share a point if neither edge has both
    // ends strictly on one side of the other edge.
    Standing of_edges(const FeaturePair& f, Time& time) const noexcept {
        const std::size_t i = f.a, j = f.b, i2 = (i + 1) % 3, j2 = (j + 1) % 3;
        const int b = sides_[0][i][j] * sides_[0][i][j2], a = sides_[1][j][i] * sides_[1][j][i2];
        if (a > 0 || b > 0 || !set_height(f, time)) return Standing::none;
        return a < 0 && b < 0 ? Standing::inside : Standing::border;
    }

    // Returns the result of meeting() for a vertex and an edge in a plane that is parallel to m. The vertex and the
    // edge meet at time s in the point at parameter t of the edge. Let w be the vector between the features' first
    // corners, from A to B, and u the edge. If the edge is of B, w = s m - t u, so w x m = t (m x u). If the edge is of
    // A, w = s m + t u, so w x m = -t (m x u).
    Standing of_vertex_and_edge(const FeaturePair& f, Time& time) const noexcept {
        const std::size_t edge_of = 1 - f.vertex_side;
        const std::size_t edge = f.corner(edge_of), vertex = f.corner(f.vertex_side);
        if (sides_[edge_of][edge][vertex] != 0) return Standing::none;
        const Vector w = features_.between(f), u = features_.from(edge_of, edge, 1);
        const LimbVector<2 *L> across = cross<L>(m_, u), num = cross<L>(w, u), along = cross<L>(w, m_);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (is_zero<2 * L>(across[axis].limbs)) continue;
            const int turn = sign<2 * L>(across[axis]) * (edge_of == 1 ? 1 : -1);
            const int from = sign<2 * L>(along[axis]) * turn;
            const int to =
                compare_shifted(without_leading_zeros(across[axis].limbs), 0, without_leading_zeros(along[axis].limbs));
            if (from < 0 || to < 0) return Standing::none;
            set(num[axis], across[axis], time);
            return from > 0 && to > 0 ? Standing::inside : Standing::border;
        }
        return Standing::none;
    }

    Standing of_vertices(const FeaturePair& f, Time& time) const noexcept {
        const Vector w = features_.between(f);
        if (!is_parallel<L>(w, m_)) return Standing::none;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (is_zero<L>(m_[axis].limbs)) continue;
            set(w[axis], m_[axis], time);
            return Standing::inside;
        }
        return Standing::none;
    }

    ExactFeatures<L> features_;
    Vector m_;
    // sides_[t][e][c] is the sign of the determinant of three vectors: m, edge e of triangle t, and the difference of
    // corner c of the other triangle and the beginning of that edge.
    std::int8_t sides_[2][3][3];
    bool is_parallel_[2][3];  // by triangle and edge: true if the edge is parallel to m
    bool all_sides_are_zero_ = true, all_edges_are_parallel_ = true;
};

}  // namespace ecods::exact
