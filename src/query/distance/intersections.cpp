#include "query/distance/distance_search.hpp"
#include "query/distance/surface_distance.hpp"
#include "query/intersection/asking.hpp"
#include "query/intersection/query_memory.hpp"
#include "query/intersection/surface_intersection.hpp"

namespace ecods {

std::vector<TriangleIntersection> surface::intersections(const Posed<MeshShape>& a, const Posed<MeshShape>& b,
                                                         const Ask& ask) {
    Asking asking(ask);
    QueryMemory& memory = asking.memory();
    const auto pairs = as_part(memory, [&] { return surface::intersecting_triangles(a, b, memory); });
    std::vector<TriangleIntersection> result;
    if (pairs.empty()) return result;
    result.reserve(pairs.size());
    DistanceSearch search(a, b, memory);
    for (const TrianglePair& pair : pairs) result.push_back({pair, search.exact_pair().intersection(pair.a, pair.b)});
    return result;
}

}  // namespace ecods
