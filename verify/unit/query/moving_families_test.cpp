// Casts between poses of every family of cast_cases.hpp beside the oracle, along their way, and what must not matter.
#include <gtest/gtest.h>

#include <array>

#include "environment/each_environment.hpp"
#include "judge/cast_truth.hpp"
#include "scenes/cast_cases.hpp"
#include "scenes/shapes.hpp"
#include "unit/query/expect_right.hpp"

namespace ecods {
namespace {

judge::CastTruth truth_of(const scenes::MoveCase& made, const MeshShape& a, const MeshShape& b, int samples) {
    return {{a, made.from_a, made.to_a}, {b, made.from_b, made.to_b}, samples};
}

// One witness goes through all of them: it comes from other bodies each time.
TEST(MovingFamilies, AsTheOracle) {
    std::array<int, 6> kinds{};
    std::size_t samples = 0;
    for (const scenes::MoveFamily family : scenes::move_families()) {
        SCOPED_TRACE(scenes::name(family));
        scenes::Random random(1);
        QueryMemory memory;
        PairWitness witness;
        for (int i = 0; i < 60; ++i) {
            SCOPED_TRACE(i);
            const scenes::MoveCase made = scenes::make_move_case(family, random);
            const MeshShape a(made.a), b(made.b);
            const judge::CastTruth truth = truth_of(made, a, b, 8);
            if (made.time) {
                ASSERT_EQ(truth.contact() ? truth.contact()->time : -1, *made.time);
            }
            ++kinds[truth.contact() ? static_cast<std::size_t>(truth.contact()->kind) : 5];
            samples += truth.sample_count();
            ASSERT_NO_FATAL_FAILURE(expect_right(truth, memory, witness));
        }
    }
    for (const int count : kinds) EXPECT_GT(count, 10);
    EXPECT_GT(samples, 1000U);
}

// Two hundred times along the way: the poses there are doubles.
TEST(MovingFamilies, SamplesAlongTheWay) {
    std::size_t samples = 0;
    for (const auto family : {scenes::MoveFamily::lattice, scenes::MoveFamily::integer_matrix,
                              scenes::MoveFamily::turned_over, scenes::MoveFamily::short_numbers}) {
        SCOPED_TRACE(scenes::name(family));
        scenes::Random random(2);
        QueryMemory memory;
        PairWitness witness;
        for (int i = 0; i < 15; ++i) {
            const scenes::MoveCase made = scenes::make_move_case(family, random);
            const MeshShape a(made.a), b(made.b);
            const judge::CastTruth truth = truth_of(made, a, b, 256);
            samples += truth.sample_count();
            ASSERT_NO_FATAL_FAILURE(expect_right(truth, memory, witness)) << i;
        }
    }
    EXPECT_GT(samples, 5000U);
}

// Neither instruction sets nor rounding modes matter, nor what a question leaves in the memory.
TEST(MovingFamilies, TheSameBitsInEveryEnvironment) {
    for (const scenes::MoveFamily family : scenes::move_families()) {
        SCOPED_TRACE(scenes::name(family));
        scenes::Random random(3);
        for (int i = 0; i < 5; ++i) {
            const scenes::MoveCase made = scenes::make_move_case(family, random);
            const MeshShape a(made.a), b(made.b);
            const judge::CastTruth truth = truth_of(made, a, b, 1);
            SCOPED_TRACE(i);
            expect_right_everywhere(truth);
        }
    }
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
        Pose a, b;
        a.R = random.rotation().toRotationMatrix();
        b.R = random.rotation().toRotationMatrix();
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
    for (const scenes::MoveFamily family : scenes::move_families()) {
        SCOPED_TRACE(scenes::name(family));
        scenes::Random random(5);
        QueryMemory memory;
        PairWitness witness;
        for (int i = 0; i < 15; ++i) {
            scenes::MoveCase made = scenes::make_move_case(family, random);
            const MeshShape a(made.a), b(made.b);
            const auto contact = cast(Moving(a, made.from_a, made.to_a), Moving(b, made.from_b, made.to_b), memory);
            if (!contact) continue;
            made.to_a = between(made.from_a, made.to_a, contact->time);
            made.to_b = between(made.from_b, made.to_b, contact->time);
            if (!made.to_a.R.allFinite() || !made.to_a.t.allFinite()) continue;
            if (!made.to_b.R.allFinite() || !made.to_b.t.allFinite()) continue;
            ++asked;
            ASSERT_NO_FATAL_FAILURE(expect_right(truth_of(made, a, b, 1), memory, witness)) << i;
        }
    }
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
            contact = cast(Moving(a, Pose(), to), Moving(b, Pose(), Pose()), memory);
        }
        EXPECT_EQ(contact ? contact->time : -1, 0.25) << mode.name;
    }
}

}  // namespace
}  // namespace ecods
