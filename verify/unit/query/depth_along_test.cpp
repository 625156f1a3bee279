// Depths with their points, and along a direction: known answers, and beside the oracle's set of differences.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

#include "ecods/contact.hpp"
#include "ecods/error.hpp"
#include "ecods/solid.hpp"
#include "oracle/convex_facets.hpp"
#include "oracle/float_environment.hpp"
#include "scenes/lattice_hull.hpp"
#include "scenes/pose_at.hpp"
#include "scenes/random.hpp"
#include "unit/query/solid_soup.hpp"

namespace ecods {
namespace {

const ConvexSolid& unit_box() {
    static const ConvexSolid solid(box(Vec3(-0.5, -0.5, -0.5), Vec3(0.5, 0.5, 0.5)));
    return solid;
}

TEST(DepthPoints, AreThoseOfTheSignedDistance) {
    for (const Vec3& t : {Vec3(0.75, 0, 0), Vec3(0.75, 0.25, 0.5), Vec3(1, 0.5, 0), Vec3(0, 0, 0), Vec3(1, 1, 1)}) {
        const auto deep = depth_points({unit_box(), Pose()}, {unit_box(), at(t)});
        ASSERT_TRUE(deep);
        EXPECT_EQ(deep->depth, *depth({unit_box(), Pose()}, {unit_box(), at(t)}));
        const SignedDistance d = signed_distance({unit_box(), Pose()}, {unit_box(), at(t)});
        EXPECT_EQ(std::tie(deep->a, deep->b, deep->point_a, deep->point_b), std::tie(d.a, d.b, d.point_a, d.point_b));
        EXPECT_EQ(deep->point_a - deep->point_b, deep->depth.depth * deep->depth.direction);
    }
    EXPECT_FALSE(depth_points({unit_box(), Pose()}, {unit_box(), at(1.5)}));
}

TEST(DepthAlong, OfCubes) {
    const auto along = [&](const Vec3& t, const Vec3& d) {
        return depth_along({unit_box(), Pose()}, {unit_box(), at(t)}, d);
    };
    const auto out = along({0.25, 0, 0}, {2, 0, 0});
    ASSERT_TRUE(out);
    EXPECT_EQ(out->parameter, 0.375);
    EXPECT_EQ(out->length, 0.75);
    EXPECT_EQ(out->normal, Vec3(1, 0, 0));
    EXPECT_EQ(along({0.25, 0, 0}, {-1, 0, 0})->length, 1.25);
    EXPECT_EQ(along({0.25, 0, 0}, {0, 3, 4})->parameter, 0.25);
    EXPECT_EQ(along({0.25, 0, 0}, {0, 3, 4})->length, 1.25);
    // touching, whatever the direction; and apart
    EXPECT_EQ(along({1, 0, 0}, {-1, 0, 0})->parameter, 0);
    EXPECT_EQ(along({1, 0, 0}, {0, 1, 0})->length, 0);
    EXPECT_FALSE(along({1.5, 0, 0}, {-1, 0, 0}));
    // numbers far from one
    EXPECT_EQ(along({0, 0, 0}, {0x1p-1000, 0, 0})->parameter, 0x1p1000);
    EXPECT_EQ(along({0, 0, 0}, {0x1p-1000, 0, 0})->length, 1);
    EXPECT_EQ(along({0, 0, 0}, {0x1p1000, 0x1p-1074, 0})->parameter, 0x1p-1000);
    EXPECT_EQ(along({0, 0, 0}, {0x1p-1074, 0, 0})->parameter, std::numeric_limits<double>::infinity());
}

TEST(DepthAlong, RefusesBadArguments) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const Vec3& bad : {Vec3(0, 0, 0), Vec3(-0.0, 0, 0), Vec3(0, nan, 0), Vec3(0, 0, 1 / 0.0)}) {
        EXPECT_THROW(std::ignore = depth_along({unit_box(), Pose()}, {unit_box(), Pose()}, bad), InvalidArgument);
    }
    Pose flat;
    flat.R(0, 0) = 0;
    EXPECT_THROW(std::ignore = depth_along({unit_box(), Pose()}, {unit_box(), flat}, Vec3::UnitX()), SingularPose);
    EXPECT_THROW(std::ignore = depth_points({unit_box(), Pose()}, {unit_box(), flat}), SingularPose);
}

// Truth has where the line meets its first facet, and the normal; several may tie where the origin is on the border.
struct Truth {
    mpq_class parameter;
    Vec3 normal;
};
std::optional<Truth> truth_of(const ConvexSolid& a, const Pose& p, const ConvexSolid& b, const Pose& q, const Vec3& d) {
    const oracle::FloatEnvironment environment;
    const oracle::ConvexBodies bodies({&a.mesh(), &b.mesh()}, {p, q});
    std::optional<Truth> first;
    for (const oracle::DifferenceFacet& facet : oracle::difference_facets(bodies)) {
        if (sgn(facet.height) < 0) return std::nullopt;
        mpq_class along = 0;
        for (std::size_t k = 0; k < 3; ++k) along += mpq_class(d[static_cast<int>(k)]) * mpq_class(facet.normal[k]);
        if (sgn(facet.height) > 0 && sgn(along) <= 0) continue;
        mpq_class parameter = 0;
        if (sgn(facet.height) > 0) {
            parameter = mpq_class(facet.height) / along;
            const mpq_class unit(mpz_class(1) << static_cast<unsigned long>(std::abs(bodies.unit)));
            parameter = bodies.unit < 0 ? mpq_class(parameter / unit) : mpq_class(parameter * unit);
        }
        if (first && parameter >= first->parameter) continue;
        first = Truth{parameter, oracle::ExactDirection{facet.normal}.nearest()};
    }
    return first;
}

TEST(DepthAlong, AsTheOracle) {
    scenes::Random random(5);
    int deep = 0, apart = 0, touching = 0;
    for (int i = 0; i < 300; ++i) {
        SCOPED_TRACE(i);
        const auto hull = [&] { return scenes::to_mesh(scenes::random_lattice_hull(2, 6, random), 1); };
        const ConvexSolid a(hull()), b(hull());
        Pose p, q;
        if (i % 3 == 1) q = random.turned();
        if (i % 5 == 2) p.R(0, 0) = -2;
        for (double& x : q.t) x = (static_cast<double>(random.below(13)) - 6) / 2;
        Vec3 d;
        do {
            for (double& x : d) x = static_cast<double>(random.below(7)) - 3;
        } while (d.isZero());
        const auto truth = truth_of(a, p, b, q, d);
        const auto found = depth_along({a, p}, {b, q}, d);
        ASSERT_EQ(truth.has_value(), found.has_value());
        if (!truth) {
            ++apart;
            continue;
        }
        ++(sgn(truth->parameter) == 0 ? touching : deep);
        EXPECT_EQ(found->parameter,
                  oracle::nearest(oracle::ExactFraction{truth->parameter.get_num(), truth->parameter.get_den(), 0}));
        const mpq_class length = truth->parameter * truth->parameter * mpq_class(d.squaredNorm());
        EXPECT_EQ(found->length, oracle::nearest(oracle::ExactRoot{length.get_num(), length.get_den(), 0}));
        EXPECT_EQ(found->normal, truth->normal);
    }
    EXPECT_GE(std::min({deep, apart, touching}), 5);
}

}  // namespace
}  // namespace ecods
