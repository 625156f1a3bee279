// The points of a posed mesh counted from the beginning of a line, beside rationals.
#include "exact/point/line_points.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>

#include "ecods/mesh.hpp"
#include "exact/point/mesh_extent.hpp"
#include "scenes/random.hpp"

namespace ecods::exact::line_points_test {
namespace {

mpq_class rational(Int128 x, int unit) {
    const bool is_negative = x < 0;
    const Uint128 size = is_negative ? -static_cast<Uint128>(x) : static_cast<Uint128>(x);
    mpz_class whole = static_cast<std::uint64_t>(size >> 64);
    whole = (whole << 64) + static_cast<std::uint64_t>(size);
    mpq_class result(is_negative ? mpz_class(-whole) : whole);
    if (unit >= 0) {
        result <<= static_cast<unsigned>(unit);
    } else {
        result >>= static_cast<unsigned>(-unit);
    }
    return result;
}

// Numbers of few digits, many digits, zeros, and of very different sizes.
double any(scenes::Random& random, int kind) {
    if (random.below(6) == 0) return 0;
    if (kind == 0) return static_cast<double>(random.below(2048)) - 1024;
    const double x = random.uniform(-1, 1);
    return kind == 1 ? x : std::ldexp(x, static_cast<int>(random.below(kind == 2 ? 40 : 200)) - 20);
}

struct Count {
    int one_limb = 0, two_limbs = 0, none = 0;
};

void check(scenes::Random& random, int kind, double far, Count& count) {
    const auto vector = [&](int k) {
        const double x = any(random, k), y = any(random, k);
        return Vec3(x, y, any(random, k));
    };
    const int of_R = static_cast<int>(random.below(static_cast<std::uint32_t>(kind) + 1));
    const auto mesh = Mesh::create({vector(kind), vector(kind), vector(kind)}, {{0, 1, 2}});
    Pose pose;
    for (int k = 0; k < 3; ++k) pose.R.col(k) = vector(of_R);
    const Vec3 origin = Vec3::Constant(far);
    pose.t = origin + vector(of_R);
    ecods::Segment segment{origin + vector(0), origin + vector(0)};
    const bool is_ray = random.below(2) == 0;
    const Line line = is_ray ? Line(Ray{segment.a, vector(of_R)}) : Line(segment);
    const MeshExtent extent = measure(*mesh);
    LinePoints points;
    points.bind(BodyRef{mesh.get(), &extent, &pose});
    if (!points.bind(line)) {
        ++count.none;
        return;
    }
    ++(points.is_one_limb() ? count.one_limb : count.two_limbs);
    const int limit = points.is_one_limb() ? OneLimbKernel::coordinate_bits : TwoLimbKernel::coordinate_bits;
    for (std::size_t row = 0; row < 3; ++row) {
        const auto k = static_cast<Eigen::Index>(row);
        const mpq_class direction = mpq_class(line.b[k]) - (is_ray ? mpq_class(0) : mpq_class(line.a[k]));
        ASSERT_EQ(rational(points.direction()[row], points.unit()), direction);
        for (const Vec3& v : mesh->vertices()) {
            mpq_class expected = mpq_class(pose.t[k]) - mpq_class(line.a[k]);
            for (int j = 0; j < 3; ++j) expected += mpq_class(pose.R(k, j)) * mpq_class(v[j]);
            const Int128 x = points.at(v)[row];
            ASSERT_EQ(rational(x, points.unit()), expected);
            ASSERT_LE(bit_width(static_cast<Uint128>(x < 0 ? -x : x)), limit);
        }
    }
}

TEST(LinePoints, AreTheExactPoints) {
    scenes::Random random(1);
    Count count;
    for (int i = 0; i < 4000; ++i) {
        for (int kind = 0; kind < 4; ++kind) {
            for (const double far : {0.0, 0x1p40, 0x1p90})
                ASSERT_NO_FATAL_FAILURE(check(random, kind, far, count)) << i;
        }
    }
    EXPECT_GT(count.one_limb, 1000);
    EXPECT_GT(count.two_limbs, 1000);
    EXPECT_GT(count.none, 1000);
}

}  // namespace
}  // namespace ecods::exact::line_points_test
