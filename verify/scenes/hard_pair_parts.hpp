// What the recipes of hard pairs are made of: random numbers with full mantissas, small integers, lattices.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "scenes/hard_pairs.hpp"

namespace ecods::scenes::hard {

using Int3 = std::array<std::int64_t, 3>;
using IntTriangle = std::array<Int3, 3>;

// A number with a full mantissa, unlike Random::uniform.
inline double full(Random& random, double min, double max) {
    const double high = random.uniform(0, 1), low = random.uniform(0, 1);
    return min + (max - min) * std::min(1.0, high + low * 0x1p-32);
}

inline int integer(Random& random, int min, int max) {
    return min + static_cast<int>(random.below(static_cast<std::uint32_t>(max - min + 1)));
}

inline bool coin(Random& random) {
    return random.below(2) == 0;
}

inline Mat3 rotation(Random& random) {
    return random.rotation().toRotationMatrix();
}

inline Pose random_pose(Random& random) {
    Pose pose;
    pose.R = rotation(random);
    for (int k = 0; k < 3; ++k) pose.t[k] = full(random, -10, 10);
    return pose;
}

// Takes the inverse away from the matrix, in one of three ways; in one case of four leaves it and returns false.
inline bool make_singular(Pose& pose, Random& random) {
    const int column = integer(random, 0, 2);
    switch (random.below(4)) {
        case 0:
            pose.R.col(column).setZero();
            return true;
        case 1:
            pose.R.col(column) = pose.R.col((column + 1) % 3);
            return true;
        case 2:
            pose.R = pose.R.col(column) * Vec3(1, 2, 3).transpose();
            return true;
        default:
            return false;
    }
}

inline Int3 cross(const Int3& a, const Int3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Int3 minus(const Int3& a, const Int3& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline std::int64_t dot(const Int3& a, const Int3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline IntTriangle integer_triangle(Random& random, int size) {
    for (;;) {
        IntTriangle t;
        for (Int3& corner : t) {
            for (auto& x : corner) x = integer(random, -size, size);
        }
        if (cross(minus(t[1], t[0]), minus(t[2], t[0])) != Int3{}) return t;
    }
}

inline Vec3 to_vec(const Int3& p, double scale = 1) {
    return {double(p[0]) * scale, double(p[1]) * scale, double(p[2]) * scale};
}

inline std::array<Vec3, 3> to_vecs(const IntTriangle& t, double scale = 1) {
    return {to_vec(t[0], scale), to_vec(t[1], scale), to_vec(t[2], scale)};
}

// Corners as integer combinations of three vectors of 45 bits: exact in double for small integers.
struct Basis {
    std::array<Vec3, 3> vectors;

    explicit Basis(Random& random) {
        for (Vec3& v : vectors) {
            for (int k = 0; k < 3; ++k) v[k] = std::floor(full(random, -1, 1) * 0x1p44) * 0x1p-44;
        }
    }
    std::array<Vec3, 3> apply(const IntTriangle& t) const {
        std::array<Vec3, 3> result;
        for (std::size_t i = 0; i < 3; ++i) {
            result[i] = double(t[i][0]) * vectors[0] + double(t[i][1]) * vectors[1] + double(t[i][2]) * vectors[2];
        }
        return result;
    }
};

inline void nudge(double& x, Random& random) {
    x = std::nextafter(x, coin(random) ? std::numeric_limits<double>::max() : std::numeric_limits<double>::lowest());
}

inline void nudge_one(PosedPair& pair, Random& random) {
    auto& triangle = coin(random) ? pair.a : pair.b;
    Vec3& corner = triangle[random.below(3)];
    nudge(corner[integer(random, 0, 2)], random);
}

inline PosedPair in_basis(const IntTriangle& a, const IntTriangle& b, Random& random) {
    const Basis basis(random);
    PosedPair pair{random_pose(random), {}, basis.apply(a), basis.apply(b), {}};
    pair.pose_b = pair.pose_a;
    return pair;
}

}  // namespace ecods::scenes::hard
