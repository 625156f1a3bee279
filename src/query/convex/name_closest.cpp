// Chooses the pair of features that is named if several pairs are at exactly the least distance, by the rule of
// ClosestPoints.
//
// All pairs of closest points of two convex sets differ by the same vector, so they are on the features of the two
// solids that are extreme along this vector. The candidates are these two features, and the edges and vertices of their
// boundaries.
#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/measure/distance/closest_points.hpp"
#include "exact/measure/round/exact_point.hpp"
#include "exact/point/vectors.hpp"
#include "geometry/feature_key.hpp"
#include "query/convex/closest_hulls.hpp"
#include "query/convex/exact_hulls.hpp"

namespace ecods::convex {
namespace {

using exact::dot;
using exact::largest;
using exact::minus;
using exact::times;

using exact::FeatureKind;
using Kind = Feature::Kind;

// A feature of each of the two solids.
using Parts = std::array<HullFeature, 2>;

// Returns the vertices of a feature; for a face, its first three.
std::array<std::uint32_t, 3> corners_of(const Hull& hull, const HullFeature& part) noexcept {
    if (part.kind == Kind::vertex) return {part.index, part.index, part.index};
    if (part.kind == Kind::edge) {
        const auto& ends = hull.edges[part.index].ends;
        return {ends[0], ends[1], ends[1]};
    }
    const auto cycle = hull.cycle_of(part.index);
    return {cycle[0].vertex, cycle[1].vertex, cycle[2].vertex};
}

HullFeatures features_of(const PosedHulls& hulls, const Parts& parts) noexcept {
    const auto count = [&](std::size_t side) { return static_cast<std::size_t>(parts[side].kind) + 1; };
    return {{corners_of(hulls.hull(0), parts[0]), corners_of(hulls.hull(1), parts[1])},
            exact::features_of_counts(count(0), count(1))};
}

// Calls use(feature) for each feature of the given kind that is `part` or borders `part`.
template <class Use>
void for_each_of(const Hull& hull, const HullFeature& part, Kind kind, Use&& use) {
    if (part.kind == kind) return use(part);
    if (part.kind < kind) return;
    if (part.kind == Kind::edge) {
        for (const std::uint32_t end : hull.edges[part.index].ends) use(HullFeature{kind, end});
    } else {
        for (const Hull::Neighbor& n : hull.cycle_of(part.index))
            use(HullFeature{kind, kind == Kind::vertex ? n.vertex : n.edge});
    }
}

class Naming {
  public:
    Naming(PosedHulls& hulls, const ClosestHulls& closest)
        : hulls_(hulls),
          parts_{closest.part(hulls, 0), closest.part(hulls, 1)},
          least_(square_of(hulls, closest.found)) {
        const double distance = exact::round_root(least_);
        if (distance > 0x1p-1000 && distance < 0x1p1000) {
            const int exponent = exponent_above(distance) - hulls.exponent();
            if (exponent > -800 && exponent < 800) limit_ = times_power(distance, -hulls.exponent());
        }
    }

    // Tries the kinds of pairs in the order of the rule. The first kind that has a pair at the least distance decides.
    Parts find() {
        try_all(Kind::vertex, Kind::vertex);
        if (has_best_) return best_;
        try_all(Kind::vertex, Kind::edge);
        try_all(Kind::edge, Kind::vertex);
        if (has_best_) return best_;
        try_all(Kind::vertex, Kind::face);
        try_all(Kind::face, Kind::vertex);
        if (has_best_) return best_;
        try_all(Kind::edge, Kind::edge);
        ECODS_ASSERT(has_best_);
        return best_;
    }

  private:
    void try_all(Kind kind_a, Kind kind_b) {
        for_each_of(hulls_.hull(0), parts_[0], kind_a, [&](const HullFeature& a) {
            for_each_of(hulls_.hull(1), parts_[1], kind_b, [&](const HullFeature& b) {
                const Parts parts{a, b};
                if (!is_first(parts) || !may_hold(parts) || !holds(parts)) return;
                best_ = parts;
                has_best_ = true;
            });
        });
    }

    FeatureNames names_of(const Parts& parts) const noexcept {
        return {ClosestKind{}, name_of(hulls_.hull(0), parts[0]), name_of(hulls_.hull(1), parts[1])};
    }
    // True if `parts` precede best_, which are of the same kinds, or if there are no best_ yet.
    bool is_first(const Parts& parts) const noexcept {
        return !has_best_ || rank(names_of(parts)) < rank(names_of(best_));
    }

    // True unless doubles prove that the distance of `parts` exceeds the least distance.
    bool may_hold(const Parts& parts) {
        const Kind greater = std::max(parts[0].kind, parts[1].kind), lesser = std::min(parts[0].kind, parts[1].kind);
        if (greater == Kind::vertex) return may_hold_vertices(parts);
        if (lesser == Kind::edge) return true;
        return greater == Kind::edge ? may_hold_vertex_and_edge(parts) : is_over(parts);
    }

    // True if `parts` have exactly the least distance, and their closest points are inside them.
    bool holds(const Parts& parts) {
        const HullFeatures found = features_of(hulls_, parts);
        return with_exact_features(hulls_, found.vertices(),
                                   [&](const auto& points, const auto& features, const auto&) {
                                       const bool is_face = found.features.kind == FeatureKind::vertex_face;
                                       if (!is_face && features.standing(found.features) < exact::Standing::inside)
                                           return false;
                                       exact::SquaredDistance square;
                                       square.exponent = points.unit;
                                       features.measure(found.features, square);
                                       return compare(square, least_) == 0;
                                   });
    }

    // Compares with a margin: rounded points are off by delta on each axis, and the norm of their difference by a
    // factor near 1.
    bool may_hold_vertices(const Parts& parts) const noexcept {
        const Point w = minus(hulls_.rounded(1, parts[1].index), hulls_.rounded(0, parts[0].index));
        const double length = std::sqrt(dot(w, w));
        return !(length * (1 - 0x1p-48) - 4 * hulls_.delta() > limit_ * (1 + 0x1p-48));
    }

    // Measures the distance of the vertex from a point on the rounded edge's line. The rounded parameter moves this
    // point by some roundings of the vectors' lengths, which the margin covers.
    bool may_hold_vertex_and_edge(const Parts& parts) const noexcept {
        const std::size_t of = parts[0].kind == Kind::edge ? 0 : 1;
        const auto& ends = hulls_.hull(of).edges[parts[of].index].ends;
        const Point p = hulls_.rounded(of, ends[0]);
        const Point w = minus(hulls_.rounded(1 - of, parts[1 - of].index), p),
                    u = minus(hulls_.rounded(of, ends[1]), p);
        const double uu = dot(u, u), t = std::min(std::max(dot(w, u) / uu, 0.0), 1.0);
        const Point x = minus(w, times(u, t));
        const double margin = 0x1p-44 * (largest(w) + largest(u)) + 16 * hulls_.delta();
        return !(std::sqrt(dot(x, x)) - margin > limit_ * (1 + 0x1p-48));
    }

    // Returns true if the vertex projects to a point inside the face: it is left of all the face's sides, seen along
    // the normal. Exact.
    bool is_over(const Parts& parts) {
        constexpr std::size_t at_once = 7;
        const std::size_t of = parts[0].kind == Kind::face ? 0 : 1;
        const HullFeatures found = features_of(hulls_, parts);
        const auto cycle = hulls_.hull(of).cycle_of(parts[of].index);
        std::array<HullVertex, 6 + at_once + 1> vertices;
        std::ranges::copy(found.vertices(), vertices.begin());
        for (std::size_t first = 0; first < cycle.size(); first += at_once) {
            for (std::size_t i = 0; i <= at_once; ++i) {
                vertices[6 + i] = {of, cycle[(first + i) % cycle.size()].vertex};
            }
            const bool is_inside = with_exact_features(
                hulls_, vertices, [&]<int L>(const auto&, const exact::ExactFeatures<L>& features, const auto& limbs) {
                    const auto n = features.normal(found.features);
                    const auto& vertex = limbs[of == 0 ? 3 : 0];
                    for (std::size_t i = 0; i < std::min(at_once, cycle.size() - first); ++i) {
                        const auto side = exact::difference<L>(limbs[7 + i], limbs[6 + i]);
                        const auto way = exact::difference<L>(vertex, limbs[6 + i]);
                        const auto turn = exact::dot<2 * L, 2 * L>(exact::cross<L>(side, way), n);
                        if (exact::sign<4 * L>(turn) <= 0) return false;
                    }
                    return true;
                });
            if (!is_inside) return false;
        }
        return true;
    }

    PosedHulls& hulls_;
    Parts parts_;
    exact::SquaredDistance least_;
    double limit_ =
        std::numeric_limits<double>::infinity();  // the rounded least distance, in the unit of rounded points
    Parts best_;
    bool has_best_ = false;
};

}  // namespace

ClosestPoints name_closest(PosedHulls& hulls, const ClosestHulls& closest) {
    const Parts parts =
        closest.are_only ? Parts{closest.part(hulls, 0), closest.part(hulls, 1)} : Naming(hulls, closest).find();
    const HullFeatures found = features_of(hulls, parts);
    return with_exact_features(hulls, found.vertices(), [&](const auto& points, const auto& features, const auto&) {
        exact::SquaredDistance square;
        square.exponent = points.unit;
        features.measure(found.features, square);
        std::array<exact::ExactPoint, 2> ends;
        exact::find_closest_points(features, found.features, points.unit, ends);
        const exact::PointRef origin = hulls.reference({0, found.corners[0][0]});
        return ClosestPoints{exact::round_root(square),           static_cast<ClosestKind>(found.features.kind),
                             name_of(hulls.hull(0), parts[0]),    name_of(hulls.hull(1), parts[1]),
                             exact::round_point(origin, ends[0]), exact::round_point(origin, ends[1])};
    });
}

}  // namespace ecods::convex
