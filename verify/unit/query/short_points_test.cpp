// Points of short digits beside rational ones, in every floating-point environment.
#include "query/convex/short_points.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "ecods/shape.hpp"
#include "ecods/solid.hpp"
#include "environment/float_mode.hpp"
#include "query/convex/convex_parts.hpp"
#include "scenes/random.hpp"

namespace ecods::convex {
namespace {

constexpr std::size_t points_each = 12;

mpz_class integer_of(exact::Int128 x) {
    mpz_class result(static_cast<long>(x >> 64));
    result <<= 64;
    return result + mpz_class(static_cast<unsigned long>(static_cast<std::uint64_t>(x)));
}

mpq_class scaled(const mpq_class& x, int exponent) {
    mpq_class result = x;
    if (exponent >= 0) {
        mpq_mul_2exp(result.get_mpq_t(), x.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
    } else {
        mpq_div_2exp(result.get_mpq_t(), x.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
    }
    return result;
}

struct Body {
    ConvexSolid solid;
    Pose pose;

    const Hull& hull() const { return ConvexSolidAccess::hull(solid); }
    const SupportPoints& points() const { return ConvexSolidAccess::points(solid); }
    mpq_class coordinate(std::uint32_t vertex, int row, const Vec3& t0) const {
        const Vec3& v = solid.mesh().vertices()[hull().mesh_vertices[vertex]];
        mpq_class sum = mpq_class(pose.t[row]) - mpq_class(t0[row]);
        for (int k = 0; k < 3; ++k) sum += mpq_class(pose.R(row, k)) * mpq_class(v[k]);
        return sum;
    }
};

ConvexSolid random_solid(scenes::Random& random, double size) {
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < points_each; ++i) points.push_back(size * random.direction());
    return ConvexSolid(std::span<const Vec3>(points));
}

Pose random_pose(scenes::Random& random, double far, double scale) {
    Pose pose = Pose::from_quaternion(random.rotation(), far * random.direction());
    pose.R *= scale;
    return pose;
}

// How many points fit and how many of them are exact.
struct Counts {
    int asked = 0, fit = 0, exact = 0;
};

void expect_right(const Body& a, const Body& b, Counts& counts) {
    ShortPoints points;
    const double reach = (b.pose.t - a.pose.t).cwiseAbs().maxCoeff();
    ++counts.asked;
    if (!points.bind(a.pose, a.points(), b.pose, b.points(), reach)) return;
    std::vector<mpz_class> found;
    std::vector<mpq_class> expected;
    for (const std::size_t side : {0, 1}) {
        const Body& of = side == 0 ? a : b;
        for (std::uint32_t v = 0; v < of.hull().vertex_count(); ++v) {
            exact::IntegerVector point;
            if (!points.find(side, v, point)) continue;
            for (int row = 0; row < 3; ++row) {
                found.push_back(integer_of(point[static_cast<std::size_t>(row)]));
                expected.push_back(scaled(of.coordinate(v, row, a.pose.t), -points.unit()));
            }
        }
    }
    ++counts.fit;
    counts.exact += points.is_exact();
    mpz_class limit = 1;
    limit <<= 122;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const mpq_class off = expected[i] - found[i];
        EXPECT_TRUE(points.is_exact() ? off == 0 : off < 2 && off > -1) << i << " " << off.get_d();
        EXPECT_LT(abs(found[i]), limit);
    }
}

TEST(ShortPoints, AreTheRealPointsOrJustBelow) {
    scenes::Random random(1);
    Counts counts;
    for (int i = 0; i < 400; ++i) {
        const double size = std::ldexp(1, static_cast<int>(random.uniform(-30, 30)));
        const double far = std::ldexp(1, static_cast<int>(random.uniform(-60, 60)));
        const Body a{random_solid(random, size), random_pose(random, far, 1)};
        Body b{random_solid(random, 1),
               random_pose(random, far, std::ldexp(1, static_cast<int>(random.uniform(-9, 9))))};
        if (i % 4 == 0) b.pose.t = a.pose.t + 0x1p-40 * random.direction();
        const environment::InFloatMode in(environment::float_modes[static_cast<std::size_t>(i) % 8]);
        expect_right(a, b, counts);
    }
    EXPECT_GT(counts.fit, counts.asked * 8 / 10);
    EXPECT_GT(counts.fit, counts.exact);
}

// Digits of few bits: nothing is cut off.
TEST(ShortPoints, AreExactOnLattices) {
    scenes::Random random(2);
    Counts counts;
    for (int i = 0; i < 100; ++i) {
        const auto lattice = [&](double most) -> Vec3 {
            const auto one = [&] { return std::round(random.uniform(-most, most)); };
            return {one(), one(), one()};
        };
        const auto body = [&] {
            std::vector<Vec3> points{{-9, 0, 0}, {0, -9, 0}, {0, 0, -9}, {9, 9, 9}};
            for (int k = 0; k < 8; ++k) points.push_back(lattice(8));
            Pose pose;
            pose.R << 2, -2, 1, 1, 2, 2, -2, -1, 2;
            pose.t = lattice(100);
            return Body{ConvexSolid(std::span<const Vec3>(points)), pose};
        };
        const Body a = body(), b = body();
        const environment::InFloatMode in(environment::float_modes[static_cast<std::size_t>(i) % 8]);
        expect_right(a, b, counts);
    }
    EXPECT_EQ(counts.exact, counts.asked);
}

// What a mode may take for zero is not short.
TEST(ShortPoints, LeaveWhatIsNextToNothing) {
    const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    std::vector<Vec3> tiny = corners;
    tiny[1][1] = 0x1p-1000;
    const ConvexSolid plain{std::span<const Vec3>(corners)}, with_tiny{std::span<const Vec3>(tiny)};
    const auto binds = [](const ConvexSolid& a, const Pose& at, const ConvexSolid& b) {
        return ShortPoints().bind(at, ConvexSolidAccess::points(a), Pose(), ConvexSolidAccess::points(b), 0);
    };
    Pose turned;
    for (const environment::FloatMode& mode : environment::float_modes) {
        const environment::InFloatMode in(mode);
        turned.R(0, 1) = 0;
        EXPECT_TRUE(binds(plain, turned, plain)) << mode.name;
        EXPECT_FALSE(binds(plain, turned, with_tiny)) << mode.name;
        turned.R(0, 1) = 0x1p-1070;
        EXPECT_FALSE(binds(plain, turned, plain)) << mode.name;
        turned.R(0, 1) = 0x1p-70;
        EXPECT_FALSE(binds(plain, turned, plain)) << mode.name;
    }
}

}  // namespace
}  // namespace ecods::convex
