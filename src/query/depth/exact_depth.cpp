#include "query/depth/exact_depth.hpp"

#include <type_traits>
#include <utility>

#include "query/depth/exact_expansion.hpp"
#include "query/depth/flat_difference.hpp"

namespace ecods::depths {
namespace {

// Calls `use` with the vertices of both solids as integers, all with as many limbs as the largest coordinate needs.
template <class Use>
auto with_points(const ConvexPair& pair, Use&& use) {
    const PairTerms terms(pair);
    return exact::with_limb_count<2>(
        terms.bits(), [&]<int L>(std::integral_constant<int, L>) { return use(ExactDifferences<L>(pair, terms)); });
}

template <int L>
ExactPlane<L> plane_of(const ExactDifferences<L>& points, const std::array<DifferenceVertex, 3>& corners) noexcept {
    return {points.difference(corners[0]), points.difference(corners[1]), points.difference(corners[2])};
}

}  // namespace

std::optional<ExactDepth> exact_depth(const ConvexPair& pair) {
    return with_points(pair, [&]<int L>(const ExactDifferences<L>& points) -> std::optional<ExactDepth> {
        ExactExpansion<L> expansion(points);
        const auto found = expansion.find();
        if (!found) return std::nullopt;
        return ExactDepth{found->face, exact::round_root(found->plane->square(points.unit())),
                          exact::round_direction<2 * L>(found->plane->n)};
    });
}

std::optional<ExactDepth> depth_in_plane(const ConvexPair& pair) {
    if (!pair[0].hull->is_flat() || !pair[1].hull->is_flat()) return std::nullopt;
    return with_points(pair,
                       [&]<int L>(const ExactDifferences<L>& points) { return FlatDifference<L>(points).find(); });
}

ExactDepth measure_exactly(const ConvexPair& pair, const DifferenceFace& face,
                           const std::array<DifferenceVertex, 3>& corners) {
    return with_points(pair, [&]<int L>(const ExactDifferences<L>& points) {
        const ExactPlane<L> plane = plane_of(points, corners);
        return ExactDepth{face, exact::round_root(plane.square(points.unit())), exact::round_direction<2 * L>(plane.n)};
    });
}

std::optional<DifferenceVertex> keep_level(const ConvexPair& pair, const std::array<DifferenceVertex, 3>& corners,
                                           std::array<std::vector<std::uint32_t>, 2>& levels) {
    return with_points(pair, [&]<int L>(const ExactDifferences<L>& points) {
        const ExactPlane<L> plane = plane_of(points, corners);
        return keep_level(levels, corners[0], [&](std::size_t side, std::uint32_t from, std::uint32_t to) {
            return points.beyond(side, plane.n, points.point(side, from), points.point(side, to));
        });
    });
}

bool is_beyond_exactly(const ConvexPair& pair, const std::array<DifferenceVertex, 3>& corners,
                       const DifferenceVertex& vertex) {
    return with_points(pair, [&]<int L>(const ExactDifferences<L>& points) {
        return plane_of(points, corners).sign_at(points.difference(vertex)) > 0;
    });
}

int compare_exactly(const ConvexPair& pair, const std::array<DifferenceVertex, 3>& first,
                    const std::array<DifferenceVertex, 3>& second) {
    return with_points(pair, [&]<int L>(const ExactDifferences<L>& points) {
        return compare(plane_of(points, first), plane_of(points, second));
    });
}

}  // namespace ecods::depths
