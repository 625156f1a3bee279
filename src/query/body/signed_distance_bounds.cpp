#include "base/double_key.hpp"
#include "ecods/distance.hpp"
#include "ecods/solid.hpp"
#include "query/body/posed_body.hpp"
#include "query/intersection/asking.hpp"
#include "query/intersection/query_memory.hpp"

namespace ecods {

DistanceBounds signed_distance_bounds(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const Ask& ask) {
    Asking asking(ask);
    QueryMemory& memory = asking.memory();
    const BodyPairAsked bodies(a, b);
    return as_one_query(memory, [&]() -> DistanceBounds {
        const Ask part(memory, asking.witness());
        const double apart = distance(a, b, part);
        if (key_of(apart) > 0) return {apart, apart};
        if (bodies.are_convex()) {
            const double inside = opposite(depth(bodies.a.convex(), bodies.b.convex(), part)->depth);
            return {inside, inside};
        }
        if (!bodies.a.has_inside() || !bodies.b.has_inside()) return {apart, apart};
        const DepthBounds inside = *depth_bounds(bodies.a.solid(), bodies.b.solid(), part);
        return {opposite(inside.upper), opposite(inside.lower)};
    });
}

}  // namespace ecods
