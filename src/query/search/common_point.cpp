#include "query/search/common_point.hpp"

#include "query/intersection/surface_intersection.hpp"

namespace ecods {

bool CommonPoint::is_in(const TrianglePair& triangles) {
    TriangleRelations& relations = QueryMemoryAccess::state(memory_).pair;
    if (!is_bound_) {
        relations.reset_counts();
        relations.bind(bodies_.a.ref(), bodies_.b.ref());
        is_bound_ = true;
    }
    return relations.relation(triangles.a, triangles.b) != Relation::apart;
}

bool CommonPoint::is_found_among_overlaps() {
    if (++overlap_count_ != overlap_max) return false;
    leave();
    const Posed<MeshShape> a(bodies_.a.shape, bodies_.a.pose), b(bodies_.b.shape, bodies_.b.pose);
    return as_part(memory_, [&] { return surface::intersects(a, b, memory_); });
}

void CommonPoint::leave() noexcept {
    if (!is_bound_) return;
    QueryMemoryAccess::State& state = QueryMemoryAccess::state(memory_);
    state.counts.stages += state.pair.counts();
    is_bound_ = false;
}

}  // namespace ecods
