// Bodies that are very far apart compared with their size: the same answers as the oracle's, for the same work.
#include <gtest/gtest.h>

#include <cfenv>
#include <tuple>

#include "ecods/distance.hpp"
#include "judge/distance_truth.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"

namespace ecods {
namespace {

constexpr double ratios[] = {1e2, 3e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8};

struct Poses {
    Pose a, b;
    Vec3 direction;

    explicit Poses(scenes::Random& random) {
        a.R = random.rotation().toRotationMatrix();
        b.R = random.rotation().toRotationMatrix();
        direction = random.direction();
    }
    void set_distance(double d) { b.t = direction * d; }
};

std::uint64_t work_of(const Posed<MeshShape>& a, const Posed<MeshShape>& b) {
    QueryMemory memory;
    std::ignore = distance(a, b, memory);
    const QueryCounts& counts = memory.counts();
    return counts.box_tests + counts.distances.enclosures + counts.distances.triangle_bounds;
}

TEST(FarDistance, WorkIsThatOfNearerBodies) {
    const MeshShape torus(scenes::torus(100, 50, 0.4));
    const double diameter = 2.8;
    scenes::Random random(1);
    for (int i = 0; i < 6; ++i) {
        Poses poses(random);
        poses.set_distance(10 * diameter);
        const std::uint64_t near = work_of({torus, poses.a}, {torus, poses.b});
        for (const double ratio : ratios) {
            poses.set_distance(ratio * diameter);
            const std::uint64_t far = work_of({torus, poses.a}, {torus, poses.b});
            ASSERT_LE(far, 2 * near) << i << ", " << ratio << " diameters";
        }
    }
}

// Turned at random, or alike and one above the other, where many triangles tie.
TEST(FarDistance, AnswersAreTheOracles) {
    const MeshShape torus(scenes::torus(6, 4, 0.4)), other(scenes::sphere(5, 4));
    scenes::Random random(2);
    for (int i = 0; i < 4; ++i) {
        Poses poses(random);
        if (i == 3) {
            poses.a.R = poses.b.R = Mat3::Identity();
            poses.direction = Vec3(0, 0, 1);
        }
        for (const double ratio : ratios) {
            SCOPED_TRACE(ratio);
            poses.set_distance(ratio * 2.8);
            const Posed<MeshShape> a{torus, poses.a}, b{i % 2 == 0 ? other : torus, poses.b};
            const judge::DistanceTruth truth(a, b);
            for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
                QueryMemory memory;
                PairWitness witness;
                std::fesetround(mode);
                const auto wrong = truth.ask(memory, witness);
                std::fesetround(FE_TONEAREST);
                ASSERT_FALSE(wrong) << "rounding mode " << mode << ": " << wrong->question << ": expected "
                                    << wrong->expected << ", got " << wrong->got;
            }
        }
    }
}

}  // namespace
}  // namespace ecods
