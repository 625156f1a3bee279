// Cases of a body and a half space, by families: lattices, general poses, contact within an ulp, far scales, wide
// numbers.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "ecods/rounded.hpp"
#include "ecods/solid.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"

namespace ecods::half_space_cases {

using scenes::Random;

// One case: a body, a half space, a motion and an end pose of the body, and where the half space is at the end.
struct Case {
    std::shared_ptr<const MeshShape> shape;
    Pose body, end;
    Vec3 motion = Vec3::Zero(), half_space_end = Vec3::Zero();
    std::shared_ptr<const HalfSpace> half_space;
    Pose at;
};

inline std::shared_ptr<const MeshShape> shape_of(Random& random) {
    switch (random.below(6)) {
        case 4: {  // triangles in the other order than their vertices
            const auto cube = scenes::cube(0.5);
            return std::make_shared<MeshShape>(Mesh::create({cube->vertices().begin(), cube->vertices().end()},
                                                            {cube->triangles().rbegin(), cube->triangles().rend()}));
        }
        case 0:
            return std::make_shared<MeshShape>(scenes::cube(0.5));
        case 1:
            return std::make_shared<MeshShape>(scenes::sphere(9, 7));
        case 2:
            return std::make_shared<MeshShape>(scenes::torus(14, 8, 0.3));
        case 3:  // a vertex that no triangle uses, two with equal coordinates, and triangles without area
            return std::make_shared<MeshShape>(
                Mesh::create({Vec3(0, 0, -9), Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 0)},
                             {{1, 2, 3}, {4, 4, 4}, {2, 3, 2}}));
        default:
            return std::make_shared<MeshShape>(
                scenes::one_triangle({random.direction(), random.direction(), random.direction()}));
    }
}

inline Vec3 small_integers(Random& random) {
    return Vec3(random.below(7) - 3.0, random.below(7) - 3.0, random.below(7) - 3.0);
}

inline Mat3 small_integer_matrix(Random& random) {
    for (;;) {
        Mat3 R;
        for (int k = 0; k < 3; ++k) R.col(k) = small_integers(random);
        if (std::abs(R.determinant()) > 0.5) return R;
    }
}

// Lattices: ties, contacts, and planes through vertices, edges and faces.
inline Case lattice(Random& random) {
    Case c;
    c.shape = shape_of(random);
    c.body = {small_integer_matrix(random), small_integers(random)};
    c.end = {small_integer_matrix(random), 4 * small_integers(random)};
    c.motion = 3 * small_integers(random);
    Vec3 normal = small_integers(random);
    if (normal.isZero()) normal = Vec3::UnitZ();
    c.half_space = std::make_shared<HalfSpace>(normal, 0.5 * (random.below(9) - 4.0));
    c.at = {random.below(2) == 0 ? Mat3(Mat3::Identity()) : small_integer_matrix(random), small_integers(random)};
    c.half_space_end = c.at.t + small_integers(random);
    return c;
}

// Rotations, stretched and mirrored bodies and half spaces.
inline Case general(Random& random) {
    Case c;
    c.shape = shape_of(random);
    c.body = random.turned();
    c.body.t = 2 * random.direction();
    c.end = random.turned();
    c.end.t = 2 * random.direction();
    if (random.below(3) == 0) c.body.R.col(0) *= -random.uniform(0.5, 2);
    c.motion = 4 * random.direction();
    c.half_space = std::make_shared<HalfSpace>(random.direction() * random.uniform(0.1, 10), random.uniform(-1, 1));
    c.at = random.turned();
    c.at.t = random.direction();
    if (random.below(3) == 0) c.at.R.row(1) *= -random.uniform(0.5, 2);
    if (random.below(3) == 0) c.at.R(0, 1) += random.uniform(-2, 2);
    c.half_space_end = c.at.t + random.direction();
    return c;
}

// The plane is within an ulp or so of a vertex: the height of the lowest vertex is computed, and the offset follows it.
inline Case near_contact(Random& random) {
    Case c = general(random);
    c.at = {};
    c.half_space_end = Vec3::Zero();
    const Vec3 n = random.direction();
    const double low = [&] {
        double least = std::numeric_limits<double>::infinity();
        for (const Vec3& v : c.shape->mesh().vertices()) least = std::min(least, n.dot(c.body.R * v + c.body.t));
        return least;
    }();
    double offset = low;
    const double to = random.below(2) == 0 ? -10 : 10;
    for (std::uint32_t i = random.below(4); i > 0; --i) offset = std::nextafter(offset, to);
    c.half_space = std::make_shared<HalfSpace>(n, offset);
    return c;
}

inline double finite(double x) {
    return std::clamp(x, -std::numeric_limits<double>::max(), std::numeric_limits<double>::max());
}

// Everything times powers of two, up to where numbers leave the range of doubles in between.
inline Case scaled(Random& random, Case c) {
    const int exponents[] = {-1000, -500, -120, 120, 300};
    const double s = std::ldexp(1.0, exponents[random.below(5)]);
    c.body.R *= s;
    c.body.t *= s;
    c.end.R *= s;
    c.end.t *= s;
    c.motion *= s;
    c.at.t *= s;
    c.half_space_end *= s;
    const double m = std::ldexp(1.0, exponents[random.below(5)]);
    if (random.below(2) == 0) {
        c.at.R *= m;
        c.half_space = std::make_shared<HalfSpace>(c.half_space->normal(), finite(c.half_space->offset() / m * s));
    } else {
        c.half_space = std::make_shared<HalfSpace>(c.half_space->normal() * m, finite(c.half_space->offset() * m * s));
    }
    return c;
}

// Numbers of very different size side by side, and subnormal ones.
inline Case wide(Random& random) {
    Case c = general(random);
    const auto stretch = [&](double x) { return std::ldexp(x, static_cast<int>(random.below(2000)) - 1050); };
    const Vec3 n = random.direction();
    c.half_space = std::make_shared<HalfSpace>(Vec3(stretch(n[0]), stretch(n[1]), n[2]), stretch(1));
    for (int k = 0; k < 3; ++k) {
        c.at.t[k] = stretch(c.at.t[k]);
        c.body.t[k] = stretch(c.body.t[k]);
        c.motion[k] = stretch(c.motion[k]);
    }
    return c;
}

}  // namespace ecods::half_space_cases
