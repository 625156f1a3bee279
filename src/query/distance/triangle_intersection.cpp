#include "exact/measure/distance/polygon_order.hpp"
#include "exact/measure/distance/shared_corners.hpp"
#include "exact/measure/round/direction.hpp"
#include "exact/measure/round/exact_point.hpp"
#include "query/distance/triangle_distances.hpp"
#include "query/distance/triangle_features.hpp"

namespace ecods {

using namespace exact;

SharedSet TriangleDistances::intersection(std::uint32_t i, std::uint32_t j) {
    return with_features(i, j, [&](const auto& points, const auto& features, const ClosestFeatures&) {
        SharedSet result;
        const SharedCorners shared(features);
        if (const auto normal = shared.normal()) result.normal = round_direction(*normal);
        ExactPoint point;
        for (const auto& corner : corners_around(shared)) {
            corner.assign_to(point, points.unit);
            result.all_corners[result.corner_count++] = round_point(first_corner(i), point);
        }
        return result;
    });
}

}  // namespace ecods
