#include "fuzz/motion/numbers.hpp"

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace ecods::fuzz {

using scenes::Random;

double sign(Random& random) {
    return random.below(2) == 0 ? 1 : -1;
}

int axis(Random& random) {
    return static_cast<int>(random.below(3));
}

Mat3 integer_matrix(Random& random) {
    Mat3 matrix;
    for (double& entry : matrix.reshaped()) entry = static_cast<double>(random.below(5)) - 2;
    return matrix;
}

// A rotation of integers times their norm, from a quaternion of integers (Euler); by a power of two back to about one.
Mat3 integer_rotation(Random& random) {
    Eigen::Vector4d q;
    do {
        for (double& x : q) x = static_cast<double>(random.below(7)) - 3;
    } while (q.isZero(0));
    const auto [w, x, y, z] = std::tuple(q[0], q[1], q[2], q[3]);
    Mat3 matrix;
    matrix << w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y),  //
        2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x),        //
        2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z;
    return std::ldexp(1.0, -std::ilogb(q.squaredNorm())) * matrix;
}

double any_radius(double unit, scenes::Random& random) {
    switch (random.below(4)) {
        case 0:
            return unit * random.uniform(0, 1);
        case 1:
            return 0x1p-60 * unit;
        default:
            return 0.25 * unit * random.below(5);
    }
}

Vec3 half_integers(double reach, Random& random) {
    Vec3 point;
    const auto steps = static_cast<std::uint32_t>(4 * reach) + 1;
    for (double& x : point) x = 0.5 * random.below(steps) - reach;
    return point;
}

Vec3 any_offset(double reach, Random& random) {
    Vec3 offset;
    for (double& x : offset) x = random.uniform(-reach, reach);
    return offset;
}

double neighbour(double x, Random& random) {
    return std::nextafter(x, sign(random) * std::numeric_limits<double>::infinity());
}

Mat3 signed_permutation(Random& random) {
    std::array<int, 3> columns = {0, 1, 2};
    for (std::uint32_t i = 2; i > 0; --i) std::swap(columns[i], columns[random.below(i + 1)]);
    Mat3 matrix = Mat3::Zero();
    for (int row = 0; row < 3; ++row) matrix(row, columns[static_cast<std::size_t>(row)]) = sign(random);
    return matrix;
}

Mat3 any_rotation(Random& random) {
    return random.rotation().toRotationMatrix();
}

}  // namespace ecods::fuzz
