#include "fuzz/motion/extremes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "fuzz/motion/numbers.hpp"

namespace ecods::fuzz {
namespace {

using scenes::Random;

constexpr int exponent_min = -1074, exponent_max = 1022;

int any_exponent(Random& random) {
    return exponent_min + static_cast<int>(random.below(exponent_max - exponent_min + 1));
}

// The power of two of the largest number; 0 if all are zero.
template <class Numbers>
int exponent_of(const Numbers& numbers) {
    const double largest = numbers.cwiseAbs().maxCoeff();
    return largest == 0 ? 0 : std::ilogb(largest);
}
int exponent_of(const Mesh& mesh) {
    Vec3 largest = Vec3::Zero();
    for (const Vec3& v : mesh.vertices()) largest = largest.cwiseMax(v.cwiseAbs());
    return exponent_of(largest);
}

// Some matrix of about 2^exponent, as near to that as doubles are. Every third flattens what it poses.
Mat3 matrix_of(int exponent, Random& random) {
    Mat3 matrix = Mat3::Identity();
    const std::uint32_t how = random.below(4);
    if (how == 0) matrix = signed_permutation(random);
    if (how == 1) matrix = any_rotation(random);
    if (how == 2) matrix = integer_matrix(random);
    if (random.below(3) == 0) matrix.row(axis(random)).setZero();
    const int bounded = std::clamp(exponent, exponent_min, exponent_max);
    for (double& entry : matrix.reshaped()) entry = std::ldexp(entry, bounded);
    return matrix;
}

const Vec3& any_vertex(const Mesh& mesh, Random& random) {
    return mesh.vertices()[random.below(static_cast<std::uint32_t>(mesh.vertices().size()))];
}

// A vertex onto one of the other's, as near as doubles come; or both bodies' origins at one place.
Pose beside_other(const PoseContext& c, const Mat3& matrix) {
    if (c.random.below(3) == 0) return {matrix, c.other.pose.t};
    const Vec3 own = matrix * any_vertex(*c.body.part.mesh, c.random);
    return {matrix, c.other.pose.R * any_vertex(*c.other.part.mesh, c.random) + c.other.pose.t - own};
}

const std::array move_table = {
    Move{"extreme: the other's size", &Weights::extreme,
         [](const PoseContext& c) {
             const int exponent = exponent_of(*c.other.part.mesh) + exponent_of(c.other.pose.R) -
                                  exponent_of(*c.body.part.mesh) + static_cast<int>(c.random.below(5)) - 2;
             return beside_other(c, matrix_of(exponent, c.random));
         }},
    Move{"extreme: any size", &Weights::extreme,
         [](const PoseContext& c) { return beside_other(c, matrix_of(any_exponent(c.random), c.random)); }},
    Move{"extreme: beyond the largest double", &Weights::extreme,
         [](const PoseContext& c) {
             const int exponent = exponent_max + 1 + static_cast<int>(c.random.below(4)) -
                                  std::max(0, exponent_of(*c.body.part.mesh) - static_cast<int>(c.random.below(200)));
             return Pose{matrix_of(exponent, c.random), c.other.pose.t};
         }},
    Move{"extreme: one row of another size", &Weights::extreme,
         [](const PoseContext& c) {
             Pose pose = c.body.pose;
             const int row = axis(c.random), exponent = any_exponent(c.random) / 2;
             for (double& entry : pose.R.row(row)) entry = std::ldexp(entry, exponent);
             return pose;
         }},
    Move{"extreme: near the largest double", &Weights::extreme,
         [](const PoseContext& c) {
             Pose pose = c.random.below(2) == 0 ? c.body.pose : c.other.pose;
             pose.t[axis(c.random)] = sign(c.random) * std::ldexp(1 + c.random.below(1024) * 0x1p-10, 1023);
             return pose;
         }},
    Move{"extreme: any distance", &Weights::extreme,
         [](const PoseContext& c) {
             Pose pose = c.random.below(2) == 0 ? c.body.pose : c.other.pose;
             pose.t[axis(c.random)] += sign(c.random) * std::ldexp(1.5, any_exponent(c.random));
             return pose;
         }},
};

}  // namespace

double extreme_unit(Random& random) {
    constexpr std::array exponents = {-1060, -900, -500, -127, -60, 0, 0, 60, 127, 500, 600, 900, 1020};
    return std::ldexp(1.0, exponents[random.below(exponents.size())]);
}

std::span<const Move> extreme_moves() {
    return move_table;
}

}  // namespace ecods::fuzz
