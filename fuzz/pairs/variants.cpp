#include "fuzz/pairs/variants.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace ecods::fuzz {
namespace {

using scenes::PosedPair;
using scenes::Random;

int integer(Random& random, int min, int max) {
    return min + static_cast<int>(random.below(static_cast<std::uint32_t>(max - min + 1)));
}

struct Body {
    Pose& pose;
    std::array<Vec3, 3>& corners;
};

std::array<Body, 2> bodies(PosedPair& pair) {
    return {Body{pair.pose_a, pair.a}, Body{pair.pose_b, pair.b}};
}

// x times 2^exponent, if that is a double.
bool scale(double& x, int exponent) {
    const double y = std::ldexp(x, exponent);
    if (!std::isfinite(y) || std::ldexp(y, -exponent) != x) return false;
    x = y;
    return true;
}

bool scale(Vec3& v, int exponent) {
    return scale(v[0], exponent) && scale(v[1], exponent) && scale(v[2], exponent);
}

bool scale(Mat3& R, int exponent) {
    for (int i = 0; i < 9; ++i) {
        if (!scale(R.data()[i], exponent)) return false;
    }
    return true;
}

bool scale(std::array<Vec3, 3>& corners, int exponent) {
    return scale(corners[0], exponent) && scale(corners[1], exponent) && scale(corners[2], exponent);
}

bool reorder_corners(PosedPair& pair, Random& random) {
    for (auto* corners : {&pair.a, &pair.b}) {
        for (std::size_t i = 2; i > 0; --i) {
            std::swap((*corners)[i], (*corners)[random.below(static_cast<std::uint32_t>(i) + 1)]);
        }
    }
    return true;
}

// Either factor of R v may take the power, in each body for itself.
bool scale_by_power_of_two(PosedPair& pair, Random& random) {
    const int exponent = integer(random, 0, 1) == 0 ? integer(random, -4, 4) : integer(random, -300, 300);
    PosedPair result = pair;
    for (const Body& body : bodies(result)) {
        const bool done = random.below(2) == 0 ? scale(body.pose.R, exponent) : scale(body.corners, exponent);
        if (!done || !scale(body.pose.t, exponent)) return false;
    }
    pair = result;
    return true;
}

struct AxisSymmetry {
    std::array<int, 3> axes{0, 1, 2};
    std::array<bool, 3> is_mirrored{};

    explicit AxisSymmetry(Random& random) {
        for (std::size_t i = 2; i > 0; --i) {
            std::swap(axes[i], axes[random.below(static_cast<std::uint32_t>(i) + 1)]);
        }
        for (bool& mirrored : is_mirrored) mirrored = random.below(2) == 0;
    }
    template <class Get>
    auto pick(int i, Get get) const {
        const auto k = static_cast<std::size_t>(i);
        return is_mirrored[k] ? -get(axes[k]) : get(axes[k]);
    }
};

bool mirror_and_permute_space(PosedPair& pair, Random& random) {
    const AxisSymmetry symmetry(random);
    for (const Body& body : bodies(pair)) {
        const Pose old = body.pose;
        for (int i = 0; i < 3; ++i) {
            body.pose.t[i] = symmetry.pick(i, [&](int k) { return old.t[k]; });
            for (int j = 0; j < 3; ++j) body.pose.R(i, j) = symmetry.pick(i, [&](int k) { return old.R(k, j); });
        }
    }
    return true;
}

// Whether a + b is a double (Knuth's error of a sum, which is exact); sum = a + b then.
bool add_exactly(double a, double b, double& sum) {
    sum = a + b;
    const double part = sum - a;
    return std::isfinite(sum) && (a - (sum - part)) + (b - part) == 0;
}

// result = m . v for small integers m, if no rounding is needed.
bool dot_exactly(const Eigen::Vector3i& m, const Vec3& v, double& result) {
    result = 0;
    for (int k = 0; k < 3; ++k) {
        const double product = m[k] * v[k];
        if (!std::isfinite(product) || std::fma(m[k], v[k], -product) != 0) return false;
        if (!add_exactly(result, product, result)) return false;
    }
    return true;
}

bool map_space(PosedPair& pair, Random& random) {
    Eigen::Matrix3i m;
    do {
        for (int i = 0; i < 9; ++i) m.data()[i] = integer(random, -2, 2);
    } while (m.cast<double>().determinant() == 0);
    // A shift of the size of the translations, so that it does not drown them.
    const double unit = std::max(std::abs(pair.pose_a.t[0]), std::abs(pair.pose_b.t[1]));
    PosedPair result = pair;
    for (int row = 0; row < 3; ++row) {
        const double shift = integer(random, -1, 1) * unit;
        const Eigen::Vector3i factors = m.row(row).transpose();
        for (auto [pose, old] : {std::pair{&result.pose_a, &pair.pose_a}, std::pair{&result.pose_b, &pair.pose_b}}) {
            for (int column = 0; column < 3; ++column) {
                if (!dot_exactly(factors, old->R.col(column), pose->R(row, column))) return false;
            }
            double t = 0;
            if (!dot_exactly(factors, old->t, t) || !add_exactly(t, shift, pose->t[row])) return false;
        }
    }
    pair = result;
    return true;
}

}  // namespace

bool model_in_other_frames(PosedPair& pair, Random& random) {
    PosedPair result = pair;
    for (const Body& body : bodies(result)) {
        const AxisSymmetry symmetry(random);
        const Mat3 R = body.pose.R;
        const std::array<Vec3, 3> corners = body.corners;
        for (int j = 0; j < 3; ++j) {
            for (int i = 0; i < 3; ++i) body.pose.R(i, j) = symmetry.pick(j, [&](int k) { return R(i, k); });
            for (std::size_t c = 0; c < 3; ++c) {
                body.corners[c][j] = symmetry.pick(j, [&](int k) { return corners[c][k]; });
            }
        }
        const int axis = integer(random, 0, 2), exponent = integer(random, -3, 3);
        for (int i = 0; i < 3; ++i) {
            if (!scale(body.pose.R(i, axis), exponent)) return false;
            if (!scale(body.corners[static_cast<std::size_t>(i)][axis], -exponent)) return false;
        }
    }
    pair = result;
    return true;
}

namespace {

constexpr std::array<Variant, 5> all{{{"corners in another order", reorder_corners},
                                      {"times a power of two", scale_by_power_of_two},
                                      {"axis symmetry of space", mirror_and_permute_space},
                                      {"bodies in other frames", model_in_other_frames},
                                      {"affine map of small integers", map_space}}};

}  // namespace

std::span<const Variant> variants() {
    return all;
}

}  // namespace ecods::fuzz
