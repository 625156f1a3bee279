// Numbers of every width, one bit at a time: each goes to a kernel that holds it, by the plain and by the cached path.
//
// Small lattice triangles keep their relation under any regular matrix, and lattice pairs are checked exhaustively
// (verify/exhaustive). So the answers are known, whatever the width of the matrix's entries.

#include <gtest/gtest.h>

#include <cmath>

#include "ecods/mesh.hpp"
#include "ecods/primitives.hpp"
#include "query/intersection/triangle_relations.hpp"
#include "scenes/random.hpp"

namespace ecods::exact::width_sweep_test {
namespace {

using scenes::Random;

std::array<Vec3, 3> lattice_triangle(Random& random) {
    std::array<Vec3, 3> corners;
    for (Vec3& v : corners) {
        for (int k = 0; k < 3; ++k) v[k] = random.below(5) - 2.0;
    }
    return corners;
}

// An odd number of exactly 53 bits, or the largest or smallest.
double full_mantissa(Random& random) {
    const double sign = random.below(2) == 0 ? 1 : -1;
    switch (random.below(4)) {
        case 0:
            return sign * (0x1p53 - 1);
        case 1:
            return sign * (0x1p52 + 1);
        default:
            return sign * (std::floor(random.uniform(0x1p51, 0x1p52)) * 2 + 1);
    }
}

bool is_singular(const Mat3& R) {
    return orient3d(Vec3::Zero(), R.col(0), R.col(1), R.col(2)) == Sign::zero;
}

// Regular. One column of every row is wider than the others by `shift` bits.
Mat3 wide_matrix(Random& random, int shift) {
    Mat3 R;
    do {
        const auto wide = random.below(3);
        for (std::uint32_t column = 0; column < 3; ++column) {
            for (int row = 0; row < 3; ++row) {
                R(row, column) = std::ldexp(full_mantissa(random), column == wide ? shift : 0);
            }
        }
    } while (is_singular(R));
    return R;
}

class Widths {
  public:
    void check(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b, const Mat3& R) {
        const Relation expected = triangle_triangle(a, b);
        Pose pose_a, pose_b;
        pose_a.R = R;
        // Modelled mirrored, so that the poses differ and the bodies are not compared where they were modelled.
        pose_b.R = -R;
        const std::array<Vec3, 3> mirrored{-b[0], -b[1], -b[2]};
        ASSERT_EQ(triangle_triangle({pose_a, a}, {pose_b, mirrored}), expected);
        ASSERT_EQ(triangle_triangle({pose_b, mirrored}, {pose_a, a}), expected);
        const auto mesh_a = Mesh::create({a.begin(), a.end()}, {{0, 1, 2}});
        const auto mesh_b = Mesh::create({mirrored.begin(), mirrored.end()}, {{0, 1, 2}});
        const MeshExtent extent_a = measure(*mesh_a), extent_b = measure(*mesh_b);
        bodies_.bind({mesh_a.get(), &extent_a, &pose_a}, {mesh_b.get(), &extent_b, &pose_b});
        ASSERT_EQ(bodies_.relation(0, 0), expected);
    }
    const StageCounts& counts() const { return bodies_.counts(); }

  private:
    TriangleRelations bodies_;
};

TEST(WidthSweep, AnswersDoNotDependOnTheWidth) {
    Random random(3);
    Widths widths;
    for (int shift = 0; shift < 900; ++shift) {
        SCOPED_TRACE(shift);
        // Most around the limits of one and two limbs.
        const int count = shift < 100 ? 300 : 10;
        for (int i = 0; i < count; ++i) {
            const auto a = lattice_triangle(random);
            auto b = lattice_triangle(random);
            if (random.below(2) == 0) b[0] = a[random.below(3)];
            widths.check(a, b, wide_matrix(random, shift));
            if (HasFatalFailure()) return;
        }
    }
    EXPECT_GT(widths.counts().one_limb, 1000u);
    EXPECT_GT(widths.counts().two_limbs, 1000u);
    EXPECT_GT(widths.counts().many_limbs, 1000u);
}

// Matrices of integers: those of few bits are where plain double is exact, and then it just is not.
TEST(WidthSweep, PlainDoubleIsNotTrustedTooFar) {
    Random random(4);
    Widths widths;
    for (int bits = 1; bits < 53; ++bits) {
        SCOPED_TRACE(bits);
        for (int i = 0; i < 400; ++i) {
            Mat3 R;
            do {
                for (int k = 0; k < 9; ++k) {
                    R.data()[k] = std::floor(random.uniform(-1, 1) * std::ldexp(1.0, bits)) + 0.0;
                }
            } while (is_singular(R));
            const auto a = lattice_triangle(random);
            auto b = lattice_triangle(random);
            if (random.below(2) == 0) b[0] = a[random.below(3)];
            widths.check(a, b, R);
            if (HasFatalFailure()) return;
        }
    }
    EXPECT_GT(widths.counts().local_passes, 1000u);
}

// Bodies modelled far from their own origin: near each other, of few bits, and yet their posed points are no doubles.
TEST(WidthSweep, PosedPointsThatAreNoDoubles) {
    const double far = 0x1p55;
    Pose sheared, moved;
    sheared.R(0, 1) = 1;
    moved.t = Vec3(far, 0, 0);
    // Sheared, (far, y, z) is (far + y, y, z).
    const auto relation = [&](const Vec3& tip) {
        const std::vector<Vec3> a{Vec3(far, 3, 0), Vec3(far, 1, 5), Vec3(far, 1, -5)};
        const std::vector<Vec3> b{tip, tip + Vec3(4, 0, 1), tip + Vec3(4, 0, -1)};
        const auto mesh_a = Mesh::create(a, {{0, 1, 2}}), mesh_b = Mesh::create(b, {{0, 1, 2}});
        const MeshExtent extent_a = measure(*mesh_a), extent_b = measure(*mesh_b);
        TriangleRelations bodies;
        bodies.bind({mesh_a.get(), &extent_a, &sheared}, {mesh_b.get(), &extent_b, &moved});
        return bodies.relation(0, 0);
    };
    EXPECT_EQ(relation({3, 3, 0}), Relation::touching);
    EXPECT_EQ(relation({1, 1, 0}), Relation::touching);
    EXPECT_EQ(relation({2, 2, 0}), Relation::touching);
    EXPECT_EQ(relation({0, 2, 0}), Relation::crossing);
    EXPECT_EQ(relation({2, 1, 0}), Relation::apart);
    EXPECT_EQ(relation({3, 2, 0}), Relation::apart);
    EXPECT_EQ(relation({4, 3, 0}), Relation::apart);
}

}  // namespace
}  // namespace ecods::exact::width_sweep_test
