// A mesh as Bullet has it: its arrays, or its convex hull.
#pragma once

#include <btBulletCollisionCommon.h>

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "ecods/mesh.hpp"

namespace ecods::bench {

inline btVector3 to_bullet(const Vec3& v) {
    return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}

inline btTransform to_bullet(const Pose& pose) {
    const auto f = [](double x) { return static_cast<btScalar>(x); };
    const Mat3& R = pose.R;
    const btMatrix3x3 rotation(f(R(0, 0)), f(R(0, 1)), f(R(0, 2)), f(R(1, 0)), f(R(1, 1)), f(R(1, 2)), f(R(2, 0)),
                               f(R(2, 1)), f(R(2, 2)));
    return btTransform(rotation, to_bullet(pose.t));
}

// Shapes refer to it. Not to be moved.
class BulletArrays {
  public:
    BulletArrays(std::span<const Vec3> vertices, std::span<const Triangle> triangles) {
        for (const Vec3& v : vertices)
            for (int axis = 0; axis < 3; ++axis) vertices_.push_back(static_cast<btScalar>(v[axis]));
        for (const Triangle& t : triangles)
            for (const std::uint32_t index : t) indices_.push_back(static_cast<int>(index));
        arrays_ = std::make_unique<btTriangleIndexVertexArray>(
            static_cast<int>(triangles.size()), indices_.data(), static_cast<int>(3 * sizeof(int)),
            static_cast<int>(vertices.size()), vertices_.data(), static_cast<int>(3 * sizeof(btScalar)));
    }
    BulletArrays(const BulletArrays&) = delete;
    BulletArrays& operator=(const BulletArrays&) = delete;

    btTriangleIndexVertexArray* get() const { return arrays_.get(); }

  private:
    std::vector<btScalar> vertices_;
    std::vector<int> indices_;
    std::unique_ptr<btTriangleIndexVertexArray> arrays_;
};

// The hull without the margin that Bullet gives it.
inline std::unique_ptr<btConvexHullShape> to_bullet_hull(const Mesh& mesh) {
    auto hull = std::make_unique<btConvexHullShape>();
    for (const Vec3& v : mesh.vertices()) hull->addPoint(to_bullet(v), false);
    hull->recalcLocalAabb();
    hull->setMargin(0);
    return hull;
}

}  // namespace ecods::bench
