// The ball around a mesh's box, by which copies of it are put beside each other.
#pragma once

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"
#include "ecods/primitives.hpp"
#include "ecods/shape.hpp"

namespace ecods::scenes {

struct Ball {
    Vec3 centre;
    double radius = 0;
};

inline Ball ball_of(const Mesh& mesh) {
    const Aabb box = box_of(mesh, Pose{});
    Ball ball{(box.min + box.max) / 2, 0};
    for (const Vec3& vertex : mesh.vertices()) {
        const Vec3 arm = vertex - ball.centre;
        ball.radius = std::max(ball.radius, std::sqrt((arm.x() * arm.x() + arm.y() * arm.y()) + arm.z() * arm.z()));
    }
    return ball;
}

// Written out, because Eigen adds up in an order that depends on the instruction set.
inline Vec3 image(const Mat3& R, const Vec3& v) {
    return {(R(0, 0) * v.x() + R(0, 1) * v.y()) + R(0, 2) * v.z(),
            (R(1, 0) * v.x() + R(1, 1) * v.y()) + R(1, 2) * v.z(),
            (R(2, 0) * v.x() + R(2, 1) * v.y()) + R(2, 2) * v.z()};
}

inline Mat3 product(const Mat3& left, const Mat3& right) {
    Mat3 result;
    for (int k = 0; k < 3; ++k) result.col(k) = image(left, right.col(k));
    return result;
}

// About an axis of length 1, by twice the angle of this tangent, up to rounding: no sine is asked for.
inline Mat3 turn_about(const Vec3& axis, double tangent) {
    const double norm = std::sqrt(1 + tangent * tangent), sine = tangent / norm;
    return Eigen::Quaterniond(1 / norm, sine * axis[0], sine * axis[1], sine * axis[2]).toRotationMatrix();
}

// Turns the mesh, and puts the centre of its ball at `centre`.
inline Pose place(const Ball& ball, const Mat3& R, const Vec3& centre) {
    return {R, centre - image(R, ball.centre)};
}

}  // namespace ecods::scenes
