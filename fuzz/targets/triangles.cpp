// How two posed triangles meet, against the oracle.
#include "ecods/primitives.hpp"
#include "fuzz/targets/bytes.hpp"
#include "fuzz/targets/require.hpp"
#include "oracle/oracle.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ecods;
    using ecods::fuzz::require;
    ecods::fuzz::Bytes bytes(data, size);
    const Pose pose_a = bytes.pose();
    const Pose pose_b = bytes.below(2) == 0 ? pose_a : bytes.pose();
    std::array<Vec3, 3> a, b;
    for (auto* triangle : {&a, &b}) {
        for (Vec3& corner : *triangle) corner = bytes.point();
    }
    const Relation expected = oracle::triangle_triangle(pose_a, a, pose_b, b);
    require(triangle_triangle({pose_a, a}, {pose_b, b}) == expected, "the relation of two posed triangles");
    require(triangle_triangle({pose_b, b}, {pose_a, a}) == expected, "the relation, swapped");
    std::swap(a[0], a[1]);
    std::swap(b[0], b[2]);
    require(triangle_triangle({pose_a, a}, {pose_b, b}) == expected, "the relation, corners in another order");
    const Pose nowhere;
    require(triangle_triangle(a, b) == oracle::triangle_triangle(nowhere, a, nowhere, b), "the relation without poses");
    return 0;
}
