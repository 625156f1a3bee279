// Casts of two bodies that turn, for every family of turn_cases.hpp and a second turn, beside the oracle, and the
// oracle beside pieces of the time; and integer maps of space.
#include <gtest/gtest.h>

#include <map>

#include "judge/both_turn_truth.hpp"
#include "judge/text.hpp"
#include "judge/turn_truth.hpp"
#include "scenes/each_case.hpp"
#include "scenes/lattice_bodies.hpp"
#include "scenes/turn_cases.hpp"
#include "unit/query/cast_bodies.hpp"

namespace ecods {
namespace {

TEST(BothTurningFamilies, AsTheOracle) {
    scenes::Random random(11);
    std::map<std::string, int> kinds;
    QueryMemory memory;
    PairWitness witness;
    int pieces = 0;
    scenes::for_each_case(scenes::turn_families(), 3, 5, [&](const scenes::TurnCase& made) {
        const std::size_t pairs = made.a->triangles().size() * made.b->triangles().size();
        if (pairs > 36) return;
        const MeshShape a(made.a), b(made.b);
        const Turn second = scenes::turn_beside(random, made);
        const judge::BothTurnTruth truth({a, made.pose_a, made.turn}, {b, made.pose_b, second});
        const auto wrong = truth.ask(memory, witness);
        ASSERT_FALSE(wrong) << wrong->question << ": " << wrong->got << " in place of " << wrong->expected << ", "
                            << judge::text(made.turn) << ", " << judge::text(second);
        ++kinds[truth.contact() ? judge::written(truth.contact()->kind) : "nothing"];
        if (pairs > 4) return;
        ++pieces;
        ASSERT_EQ(truth.contradiction().value_or(""), "") << judge::text(made.turn) << ", " << judge::text(second);
    });
    EXPECT_GE(kinds.size(), 4U);
    EXPECT_GT(pieces, 10);
}

// All that turns is turned by an integer matrix of norm 9, and no number is rounded.
TEST(BothTurningFamilies, IntegerMapsOfSpace) {
    Mat3 R;  // of the quaternion (2, 1, 2, 0)
    R << 1, 4, 8, 4, 7, -4, -8, 4, -1;
    ASSERT_EQ(R * R.transpose(), Mat3(81 * Mat3::Identity()));
    scenes::Random random(3);
    QueryMemory memory;
    int met = 0;
    for (int i = 0; i < 100; ++i) {
        const MeshShape a(scenes::lattice_mesh(random, 3, 3, false)), b(scenes::lattice_mesh(random, 3, 3, false));
        const Pose pose{Mat3::Identity(), scenes::lattice_point(random, 4)};
        struct Parts {
            double w;
            Vec3 axis, pivot, glide;
        };
        const auto any = [&] {
            const double w = 1 + random.below(20);
            const Vec3 axis = scenes::lattice_point(random, 2), pivot = scenes::lattice_point(random, 3);
            return Parts{w, axis, pivot, i % 2 == 0 ? Vec3(Vec3::Zero()) : scenes::lattice_point(random, 3)};
        };
        const Parts first = any(), second = any();
        const auto turn = [](const Parts& parts, const Vec3& v, const Mat3& map) {
            return Turn{{parts.w, v[0], v[1], v[2]}, map * parts.pivot, map * (parts.pivot + parts.glide)};
        };
        const auto plain = [&](const Parts& parts) { return turn(parts, 9 * parts.axis, Mat3::Identity()); };
        const auto mapped = [&](const Parts& parts) { return turn(parts, R * parts.axis, R); };
        const Contact contact =
            cast(Turning<MeshShape>(a, pose, plain(first)), Turning<MeshShape>(b, Pose(), plain(second)), 1, memory);
        const Contact other = cast(Turning<MeshShape>(a, {R, R * pose.t}, mapped(first)),
                                   Turning<MeshShape>(b, {R, Vec3::Zero()}, mapped(second)), 1, memory);
        ASSERT_EQ(contact, other) << i;
        met += contact.has_value();
    }
    EXPECT_GT(met, 12);
}

}  // namespace
}  // namespace ecods
