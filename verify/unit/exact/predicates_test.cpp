#include "ecods/primitives.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "scenes/random.hpp"

namespace ecods::predicates_test {
namespace {

constexpr double max = std::numeric_limits<double>::max();
constexpr double tiny = std::numeric_limits<double>::denorm_min();

TEST(Orient2d, SignsAndTheirNeighbours) {
    EXPECT_EQ(orient2d({0, 0}, {1, 0}, {0, 1}), Sign::positive);
    EXPECT_EQ(orient2d({0, 0}, {0, 1}, {1, 0}), Sign::negative);
    EXPECT_EQ(orient2d({0, 0}, {1, 1}, {2, 2}), Sign::zero);
    // The classic: 12 and 24 on the diagonal, around 0.5 in steps of the last place (Kettner et al. 2008).
    const double u = 0x1p-53;
    for (int i = 0; i < 64; ++i) {
        for (int j = 0; j < 64; ++j) {
            const Sign expected = j > i ? Sign::positive : j < i ? Sign::negative : Sign::zero;
            ASSERT_EQ(orient2d({12, 12}, {24, 24}, {0.5 + i * u, 0.5 + j * u}), expected) << i << " " << j;
        }
    }
}

TEST(Orient3d, SignsAndTheirNeighbours) {
    EXPECT_EQ(orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), Sign::positive);
    EXPECT_EQ(orient3d({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}), Sign::negative);
    const Vec3 a(0.1, 0.2, 0.3), b(1.1, 0.2, 0.3), c(0.1, 1.2, 0.3);
    EXPECT_EQ(orient3d(a, b, c, {0.7, 0.7, 0.3}), Sign::zero);
    EXPECT_EQ(orient3d(a, b, c, {0.7, 0.7, std::nextafter(0.3, 1)}), Sign::positive);
    EXPECT_EQ(orient3d(a, b, c, {0.7, 0.7, std::nextafter(0.3, 0)}), Sign::negative);
}

TEST(Orient3d, ExtremesOfTheRange) {
    EXPECT_EQ(orient3d({-max, -max, -max}, {max, -max, -max}, {-max, max, -max}, {0, 0, tiny}), Sign::positive);
    EXPECT_EQ(orient3d({0, 0, 0}, {max, 0, 0}, {0, max, 0}, {max, max, 0}), Sign::zero);
    EXPECT_EQ(orient3d({0, 0, 0}, {max, 0, 0}, {0, max, 0}, {max, max, -tiny}), Sign::negative);
    EXPECT_EQ(orient3d({0, 0, 0}, {tiny, 0, 0}, {0, tiny, 0}, {0, 0, tiny}), Sign::positive);
    EXPECT_EQ(orient2d({0, 0}, {tiny, 0}, {max, tiny}), Sign::positive);
    EXPECT_EQ(orient2d({-max, -max}, {0, 0}, {max, max}), Sign::zero);
    EXPECT_EQ(orient2d({-max, -max}, {tiny, 0}, {max, max}), Sign::positive);
}

TEST(Orient3d, PosedPointsAreNotRounded) {
    Pose a, b;
    // 3 * (1 / 3) is one in rounded arithmetic, and a little less in truth.
    a.R *= 1.0 / 3;
    const PosedPoint third{a, {3, 0, 0}}, one{b, {1, 0, 0}};
    const PosedPoint o{b, {0, 0, 0}}, y{b, {0, 1, 0}};
    EXPECT_EQ(orient2d(one, y, third, 2), Sign::positive);
    EXPECT_EQ(orient2d(one, y, {b, {3 * (1.0 / 3), 0, 0}}, 2), Sign::zero);
    EXPECT_EQ(orient3d(o, one, y, {a, {1, 1, tiny}}), Sign::positive);
    EXPECT_EQ(orient3d(o, one, y, {a, {1, 1, 0}}), Sign::zero);
    EXPECT_EQ(orient3d(o, one, y, {a, {1, 1, -tiny}}), Sign::negative);
}

TEST(TriangleTriangle, KnownRelations) {
    const std::array<Vec3, 3> a{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};
    const auto relation = [&](const Vec3& p, const Vec3& q, const Vec3& r) { return triangle_triangle(a, {p, q, r}); };
    EXPECT_EQ(relation({1, 1, -1}, {1, 1, 1}, {2, 1, 1}), Relation::crossing);
    EXPECT_EQ(relation({1, 1, 0}, {1, 1, 1}, {2, 1, 1}), Relation::touching) << "a vertex on the face";
    EXPECT_EQ(relation({1, 1, tiny}, {1, 1, 1}, {2, 1, 1}), Relation::apart);
    EXPECT_EQ(relation({2, 0, -1}, {2, 0, 1}, {2, -5, 0}), Relation::touching) << "edge on edge";
    EXPECT_EQ(relation({1, 1, 0}, {2, 1, 0}, {1, 2, 0}), Relation::touching) << "coplanar, inside";
    EXPECT_EQ(relation({4, 0, 0}, {8, 0, 0}, {8, 4, 0}), Relation::touching) << "coplanar, a shared vertex";
    EXPECT_EQ(relation({3, 3, 0}, {8, 0, 0}, {8, 4, 0}), Relation::apart) << "coplanar";
    EXPECT_EQ(relation({0, 0, 0}, {4, 0, 0}, {0, 0, 4}), Relation::touching) << "a shared edge";
    EXPECT_EQ(relation({1, 1, -1}, {1, 1, 1}, {1, 1, 1}), Relation::crossing) << "a segment through the face";
    EXPECT_EQ(relation({1, 1, 0}, {1, 1, 1}, {1, 1, 1}), Relation::touching) << "a segment that ends on the face";
    EXPECT_EQ(relation({0, 0, -1}, {0, 0, 1}, {0, 0, 0}), Relation::touching) << "a segment through a vertex";
    EXPECT_EQ(relation({1, 1, 0}, {1, 1, 0}, {1, 1, 0}), Relation::touching) << "a point";
    EXPECT_EQ(relation({3, 3, 0}, {3, 3, 0}, {3, 3, 0}), Relation::apart) << "a point";
}

}  // namespace
}  // namespace ecods::predicates_test
