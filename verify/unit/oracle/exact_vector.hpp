// Vectors of GMP's rationals, which prove the oracle's answers by other means than its own.
#pragma once

#include <gmpxx.h>

#include <array>

#include "oracle/distance.hpp"

namespace ecods::oracle {

struct ExactVector {
    std::array<mpq_class, 3> x;

    mpq_class dot(const ExactVector& o) const { return x[0] * o.x[0] + x[1] * o.x[1] + x[2] * o.x[2]; }
    ExactVector cross(const ExactVector& o) const {
        return {mpq_class(x[1] * o.x[2] - x[2] * o.x[1]), mpq_class(x[2] * o.x[0] - x[0] * o.x[2]),
                mpq_class(x[0] * o.x[1] - x[1] * o.x[0])};
    }
    friend ExactVector operator-(const ExactVector& a, const ExactVector& b) {
        return {mpq_class(a.x[0] - b.x[0]), mpq_class(a.x[1] - b.x[1]), mpq_class(a.x[2] - b.x[2])};
    }
    friend bool operator==(const ExactVector& a, const ExactVector& b) { return a.x == b.x; }
};

inline mpq_class fraction(const mpz_class& num, const mpz_class& den, long unit) {
    mpq_class q(num, den);
    q.canonicalize();
    if (unit >= 0) return q << static_cast<unsigned long>(unit);
    return q >> static_cast<unsigned long>(-unit);
}

inline ExactVector exact_vector(const ExactPoint& p) {
    ExactVector v;
    for (std::size_t k = 0; k < 3; ++k) v.x[k] = fraction(p.x[k].num, p.x[k].den, p.x[k].unit);
    return v;
}

inline mpq_class square_of(const ExactRoot& root) {
    return fraction(root.num, root.den, 2 * root.unit);
}

inline std::array<ExactVector, 3> exact_corners(const Pose& pose, const std::array<Vec3, 3>& corners) {
    std::array<ExactVector, 3> exact;
    for (std::size_t i = 0; i < 3; ++i) {
        for (int row = 0; row < 3; ++row) {
            mpq_class sum = pose.t[row];
            for (int k = 0; k < 3; ++k) sum += mpq_class(pose.R(row, k)) * mpq_class(corners[i][k]);
            exact[i].x[static_cast<std::size_t>(row)] = sum;
        }
    }
    return exact;
}

// Whether p is the corner, inside the edge that begins there, or inside the face.
inline bool lies_inside(const ExactVector& p, const std::array<ExactVector, 3>& corners, int dimension,
                        std::uint32_t corner) {
    if (dimension == 0) return p == corners[corner];
    if (dimension == 1) {
        const ExactVector u = corners[(corner + 1) % 3] - corners[corner], w = p - corners[corner];
        const mpq_class along = u.dot(w);
        return u.cross(w) == ExactVector{} && along > 0 && along < u.dot(u);
    }
    const ExactVector n = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    if (n == ExactVector{} || n.dot(p - corners[0]) != 0) return false;
    for (std::size_t i = 0; i < 3; ++i) {
        if ((corners[(i + 1) % 3] - corners[i]).cross(p - corners[i]).dot(n) <= 0) return false;
    }
    return true;
}

}  // namespace ecods::oracle
