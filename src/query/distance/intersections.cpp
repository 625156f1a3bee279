#include "ecods/contact.hpp"
#include "query/distance/distance_search.hpp"

namespace ecods {

std::vector<TriangleIntersection> intersections(const Posed<MeshShape>& a, const Posed<MeshShape>& b,
                                                QueryMemory& memory) {
    DistanceSearch search(a, b, memory);
    std::vector<TriangleIntersection> result;
    for (const TrianglePair& pair : intersecting_triangles(a, b, memory)) {
        result.push_back({pair, search.exact_pair().intersection(pair.a, pair.b)});
    }
    return result;
}

}  // namespace ecods
