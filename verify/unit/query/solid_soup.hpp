// Small meshes for tests of solids, and poses for them.
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "ecods/solid.hpp"
#include "scenes/random.hpp"

namespace ecods {

using MeshPtr = std::shared_ptr<const Mesh>;

// Triangles with corners of their own, as formats without indices have them.
struct Soup {
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;

    void add(const Vec3& a, const Vec3& b, const Vec3& c) {
        const auto first = static_cast<std::uint32_t>(vertices.size());
        vertices.insert(vertices.end(), {a, b, c});
        triangles.push_back({first, first + 1, first + 2});
    }
    void add(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
        add(a, b, c);
        add(a, c, d);
    }
    // Each face as a grid of rectangles.
    void add_box(const Vec3& low, const Vec3& high, int parts = 1) {
        for (int axis = 0; axis < 3; ++axis) {
            const int i = (axis + 1) % 3, j = (axis + 2) % 3;
            for (const bool is_high : {false, true}) {
                const auto at = [&](int p, int q) {
                    Vec3 v;
                    v[axis] = is_high ? high[axis] : low[axis];
                    v[i] = p == parts ? high[i] : low[i] + (high[i] - low[i]) * p / parts;
                    v[j] = q == parts ? high[j] : low[j] + (high[j] - low[j]) * q / parts;
                    return v;
                };
                for (int p = 0; p < parts; ++p) {
                    for (int q = 0; q < parts; ++q) add(at(p, q), at(p + 1, q), at(p + 1, q + 1), at(p, q + 1));
                }
            }
        }
    }
    MeshPtr mesh() const { return Mesh::create(vertices, triangles); }
};

inline Soup soup_of_box(const Vec3& low, const Vec3& high, int parts = 1) {
    Soup soup;
    soup.add_box(low, high, parts);
    return soup;
}

inline MeshPtr box(const Vec3& low, const Vec3& high, int parts = 1) {
    return soup_of_box(low, high, parts).mesh();
}

inline Soup octahedron(const Vec3& center, double reach) {
    Soup soup;
    for (const double x : {-reach, reach}) {
        for (const double y : {-reach, reach}) {
            for (const double z : {-reach, reach}) {
                soup.add(center + Vec3(x, 0, 0), center + Vec3(0, y, 0), center + Vec3(0, 0, z));
            }
        }
    }
    return soup;
}

inline Relation swapped(Relation relation) {
    return relation == Relation::inside     ? Relation::contains
           : relation == Relation::contains ? Relation::inside
                                            : relation;
}

// Poses that are the same affine map for both, so that the answer stays: also reflecting, sheared, and of any size.
inline std::vector<Pose> common_poses() {
    std::vector<Pose> poses(1);
    Pose mirrored;
    mirrored.R << -1, 0, 0, 0, 1, 0, 0, 0, 1;
    mirrored.t = Vec3(3, -5, 7);
    poses.push_back(mirrored);
    Pose sheared;
    sheared.R << 3, 1, -2, 0, 5, 1, 2, 0, 7;
    sheared.t = Vec3(0.1, 0.2, 0.3);
    poses.push_back(sheared);
    scenes::Random random(11);
    Pose turned = random.turned();
    poses.push_back(turned);
    for (const int exponent : {-900, -200, 200, 900}) {
        Pose scaled = turned;
        scaled.R *= std::ldexp(1.0, exponent);
        poses.push_back(scaled);
    }
    return poses;
}

}  // namespace ecods
