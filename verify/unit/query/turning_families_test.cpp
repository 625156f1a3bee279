// Casts of turning bodies of every family of turn_cases.hpp beside the oracle, and what must not matter: integer maps
// of space, and how far away the pivot of a small turn is.
#include <gtest/gtest.h>

#include <string_view>

#include "scenes/hard_pair_parts.hpp"
#include "scenes/lattice_bodies.hpp"
#include "scenes/shapes.hpp"
#include "unit/query/expect_right.hpp"
#include "unit/query/turn_bodies.hpp"

namespace ecods {
namespace {

TEST(TurningFamilies, AsTheOracle) {
    std::map<std::string, int> kinds;
    std::size_t samples = 0;
    QueryMemory memory;
    PairWitness witness;
    const auto count = [](std::string_view family) {
        return family == "rods" || family == "doors" || family == "gears" ? 1 : 4;  // these have the most triangles
    };
    scenes::for_each_case(scenes::turn_families(), 1, count, [&](const scenes::TurnCase& made) {
        const judge::Judged<scenes::TurnCase> judged(made);
        samples += judged.truth.sample_count();
        expect_right(made, judged, memory, witness, kinds);
    });
    EXPECT_EQ(kinds.size(), 6U);
    EXPECT_GT(samples, 50U);
}

TEST(TurningFamilies, TheSameBitsInEveryEnvironment) {
    const auto small = scenes::turn_families();
    expect_all_right_everywhere(small.first(7), 2, 1, 1);  // of few triangles
}

// The quaternion's vector is a multiple of 9, so that the matrix, of norm 9, takes it to integers; no number is
// rounded.
TEST(TurningFamilies, IntegerMapsOfSpace) {
    Mat3 R;  // of the quaternion (2, 1, 2, 0)
    R << 1, 4, 8, 4, 7, -4, -8, 4, -1;
    ASSERT_EQ(R * R.transpose(), Mat3(81 * Mat3::Identity()));
    scenes::Random random(3);
    QueryMemory memory;
    int met = 0;
    for (int i = 0; i < 200; ++i) {
        const MeshShape a(scenes::lattice_mesh(random, 3, 3, false)), b(scenes::lattice_mesh(random, 3, 3, false));
        const Vec3 axis = scenes::lattice_point(random, 2), pivot = scenes::lattice_point(random, 3);
        const Vec3 glide = i % 2 == 0 ? Vec3(Vec3::Zero()) : scenes::lattice_point(random, 3);
        const Pose pose = at(scenes::hard::integer(random, -4, 4), 4, 3);
        const double w = scenes::hard::integer(random, 1, 20);
        const auto turn = [&](const Vec3& v, const Mat3& map) {
            return Turn{{w, v[0], v[1], v[2]}, map * pivot, map * (pivot + glide)};
        };
        const Contact first =
            cast(Turning<MeshShape>(a, pose, turn(9 * axis, Mat3::Identity())), {b, Pose()}, 1, memory);
        const Contact mapped =
            cast(Turning<MeshShape>(a, {R, R * pose.t}, turn(R * axis, R)), {b, {R, Vec3::Zero()}}, 1, memory);
        ASSERT_EQ(first, mapped) << i;
        met += first.has_value();
    }
    EXPECT_GT(met, 12);
}

// With its pivot r away a turn by an angle of 2 / r is nearly a translation by 2: points are off by about 2 / r.
TEST(TurningFamilies, FarPivotsAreNearlyTranslations) {
    scenes::Random random(4);
    QueryMemory memory;
    const MeshShape sphere(scenes::sphere(8, 5)), torus(scenes::torus(8, 5, 0.4));
    for (int i = 0; i < 12; ++i) {
        const double r = std::ldexp(1.0, 12 + 3 * i);
        const Pose a = random.turned(), b = {random.turned().R, Vec3(3, 0, 0)};
        const Turn turn{{1, 0, 0, -1 / r}, {0, -r, 0}, {0, -r, 0}};  // the x axis is the way, at first
        const Contact turned = cast(Turning<MeshShape>(torus, a, turn), {sphere, b}, 1, memory);
        const Contact moved = cast({torus, a}, Vec3(2, 0, 0), {sphere, b}, 1, memory);
        ASSERT_TRUE(turned && moved) << i;
        EXPECT_NEAR(turned->time, moved->time, 64 / r + 1e-12) << i;
    }
}

// A turn by twice the least angle, and a wall at half of it.
TEST(TurningFamilies, TinyTurns) {
    for (const double e : {0x1p-40, 0x1p-400, 0x1p-499}) {
        const std::vector<Vec3> wall{{-3, 5 * e, -1}, {9, 5 * e, -1}, {5, 5 * e, 3}};
        const Contact contact = cast_turning({{5, 0, 0}, {1, 0, 0}, {2, 0, 1}}, about_origin({1, 0, 0, e}), wall);
        // 10 e s / (1 + e^2 s^2) = 5 e
        const mpq_class square = mpq_class(e) * mpq_class(e);
        expect_root(contact, {1, -2, square});
        EXPECT_EQ(contact->time, 0.5);
    }
}

}  // namespace
}  // namespace ecods
