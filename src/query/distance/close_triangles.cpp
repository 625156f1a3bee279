#include <algorithm>
#include <array>

#include "base/limits.hpp"
#include "query/distance/distance_search.hpp"
#include "query/distance/surface_distance.hpp"
#include "query/intersection/asking.hpp"

namespace ecods {

std::vector<ClosestPoints> surface::close_triangles(const Posed<MeshShape>& a, const Posed<MeshShape>& b,
                                                    double max_distance, const Ask& ask) {
    require_finite_distance(max_distance);
    Asking asking(ask);
    std::vector<ClosestPoints> result;
    DistanceSearch search(a, b, asking.memory());
    search.visit_within(max_distance, [&](const TrianglePair& pair, const DistanceInterval&) {
        result.push_back(search.exact_pair().closest(pair.a, pair.b));
    });
    std::ranges::sort(result, {}, [](const ClosestPoints& points) { return points.triangles(); });
    return result;
}

std::optional<std::vector<TrianglePair>> surface::pairs_within(const Posed<MeshShape>& a, const Posed<MeshShape>& b,
                                                               double d, std::size_t most, QueryMemory& memory) {
    std::vector<TrianglePair> pairs;
    bool are_too_many = false;
    DistanceSearch search(a, b, memory);
    search.visit_within(d, [&](const TrianglePair& pair, const DistanceInterval&) {
        are_too_many = pairs.size() == most;
        if (!are_too_many) pairs.push_back(pair);
        return !are_too_many;
    });
    if (are_too_many) return std::nullopt;
    return pairs;
}

}  // namespace ecods
