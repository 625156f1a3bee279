// That the queries about the triangles of two bodies answer as the oracle does.
#pragma once

#include <gtest/gtest.h>

#include "ecods/intersection.hpp"
#include "oracle/oracle.hpp"

namespace ecods {

// All three queries, in both orders.
inline void expect_right(const MeshShape& a, const Pose& pose_a, const MeshShape& b, const Pose& pose_b,
                         QueryMemory& memory) {
    const oracle::OracleMesh exact_a(a.mesh_ptr(), pose_a), exact_b(b.mesh_ptr(), pose_b);
    const auto expected = oracle::intersecting_triangles(exact_a, exact_b);
    const Posed<MeshShape> x{a, pose_a}, y{b, pose_b};
    ASSERT_EQ(intersecting_triangles(x, y, memory), expected);
    ASSERT_EQ(intersects(x, y, memory), !expected.empty());
    ASSERT_EQ(intersects(y, x, memory), !expected.empty());
    ASSERT_EQ(relation(x, y, memory), oracle::relation(exact_a, exact_b));
    ASSERT_EQ(relation(y, x, memory), oracle::relation(exact_a, exact_b));
    ASSERT_EQ(intersecting_triangles(y, x, memory).size(), expected.size());
}

}  // namespace ecods
