// Small polygons, segments, points and cubes as convex solids.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "ecods/intersection.hpp"
#include "ecods/solid.hpp"
#include "unit/query/solid_soup.hpp"

namespace ecods::flat_sets {

using SolidPtr = std::shared_ptr<const ConvexSolid>;

inline SolidPtr hull_of(const std::vector<Vec3>& points) {
    return std::make_shared<const ConvexSolid>(std::span<const Vec3>(points));
}

inline SolidPtr solid_of(std::vector<Vec3> vertices, std::vector<Triangle> triangles) {
    return std::make_shared<const ConvexSolid>(Mesh::create(std::move(vertices), std::move(triangles)));
}

// In the plane z = 0.
inline SolidPtr square(double half) {
    return hull_of({{-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}});
}
inline SolidPtr segment(const Vec3& p, const Vec3& q) {
    return hull_of({p, q});
}
inline SolidPtr point(const Vec3& p) {
    return hull_of({p});
}
inline SolidPtr cube(double half) {
    return std::make_shared<const ConvexSolid>(box(Vec3::Constant(-half), Vec3::Constant(half)));
}

inline std::vector<Triangle> triangles_of(const SolidPtr& solid) {
    return {solid->mesh().triangles().begin(), solid->mesh().triangles().end()};
}

inline void expect_relation(Relation expected, const Posed<MeshShape>& a, const Posed<MeshShape>& b) {
    EXPECT_EQ(relation(a, b), expected);
    EXPECT_EQ(relation(b, a), swapped(expected));
    EXPECT_EQ(intersects(a, b), expected != Relation::apart);
    EXPECT_EQ(intersects(b, a), expected != Relation::apart);
}

}  // namespace ecods::flat_sets
