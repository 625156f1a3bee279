// The rotation of a quaternion of any length, as a matrix: rational at one time, or polynomials of the time.
#pragma once

#include <gmpxx.h>

#include <array>
#include <memory>

#include "oracle/first_contact.hpp"
#include "oracle/pair_motion.hpp"
#include "oracle/rounded.hpp"

namespace ecods::oracle {

// The rows of the matrix, times the squared length.
template <class N>
std::array<Vector<N>, 3> rotation_of(const std::array<N, 4>& q) {
    const N &w = q[0], &x = q[1], &y = q[2], &z = q[3];
    const N ww = w * w, xx = x * x, yy = y * y, zz = z * z;
    const auto twice = [](const N& f) -> N { return f + f; };
    return {{{ww + xx - yy - zz, twice(x * y - w * z), twice(x * z + w * y)},
             {twice(x * y + w * z), ww - xx + yy - zz, twice(y * z - w * x)},
             {twice(x * z - w * y), twice(y * z + w * x), ww - xx - yy + zz}}};
}

// The rotation of (1 - time) from + time to.
struct RationalRotation {
    std::array<Vector<mpq_class>, 3> rows;

    RationalRotation(const std::array<double, 4>& from, const std::array<double, 4>& to, const mpq_class& time) {
        std::array<mpq_class, 4> q;
        mpq_class norm = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            q[i] = (1 - time) * exactly(from[i]) + time * exactly(to[i]);
            norm += q[i] * q[i];
        }
        const auto scaled = rotation_of(q);
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t i = 0; i < 3; ++i) rows[k][i] = scaled[k][i] / norm;
        }
    }
};

// Returns the motion of a triangle of a leg beside a triangle at rest (oracle/way.hpp).
struct LegSoup;
std::unique_ptr<PairMotion> motion_of_pair(const LegSoup& a, const Soup& b, const TrianglePair& pair);

}  // namespace ecods::oracle
