// What meshes are taken for.
#include "programs/clash/make_shape.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "ecods/mesh.hpp"
#include "ecods/shape.hpp"
#include "ecods/solid.hpp"

namespace ecods::clash {
namespace {

using Triangles = std::vector<Triangle>;

std::shared_ptr<const Mesh> tetrahedron(const Triangles& triangles) {
    return Mesh::create({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5, 0, 0}}, triangles);
}

template <class T>
bool is_a(const MadeShape& made) {
    return dynamic_cast<const T*>(made.shape.get()) != nullptr;
}

TEST(ClashShapes, ClosedMeshesAreSolids) {
    const auto closed = tetrahedron({{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
    EXPECT_TRUE(is_a<ConvexSolid>(make_shape(closed, true)));
    EXPECT_TRUE(is_a<Solid>(make_shape(closed, false)));
    EXPECT_EQ(make_shape(closed, false).not_solid_because, "");
}

TEST(ClashShapes, OthersAreSurfacesWithTheirReason) {
    const MadeShape open = make_shape(tetrahedron({{0, 2, 1}, {0, 1, 3}, {0, 3, 2}}), true);
    EXPECT_FALSE(is_a<Solid>(open) || is_a<ConvexSolid>(open));
    EXPECT_NE(open.not_solid_because.find("triangle"), std::string::npos) << open.not_solid_because;
}

// Triangles without area bound nothing.
TEST(ClashShapes, WhatHasNoAreaIsASurface) {
    for (const bool may_be_convex : {false, true}) {
        const MadeShape wire = make_shape(tetrahedron({{0, 4, 1}, {2, 3, 3}}), may_be_convex);
        EXPECT_FALSE(is_a<Solid>(wire) || is_a<ConvexSolid>(wire));
        EXPECT_EQ(wire.not_solid_because, "no triangle has an area: there is no interior");
    }
}

}  // namespace
}  // namespace ecods::clash
