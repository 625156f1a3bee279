// The exact search: the closest features of two simplices of vertices are found in integers; if no vertex is beyond
// them, they are those of the solids, and otherwise the vertices furthest beyond go into the simplices.
//
// Each round the distance of the simplices gets less, as the point that is beyond brings them closer, so that no pair
// of simplices comes twice. It is found as that of their triangles, which is larger only if one of them is inside the
// other: where it does not get less, the solids share a point.
#include <algorithm>
#include <span>

#include "exact/measure/distance/enclose_distance.hpp"
#include "exact/measure/distance/guess_features.hpp"
#include "exact/measure/round/fixed_length.hpp"
#include "exact/measure/round/fixed_plane.hpp"
#include "query/convex/closest_hulls.hpp"
#include "query/convex/exact_hulls.hpp"

namespace ecods::convex {
namespace {

using exact::Limbs;
using exact::SquaredDistance;

// Up to four vertices of each solid.
struct VertexSets {
    std::array<std::array<std::uint32_t, 4>, 2> at{};
    std::array<std::size_t, 2> count{};

    void add(std::size_t side, std::uint32_t vertex) noexcept {
        auto& vertices = at[side];
        if (std::find(vertices.begin(), vertices.begin() + count[side], vertex) != vertices.begin() + count[side])
            return;
        vertices[count[side]++] = vertex;
    }
    std::size_t triangle_count(std::size_t side) const noexcept { return count[side] == 4 ? 4 : 1; }
    // Of four vertices, all but one; otherwise all, the last one more than once if they are less than three.
    std::array<std::uint32_t, 3> triangle(std::size_t side, std::size_t without) const noexcept {
        std::array<std::uint32_t, 3> result;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t k = count[side] == 4 ? i + (i >= without) : std::min(i, count[side] - 1);
            result[i] = at[side][k];
        }
        return result;
    }
};

struct Measured {
    HullFeatures found;
    SquaredDistance square;
};

// The distance of two triangles; zero where they share a point.
void measure(PosedHulls& hulls, Measured& result) {
    result.found = guess_of_triangles(hulls, result.found.corners);
    with_exact_features(hulls, result.found.vertices(), [&](const auto& points, const auto& features, const auto&) {
        const exact::ClosestFeatures closest =
            exact::find_closest(points, features, {result.found.features, exact::Standing::none});
        result.square.exponent = points.unit;
        if (closest.standing == exact::Standing::none) {
            result.square.num = {};
            return;
        }
        result.found.features = closest.features;
        features.measure(closest.features, result.square);
    });
}

// The least one of all triangles of the sets.
void measure_all(PosedHulls& hulls, const VertexSets& sets, Measured& least, Measured& other) {
    bool is_first = true;
    for (std::size_t i = 0; i < sets.triangle_count(0); ++i) {
        for (std::size_t k = 0; k < sets.triangle_count(1); ++k) {
            Measured& result = is_first ? least : other;
            result.found = {{sets.triangle(0, i), sets.triangle(1, k)}, least.found.features};
            measure(hulls, result);
            if (!is_first && compare(other.square, least.square) < 0) std::swap(least, other);
            is_first = false;
            if (least.square.num.is_zero()) return;
        }
    }
}

// What of a solid is furthest along the direction of features (of the second: against it), from a vertex on.
class Furthest {
  public:
    Furthest(PosedHulls& hulls, const HullFeatures& found, std::size_t side)
        : hulls_(hulls), found_(found), side_(side), at_(found.corner(side, 0)) {
        while (climb()) {
        }
    }

    std::uint32_t vertex() const noexcept { return at_; }

    HullPart part() const noexcept { return level_.part(hulls_.hull(side_), at_); }

  private:
    // Goes to a neighbor that is further, if there is one. Otherwise it knows which are as far: two at most, since they
    // are on one face.
    bool climb() {
        level_ = {};
        const auto neighbors = hulls_.hull(side_).neighbors_of(at_);
        for (std::size_t first = 0; first < neighbors.size(); first += signs_at_once) {
            const auto some = neighbors.subspan(first, std::min(signs_at_once, neighbors.size() - first));
            const std::array<int, signs_at_once> signs = signs_beyond(hulls_, found_, side_, at_, some);
            for (std::size_t i = 0; i < some.size(); ++i) {
                if (signs[i] > 0) {
                    at_ = some[i].vertex;
                    return true;
                }
                if (signs[i] == 0) level_.add(some[i].edge);
            }
        }
        return false;
    }

    PosedHulls& hulls_;
    const HullFeatures& found_;
    std::size_t side_;
    std::uint32_t at_;
    LevelEdges level_;
};

template <std::size_t N>
std::array<int, signs_at_once> find_signs(PosedHulls& hulls, const HullFeatures& found, std::size_t side,
                                          std::uint32_t at, std::span<const Hull::Neighbor> neighbors) {
    std::array<HullVertex, 7 + N> vertices;
    std::ranges::copy(found.vertices(), vertices.begin());
    std::fill(vertices.begin() + 6, vertices.end(), HullVertex{side, at});
    for (std::size_t i = 0; i < neighbors.size(); ++i) vertices[7 + i].vertex = neighbors[i].vertex;
    return with_exact_features(
        hulls, vertices, [&]<int L>(const auto&, const exact::ExactFeatures<L>& features, const auto& limbs) {
            return features.with_direction(found.features, [&]<int M>(const exact::LimbVector<M>& n, bool is_turned) {
                std::array<int, signs_at_once> signs{};
                for (std::size_t i = 0; i < neighbors.size(); ++i) {
                    const auto way = exact::difference<L>(limbs[7 + i], limbs[6]);
                    const int sign = exact::sign<M + L>(exact::dot<M, L>(n, way));
                    signs[i] = is_turned == (side == 0) ? -sign : sign;
                }
                return signs;
            });
        });
}

VertexSets sets_of(const Simplex& guess) noexcept {
    VertexSets sets;
    for (std::size_t i = 0; i < static_cast<std::size_t>(guess.count); ++i) {
        for (const std::size_t side : {0, 1}) sets.add(side, guess.pairs[i][side]);
    }
    return sets;
}

VertexSets sets_of(const HullFeatures& found) noexcept {
    VertexSets sets;
    for (const std::size_t side : {0, 1}) {
        for (std::size_t i = 0; i < found.corner_count(side); ++i) sets.add(side, found.corner(side, i));
    }
    return sets;
}

// In fixed precision: a vertex and a face, or two edges, are in one plane of the set of differences, a vertex and an
// edge on one line. Nothing where the rounding is not certain.
std::optional<double> round_from_digits(PosedHulls& hulls, const HullFeatures& found) {
    const std::array<std::array<std::uint32_t, 3>, 2> corners{found.of_side(0), found.of_side(1)};
    const auto points = hulls.integers(
        {std::span(corners[0]).first(found.corner_count(0)), std::span(corners[1]).first(found.corner_count(1))});
    const auto at = [&](std::size_t a, std::size_t b) { return exact::difference(points.at[1][b], points.at[0][a]); };
    using Vector = exact::FixedPlane::Vector;
    const exact::FeatureKind kind = found.features.kind;
    const std::size_t other = 1 - found.features.vertex_side;
    if (kind == exact::FeatureKind::vertex_vertex) return exact::fixed_length(at(0, 0), points.unit, points.are_exact);
    if (kind == exact::FeatureKind::vertex_edge) {
        const Vector edge = exact::difference(points.at[other][1], points.at[other][0]);
        return exact::fixed_distance_from_line(at(0, 0), edge, points.unit, points.are_exact);
    }
    const std::array<Vector, 3> m =
        kind == exact::FeatureKind::edge_edge ? std::array<Vector, 3>{at(0, 0), at(1, 0), at(0, 1)}
        : found.features.vertex_side == 0     ? std::array<Vector, 3>{at(0, 0), at(0, 1), at(0, 2)}
                                              : std::array<Vector, 3>{at(0, 0), at(1, 0), at(2, 0)};
    const exact::FixedPlane plane(m, points.unit, points.are_exact);
    return plane.side() ? plane.distance() : std::nullopt;
}

}  // namespace

HullFeatures guess_of_triangles(PosedHulls& hulls, const std::array<std::array<std::uint32_t, 3>, 2>& corners) {
    HullFeatures result{corners, {}};
    if (!hulls.has_fixed_points()) return result;
    const auto vertices = result.vertices();
    exact::IntegerPair pair{{}, hulls.fixed_unit(), 0};
    for (std::size_t i = 0; i < 6; ++i) pair.at[i] = hulls.fixed(vertices[i]);
    result.features = exact::guess_features(pair);
    return result;
}

bool are_closest_of_triangles(PosedHulls& hulls, const HullFeatures& found) {
    return with_exact_features(hulls, found.vertices(), [&](const auto&, const auto& features, const auto&) {
        return features.standing(found.features) != exact::Standing::none;
    });
}

std::array<int, signs_at_once> signs_beyond(PosedHulls& hulls, const HullFeatures& found, std::size_t side,
                                            std::uint32_t at, std::span<const Hull::Neighbor> neighbors) {
    ECODS_ASSERT(neighbors.size() <= signs_at_once);
    return neighbors.size() <= 2 ? find_signs<2>(hulls, found, side, at, neighbors)
                                 : find_signs<signs_at_once>(hulls, found, side, at, neighbors);
}

std::optional<ClosestHulls> find_closest_exactly(PosedHulls& hulls, const Simplex& guess) {
    VertexSets sets = sets_of(guess);
    Measured least, other;
    SquaredDistance last;
    for (bool is_first = true;; is_first = false) {
        measure_all(hulls, sets, least, other);
        if (least.square.num.is_zero()) return std::nullopt;
        if (!is_first && compare(least.square, last) >= 0) return std::nullopt;
        last = least.square;
        const Furthest first(hulls, least.found, 0), second(hulls, least.found, 1);
        sets = sets_of(least.found);
        const std::array<std::size_t, 2> before = sets.count;
        if (first.vertex() != least.found.corner(0, 0)) sets.add(0, first.vertex());
        if (second.vertex() != least.found.corner(1, 0)) sets.add(1, second.vertex());
        if (sets.count == before) return ClosestHulls{least.found, {first.part(), second.part()}, false};
    }
}

namespace {

SquaredDistance square_of(PosedHulls& hulls, const HullFeatures& found) {
    return with_exact_features(hulls, found.vertices(), [&](const auto& points, const auto& features, const auto&) {
        SquaredDistance square;
        square.exponent = points.unit;
        features.measure(found.features, square);
        return square;
    });
}

}  // namespace

double round_distance(PosedHulls& hulls, const HullFeatures& found) {
    if (const auto distance = round_from_digits(hulls, found)) return *distance;
    return exact::round_root(square_of(hulls, found));
}

int compare_distance(PosedHulls& hulls, const HullFeatures& found, double d) {
    return exact::compare(square_of(hulls, found), d);
}

}  // namespace ecods::convex
