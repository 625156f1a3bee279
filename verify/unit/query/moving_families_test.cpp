// Casts between poses of every family of cast_cases.hpp beside the oracle, along their way, and what must not matter.
#include <gtest/gtest.h>

#include <string_view>

#include "scenes/shapes.hpp"
#include "unit/query/expect_right.hpp"

namespace ecods {
namespace {

using Judged = judge::Judged<scenes::MoveCase>;

TEST(MovingFamilies, AsTheOracle) {
    std::map<std::string, int> kinds;
    std::size_t samples = 0;
    QueryMemory memory;
    PairWitness witness;
    scenes::for_each_case(scenes::move_families(), 1, 60, [&](const scenes::MoveCase& made) {
        const Judged judged(made);
        samples += judged.truth.sample_count();
        expect_right(made, judged, memory, witness, kinds);
    });
    expect_each(kinds, 6, 10);
    EXPECT_GT(samples, 1000U);
}

// Two hundred times along the way: the poses there are doubles.
TEST(MovingFamilies, SamplesAlongTheWay) {
    std::size_t samples = 0;
    QueryMemory memory;
    PairWitness witness;
    const auto count = [](std::string_view family) {
        const bool has_doubles =
            family == "lattice" || family == "integer matrix" || family == "turned over" || family == "short numbers";
        return has_doubles ? 15 : 0;
    };
    scenes::for_each_case(scenes::move_families(), 2, count, [&](const scenes::MoveCase& made) {
        const Judged judged(made, 256);
        samples += judged.truth.sample_count();
        expect_right(judged.truth, memory, witness);
    });
    EXPECT_GT(samples, 5000U);
}

TEST(MovingFamilies, TheSameBitsInEveryEnvironment) {
    expect_all_right_everywhere(scenes::move_families(), 3, 5, 1);
}

// Trees of several levels.
TEST(MovingFamilies, LargerMeshesAsTheOracle) {
    const MeshShape sphere(scenes::sphere(8, 5)), torus(scenes::torus(8, 5, 0.4));
    scenes::Random random(4);
    QueryMemory memory;
    PairWitness witness;
    const auto near = [&](const Pose& pose) {
        Pose result = pose;
        result.R += 0.125 * random.rotation().toRotationMatrix();
        return result;
    };
    for (int i = 0; i < 8; ++i) {
        Pose a = random.turned(), b = random.turned();
        a.t = 4 * random.direction();
        Pose to_a = near(a), to_b = near(b);
        to_a.t = (i % 3) * random.direction() - (i % 2) * a.t;
        const judge::CastTruth truth(Moving<MeshShape>(torus, a, to_a), Moving<MeshShape>(sphere, b, to_b));
        ASSERT_NO_FATAL_FAILURE(expect_right(truth, memory, witness)) << i;
    }
}

// To where they are, about, when they meet.
TEST(MovingFamilies, OwnAnswersAsArguments) {
    std::size_t asked = 0;
    const auto between = [](const Pose& from, const Pose& to, double s) {
        return Pose{from.R * (1 - s) + to.R * s, from.t * (1 - s) + to.t * s};
    };
    QueryMemory memory;
    PairWitness witness;
    scenes::for_each_case(scenes::move_families(), 5, 15, [&](scenes::MoveCase made) {
        const MeshShape a(made.a), b(made.b);
        const auto contact = cast(Moving(a, made.from_a, made.to_a), Moving(b, made.from_b, made.to_b), 1, memory);
        if (!contact) return;
        made.to_a = between(made.from_a, made.to_a, contact->time);
        made.to_b = between(made.from_b, made.to_b, contact->time);
        if (!made.to_a.R.allFinite() || !made.to_a.t.allFinite()) return;
        if (!made.to_b.R.allFinite() || !made.to_b.t.allFinite()) return;
        ++asked;
        expect_right(Judged(made, 1).truth, memory, witness);
    });
    EXPECT_GT(asked, 40U);
}

// A way of which both ends count as zero is one. (Found by the fuzzer: it was taken for no way.)
TEST(MovingFamilies, ASubnormalWayIsOne) {
    const MeshShape a(Mesh::create({Vec3(0, 0, 0)}, {{0, 0, 0}}));
    const MeshShape b(Mesh::create({Vec3(0x1p-1060, 0, 0)}, {{0, 0, 0}}));
    Pose to;
    to.t[0] = 0x1p-1058;
    QueryMemory memory;
    for (const environment::FloatMode& mode : environment::float_modes) {
        std::optional<FirstContact> contact;
        {
            const environment::InFloatMode in_mode(mode);
            contact = cast(Moving(a, Pose(), to), Moving(b, Pose(), Pose()), 1, memory);
        }
        EXPECT_EQ(contact ? contact->time : -1, 0.25) << mode.name;
    }
}

}  // namespace
}  // namespace ecods
