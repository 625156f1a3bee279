#include "fuzz/engines/boxes.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "scenes/random.hpp"
#include "scenes/shapes.hpp"

namespace ecods::fuzz {
namespace {

using scenes::Random;

// A multiple of 2^-bits, between 1/4 and 1.
double size_of(int bits, Random& random) {
    const double high = random.uniform(0.25, 1), low = random.uniform(0, 1);
    return std::floor(std::ldexp(high + low * 0x1p-33, bits)) * std::ldexp(1.0, -bits);
}

std::shared_ptr<const Mesh> box(const Vec3& min, const Vec3& max) {
    return scenes::mapped(*scenes::cube(1), [&](const Vec3& v) {
        return Vec3(v[0] < 0 ? min[0] : max[0], v[1] < 0 ? min[1] : max[1], v[2] < 0 ? min[2] : max[2]);
    });
}

struct Contact {
    Vec3 min_a, max_a, min_b, max_b;
};

// The second box lies behind the first on one to three axes (face, edge, corner), and over it on the others.
Contact make_contact(const BoxRecipe& recipe, Random& random) {
    Contact c;
    const auto axis_count = 1 + static_cast<int>(random.below(3));
    const auto first_axis = static_cast<int>(random.below(3));
    const auto thin_axis = static_cast<int>(random.below(3));
    for (int i = 0; i < 3; ++i) {
        const int k = (first_axis + i) % 3;
        double a = size_of(recipe.bits, random), b = size_of(recipe.bits, random);
        if (recipe.thin_exponent_max > 0 && k == thin_axis) {
            const int range = recipe.thin_exponent_max - 9;
            a = std::ldexp(a, -10 - static_cast<int>(random.below(static_cast<std::uint32_t>(range))));
            b = std::ldexp(b, -10 - static_cast<int>(random.below(static_cast<std::uint32_t>(range))));
        }
        c.min_a[k] = 0;
        c.max_a[k] = a;
        // Half of what the first has: still on it.
        c.min_b[k] = i < axis_count ? a : 0.5 * a;
        c.max_b[k] = c.min_b[k] + b;
    }
    if (recipe.ulps != 0) {
        const double far = std::numeric_limits<double>::infinity();
        const double to = random.below(2) == 0 ? far : -far;
        for (int i = 0; i < recipe.ulps; ++i) c.min_b[first_axis] = std::nextafter(c.min_b[first_axis], to);
    }
    return c;
}

Mat3 signed_permutation(Random& random) {
    std::array<int, 3> columns = {0, 1, 2};
    for (std::uint32_t i = 2; i > 0; --i) std::swap(columns[i], columns[random.below(i + 1)]);
    Mat3 matrix = Mat3::Zero();
    for (int row = 0; row < 3; ++row) matrix(row, columns[static_cast<std::size_t>(row)]) = random.below(2) ? 1 : -1;
    // A rotation: no mirror images.
    if (matrix.determinant() < 0) matrix.row(0) *= -1;
    return matrix;
}

// The same box of the world as the mesh of a body that is turned.
std::shared_ptr<const Mesh> turned_back(const Vec3& min, const Vec3& max, const Mat3& R) {
    const Vec3 p = R.transpose() * min, q = R.transpose() * max;
    return box(p.cwiseMin(q), p.cwiseMax(q));
}

}  // namespace

scenes::MeshPairs box_pairs(const BoxRecipe& recipe, std::size_t count, std::uint32_t seed) {
    scenes::MeshPairs pairs;
    Random random(seed);
    for (std::size_t i = 0; i < count; ++i) {
        const Contact c = make_contact(recipe, random);
        Pose a, b;
        if (recipe.turn == BoxTurn::permutations) {
            a.R = signed_permutation(random);
            b.R = signed_permutation(random);
            pairs.meshes.push_back({"box", turned_back(c.min_a, c.max_a, a.R)});
            pairs.meshes.push_back({"box", turned_back(c.min_b, c.max_b, b.R)});
        } else {
            const Vec3 origin_b = recipe.turn == BoxTurn::none ? c.min_b : Vec3(0, 0, 0);
            pairs.meshes.push_back({"box", box(c.min_a, c.max_a)});
            pairs.meshes.push_back({"box", box(c.min_b - origin_b, c.max_b - origin_b)});
            b.t = origin_b;
        }
        if (recipe.turn == BoxTurn::common_rotation) {
            a.R = random.rotation().toRotationMatrix();
            for (double& x : a.t) x = random.uniform(-10, 10);
            if (recipe.far_exponent_max > 0) {
                a.t *=
                    std::ldexp(1, static_cast<int>(random.below(static_cast<std::uint32_t>(recipe.far_exponent_max))));
            }
            b = a;
        } else if (recipe.ulps == 0) {
            // A translation of few bits, so that contact stays exact.
            for (double& x : a.t) x = static_cast<double>(random.below(9)) - 4;
            b.t += a.t;
        }
        pairs.queries.push_back({{2 * i, a}, {2 * i + 1, b}});
    }
    return pairs;
}

}  // namespace ecods::fuzz
