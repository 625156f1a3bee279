// Questions about two meshes, against the oracle: in both orders, with witnesses of whatever kind, and after a refit.
#include <algorithm>

#include "ecods/intersection.hpp"
#include "fuzz/targets/bytes.hpp"
#include "fuzz/targets/require.hpp"
#include "oracle/oracle.hpp"

namespace {

using namespace ecods;
using ecods::fuzz::require;

void check(const Posed<MeshShape>& a, const Posed<MeshShape>& b, QueryMemory& memory, PairWitness& witness) {
    const oracle::OracleMesh exact_a(a.what->mesh_ptr(), a.pose), exact_b(b.what->mesh_ptr(), b.pose);
    require(oracle::box_contains(a.what->box(a.pose), exact_a), "a box contains its body");
    oracle::Verdict expected = oracle::verdict(exact_a, exact_b);
    const bool hit = !expected.triangles.empty();
    require(intersects(a, b, memory) == hit, "whether two meshes share a point");
    require(intersects(b, a, memory) == hit, "whether two meshes share a point, swapped");
    require(intersects(a, b, {memory, witness}) == hit, "the same with a witness");
    require(intersects(a, b, {memory, witness}) == hit, "the same with the witness that was just left");
    require(relation(a, b, memory) == expected.relation, "the relation of two meshes");
    require(relation(b, a, memory) == expected.relation, "the relation of two meshes, swapped");
    require(intersecting_triangles(a, b, memory) == expected.triangles, "the triangles that touch");
    for (TrianglePair& pair : expected.triangles) std::swap(pair.a, pair.b);
    std::ranges::sort(expected.triangles);
    require(intersecting_triangles(b, a, memory) == expected.triangles, "the triangles that touch, swapped");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    ecods::fuzz::Bytes bytes(data, size);
    // More triangles than a leaf has places, and sometimes more vertices than are posed one by one.
    const MeshShape a(bytes.mesh(40, 30)), b(bytes.mesh(8, 20));
    QueryMemory memory;
    PairWitness witness{bytes.byte(), bytes.byte()};
    const Pose pose = bytes.pose();
    check({a, pose}, {b, pose}, memory, witness);
    for (int i = 0; i < 3 && !bytes.empty(); ++i) {
        const Pose other = bytes.pose();
        check({a, pose}, {b, other}, memory, witness);
    }
    std::vector<Vec3> vertices(a.mesh().vertices().begin(), a.mesh().vertices().end());
    for (Vec3& v : vertices) {
        if (bytes.below(3) == 0) v = bytes.point();
    }
    const auto soft = refit(a, std::move(vertices));
    const Pose other = bytes.pose();
    check({*soft, pose}, {b, other}, memory, witness);
    return 0;
}
