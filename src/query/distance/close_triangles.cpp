#include <algorithm>
#include <array>

#include "base/limits.hpp"
#include "ecods/distance.hpp"
#include "query/distance/distance_search.hpp"

namespace ecods {

std::vector<ClosestPoints> close_triangles(const Posed<MeshShape>& a, const Posed<MeshShape>& b, double d,
                                           QueryMemory& memory) {
    require_finite_distance(d);
    std::vector<ClosestPoints> result;
    DistanceSearch search(a, b, memory);
    search.visit_within(d, [&](const TrianglePair& pair, const DistanceInterval&) {
        result.push_back(search.exact_pair().closest(pair.a, pair.b));
    });
    std::ranges::sort(result, {}, [](const ClosestPoints& points) { return points.triangles(); });
    return result;
}

}  // namespace ecods
