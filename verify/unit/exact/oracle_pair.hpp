// The oracle's view of a pair of triangles, and rational numbers for what it does not answer.
#pragma once

#include <gmpxx.h>

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "integers.hpp"
#include "measured_pairs.hpp"
#include "oracle/distance.hpp"
#include "oracle/nearest.hpp"
#include "oracle/solid_points.hpp"

namespace ecods::exact {

class OraclePair {
  public:
    explicit OraclePair(const PosedPair& pair)
        : a_(pair.a.begin(), pair.a.end()),
          b_(pair.b.begin(), pair.b.end()),
          meshes_({a_, triangle_, pair.pose_a}, {b_, triangle_, pair.pose_b}) {}
    const oracle::MeshDistances* operator->() const { return &meshes_; }

  private:
    std::vector<Vec3> a_, b_;
    std::vector<Triangle> triangle_{{0, 1, 2}};
    oracle::MeshDistances meshes_;
};

inline std::uint64_t bits(double x) {
    return std::bit_cast<std::uint64_t>(x);
}

inline bool same_bits(const Vec3& a, const Vec3& b) {
    return bits(a[0]) == bits(b[0]) && bits(a[1]) == bits(b[1]) && bits(a[2]) == bits(b[2]);
}

inline double nearest(const mpq_class& x) {
    return oracle::nearest(oracle::ExactFraction{x.get_num(), x.get_den(), 0});
}

using oracle::RationalPoint;

inline RationalPoint rational(const Pose& pose, const Vec3& v) {
    return oracle::posed(pose, v);
}

inline RationalPoint rational(const oracle::ExactPoint& point) {
    RationalPoint result;
    for (std::size_t k = 0; k < 3; ++k) {
        const oracle::ExactFraction& x = point.x[k];
        result[k] = mpq_class(x.num, x.den);
        result[k].canonicalize();
        result[k] = testing::times_power(result[k], x.unit);
    }
    return result;
}

inline RationalPoint operator-(const RationalPoint& a, const RationalPoint& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline mpq_class dot(const RationalPoint& a, const RationalPoint& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline RationalPoint cross(const RationalPoint& a, const RationalPoint& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Whether every coordinate of u is the double nearest to that of v / |v|, and zeros are +0.
inline bool is_direction(const Vec3& u, const RationalPoint& v) {
    const mpq_class all = dot(v, v);
    for (std::size_t k = 0; k < 3; ++k) {
        const double x = u[static_cast<Eigen::Index>(k)];
        const mpq_class part = v[k] * v[k] / all;
        // Up to half of the least double, unlike distances, it rounds to zero.
        if (part <= mpq_class(0x1p-1000) * mpq_class(0x1p-1000) * mpq_class(0x1p-150)) {
            if (bits(x) != 0) return false;
            continue;
        }
        const oracle::ExactRoot root{part.get_num(), part.get_den(), 0};
        const double expected = oracle::nearest(root);
        if (bits(x) != bits(sgn(v[k]) < 0 ? -expected : expected)) return false;
    }
    return true;
}

}  // namespace ecods::exact
