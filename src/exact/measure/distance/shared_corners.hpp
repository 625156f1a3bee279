// SharedCorners computes the corners of the intersection of two triangles, in integers.
//
// The intersection is convex and has at most six corners. Each of these corners is in the relative interior of one
// feature (vertex, edge or face) of each triangle, and these two features have no other common point. So each corner is
// a vertex that is in the other triangle, a point where an edge goes through the other's face, or a crossing of two
// edges. If both triangles have an area, all points of these three kinds are corners of the intersection, since the two
// features of each point have only one common point. If the intersection is a segment, a vertex of a triangle without
// area may lie between its ends.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "exact/measure/distance/closest_points.hpp"
#include "exact/measure/distance/exact_features.hpp"
#include "exact/measure/round/exact_point.hpp"
#include "exact/measure/round/limb_vectors.hpp"

namespace ecods::exact {

template <int L>
class SharedCorners {
  public:
    using Corner = WeightedPoint<L>;

    explicit SharedCorners(const ExactFeatures<L>& features) : features_(features) {
        for (std::size_t side = 0; side < 2; ++side) {
            normal_[side] = cross<L>(features.from(side, 0, 1), features.from(side, 0, 2));
            is_proper_[side] = !is_zero_vector<2 * L>(normal_[side]);
        }
        for (std::size_t side = 0; side < 2; ++side) {
            for (std::size_t i = 0; i < 3; ++i) {
                if (is_in(side, i)) add(corner_point<L>(features.position(side, i)));
                if (is_proper_[1 - side]) add_piercing(side, i);
            }
        }
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) add_crossing(i, j);
        }
        const bool is_segment = !is_proper_[0] || !is_proper_[1];
        if (is_segment && corners_.size() > 2) corners_ = {corners_.front(), corners_.back()};
    }

    // Returns each corner once, in lexicographic order of coordinates; an empty list if the triangles share no point.
    const std::vector<Corner>& corners() const noexcept { return corners_; }

    // Returns a common normal of the two features of lowest dimension that contain the relative interior of the
    // intersection, if the features define a normal. A face and a feature in its plane define the face's normal (the
    // first triangle's if both are faces). Two edges that are not parallel define their cross product. Otherwise, or if
    // the triangles share no point, returns nullopt.
    std::optional<LimbVector<2 * L>> normal() const;

  private:
    using Vector = LimbVector<L>;
    using Weight = Magnitude<4 * L>;

    bool is_in(std::size_t side, std::size_t i) const noexcept;
    std::optional<LimbVector<2 * L>> normal_at_point() const;
    bool goes_through(const FeaturePair& f) const;
    std::optional<LimbVector<2 * L>> normal_along_segment() const;
    bool is_in_edge(std::size_t side) const noexcept;
    void add_piercing(std::size_t side, std::size_t edge);
    void add_crossing(std::size_t i, std::size_t j);
    void add(const Corner& corner);
    static int compare(const Corner& a, const Corner& b) noexcept;

    const ExactFeatures<L>& features_;
    std::array<LimbVector<2 * L>, 2> normal_;
    std::array<bool, 2> is_proper_{};
    std::vector<Corner> corners_;
};

// Returns true if corner i of triangle `side` is in the other triangle.
template <int L>
bool SharedCorners<L>::is_in(std::size_t side, std::size_t i) const noexcept {
    const auto holds = [&](FeatureKind kind, std::size_t of_other) {
        return features_.meeting(vertex_and(kind, side, i, of_other)) != Standing::none;
    };
    if (is_proper_[1 - side]) return holds(FeatureKind::vertex_face, 0);
    for (std::size_t j = 0; j < 3; ++j) {
        if (holds(FeatureKind::vertex_vertex, j) || holds(FeatureKind::vertex_edge, j)) return true;
    }
    return false;
}

// Adds the point in which an edge of triangle `side` goes through the other's face, if there is one: the edge's ends
// must be strictly on both sides of the face. The point is at h0 / (h0 - h1) of the edge, where h0 and h1 are the
// heights of its ends above the face's plane.
template <int L>
void SharedCorners<L>::add_piercing(std::size_t side, std::size_t edge) {
    const std::size_t face = 1 - side;
    const LimbVector<2 * L>& n = normal_[face];
    const Vector base = features_.position(face, 0), u = features_.from(side, edge, 1);
    Vector r = features_.position(side, edge);
    for (std::size_t k = 0; k < 3; ++k) r[k] = minus<L>(r[k], base[k]);
    const Magnitude<3 *L> h0 = dot<2 * L, L>(n, r), rise = dot<2 * L, L>(n, u);
    const Magnitude<3 * L> fall = negated<3 * L>(rise);
    const int begin = sign<3 * L>(h0), end = begin * sign<3 * L>(minus<3 * L>(h0, fall));
    if (begin == 0 || end >= 0) return;
    // Computes the signs of the sides of the edge's line on which the edges of the face pass. The line misses the face
    // if both signs occur.
    int least = 1, most = -1;
    for (std::size_t i = 0; i < 3; ++i) {
        Vector x = features_.position(face, i), y = features_.position(face, i + 1);
        const Vector p = features_.position(side, edge);
        for (std::size_t k = 0; k < 3; ++k) {
            x[k] = minus<L>(x[k], p[k]);
            y[k] = minus<L>(y[k], p[k]);
        }
        const int s = sign<3 * L>(dot<2 * L, L>(cross<L>(x, y), u));
        least = std::min(least, s);
        most = std::max(most, s);
    }
    if (least < 0 && most > 0) return;
    // h0 and h0 - h1 have the same sign. Both are made positive, as denominators must be.
    Weight den = widened<4 * L>(fall), s = widened<4 * L>(h0);
    den.negative = s.negative = 0;
    add(weighted_point<L>(den, features_.position(side, edge), Weighted<L>{s, u}));
}

template <int L>
void SharedCorners<L>::add_crossing(std::size_t i, std::size_t j) {
    const FeaturePair f = pair_of(FeatureKind::edge_edge, 0, i, j);
    if (features_.meeting(f) == Standing::none) return;
    const auto feet = features_.feet(f, features_.normal(f));
    const Vector u = features_.from(0, i, 1);
    add(weighted_point<L>(feet.den, features_.position(0, i), Weighted<L>{feet.s, u}));
}

// Inserts a corner into the sorted list, unless the list contains it.
template <int L>
void SharedCorners<L>::add(const Corner& corner) {
    const auto at = std::ranges::find_if(corners_, [&](const Corner& other) { return compare(other, corner) >= 0; });
    if (at == corners_.end() || compare(*at, corner) != 0) corners_.insert(at, corner);
}

template <int L>
int SharedCorners<L>::compare(const Corner& a, const Corner& b) noexcept {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        Limbs<9 * L> sum{};
        add_signed<9 * L>(sum, multiply<5 * L, 4 * L>(a.num[axis].limbs, b.den), a.num[axis].negative);
        add_signed<9 * L>(sum, multiply<5 * L, 4 * L>(b.num[axis].limbs, a.den), ~b.num[axis].negative);
        if (const int s = sign<9 * L>(sum)) return s;
    }
    return 0;
}

template <int L>
auto SharedCorners<L>::normal() const -> std::optional<LimbVector<2 * L>> {
    if (corners_.empty()) return std::nullopt;
    if (corners_.size() == 1) return normal_at_point();
    if (corners_.size() == 2) return normal_along_segment();
    return normal_[0];
}

template <int L>
auto SharedCorners<L>::normal_at_point() const -> std::optional<LimbVector<2 * L>> {
    for (const FeaturePair& f : feature_pairs) {
        if (features_.meeting(f) != Standing::inside) continue;
        if (f.kind == FeatureKind::edge_edge) return features_.normal(f);
        if (f.kind != FeatureKind::vertex_face || goes_through(f)) return std::nullopt;
        return features_.normal(f);
    }
    return std::nullopt;  // an edge that goes through a face
}

// Returns true if a corner of one triangle is inside the other's face, and the corner's triangle has points strictly on
// both sides of the face. If the triangles share only this corner, the corner is the middle one of a triangle without
// area.
template <int L>
bool SharedCorners<L>::goes_through(const FeaturePair& f) const {
    const std::size_t side = f.vertex_side, corner = f.corner(side);
    const LimbVector<2 * L> n = features_.normal(f);
    const auto height = [&](std::size_t k) { return sign<3 * L>(dot<2 * L, L>(n, features_.from(side, corner, k))); };
    return height(1) * height(2) < 0;
}

template <int L>
auto SharedCorners<L>::normal_along_segment() const -> std::optional<LimbVector<2 * L>> {
    const bool is_in_edge_of_a = is_in_edge(0), is_in_edge_of_b = is_in_edge(1);
    if (is_in_edge_of_a == is_in_edge_of_b) return std::nullopt;
    return normal_[is_in_edge_of_a ? 1 : 0];
}

// Returns true if one edge of triangle `side` contains both corners in corners_. A corner num / den is on the line of
// an edge from p if den p - num is parallel to the edge.
template <int L>
bool SharedCorners<L>::is_in_edge(std::size_t side) const noexcept {
    const auto is_on_line = [&](const Corner& corner, std::size_t edge) {
        const Vector p = features_.position(side, edge), u = features_.from(side, edge, 1);
        LimbVector<5 * L> r;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Limbs<5 * L> sum{};
            add_product<4 * L, L>(sum, Weight{corner.den, 0}, p[axis]);
            add_signed<5 * L>(sum, corner.num[axis].limbs, ~corner.num[axis].negative);
            r[axis] = magnitude<5 * L>(sum);
        }
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
            Limbs<6 * L> sum{};
            add_product<5 * L, L>(sum, r[i], u[j]);
            add_product<5 * L, L>(sum, r[j], u[i], all_ones);
            if (!is_zero<6 * L>(sum)) return false;
        }
        return true;
    };
    for (std::size_t edge = 0; edge < 3; ++edge) {
        const Vector u = features_.from(side, edge, 1);
        if (is_zero<2 * L>(dot<L, L>(u, u).limbs)) continue;
        if (is_on_line(corners_[0], edge) && is_on_line(corners_[1], edge)) return true;
    }
    return false;
}

}  // namespace ecods::exact
