#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "base/double_key.hpp"
#include "ecods/distance.hpp"
#include "ecods/error.hpp"
#include "query/distance/distance_search.hpp"

namespace ecods {

std::vector<ClosestPoints> close_triangles(const Posed<MeshShape>& a, const Posed<MeshShape>& b, double d,
                                           QueryMemory& memory) {
    const std::int64_t key = key_of(d);
    if (key < 0 || key >= key_of(std::numeric_limits<double>::infinity())) throw InvalidDistance(d);
    std::vector<ClosestPoints> result;
    DistanceSearch search(a, b, memory);
    search.visit_within(d, [&](const TrianglePair& pair, const DistanceInterval&) {
        result.push_back(search.exact_pair().closest(pair.a, pair.b));
    });
    std::ranges::sort(result, {}, [](const ClosestPoints& points) { return points.triangles(); });
    return result;
}

}  // namespace ecods
