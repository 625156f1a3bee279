#include "fuzz/pairs/ask.hpp"

#include <algorithm>

#include "scenes/shapes.hpp"

namespace ecods::fuzz {
namespace {

std::array<Vec3, 3> corners_of(const Mesh& mesh, std::uint32_t triangle) {
    const Triangle& t = mesh.triangles()[triangle];
    return {mesh.vertices()[t[0]], mesh.vertices()[t[1]], mesh.vertices()[t[2]]};
}

}  // namespace

Answer ask_all_paths(const scenes::PosedPair& pair, Relation expected, const FloatMode& mode,
                     TriangleRelations& bodies) {
    const InFloatMode in_mode(mode);
    const PosedTriangle a{pair.pose_a, pair.a}, b{pair.pose_b, pair.b};
    if (const Relation r = triangle_triangle(a, b); r != expected) return {"triangle_triangle", r};
    if (const Relation r = triangle_triangle(b, a); r != expected) return {"triangle_triangle, swapped", r};
    const MeshPair meshes{scenes::one_triangle(pair.a), scenes::one_triangle(pair.b), pair.pose_a, pair.pose_b};
    const BoundMeshes bound(meshes);
    bound.bind(bodies, meshes, false);
    if (const Relation r = bodies.relation(0, 0); r != expected) return {"TriangleRelations", r};
    // A second time: what the first question prepared is used.
    if (const Relation r = bodies.relation(0, 0); r != expected) return {"TriangleRelations, again", r};
    bound.bind(bodies, meshes, true);
    if (const Relation r = bodies.relation(0, 0); r != expected) return {"TriangleRelations, swapped", r};
    return {};
}

Answer ask_all_orders(const scenes::PosedPair& pair, Relation expected) {
    std::array<std::size_t, 3> i{0, 1, 2};
    do {
        std::array<std::size_t, 3> j{0, 1, 2};
        do {
            const PosedTriangle a{pair.pose_a, {pair.a[i[0]], pair.a[i[1]], pair.a[i[2]]}};
            const PosedTriangle b{pair.pose_b, {pair.b[j[0]], pair.b[j[1]], pair.b[j[2]]}};
            for (const Relation r : {triangle_triangle(a, b), triangle_triangle(b, a)}) {
                if (r != expected) return {"triangle_triangle, corners in another order", r};
            }
        } while (std::ranges::next_permutation(j).found);
    } while (std::ranges::next_permutation(i).found);
    return {};
}

scenes::PosedPair triangle_pair_of(const MeshPair& meshes, std::uint32_t a, std::uint32_t b) {
    return {meshes.pose_a, meshes.pose_b, corners_of(*meshes.a, a), corners_of(*meshes.b, b), {}};
}

BoundMeshes::BoundMeshes(const MeshPair& meshes)
    : extent_a_(exact::measure(*meshes.a)), extent_b_(exact::measure(*meshes.b)) {}

void BoundMeshes::bind(TriangleRelations& bodies, const MeshPair& meshes, bool is_swapped) const {
    const exact::BodyRef a{meshes.a.get(), &extent_a_, &meshes.pose_a};
    const exact::BodyRef b{meshes.b.get(), &extent_b_, &meshes.pose_b};
    is_swapped ? bodies.bind(b, a) : bodies.bind(a, b);
}

}  // namespace ecods::fuzz
