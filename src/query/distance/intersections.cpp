#include "ecods/distance.hpp"
#include "ecods/intersection.hpp"
#include "query/distance/distance_search.hpp"
#include "query/intersection/asking.hpp"
#include "query/intersection/query_memory.hpp"

namespace ecods {

std::vector<TriangleIntersection> intersections(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const Ask& ask) {
    Asking asking(ask);
    QueryMemory& memory = asking.memory();
    const auto pairs = as_part(memory, [&] { return intersecting_triangles(a, b, memory); });
    std::vector<TriangleIntersection> result;
    if (pairs.empty()) return result;
    result.reserve(pairs.size());
    DistanceSearch search(a, b, memory);
    for (const TrianglePair& pair : pairs) result.push_back({pair, search.exact_pair().intersection(pair.a, pair.b)});
    return result;
}

}  // namespace ecods
