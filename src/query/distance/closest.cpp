#include "query/distance/distance_search.hpp"
#include "query/distance/surface_distance.hpp"
#include "query/intersection/asking.hpp"
#include "query/intersection/surface_intersection.hpp"

namespace ecods {
namespace {

ClosestPoints closest_of_intersecting(const Posed<MeshShape>& a, const Posed<MeshShape>& b, DistanceSearch& search,
                                      QueryMemory& memory) {
    const TrianglePair first = surface::intersecting_triangles(a, b, memory).front();
    return search.exact_pair().closest(first.a, first.b);
}

// Returns the closest points, and sets the witness to their triangles.
ClosestPoints find_closest(const Posed<MeshShape>& a, const Posed<MeshShape>& b, DistanceSearch& search, Asking& asking,
                           const exact::Radii& radii) {
    search.run({}, asking.witness());
    ClosestPoints result;
    if (search.sieve().is_zero()) {
        result = closest_of_intersecting(a, b, search, asking.memory());
    } else {
        // Each pair of triangles at the least distance is open, or an open pair with the same closest features precedes
        // that pair in the order of triangles.
        const auto& open = search.sieve().keep_least(
            [&](const TrianglePair& x, const TrianglePair& y) { return search.exact_pair().compare(x, y); });
        result =
            least_closest(open, [&](const TrianglePair& x) { return search.exact_pair().closest(x.a, x.b, radii); });
    }
    asking.witness() = {result.a.triangle, result.b.triangle};
    return result;
}

}  // namespace

ClosestPoints surface::closest(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const Ask& ask,
                               const exact::Radii& radii) {
    Asking asking(ask);
    DistanceSearch search(a, b, asking.memory());
    return find_closest(a, b, search, asking, radii);
}

std::optional<CloseFeatures> surface::signed_closest(const Body& a, const Body& b, const Ask& ask,
                                                     const exact::Radii& radii) {
    Asking asking(ask);
    DistanceSearch search(a, b, asking.memory());
    ClosestPoints at = find_closest(a, b, search, asking, radii);
    if (at.kind == ClosestKind::intersecting) return std::nullopt;
    at.distance = search.exact_pair().signed_beyond(at.triangles(), radii.sum());
    return CloseFeatures{at, search.exact_pair().measure({at.kind, at.a, at.b}).direction};
}

}  // namespace ecods
