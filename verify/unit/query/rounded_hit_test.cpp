// Hits of rounded bodies: known answers, and random lines against the oracle.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "ecods/error.hpp"
#include "ecods/hit.hpp"
#include "environment/each_environment.hpp"
#include "oracle/rounded_motion.hpp"
#include "scenes/pose_at.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"
#include "unit/query/rounded_bodies.hpp"
#include "unit/query/solid_soup.hpp"

namespace ecods {
namespace {

using rounded_bodies::around;
using rounded_bodies::Ball;

struct Met {
    double parameter;
    HitKind kind;

    friend bool operator==(const Met&, const Met&) = default;
    friend std::ostream& operator<<(std::ostream& out, const Met& met) {
        return out << met.kind << " at " << met.parameter;
    }
};
using Mets = std::vector<Met>;

constexpr HitKind enters = HitKind::front, leaves = HitKind::back, begins = HitKind::inside, touches = HitKind::face;

// Returns the hits, and expects the first of them from first_hit, with ascending ranks.
template <class Line>
Mets hits_of(const Line& line, const Rounded& body, const Pose& pose = Pose()) {
    const std::vector<Hit> all = body.all_hits(line, pose, {});
    const std::optional<Hit> first = body.first_hit(line, pose, {});
    EXPECT_EQ(first.has_value(), !all.empty());
    Mets result;
    for (const Hit& hit : all) {
        EXPECT_EQ(hit.rank, result.size());
        EXPECT_EQ(hit.leave_parameter, hit.parameter);
        result.push_back({hit.parameter, hit.kind});
    }
    if (first && !all.empty()) {
        const auto parts = [](const Hit& hit) {
            return std::tuple(hit.parameter, hit.kind, hit.rank, hit.feature.kind, hit.feature.triangle,
                              hit.feature.corner);
        };
        EXPECT_EQ(parts(*first), parts(all[0]));
        EXPECT_EQ(first->point, all[0].point);
    }
    return result;
}

TEST(RoundedHit, ABall) {
    const Ball ball = sphere(5, {1, 0, 0});
    const auto along_x = [](double x, double y) { return Ray{{x, y, 0}, {1, 0, 0}}; };
    EXPECT_EQ(hits_of(along_x(-9, 3), *ball), (Mets{{6, enters}, {14, leaves}}));
    EXPECT_EQ(hits_of(along_x(-9, 5), *ball), (Mets{{10, touches}}));
    EXPECT_EQ(hits_of(along_x(-9, std::nextafter(5.0, 6)), *ball), Mets());
    EXPECT_EQ(hits_of(along_x(-2, 3), *ball), (Mets{{0, begins}, {7, leaves}}));
    EXPECT_EQ(hits_of(along_x(-3, 3), *ball), (Mets{{0, enters}, {8, leaves}})) << "it begins on the surface";
    EXPECT_EQ(hits_of(along_x(5, 3), *ball), (Mets{{0, touches}}));
    EXPECT_EQ(hits_of(along_x(std::nextafter(5.0, 6), 3), *ball), Mets());
    EXPECT_EQ(hits_of(along_x(1, 5), *ball), (Mets{{0, touches}}));
    EXPECT_EQ(hits_of(Segment{{-9, 3, 0}, {-3, 3, 0}}, *ball), (Mets{{1, enters}}));
    EXPECT_EQ(hits_of(Segment{{-9, 3, 0}, {std::nextafter(-3.0, -4), 3, 0}}, *ball), Mets());
    EXPECT_EQ(hits_of(Segment{{-9, 3, 0}, {7, 3, 0}}, *ball), (Mets{{0.375, enters}, {0.875, leaves}}));
    EXPECT_EQ(hits_of(Segment{{0, 0, 0}, {1, 0, 0}}, *ball), (Mets{{0, begins}}));
    EXPECT_EQ(hits_of(Segment{{0, 0, 0}, {0, 0, 0}}, *ball), (Mets{{0, begins}}));
    EXPECT_EQ(hits_of(Segment{{5, 3, 0}, {5, 3, 0}}, *ball), (Mets{{0, touches}}));
    EXPECT_EQ(hits_of(Segment{{5, 4, 0}, {5, 4, 0}}, *ball), Mets());
    EXPECT_EQ(hits_of(Ray{{-9, 3, 0}, {2, 0, 0}, 3}, *ball), (Mets{{3, enters}}));
    EXPECT_EQ(hits_of(Ray{{-9, 3, 0}, {2, 0, 0}, 2.5}, *ball), Mets());
    EXPECT_EQ(hits_of(Ray{{0, 0, 0}, {1, 0, 0}, 0}, *ball), (Mets{{0, begins}}));
    const Hit hit = *ball->first_hit(along_x(-9, 3), Pose(), {});
    EXPECT_EQ(hit.point, Vec3(-3, 3, 0));
    EXPECT_EQ(hit.feature, (Feature{Feature::Kind::vertex, 0, 0}));
    const Hit diagonal = *ball->first_hit(Ray{{-4, 0, -5}, {0, 0, 1}}, Pose(), {});
    EXPECT_EQ(diagonal.point, Vec3(-4, 0, 0)) << "+0";
    EXPECT_FALSE(std::signbit(diagonal.point[2]));
    // An irrational point: y^2 + z^2 = 25 at y = z.
    EXPECT_EQ(ball->first_hit(Ray{{1, 9, 9}, {0, -1, -1}}, Pose(), {})->point,
              Vec3(1, std::sqrt(12.5), std::sqrt(12.5)));
}

TEST(RoundedHit, ACapsuleAndABoxWithAMargin) {
    const Ball bone = capsule({0, 0, -2}, {0, 0, 2}, 5);
    EXPECT_EQ(hits_of(Ray{{-9, 3, 1}, {1, 0, 0}}, *bone), (Mets{{5, enters}, {13, leaves}}));
    EXPECT_EQ(bone->first_hit(Ray{{-9, 3, 1}, {1, 0, 0}}, Pose(), {})->feature.kind, Feature::Kind::edge);
    EXPECT_EQ(bone->first_hit(Ray{{-9, 3, 2}, {1, 0, 0}}, Pose(), {})->feature, (Feature{Feature::Kind::vertex, 0, 1}))
        << "where the cylinder and the ball join";
    EXPECT_EQ(hits_of(Ray{{-9, 3, 5}, {1, 0, 0}}, *bone),
              (Mets{{9 - std::sqrt(7.0), enters}, {9 + std::sqrt(7.0), leaves}}));
    EXPECT_EQ(hits_of(Ray{{0, 3, -9}, {0, 0, 1}}, *bone), (Mets{{3, enters}, {15, leaves}}));
    EXPECT_EQ(hits_of(Ray{{0, 5, -9}, {0, 0, 1}}, *bone), (Mets{{7, enters}, {11, leaves}}))
        << "it runs along the side";
    const Ball padded = rounded(std::make_shared<const ConvexSolid>(scenes::cube(1)), 1);
    EXPECT_EQ(hits_of(Ray{{-9, 0.5, 0.25}, {1, 0, 0}}, *padded), (Mets{{7, enters}, {11, leaves}}));
    EXPECT_EQ(hits_of(Ray{{0, 0, 0}, {1, 0, 0}}, *padded), (Mets{{0, begins}, {2, leaves}}));
    EXPECT_EQ(hits_of(Ray{{-9, 1.6, 0}, {1, 0, 0}}, *padded), (Mets{{7.2, enters}, {10.8, leaves}})) << "at an edge";
    EXPECT_EQ(hits_of(Ray{{-9, 2, 0}, {1, 0, 0}}, *padded), (Mets{{8, enters}, {10, leaves}})) << "along a face";
    EXPECT_EQ(hits_of(Segment{{0, 0, 0}, {0.5, 0, 0}}, *padded), (Mets{{0, begins}}));
    const Ball thin = rounded(std::make_shared<const ConvexSolid>(scenes::cube(1)), 0.25);
    EXPECT_EQ(hits_of(Ray{{-9, 0.5, 0.25}, {1, 0, 0}}, *thin), (Mets{{7.75, enters}, {10.25, leaves}}));
    // The margin of a surface has a hollow.
    const Ball shell = around(scenes::cube(1), 0.25);
    EXPECT_EQ(hits_of(Ray{{-9, 0.5, 0.25}, {1, 0, 0}}, *shell),
              (Mets{{7.75, enters}, {8.25, leaves}, {9.75, enters}, {10.25, leaves}}));
    EXPECT_EQ(hits_of(Ray{{0, 0, 0}, {1, 0, 0}}, *shell), (Mets{{0.75, enters}, {1.25, leaves}}));
    Pose stretched;
    stretched.R(0, 0) = -4;
    EXPECT_EQ(hits_of(Ray{{-9, 0.5, 0.25}, {1, 0, 0}}, *padded, stretched), (Mets{{4, enters}, {14, leaves}}));
}

// A solid of two boxes, one behind the other.
TEST(RoundedHit, ASolidThatIsNotConvex) {
    Soup soup = soup_of_box({-4, -1, -1}, {-1, 1, 1});
    soup.add_box({1, -1, -1}, {4, 1, 1});
    const auto solid = std::make_shared<const Solid>(soup.mesh());
    const Ray ray{{-9, 0.5, 0.25}, {1, 0, 0}};
    EXPECT_EQ(hits_of(ray, *rounded(solid, 0.5)), (Mets{{4.5, enters}, {8.5, leaves}, {9.5, enters}, {13.5, leaves}}));
    EXPECT_EQ(hits_of(ray, *rounded(solid, 1)), (Mets{{4, enters}, {14, leaves}})) << "the margins touch";
    const Ray from_inside{{-2.5, 0, 0}, {1, 0, 0}};
    EXPECT_EQ(hits_of(from_inside, *rounded(solid, 0.125)),
              (Mets{{0, begins}, {1.625, leaves}, {3.375, enters}, {6.625, leaves}}));
    EXPECT_EQ(hits_of(Segment{{-2.5, 0, 0}, {-2, 0, 0}}, *rounded(solid, 0.125)), (Mets{{0, begins}}));
    EXPECT_EQ(hits_of(Segment{{-9, 0, 0}, {-2.5, 0, 0}}, *rounded(solid, 0.5)), (Mets{{4.5 / 6.5, enters}}));
    EXPECT_EQ(hits_of(Segment{{-9, 0, 0}, {1, 0, 0}}, *rounded(solid, 0.5)),
              (Mets{{0.45, enters}, {0.85, leaves}, {0.95, enters}}));
    // A radius below the digits of the coordinates: where the line is between hits is not known.
    const Ball thin = rounded(solid, 0x1p-60);
    EXPECT_TRUE(thin->first_hit(ray, Pose(), {}));
    EXPECT_THROW((void)thin->all_hits(ray, Pose(), {}), NotSupported);
}

TEST(RoundedHit, WithoutARadiusItIsThatOfTheCore) {
    const auto ring = std::make_shared<const MeshShape>(scenes::torus(20, 10, 0.25));
    scenes::Random random(41);
    for (int i = 0; i < 40; ++i) {
        const Pose pose(random.turned().R, random.direction());
        const Segment segment{random.direction() * 3, random.direction() * 3};
        const auto all = rounded(ring, 0)->all_hits(segment, pose, {}), expected = ring->all_hits(segment, pose, {});
        ASSERT_EQ(all.size(), expected.size());
        for (std::size_t k = 0; k < all.size(); ++k) {
            EXPECT_EQ(all[k].parameter, expected[k].parameter);
            EXPECT_EQ(all[k].feature, expected[k].feature);
        }
        EXPECT_EQ(rounded(ring, 0)->first_hit(segment, pose, {}).has_value(), !expected.empty());
    }
}

TEST(RoundedHit, RandomLinesAsTheOracle) {
    scenes::Random random(42);
    int hit_count = 0;
    for (int i = 0; i < 200; ++i) {
        SCOPED_TRACE(i);
        const auto point = [&] { return Vec3(random.direction() * random.uniform(0, 2)); };
        const std::array<Vec3, 3> corners{point(), point(), i % 4 == 0 ? Vec3(0, 0, 0) : point()};
        const Ball body = around(scenes::one_triangle(corners), random.uniform(0.01, 1));
        Pose pose = random.turned();
        if (i % 5 == 0) pose.R.col(1) *= -0.5;
        const Vec3 from = random.direction() * 5, to = -from + 4 * random.direction();
        const Segment segment{from, to};
        oracle::Vector<mpq_class> begin, step;
        for (std::size_t k = 0; k < 3; ++k) {
            begin[k] = oracle::exactly(from[static_cast<Eigen::Index>(k)]);
            step[k] = oracle::exactly(to[static_cast<Eigen::Index>(k)]) - begin[k];
        }
        const auto points = oracle::posed_points(body->core().mesh(), pose);
        const oracle::RoundedMotion truth({begin, begin, begin}, {points[0], points[1], points[2]}, step,
                                          oracle::exactly(body->radius()));
        const Mets found = hits_of(segment, *body, pose);
        const auto expected = truth.first(1);
        ASSERT_EQ(!found.empty(), expected.has_value());
        if (found.empty()) continue;
        ++hit_count;
        EXPECT_EQ(found[0], (Met{*expected, enters}));
        if (found.size() == 2) {
            EXPECT_TRUE(truth.is_last(found[1].parameter));
        } else {
            EXPECT_TRUE(truth.is_near(1));
        }
        EXPECT_EQ(hits_of(Ray{from, to - from}, *body, pose).empty(), false);
        if (testing::Test::HasFailure()) return;
    }
    EXPECT_GT(hit_count, 30);
}

// The first hit of a mesh is the first of its triangles; a box of the size of doubles' digits is found, too.
TEST(RoundedHit, MeshesAsTheirTriangles) {
    const auto ring = scenes::torus(24, 12, 0.25);
    scenes::Random random(43);
    int hit_count = 0;
    for (int i = 0; i < 40; ++i) {
        const double r = random.uniform(0, 0.3);
        const Ray ray{random.direction() * random.uniform(2, 1000), Vec3(0, 0, 0)};
        const Ray aimed{ray.origin, random.direction() - ray.origin};
        const auto found = around(ring, r)->first_hit(aimed, Pose(), {});
        std::optional<Hit> least;
        for (const Triangle& triangle : ring->triangles()) {
            const auto part = Mesh::create({ring->vertices().begin(), ring->vertices().end()}, {triangle});
            const auto hit = around(part, r)->first_hit(aimed, Pose(), {});
            if (hit && (!least || hit->parameter < least->parameter)) least = hit;
        }
        ASSERT_EQ(found.has_value(), least.has_value());
        if (!found) continue;
        ++hit_count;
        EXPECT_EQ(found->parameter, least->parameter);
        EXPECT_EQ(found->point, least->point);
    }
    EXPECT_GT(hit_count, 15);
}

TEST(RoundedHit, SmallAndLargeUnits) {
    scenes::Random random(44);
    for (int i = 0; i < 40; ++i) {
        const auto point = [&] { return Vec3(random.below(9), random.below(9), random.below(9)); };
        const std::array<Vec3, 3> corners{point(), point(), point()};
        const Vec3 from = Vec3(-20, random.below(9), random.below(9)), to = point();
        Mets expected;
        for (const double unit : {1.0, 0x1p-1070, 0x1p1015, 0x1p-200}) {
            const Ball body =
                around(scenes::one_triangle({unit * corners[0], unit * corners[1], unit * corners[2]}), unit * 2);
            const Mets found = hits_of(Segment{unit * from, unit * to}, *body);
            if (unit == 1) expected = found;
            EXPECT_EQ(found, expected) << unit;
            if (!found.empty()) {
                EXPECT_EQ(hits_of(Ray{unit * from, unit * (to - from)}, *body)[0], found[0]) << unit;
            }
        }
    }
    // Distances below the least double, and a radius that is much larger than all else.
    EXPECT_EQ(hits_of(Ray{{-0x1p-1073, 0, 0}, {0x1p1000, 0, 0}}, *sphere(0x1p-1074)),
              (Mets{{0x1p-1074, enters}, {0x1p-1074, leaves}}));
    EXPECT_EQ(hits_of(Ray{{-0x1p-500, 0, 0}, {1, 0, 0}}, *sphere(0x1p500)), (Mets{{0, begins}, {0x1p500, leaves}}));
}

TEST(RoundedHit, TheSameInEveryEnvironment) {
    struct Asked {
        Ball body;
        Pose pose;
        Ray ray;
    };
    std::vector<Asked> asked;
    const Ball bone = capsule({0, 0, -2}, {0, 0, 2}, 0.1), soup = around(scenes::torus(9, 5, 0.25), 0.2);
    for (const double unit : {1.0, 0x1p-1060, 0x1p1000}) {
        for (const Ball& body : {bone, soup}) {
            asked.push_back({body, Pose(unit * Mat3::Identity(), Vec3::Zero()),
                             Ray{unit * Vec3(5, 0.125, 0.25), Vec3(-6, -0.1, -0.3)}});
        }
    }
    const auto ask = [&] {
        std::vector<double> all;
        for (const auto& [body, pose, ray] : asked) {
            for (const Hit& hit : body->all_hits(ray, pose, {})) {
                all.insert(all.end(), {hit.parameter, hit.point[0], hit.point[1], hit.point[2]});
            }
        }
        std::vector<std::uint64_t> bits;
        for (const double x : all) bits.push_back(std::bit_cast<std::uint64_t>(x));
        return bits;
    };
    const auto expected = ask();
    EXPECT_FALSE(expected.empty());
    environment::in_each_environment(
        ask, [&](const auto& got, const std::string& where) { EXPECT_TRUE(got == expected) << where; });
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW((void)bone->all_hits(Ray{{nan, 0, 0}, {1, 0, 0}}, Pose(), {}), InvalidArgument);
    EXPECT_THROW((void)bone->first_hit(Ray{{0, 0, 0}, {0, 0, 0}}, Pose(), {}), InvalidArgument);
}

}  // namespace
}  // namespace ecods
