#include "query/depth/exact_depth.hpp"

#include <type_traits>
#include <utility>

#include "query/depth/exact_expansion.hpp"

namespace ecods::depths {
namespace {

// Calls use(number of limbs that hold all points, as a constant type; their scale).
template <class Use>
auto with_limbs(const ConvexPair& pair, Use&& use) {
    const PointScale scale = find_scale(pair);
    if (scale.bits() <= 64 * 2) return use(std::integral_constant<int, 2>{}, scale);
    if (scale.bits() <= 64 * 4) return use(std::integral_constant<int, 4>{}, scale);
    if (scale.bits() <= 64 * 8) return use(std::integral_constant<int, 8>{}, scale);
    if (scale.bits() <= 64 * 20) return use(std::integral_constant<int, 20>{}, scale);
    ECODS_ASSERT(scale.bits() <= 64 * exact::limb_count_max);
    return use(std::integral_constant<int, exact::limb_count_max>{}, scale);
}

template <int L>
ExactPlane<L> plane_of(const ExactDifferences<L>& points, const std::array<DifferenceVertex, 3>& corners) noexcept {
    return {points.difference(corners[0]), points.difference(corners[1]), points.difference(corners[2])};
}

}  // namespace

std::optional<ExactDepth> exact_depth(const ConvexPair& pair) {
    return with_limbs(pair, [&]<int L>(std::integral_constant<int, L>, const PointScale& scale) {
        return ExactExpansion<L>(pair, scale).find();
    });
}

ExactDepth measure_exactly(const ConvexPair& pair, const DifferenceFace& face,
                           const std::array<DifferenceVertex, 3>& corners) {
    return with_limbs(pair, [&]<int L>(std::integral_constant<int, L>, const PointScale& scale) {
        const ExactDifferences<L> points(pair, scale);
        const ExactPlane<L> plane = plane_of(points, corners);
        return ExactDepth{face, exact::round_root(plane.square(points.unit())), exact::round_direction<2 * L>(plane.n)};
    });
}

std::optional<DifferenceVertex> keep_level(const ConvexPair& pair, const std::array<DifferenceVertex, 3>& corners,
                                           std::array<std::vector<std::uint32_t>, 2>& levels) {
    return with_limbs(pair, [&]<int L>(std::integral_constant<int, L>, const PointScale& scale) {
        const ExactDifferences<L> points(pair, scale);
        const ExactPlane<L> plane = plane_of(points, corners);
        return keep_level(levels, corners[0], [&](std::size_t side, std::uint32_t from, std::uint32_t to) {
            return points.beyond(side, plane.n, points.point(side, from), points.point(side, to));
        });
    });
}

bool is_beyond_exactly(const ConvexPair& pair, const std::array<DifferenceVertex, 3>& corners,
                       const DifferenceVertex& vertex) {
    return with_limbs(pair, [&]<int L>(std::integral_constant<int, L>, const PointScale& scale) {
        const ExactDifferences<L> points(pair, scale);
        return plane_of(points, corners).sign_at(points.difference(vertex)) > 0;
    });
}

int compare_exactly(const ConvexPair& pair, const std::array<DifferenceVertex, 3>& first,
                    const std::array<DifferenceVertex, 3>& second) {
    return with_limbs(pair, [&]<int L>(std::integral_constant<int, L>, const PointScale& scale) {
        const ExactDifferences<L> points(pair, scale);
        return compare(plane_of(points, first), plane_of(points, second));
    });
}

}  // namespace ecods::depths
