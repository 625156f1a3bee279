// The integer points of several posed meshes, and of one counted from the beginning of a line, beside rationals.
#include "exact/point/integer_frame.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "ecods/mesh.hpp"
#include "environment/float_mode.hpp"
#include "exact/point/line_points.hpp"
#include "exact/point/mesh_extent.hpp"
#include "integers.hpp"
#include "scenes/random.hpp"

namespace ecods::exact::integer_frame_test {
namespace {

mpq_class rational(Int128 x, int unit) {
    return testing::times_power(testing::mpz_of(x), unit);
}

// Numbers of few digits, many digits, zeros, and of very different sizes.
double any(scenes::Random& random, int kind) {
    if (random.below(6) == 0) return 0;
    if (kind == 0) return static_cast<double>(random.below(2048)) - 1024;
    const double x = random.uniform(-1, 1);
    return kind == 1 ? x : std::ldexp(x, static_cast<int>(random.below(kind == 2 ? 40 : 200)) - 20);
}

Vec3 any_vector(scenes::Random& random, int kind) {
    const double x = any(random, kind), y = any(random, kind);
    return Vec3(x, y, any(random, kind));
}

// A coordinate of R v + t - t0.
mpq_class expected_coordinate(const Pose& pose, const Vec3& v, const Vec3& t0, Eigen::Index k) {
    mpq_class result = mpq_class(pose.t[k]) - mpq_class(t0[k]);
    for (int j = 0; j < 3; ++j) result += mpq_class(pose.R(k, j)) * mpq_class(v[j]);
    return result;
}

struct Count {
    int one_limb = 0, two_limbs = 0, none = 0;
};

void check(scenes::Random& random, int kind, double far, Count& count) {
    const int of_R = static_cast<int>(random.below(static_cast<std::uint32_t>(kind) + 1));
    const auto mesh =
        Mesh::create({any_vector(random, kind), any_vector(random, kind), any_vector(random, kind)}, {{0, 1, 2}});
    Pose pose;
    for (int k = 0; k < 3; ++k) pose.R.col(k) = any_vector(random, of_R);
    const Vec3 origin = Vec3::Constant(far);
    pose.t = origin + any_vector(random, of_R);
    ecods::Segment segment{origin + any_vector(random, 0), origin + any_vector(random, 0)};
    const bool is_ray = random.below(2) == 0;
    const Line line = is_ray ? Line(Ray{segment.a, any_vector(random, of_R)}) : Line(segment);
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
            const Int128 x = points.at(v)[row];
            ASSERT_EQ(rational(x, points.unit()), expected_coordinate(pose, v, line.a, k));
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

// Some bodies, two of which may have one rotation.
struct Bodies {
    Bodies(scenes::Random& random, int kind, double far, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) {
            std::vector<Vec3> corners;
            for (int k = 0; k < 3; ++k) corners.push_back(any_vector(random, kind));
            meshes.push_back(Mesh::create(corners, {{0, 1, 2}}));
            extents.push_back(measure(*meshes.back()));
            Pose pose;
            const int of_R = static_cast<int>(random.below(static_cast<std::uint32_t>(kind) + 1));
            for (int k = 0; k < 3; ++k) pose.R.col(k) = any_vector(random, of_R);
            if (i > 0 && random.below(2) == 0) pose.R = poses.back().R;
            pose.t = Vec3::Constant(far) + any_vector(random, of_R);
            poses.push_back(pose);
        }
        for (std::size_t i = 0; i < count; ++i) refs.push_back({meshes[i].get(), &extents[i], &poses[i]});
    }

    std::vector<std::shared_ptr<const Mesh>> meshes;
    std::vector<MeshExtent> extents;
    std::vector<Pose> poses;
    std::vector<BodyRef> refs;
};

// Points are exact, or below the real ones by less than five units.
void check_frame(IntegerFrame& frame, const Bodies& bodies, const BitRange& others, Count& count) {
    frame.bind(bodies.refs);
    frame.measure(others);
    ++(frame.is_exact() ? count.two_limbs : count.none);
    const bool holds_others = !others.empty() && frame.is_exact() && others.high - frame.digits().low < 100 &&
                              frame.digits().high - others.low < 100 && others.width() < 100;
    if (holds_others) {
        ASSERT_LE(frame.unit(), others.low);
        ++count.one_limb;
    }
    for (std::size_t i = 0; i < bodies.refs.size(); ++i) {
        for (std::uint32_t v = 0; v < 3; ++v) {
            for (std::size_t k = 0; k < 3; ++k) {
                const mpq_class off = expected_coordinate(bodies.poses[i], bodies.meshes[i]->vertices()[v],
                                                          bodies.poses[0].t, static_cast<Eigen::Index>(k)) -
                                      rational(frame.at(i, v)[k], frame.unit());
                if (frame.is_exact()) {
                    ASSERT_EQ(off, 0);
                } else {
                    ASSERT_GE(off, 0);
                    ASSERT_LT(off, rational(IntegerFrame::error_units, frame.unit()));
                }
            }
        }
    }
}

TEST(IntegerFrame, HasTheExactPointsOrThoseJustBelow) {
    scenes::Random random(2);
    IntegerFrame frame;
    Count count;
    for (int i = 0; i < 1000; ++i) {
        for (int kind = 0; kind < 4; ++kind) {
            for (const double far : {0.0, 0x1p40, 0x1p90}) {
                const Bodies bodies(random, kind, far, 1 + random.below(4));
                BitRange others;
                if (i % 2 == 0) others.include(-20 - i % 90, 10 - i % 90);
                const environment::InFloatMode in(environment::float_modes[static_cast<std::size_t>(i) % 8]);
                ASSERT_NO_FATAL_FAILURE(check_frame(frame, bodies, others, count)) << i << " " << kind << " " << far;
            }
        }
    }
    EXPECT_GT(count.one_limb, 1000);
    EXPECT_GT(count.two_limbs, 1000);
    EXPECT_GT(count.none, 1000);
}

}  // namespace
}  // namespace ecods::exact::integer_frame_test
