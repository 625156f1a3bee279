// Rotations written in integers.
#pragma once

#include "scenes/hard_pair_parts.hpp"

namespace ecods::scenes {

// The matrix of Euler and Rodrigues of a quaternion of small integers. Lengths are multiplied by `norm`; the transpose
// undoes the rotation, and multiplies by the same.
struct IntegerRotation {
    Mat3 R;
    double norm;

    explicit IntegerRotation(Random& random) {
        int m = 0, a = 0, b = 0, c = 0;
        do {
            m = hard::integer(random, -4, 4), a = hard::integer(random, -4, 4), b = hard::integer(random, -4, 4);
            c = hard::integer(random, -4, 4);
        } while (m * m + a * a + b * b + c * c == 0);
        norm = m * m + a * a + b * b + c * c;
        R << m * m + a * a - b * b - c * c, 2 * (a * b - m * c), 2 * (a * c + m * b),  //
            2 * (a * b + m * c), m * m - a * a + b * b - c * c, 2 * (b * c - m * a),   //
            2 * (a * c - m * b), 2 * (b * c + m * a), m * m - a * a - b * b + c * c;
    }
};

}  // namespace ecods::scenes
