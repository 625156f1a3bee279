// Bodies of one triangle, and what is expected of their first contact.
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "ecods/cast.hpp"
#include "scenes/pose_at.hpp"

namespace ecods {

using Contact = std::optional<FirstContact>;

inline MeshShape shape_of(const std::vector<Vec3>& vertices) {
    std::vector<Triangle> triangles;
    for (std::uint32_t i = 0; i + 3 <= vertices.size(); i += 3) triangles.push_back({i, i + 1, i + 2});
    return MeshShape(Mesh::create(vertices, triangles));
}

inline void expect_contact(const Contact& contact, double time, ClosestKind kind) {
    ASSERT_TRUE(contact.has_value());
    EXPECT_EQ(contact->time, time);
    EXPECT_EQ(contact->kind, kind);
}

inline const std::vector<Vec3> flat{{-1, -1, 0}, {2, -1, 0}, {-1, 2, 0}};
inline const std::vector<Vec3> needle{{0, 0, 0}, {0.25, 0, 1}, {-0.25, 0, 1}};
inline const std::vector<Vec3> single_point{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};

}  // namespace ecods
