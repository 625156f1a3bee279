// Which of several pairs of features that have exactly the least distance is named, by the rule of ClosestPoints.
//
// All closest points of two convex sets are apart by one vector, so they are on the parts that are furthest along it:
// one part of each solid, and the features in question are these and what borders them.
#include <cmath>
#include <limits>
#include <tuple>

#include "exact/measure/distance/closest_points.hpp"
#include "exact/measure/round/exact_point.hpp"
#include "exact/point/vectors.hpp"
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

// Three vertices of the hull that a part is named by, the first ones of its own.
std::array<std::uint32_t, 3> corners_of(const Hull& hull, const HullPart& part) noexcept {
    if (part.kind == Kind::vertex) return {part.index, part.index, part.index};
    if (part.kind == Kind::edge) {
        const auto& ends = hull.edges[part.index].ends;
        return {ends[0], ends[1], ends[1]};
    }
    const auto cycle = hull.cycle_of(part.index);
    return {cycle[0].vertex, cycle[1].vertex, cycle[2].vertex};
}

// Calls use(part) for the vertices of a part, or for its edges.
template <class Use>
void for_vertices(const Hull& hull, const HullPart& part, Use&& use) {
    if (part.kind == Kind::vertex) use(part);
    if (part.kind == Kind::edge) {
        for (const std::uint32_t end : hull.edges[part.index].ends) use(HullPart{Kind::vertex, end});
    }
    if (part.kind == Kind::face) {
        for (const Hull::Neighbor& n : hull.cycle_of(part.index)) use(HullPart{Kind::vertex, n.vertex});
    }
}
template <class Use>
void for_edges(const Hull& hull, const HullPart& part, Use&& use) {
    if (part.kind == Kind::edge) use(part);
    if (part.kind == Kind::face) {
        for (const Hull::Neighbor& n : hull.cycle_of(part.index)) use(HullPart{Kind::edge, n.edge});
    }
}

// A part of each solid.
using PartPair = std::array<HullPart, 2>;

HullFeatures features_of(const PosedHulls& hulls, const PartPair& parts) noexcept {
    HullFeatures result;
    for (const std::size_t side : {0, 1}) result.corners[side] = corners_of(hulls.hull(side), parts[side]);
    const bool has_face = parts[0].kind == Kind::face || parts[1].kind == Kind::face;
    const int edges = (parts[0].kind == Kind::edge) + (parts[1].kind == Kind::edge);
    result.features.kind = has_face     ? FeatureKind::vertex_face
                           : edges == 2 ? FeatureKind::edge_edge
                           : edges == 1 ? FeatureKind::vertex_edge
                                        : FeatureKind::vertex_vertex;
    result.features.vertex_side = parts[0].kind > parts[1].kind ? 1 : 0;
    return result;
}

class Naming {
  public:
    Naming(PosedHulls& hulls, const ClosestHulls& closest)
        : hulls_(hulls), parts_{closest.part(hulls, 0), closest.part(hulls, 1)} {
        with_exact_features(hulls, closest.found.vertices(),
                            [&](const auto& points, const auto& features, const auto&) {
                                least_.exponent = points.unit;
                                features.measure(closest.found.features, least_);
                            });
        const double distance = exact::round_root(least_);
        if (distance > 0x1p-1000 && distance < 0x1p1000) {
            const int exponent = exponent_above(distance) - hulls.exponent();
            if (exponent > -800 && exponent < 800) limit_ = times_power(distance, -hulls.exponent());
        }
    }

    // The kinds in their order; of each, what is named first.
    PartPair find() {
        const Hull &a = hulls_.hull(0), &b = hulls_.hull(1);
        for_vertices(a, parts_[0], [&](const HullPart& x) {
            for_vertices(b, parts_[1], [&](const HullPart& y) { try_vertices({x, y}); });
        });
        if (has_best_) return best_;
        for_vertices(a, parts_[0], [&](const HullPart& x) {
            for_edges(b, parts_[1], [&](const HullPart& y) { try_vertex_and_edge({x, y}); });
        });
        for_edges(a, parts_[0], [&](const HullPart& x) {
            for_vertices(b, parts_[1], [&](const HullPart& y) { try_vertex_and_edge({x, y}); });
        });
        if (has_best_) return best_;
        if (parts_[1].kind == Kind::face) {
            for_vertices(a, parts_[0], [&](const HullPart& x) { try_vertex_and_face({x, parts_[1]}); });
        }
        if (parts_[0].kind == Kind::face) {
            for_vertices(b, parts_[1], [&](const HullPart& y) { try_vertex_and_face({parts_[0], y}); });
        }
        if (has_best_) return best_;
        for_edges(a, parts_[0], [&](const HullPart& x) {
            for_edges(b, parts_[1], [&](const HullPart& y) { try_exactly({x, y}); });
        });
        ECODS_ASSERT(has_best_);
        return best_;
    }

  private:
    auto rank(const PartPair& parts) const noexcept {
        const Feature a = part_name(hulls_.hull(0), parts[0]), b = part_name(hulls_.hull(1), parts[1]);
        return std::tuple(a.triangle, a.corner, b.triangle, b.corner, a.kind);
    }
    bool is_first(const PartPair& parts) const noexcept { return !has_best_ || rank(parts) < rank(best_); }
    void take(const PartPair& parts) noexcept {
        best_ = parts;
        has_best_ = true;
    }

    // Whether the parts have exactly the least distance, with points inside them.
    bool holds(const PartPair& parts) {
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

    void try_exactly(const PartPair& parts) {
        if (is_first(parts) && holds(parts)) take(parts);
    }

    // Rounded points are off by delta on each axis, and a norm of their difference by a factor that is near 1.
    void try_vertices(const PartPair& parts) {
        if (!is_first(parts)) return;
        const Point w = minus(hulls_.rounded(1, parts[1].index), hulls_.rounded(0, parts[0].index));
        const double length = std::sqrt(dot(w, w));
        if (length * (1 - 0x1p-48) - 4 * hulls_.delta() > limit_ * (1 + 0x1p-48)) return;
        if (holds(parts)) take(parts);
    }

    // The distance from the rounded edge is that from a point on its line, which its parameter's rounding moves by some
    // roundings of the vectors' lengths.
    void try_vertex_and_edge(const PartPair& parts) {
        if (!is_first(parts)) return;
        const std::size_t of = parts[0].kind == Kind::edge ? 0 : 1;
        const auto& ends = hulls_.hull(of).edges[parts[of].index].ends;
        const Point p = hulls_.rounded(of, ends[0]);
        const Point w = minus(hulls_.rounded(1 - of, parts[1 - of].index), p),
                    u = minus(hulls_.rounded(of, ends[1]), p);
        const double uu = dot(u, u), t = std::min(std::max(dot(w, u) / uu, 0.0), 1.0);
        const Point x = minus(w, times(u, t));
        const double margin = 0x1p-44 * (largest(w) + largest(u)) + 16 * hulls_.delta();
        if (std::sqrt(dot(x, x)) - margin > limit_ * (1 + 0x1p-48)) return;
        if (holds(parts)) take(parts);
    }

    void try_vertex_and_face(const PartPair& parts) {
        if (is_first(parts) && is_over(parts) && holds(parts)) take(parts);
    }

    // Whether the foot of a vertex is inside a face: left of all its sides, seen along the normal.
    bool is_over(const PartPair& parts) {
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
    std::array<HullPart, 2> parts_;
    exact::SquaredDistance least_;
    double limit_ = std::numeric_limits<double>::infinity();  // the distance, about, as rounded points are counted
    PartPair best_;
    bool has_best_ = false;
};

}  // namespace

ClosestPoints name_closest(PosedHulls& hulls, const ClosestHulls& closest) {
    const PartPair parts =
        closest.are_only ? PartPair{closest.part(hulls, 0), closest.part(hulls, 1)} : Naming(hulls, closest).find();
    const HullFeatures found = features_of(hulls, parts);
    return with_exact_features(hulls, found.vertices(), [&](const auto& points, const auto& features, const auto&) {
        exact::SquaredDistance square;
        square.exponent = points.unit;
        features.measure(found.features, square);
        std::array<exact::ExactPoint, 2> ends;
        exact::ClosestPointsOf(features, found.features, points.unit).find(ends);
        const exact::PointRef origin = hulls.reference({0, found.corners[0][0]});
        return ClosestPoints{exact::round_root(square),           static_cast<ClosestKind>(found.features.kind),
                             part_name(hulls.hull(0), parts[0]),  part_name(hulls.hull(1), parts[1]),
                             exact::round_point(origin, ends[0]), exact::round_point(origin, ends[1])};
    });
}

}  // namespace ecods::convex
