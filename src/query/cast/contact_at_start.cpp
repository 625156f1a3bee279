#include "query/cast/contact_at_start.hpp"

#include "query/intersection/query_memory.hpp"

namespace ecods {

FirstContact contact_at_start(const Posed<MeshShape>& a, const Posed<MeshShape>& b, QueryMemory& memory) {
    const TrianglePair first = as_part(memory, [&] { return intersecting_triangles(a, b, memory); }).front();
    return {0, ClosestKind::intersecting, {Feature::Kind::face, first.a, 0}, {Feature::Kind::face, first.b, 0}};
}

}  // namespace ecods
