#include "ecods/depth.hpp"

#include <optional>

#include "ecods/error.hpp"
#include "query/convex/posed_hulls.hpp"
#include "query/depth/depth_memory.hpp"
#include "query/shape/mesh_tree.hpp"

namespace ecods {
namespace {

depths::ConvexBody body_of(const Posed<ConvexSolid>& solid) {
    return {&ConvexSolidAccess::hull(*solid.what),
            {&solid.what->mesh(), &MeshShapeAccess::tree(*solid.what).extent, &solid.pose}};
}

}  // namespace

Depth depth(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, QueryMemory& memory, PairWitness& witness) {
    ++QueryMemoryAccess::state(memory).counts.queries;
    const convex::PosedHulls hulls(a, b, memory);
    const depths::ConvexPair pair{body_of(a), body_of(b)};
    const std::optional<depths::ExactDepth> found = depths::find_depth(pair, hulls, depths::DepthMemory::of(memory));
    if (!found) throw SolidsApart();
    const Depth result{found->depth, name_of(*pair[0].hull, found->face[0]), name_of(*pair[1].hull, found->face[1]),
                       found->direction};
    witness = {result.a.triangle, result.b.triangle};
    return result;
}

Depth depth(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, QueryMemory& memory) {
    PairWitness witness;
    return depth(a, b, memory, witness);
}

}  // namespace ecods
