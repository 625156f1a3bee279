// Chooses, by the rule of ClosestPoints, the pair of features that is named if several are at the least distance.
//
// All pairs of closest points of two convex sets differ by the same vector, so they are on the features of the two
// solids that are extreme along this vector. The candidates are these two features, and the edges and vertices of their
// boundaries. If the sets meet, the vector is that of the shortest translation, along the normal of the depth. The two
// features are in planes across the normal, whose distance is the depth; points at this distance differ by the vector.
#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "base/double_key.hpp"
#include "base/short_list.hpp"
#include "exact/measure/distance/closest_points.hpp"
#include "exact/measure/distance/set_ends.hpp"
#include "exact/measure/round/distance_beyond.hpp"
#include "exact/measure/round/exact_point.hpp"
#include "geometry/feature_key.hpp"
#include "query/convex/closest_hulls.hpp"
#include "query/convex/exact_hulls.hpp"
#include "query/convex/on_way.hpp"
#include "query/convex/planar_features.hpp"

namespace ecods::convex {
namespace {

using Kind = Feature::Kind;

using Parts = HullFeaturePair;

// Returns the vertices of a feature, padded to three; for a face, its first three.
std::array<std::uint32_t, 3> corners_of(const Hull& hull, const HullFeature& part) noexcept {
    if (part.kind == Kind::vertex) return {part.index, part.index, part.index};
    if (part.kind == Kind::edge) {
        const auto& ends = hull.edges[part.index].ends;
        return {ends[0], ends[1], ends[1]};
    }
    const auto cycle = hull.cycle_of(part.index);
    return {cycle[0].vertex, cycle[1].vertex, cycle[2].vertex};
}

}  // namespace

HullFeatures features_of(const PosedHulls& hulls, const Parts& parts) noexcept {
    const auto count = [&](std::size_t side) { return static_cast<std::size_t>(parts[side].kind) + 1; };
    return {{corners_of(hulls.hull(0), parts[0]), corners_of(hulls.hull(1), parts[1])},
            exact::features_of_counts(count(0), count(1))};
}

namespace {

// Returns a distance in the unit of rounded points; infinity if this cannot be computed with the full precision of a
// double. The distance must be rounded once, and at least the least double if it is positive.
double in_units_of(const PosedHulls& hulls, double distance) noexcept {
    if (key_of(distance) == 0) return 0;
    if (!(distance > 0x1p-1000 && distance < 0x1p1000)) return std::numeric_limits<double>::infinity();
    const int exponent = exponent_above(distance) - hulls.exponent();
    if (exponent <= -800 || exponent >= 800) return std::numeric_limits<double>::infinity();
    return times_power(distance, -hulls.exponent());
}

class Naming {
    using Answer = PlanarFeatures::Answer;

  public:
    // Takes features that contain all closest points, and the square `least` of their distance. `normal` is the rounded
    // direction from the first body's closest point to the second's if `turned` is 1, the opposite if -1.
    Naming(PosedHulls& hulls, const Parts& parts, const exact::SquaredDistance& least, const Vec3& normal, int turned)
        : Naming(hulls, parts, normal, turned * in_units_of(hulls, exact::round_root(least))) {
        least_ = least;
    }
    // Computes the square on demand. `way` is the vector between two points of a closest pair, if known (list_least).
    Naming(PosedHulls& hulls, const LeastDifference& least, double distance,
           const std::optional<exact::IntegerVector>& way)
        : Naming(hulls, least.parts, least.normal, (least.is_depth ? -1 : 1) * in_units_of(hulls, distance)) {
        of_ = &least;
        way_ = way;
    }

    // Sets `pairs` to all pairs of features at the least distance.
    void list(LeastPairs& pairs) {
        pairs.clear();
        pairs_ = &pairs;
        for (const std::size_t side : {0, 1}) places_[side].assign(planar_.vertex_count(side), {});
        try_vertices();
        for (const std::size_t side : {0, 1}) {
            try_vertex_and_edge(side);
            try_vertex_and_face(side);
        }
        try_edges();
        ECODS_ASSERT(!pairs.empty());
    }

    // Returns the first pair of features: tries the kinds of pairs in the order of the rule, until a pair is found.
    Parts find() {
        try_vertices();
        if (has_best_) return best_;
        for (const std::size_t side : {0, 1}) try_vertex_and_edge(side);
        if (has_best_) return best_;
        for (const std::size_t side : {0, 1}) try_vertex_and_face(side);
        if (has_best_) return best_;
        try_edges();
        ECODS_ASSERT(has_best_);
        return best_;
    }

  private:
    Naming(PosedHulls& hulls, const Parts& parts, const Vec3& normal, double along)
        : hulls_(hulls), parts_(parts), planar_(hulls, parts, normal, along) {}

    void try_vertices() {
        planar_.visit_meeting([&](std::size_t i, std::size_t j) {
            const Parts parts{planar_.vertex(0, i), planar_.vertex(1, j)};
            if (!is_wanted(parts) || !holds(parts)) return;
            take(parts);
            place(0, i, Kind::vertex, j);
            place(1, j, Kind::vertex, i);
            find_way(i, j);
        });
    }

    void try_vertex_and_edge(std::size_t side) {
        planar_.visit_on_edges(side, [&](std::size_t i, std::size_t j) {
            const Parts parts = of_sides(side, planar_.vertex(side, i), planar_.edge(1 - side, j));
            if (is_placed(side, i) || !is_wanted(parts) || !holds(parts)) return is_placed(side, i);
            take(parts);
            place(side, i, Kind::edge, j);
            return is_placed(side, i);
        });
    }

    void try_vertex_and_face(std::size_t side) {
        if (parts_[1 - side].kind != Kind::face) return;
        for (std::size_t i = 0; i < planar_.vertex_count(side); ++i) {
            const Parts parts = of_sides(side, planar_.vertex(side, i), parts_[1 - side]);
            if (is_placed(side, i) || !is_wanted(parts)) continue;
            const Answer answer = planar_.is_inside(side, i);
            if (answer == Answer::yes || (answer == Answer::open && is_over(parts))) take(parts);
        }
    }

    void try_edges() {
        for (std::size_t i = 0; i < planar_.edge_count(0); ++i) {
            for (std::size_t j = 0; j < planar_.edge_count(1); ++j) {
                const Answer answer = planar_.do_cross(i, j);
                if (answer == Answer::no || do_share_an_end(i, j)) continue;
                const Parts parts{planar_.edge(0, i), planar_.edge(1, j)};
                if (is_wanted(parts) && (answer == Answer::yes || holds(parts))) take(parts);
            }
        }
    }

    static Parts of_sides(std::size_t side, const HullFeature& own, const HullFeature& other) noexcept {
        return side == 0 ? Parts{own, other} : Parts{other, own};
    }
    FeatureNames names_of(const Parts& parts) const noexcept {
        return {ClosestKind{}, name_of(hulls_.hull(0), parts[0]), name_of(hulls_.hull(1), parts[1])};
    }
    // Returns true if `parts` must be tested: all pairs are listed, or no best_ of the same kind precedes `parts`.
    bool is_wanted(const Parts& parts) const noexcept {
        return pairs_ != nullptr || !has_best_ || rank(names_of(parts)) < rank(names_of(best_));
    }
    void take(const Parts& parts) {
        if (pairs_ != nullptr) return pairs_->push_back(parts);
        best_ = parts;
        has_best_ = true;
    }

    // A Place says where a vertex of one polygon is on the other polygon, at a vertex or on an edge. It is stored while
    // all pairs are listed. A vertex that has a place is at no other vertex, on no other edge and not in the face; and
    // two edges that share an end of one of them cross nowhere else, unless they are parallel.
    struct Place {
        Kind kind = Kind::none;
        std::size_t index = 0;
    };
    void place(std::size_t side, std::size_t i, Kind kind, std::size_t at) {
        if (pairs_ != nullptr) places_[side][i] = {kind, at};
    }
    bool is_placed(std::size_t side, std::size_t i) const noexcept {
        return pairs_ != nullptr && places_[side][i].kind != Kind::none;
    }
    // Returns true if vertex i of a polygon is placed on edge j of the other one, or at an end of this edge.
    bool is_placed_on(std::size_t side, std::size_t i, std::size_t j) const noexcept {
        const Place& at = places_[side][i];
        if (at.kind == Kind::edge) return at.index == j;
        return at.kind == Kind::vertex && (at.index == j || at.index == planar_.next(1 - side, j));
    }
    bool do_share_an_end(std::size_t i, std::size_t j) const noexcept {
        if (pairs_ == nullptr) return false;
        return is_placed_on(0, i, j) || is_placed_on(0, planar_.next(0, i), j) || is_placed_on(1, j, i) ||
               is_placed_on(1, planar_.next(1, j), i);
    }

    // Returns true if the interiors of `parts`, none of them a face, have points at exactly the least distance.
    bool holds(const Parts& parts) {
        if (way_) return are_on_way(hulls_, parts, *way_, planar_.dropped_axis());
        if (!least_) least_ = square_of(hulls_, *of_);
        const HullFeatures found = features_of(hulls_, parts);
        return with_exact_features(hulls_, found.vertices(),
                                   [&](const auto& points, const auto& features, const auto&) {
                                       if (features.standing(found.features) < exact::Standing::inside) return false;
                                       exact::SquaredDistance square;
                                       square.exponent = points.unit;
                                       features.measure(found.features, square);
                                       return compare(square, *least_) == 0;
                                   });
    }

    // Sets way_ to the vector from vertex i to vertex j, which all closest pairs share, if all pairs are listed.
    void find_way(std::size_t i, std::size_t j) {
        if (pairs_ == nullptr || way_ || !hulls_.has_fixed_points()) return;
        way_ = exact::difference(hulls_.fixed({1, planar_.vertex(1, j).index}),
                                 hulls_.fixed({0, planar_.vertex(0, i).index}));
    }

    // Returns true if the vertex projects into the face: seen along the normal, it is left of all sides. Exact.
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
    const LeastDifference* of_ = nullptr;
    std::optional<exact::SquaredDistance> least_;
    std::optional<exact::IntegerVector> way_;
    PlanarFeatures planar_;
    Parts best_;
    bool has_best_ = false;
    LeastPairs* pairs_ = nullptr;                   // the list of all pairs; null if only the first one is wanted
    std::array<ShortList<Place, 32>, 2> places_{};  // by vertex of each polygon
};

// Returns the closest points of `parts`, with their names. set() must set the result's distance and both points.
template <class SetEnds>
ClosestPoints measure_named(PosedHulls& hulls, const Parts& parts, const SetEnds& set) {
    const HullFeatures found = features_of(hulls, parts);
    return with_exact_features(hulls, found.vertices(), [&](const auto& points, const auto& features, const auto&) {
        exact::SquaredDistance square;
        square.exponent = points.unit;
        features.measure(found.features, square);
        std::array<exact::ExactPoint, 2> ends;
        exact::find_closest_points(features, found.features, points.unit, ends);
        const exact::PointRef origin = hulls.reference({0, found.corners[0][0]});
        ClosestPoints result;
        result.kind = static_cast<ClosestKind>(found.features.kind);
        result.a = name_of(hulls.hull(0), parts[0]);
        result.b = name_of(hulls.hull(1), parts[1]);
        set(result, square, origin, ends, features, found.features);
        return result;
    });
}

ClosestPoints measure_closest(PosedHulls& hulls, const Parts& parts, const exact::Radii& radii) {
    return measure_named(hulls, parts, [&](ClosestPoints& result, const auto&... of_features) {
        set_ends(result, of_features..., radii);
    });
}

}  // namespace

ClosestPoints name_closest(PosedHulls& hulls, const ClosestHulls& closest, const exact::Radii& radii) {
    const auto fixed = find_fixed(hulls, closest, radii);
    if (auto points = fixed ? fixed->signed_closest() : std::nullopt) {
        points->distance = positive_part(points->distance);
        return *points;
    }
    const Parts parts{closest.part(hulls, 0), closest.part(hulls, 1)};
    if (closest.are_only) return measure_closest(hulls, parts, radii);
    const Vec3 normal = round_direction(hulls, closest.found);
    return measure_closest(hulls, Naming(hulls, parts, square_of(hulls, closest.found), normal, 1).find(), radii);
}

ClosestPoints name_deepest(PosedHulls& hulls, const LeastDifference& least, const exact::Radii& radii) {
    const Parts parts = Naming(hulls, least.parts, square_of(hulls, least), least.normal, -1).find();
    const auto fixed = least.is_zero ? std::nullopt : find_fixed(hulls, parts, radii);
    if (const auto points = fixed ? fixed->inverted().signed_closest() : std::nullopt) return *points;
    const exact::ExactSum sum = radii.sum();
    if (sum.sign() == 0) return measure_closest(hulls, parts, {});
    const exact::LongDirection out_of_a = exact_normal(hulls, least), out_of_b = -out_of_a;
    return measure_named(
        hulls, parts,
        [&](ClosestPoints& result, const auto& square, const auto& origin, const auto& ends, const auto&...) {
            result.distance = exact::round_signed_beyond(square, -sum);
            result.point_a = exact::round_end(origin, ends[0], radii.a, out_of_a);
            result.point_b = exact::round_end(origin, ends[1], radii.b, out_of_b);
        });
}

LeastDifference least_of_closest(PosedHulls& hulls, const ClosestHulls& closest) {
    const HullFeaturePair parts{closest.part(hulls, 0), closest.part(hulls, 1)};
    return {parts, closest.found, round_direction(hulls, closest.found), false, false, closest.are_only};
}

LeastDifference least_of_deepest(PosedHulls& hulls, const HullFeaturePair& extreme, const Vec3& normal, bool is_zero) {
    return {extreme, features_of(hulls, extreme), normal, true, is_zero};
}

// Returns the least difference squared. If is_zero, the features may be parallel edges, which measure() does not take.
exact::SquaredDistance square_of(PosedHulls& hulls, const LeastDifference& least) {
    return least.is_zero ? exact::SquaredDistance() : square_of(hulls, least.found);
}

exact::LongDirection exact_normal(PosedHulls& hulls, const LeastDifference& least) {
    const exact::LongDirection found = with_exact_features(
        hulls, least.found.vertices(), [&]<int L>(const auto&, const exact::ExactFeatures<L>& features, const auto&) {
            return features.with_direction(
                least.found.features, [&]<int M>(const exact::LimbVector<M>& n, bool is_turned) {
                    if (!exact::is_zero_vector<M>(n)) return exact::LongDirection::of<M>(n, is_turned);
                    const std::size_t along = least.parts[0].kind == Kind::edge ? 0 : 1;
                    return exact::LongDirection::of<2 * L>(exact::across<L>(features.from(along, 0, 1)), false);
                });
        });
    Eigen::Index axis = 0;
    least.normal.cwiseAbs().maxCoeff(&axis);
    const bool is_opposite = (found.x[static_cast<std::size_t>(axis)].sign() < 0) != (least.normal[axis] < 0);
    return is_opposite ? -found : found;
}

void list_least(PosedHulls& hulls, const LeastDifference& least, double distance,
                const std::optional<exact::IntegerVector>& way, LeastPairs& pairs) {
    pairs.clear();
    if (least.are_only) return pairs.push_back(least.parts);
    Naming(hulls, least, distance, way).list(pairs);
}

}  // namespace ecods::convex
