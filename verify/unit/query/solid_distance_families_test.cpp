#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "unit/query/expect_right.hpp"

namespace ecods {
namespace {

TEST(SolidDistanceFamilies, AsTheOracle) {
    expect_all_right_everywhere(scenes::convex_families(), 7, 8);
}

// A vertex beside, over or beyond the end of an edge or the side of a face, as the rounding of a pose has it.
TEST(SolidDistanceFamilies, AtTheBordersOfFeatures) {
    QueryMemory memory;
    PairWitness witness;
    scenes::Random random(9);
    const auto hull = [](std::vector<Vec3> points) { return convex_hull(std::span<const Vec3>(points)); };
    const auto box = hull({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 0}, {0, 0, 2}, {2, 0, 2}, {0, 2, 2}, {2, 2, 2}});
    const auto spike = hull({{0, 0, 0}, {1, 2, 3}, {-1, 2, 3}, {1, 3, 2}, {-1, 3, 2}, {0, 6, 6}});
    const auto wedge = hull({{-1, 0, 0}, {1, 0, 0}, {-1, 2, 3}, {1, 2, 3}, {-1, 3, 2}, {1, 3, 2}});
    const ConvexSolid a(box);
    for (const auto& mesh : {spike, wedge}) {
        const ConvexSolid b(mesh);
        for (const Vec3& offset : {Vec3(2, 3, 3), Vec3(1, 2, 3), Vec3(2, 2, 3), Vec3(3, 3, 3), Vec3(1, 3, 3),
                                   Vec3(2, 2 + 0x1p-30, 2 + 0x1p-30), Vec3(1, 2, 2 + 0x1p-40)}) {
            for (int i = 0; i < 12; ++i) {
                SCOPED_TRACE(testing::Message() << offset.transpose() << ", " << i);
                Pose p, q;
                p.R = q.R = random.rotation().toRotationMatrix();
                q.t = p.R * offset;
                if (i % 3 == 1) q.R = q.R * Eigen::AngleAxisd(1, Vec3::UnitX()).toRotationMatrix();
                expect_none(judge::ConvexTruth({a, p}, {b, q}).ask(memory, witness));
            }
        }
    }
}

}  // namespace
}  // namespace ecods
