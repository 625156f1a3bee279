// A body modelled far from its own origin, and brought back by its translation: its rounded points are off by far more
// than its size suggests. The other body's are exact.

#include <gtest/gtest.h>

#include <cmath>

#include "ecods/mesh.hpp"
#include "ecods/primitives.hpp"
#include "oracle/oracle.hpp"
#include "query/intersection/triangle_relations.hpp"
#include "scenes/random.hpp"

namespace ecods::exact::far_frame_test {
namespace {

// A corner next to the face z = 0 of the other triangle: on which side is a matter of the roundings of R v + t.
TEST(FarFrame, ErrorsOfEitherBodyCount) {
    scenes::Random random(5);
    const Pose identity;
    const std::array<Vec3, 3> face{Vec3(-8, -8, 0), Vec3(8, -8, 0), Vec3(0, 8, 0)};
    const auto mesh_a = Mesh::create({face.begin(), face.end()}, {{0, 1, 2}});
    const MeshExtent extent_a = measure(*mesh_a);
    TriangleRelations bodies;
    std::array<int, 3> counts{};
    for (int i = 0; i < 2000; ++i) {
        Pose pose = random.turned();
        const Vec3 center = std::ldexp(1.0, static_cast<int>(random.below(40))) * random.direction();
        const std::array<Vec3, 3> corners{center, center + pose.R.transpose() * Vec3(1, 0, 2),
                                          center + pose.R.transpose() * Vec3(0, 1, 3)};
        pose.t = -(pose.R * center);
        const double step = std::nextafter(std::abs(pose.t[2]), 0x1p60) - std::abs(pose.t[2]);
        pose.t[2] += (random.below(9) - 4.0) * step;

        const Relation expected = oracle::triangle_triangle(identity, face, pose, corners);
        ++counts[static_cast<std::size_t>(expected)];
        ASSERT_EQ(triangle_triangle({identity, face}, {pose, corners}), expected) << i;
        ASSERT_EQ(triangle_triangle({pose, corners}, {identity, face}), expected) << i;
        const auto mesh_b = Mesh::create({corners.begin(), corners.end()}, {{0, 1, 2}});
        const MeshExtent extent_b = measure(*mesh_b);
        const BodyRef a{mesh_a.get(), &extent_a, &identity}, b{mesh_b.get(), &extent_b, &pose};
        bodies.bind(a, b);
        ASSERT_EQ(bodies.relation(0, 0), expected) << i;
        bodies.bind(b, a);
        ASSERT_EQ(bodies.relation(0, 0), expected) << i;
    }
    EXPECT_GT(counts[0], 500);
    EXPECT_GT(counts[2], 500);
}

}  // namespace
}  // namespace ecods::exact::far_frame_test
