// The library's answers about one pair of triangles, by each path that gives any.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "ecods/mesh.hpp"
#include "ecods/primitives.hpp"
#include "environment/float_mode.hpp"
#include "query/intersection/triangle_relations.hpp"
#include "scenes/hard_pairs.hpp"

namespace ecods::fuzz {

using environment::float_modes;
using environment::FloatMode;
using environment::InFloatMode;

// `path` is the first whose answer was not `expected`; null if all agreed.
struct Answer {
    const char* path = nullptr;
    Relation relation = Relation::apart;
};

// Asks everything in the given mode: the predicate and the cached path of the narrow phase, arguments in both orders.
// `bodies` may have been used before; it must not matter.
Answer ask_all_paths(const scenes::PosedPair& pair, Relation expected, const FloatMode& mode,
                     TriangleRelations& bodies);

// The predicate alone, in all 36 orders of corners and both of arguments.
Answer ask_all_orders(const scenes::PosedPair& pair, Relation expected);

// Two meshes of a few triangles that share vertices, at a pose each.
struct MeshPair {
    std::shared_ptr<const Mesh> a;
    std::shared_ptr<const Mesh> b;
    Pose pose_a;
    Pose pose_b;
};

// The triangles of one mesh against those of the other, as a pair on its own.
scenes::PosedPair triangle_pair_of(const MeshPair& meshes, std::uint32_t a, std::uint32_t b);

// The extents of two meshes, for as long as a TriangleRelations is asked about them.
class BoundMeshes {
  public:
    explicit BoundMeshes(const MeshPair& meshes);
    void bind(TriangleRelations& bodies, const MeshPair& meshes, bool is_swapped) const;

  private:
    exact::MeshExtent extent_a_;
    exact::MeshExtent extent_b_;
};

}  // namespace ecods::fuzz
