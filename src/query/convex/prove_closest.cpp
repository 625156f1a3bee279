// Proves closest features by signs of rounded points, with error bounds.
//
// In any rounding mode, one operation is off by a factor of 1 + e, |e| <= u' = 2^-52. Rounded points are off by at most
// delta on each axis. So a difference x of two points, with no coordinate larger than X, is off by at most
//     e(X) = 2 delta + u' X.
// Let vectors x, y be off by at most a, b on each axis, and their coordinates be at most X, Y. With a <= X / 16, b <= Y
// / 16 (or the bound is written out):
//     x . y         three products, each off by X b + Y a + a b, and 4 u' X Y for its rounding and those of the sums
//     x cross y     two products on each axis, off by X b + Y a + a b <= 1.04 (X b + Y a), and 3 u' X Y
//     (u.u) w - (w.u) u   six products of three factors on each axis, off by
//                   (U + a)^2 (W + b) - U^2 W <= 1.13 (2 U W a + U^2 b), and by 6 u' U^2 W for their roundings
// The factors in the code are larger by some percent, which covers the roundings of the bounds themselves.
//
// Nothing overflows: coordinates are below 2^111, products of four coordinates below 2^460. Underflow loses less than
// 2^-1022, times other factors. In its place the bounds have two factors of at least 2^-200, because delta must be at
// least 2^-200.
// Claim: verify/proofs/hull_signs.py
#include <cmath>

#include "base/arithmetic.hpp"
#include "exact/point/vectors.hpp"
#include "query/convex/closest_hulls.hpp"

namespace ecods::convex {
namespace {

using exact::cross;
using exact::dot;
using exact::largest;
using exact::minus;
using exact::negated;
using exact::times;

using exact::FeatureKind;

// A Bounded is a vector, its largest coordinate in magnitude, and a bound of its error on each axis.
struct Bounded {
    Point x;
    double size;
    double error;
};

struct BoundedNumber {
    double x;
    double error;

    bool is_positive() const noexcept { return x > error; }
};

Bounded difference(const Point& to, const Point& from, double delta) noexcept {
    const Point x = minus(to, from);
    const double size = largest(x);
    return {x, size, 2 * delta + two_u * size};
}

Bounded negated(const Bounded& a) noexcept {
    return {negated(a.x), a.size, a.error};
}

BoundedNumber dot(const Bounded& a, const Bounded& b) noexcept {
    const double products = a.size * b.error + (b.size + b.error) * a.error;
    return {convex::dot(a.x, b.x), 3.1 * products + 13 * two_u * (a.size * b.size)};
}

Bounded cross(const Bounded& a, const Bounded& b) noexcept {
    const Point x = convex::cross(a.x, b.x);
    return {x, largest(x), 2.2 * (a.size * b.error + b.size * a.error) + 7 * two_u * (a.size * b.size)};
}

BoundedNumber operator-(const BoundedNumber& a, const BoundedNumber& b) noexcept {
    const double x = a.x - b.x;
    return {x, (a.error + b.error) * (1 + 4 * two_u) + two_u * std::abs(x)};
}

// Returns (u . u) w - (w . u) u: the part of w that is perpendicular to u, multiplied by u . u.
Bounded across(const Bounded& w, const Bounded& u) noexcept {
    const double uu = convex::dot(u.x, u.x), wu = convex::dot(w.x, u.x);
    const Point x = minus(times(w.x, uu), times(u.x, wu));
    const double products = 2 * (u.size * w.size) * u.error + (u.size * u.size) * w.error;
    return {x, largest(x), 7 * products + 44 * two_u * (u.size * u.size * w.size)};
}

// Returns true if the vector's error is at most 1/16 of its size, as the bounds require.
bool is_certain(const Bounded& a) noexcept {
    return 16 * a.error <= a.size;
}

class Proof {
  public:
    Proof(PosedHulls& hulls, const HullFeatures& found) : hulls_(hulls), found_(found) {
        for (const std::size_t side : {0, 1}) {
            const auto corners = found.of_side(side);
            for (std::size_t i = 0; i < corners.size(); ++i) points_[side][i] = hulls.rounded(side, corners[i]);
        }
    }

    // Returns true if the features contain closest points. Then sets `parts` to the solids' features that are extreme
    // towards each other. A part stays empty if all other vertices of the solid were proven to be behind the feature in
    // `found`.
    bool prove(std::array<std::optional<HullFeature>, 2>& parts) {
        if (!find_direction()) return false;
        if (!prove_furthest(0, parts[0]) || !prove_furthest(1, parts[1])) return false;
        return is_inside_ || are_closest_of_triangles(hulls_, found_);
    }
    // Returns true if the closest points are certainly inside the features, not on their borders.
    bool is_inside() const noexcept { return is_inside_; }

  private:
    Bounded from(std::size_t side, std::size_t to) const noexcept {
        return difference(points_[side][to], points_[side][0], hulls_.delta());
    }

    // Checks a number that is positive if the closest point is inside a feature, and zero if it is on its border.
    // Returns false if the number is certainly negative. Clears is_inside_ unless it is certainly positive.
    bool may_hold(const BoundedNumber& x) noexcept {
        is_inside_ &= x.is_positive();
        return !(x.x < -x.error);
    }

    // Sets n_ to the direction from the first solid to the second, and returns true. Returns false if the direction is
    // not certain, or a closest point is certainly outside its feature.
    bool find_direction() noexcept {
        const Bounded w = difference(points_[1][0], points_[0][0], hulls_.delta());
        if (!is_certain(w)) return false;
        switch (found_.features.kind) {
            case FeatureKind::vertex_vertex:
                n_ = w;
                return true;
            case FeatureKind::vertex_edge:
                return find_from_edge(w);
            case FeatureKind::vertex_face:
                return find_from_face(w);
            default:
                return find_from_edges(w);
        }
    }

    bool find_from_edge(const Bounded& w) noexcept {
        const std::size_t of = 1 - found_.features.vertex_side;
        const Bounded u = from(of, 1);
        if (!is_certain(u)) return false;
        const BoundedNumber along = dot(of == 0 ? w : negated(w), u);
        n_ = across(w, u);
        if (!(n_.size > n_.error)) return false;  // otherwise the vertex may be on the edge
        return may_hold(along) && may_hold(dot(u, u) - along);
    }

    bool find_from_face(const Bounded& w) noexcept {
        const std::size_t of = 1 - found_.features.vertex_side;
        const Bounded u = from(of, 1), v = from(of, 2);
        if (!is_certain(u) || !is_certain(v)) return false;
        const Bounded foot = of == 0 ? w : negated(w);
        n_ = cross(u, v);
        const BoundedNumber s = dot(cross(foot, v), n_), t = dot(cross(u, foot), n_);
        return may_hold(s) && may_hold(t) && may_hold((dot(n_, n_) - s) - t) && turn_along(w);
    }

    bool find_from_edges(const Bounded& w) noexcept {
        const Bounded u = from(0, 1), v = from(1, 1);
        if (!is_certain(u) || !is_certain(v)) return false;
        n_ = cross(u, v);
        const BoundedNumber s = dot(cross(w, v), n_), t = dot(cross(w, u), n_), nn = dot(n_, n_);
        return may_hold(s) && may_hold(t) && may_hold(nn - s) && may_hold(nn - t) && turn_along(w);
    }

    bool turn_along(const Bounded& w) noexcept {
        const BoundedNumber gap = dot(n_, w);
        if (gap.is_positive()) return true;
        n_ = negated(n_);
        return gap.x < -gap.error;
    }

    // Returns true if no vertex of a solid is beyond its feature along n_. If a scan proves that all other vertices are
    // behind the feature, leaves `part` unset. Otherwise sets `part` to the hull's feature that contains all vertices
    // level with the feature.
    bool prove_furthest(std::size_t side, std::optional<HullFeature>& part) {
        const Bounded n = side == 0 ? n_ : negated(n_);
        if (hulls_.are_others_behind(side, n.x, n.error, found_.of_side(side))) return true;
        return prove_by_neighbors(side, n, part);
    }

    // Compares the neighbors of the feature's first vertex with this vertex. Neighbors along the feature's own edges
    // need no test. If doubles leave some of the other neighbors undecided, exact signs decide.
    bool prove_by_neighbors(std::size_t side, const Bounded& n, std::optional<HullFeature>& part) {
        const Hull& hull = hulls_.hull(side);
        const auto corners = found_.of_side(side);
        const std::uint32_t at = corners[0];
        const std::uint32_t face = corners.size() == 3 ? face_of(hull, found_.corners[side]) : SupportPoints::none;
        const std::uint32_t other = corners.size() == 2 ? corners[1] : SupportPoints::none;
        LevelEdges level;
        std::array<Hull::Neighbor, signs_at_once> open;
        std::size_t open_count = 0;
        for (const Hull::Neighbor& to : hull.neighbors_of(at)) {
            if (to.vertex == other || (face != SupportPoints::none && is_edge_of(hull, to.edge, face))) {
                level.add(to.edge);
                continue;
            }
            const Bounded d = difference(points_[side][0], hulls_.rounded(side, to.vertex), hulls_.delta());
            const BoundedNumber behind = dot(n, d);
            if (behind.is_positive()) continue;
            if (behind.x < -behind.error || open_count == signs_at_once) return false;
            open[open_count++] = to;
        }
        if (open_count > 0) {
            const auto signs = signs_beyond(hulls_, found_, side, at, {open.data(), open_count});
            for (std::size_t i = 0; i < open_count; ++i) {
                if (signs[i] > 0) return false;
                if (signs[i] == 0) level.add(open[i].edge);
            }
        }
        part = level.feature(hull, at);
        return true;
    }

    PosedHulls& hulls_;
    const HullFeatures& found_;
    std::array<std::array<Point, 3>, 2> points_;
    Bounded n_{};
    bool is_inside_ = true;
};

}  // namespace

VertexSets::VertexSets(const Simplex& simplex) noexcept {
    for (std::size_t i = 0; i < static_cast<std::size_t>(simplex.count); ++i) {
        for (const std::size_t side : {0, 1}) add(side, simplex.pairs[i][side]);
    }
}

HullFeatures::HullFeatures(const std::array<std::array<std::uint32_t, 3>, 2>& triangles,
                           const exact::FeaturePair& f) noexcept
    : features(exact::features_of_counts(f.corner_count(0), f.corner_count(1))) {
    for (const std::size_t side : {0, 1}) {
        for (std::size_t i = 0; i < 3; ++i) corners[side][i] = triangles[side][(f.corner(side) + i) % 3];
    }
}

HullFeature ClosestHulls::part(const PosedHulls& hulls, std::size_t side) const noexcept {
    if (parts[side]) return *parts[side];
    const Hull& hull = hulls.hull(side);
    const auto corners = found.of_side(side);
    switch (corners.size()) {
        case 1:
            return {Feature::Kind::vertex, corners[0]};
        case 2:
            return {Feature::Kind::edge, edge_of(hull, corners[0], corners[1])};
        default:
            return {Feature::Kind::face, face_of(hull, found.corners[side])};
    }
}

std::optional<ClosestHulls> prove_closest(PosedHulls& hulls, const Simplex& guess) {
    if (!(hulls.delta() >= 0x1p-200) || guess.count < 1 || guess.count > 3) return std::nullopt;
    const VertexSets sets(guess);
    const std::array<std::array<std::uint32_t, 3>, 2> triangles{sets.triangle(0), sets.triangle(1)};
    // A simplex names features directly if its pairs span them with no vertex too many. Otherwise, for example at
    // parallel faces, it has more vertices than the features have. Doubles then guess the closest features of the two
    // triangles.
    const bool are_features = static_cast<std::size_t>(guess.count) + 1 == sets.count[0] + sets.count[1];
    ClosestHulls result{are_features ? HullFeatures(triangles, exact::features_of_counts(sets.count[0], sets.count[1]))
                                     : guess_of_triangles(hulls, triangles),
                        {},
                        false};
    const HullFeatures& found = result.found;
    Proof proof(hulls, found);
    if (!proof.prove(result.parts)) return std::nullopt;
    result.are_only = proof.is_inside();
    for (const std::size_t side : {0, 1}) {
        const auto& part = result.parts[side];
        result.are_only &= !part || static_cast<std::size_t>(part->kind) + 1 == found.of_side(side).size();
    }
    return result;
}

// Proves that the origin is inside the tetrahedron: for every three vertices, the origin is on the same side of their
// plane as the fourth vertex.
bool prove_meeting(const PosedHulls& hulls, const Simplex& guess) noexcept {
    if (guess.count != 4 || !(hulls.delta() >= 0x1p-200)) return false;
    std::array<Bounded, 4> w;
    for (std::size_t i = 0; i < 4; ++i) {
        const double size = largest(guess.points[i]);
        w[i] = {guess.points[i], size, 2 * hulls.delta() + two_u * size};
        if (!is_certain(w[i])) return false;
    }
    // The origin is inside if det(w_j, w_k, w_l) has the same sign for all four triples, in alternating orders.
    const auto det = [&](std::size_t i, std::size_t j, std::size_t k) { return dot(cross(w[i], w[j]), w[k]); };
    const std::array<BoundedNumber, 4> dets{det(1, 2, 3), det(0, 3, 2), det(0, 1, 3), det(0, 2, 1)};
    bool are_positive = true, are_negative = true;
    for (const BoundedNumber& d : dets) {
        are_positive &= d.x > d.error;
        are_negative &= d.x < -d.error;
    }
    return are_positive || are_negative;
}

}  // namespace ecods::convex
