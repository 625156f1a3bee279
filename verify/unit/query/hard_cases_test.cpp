// The configurations on which other libraries fail, asked about distances, hits, casts, moves and depths beside the
// oracle: by lines through their corners and along their edges, and on ways that end at a corner, pass it, or begin in
// contact.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "ecods/cast.hpp"
#include "ecods/error.hpp"
#include "ecods/turn.hpp"
#include "judge/along_questions.hpp"
#include "judge/text.hpp"
#include "judge/turn_truth.hpp"
#include "judge/way_questions.hpp"
#include "scenes/io/hard_case_file.hpp"
#include "unit/query/expect_right.hpp"

namespace ecods {
namespace {

// Larger pairs take the oracle's brute force too long.
constexpr std::size_t pair_count_max = 400;

class HardCases : public testing::Test {
  protected:
    HardCases() : known_(scenes::read_hard_cases(ECODS_HARD_CASES)) {}

    // Calls with two bodies, and corners of theirs as doubles have them.
    template <class Call>
    void for_each(const Call& call) {
        std::size_t asked = 0;
        for (const scenes::HardCase& hard : known_.cases) {
            SCOPED_TRACE(hard.id);
            const auto triangles_a = hard.a.mesh->triangles(), triangles_b = hard.b.mesh->triangles();
            if (triangles_a.size() * triangles_b.size() > pair_count_max) continue;
            ++asked;
            const MeshShape a(hard.a.mesh), b(hard.b.mesh);
            const auto corner = [](const scenes::HardCase::Body& body, std::size_t i) -> Vec3 {
                return body.pose.R * body.mesh->vertices()[body.mesh->triangles().back()[i]] + body.pose.t;
            };
            ASSERT_NO_FATAL_FAILURE(call(
                Posed<MeshShape>{a, hard.a.pose}, Posed<MeshShape>{b, hard.b.pose},
                [&](std::size_t i) { return corner(hard.a, i); }, [&](std::size_t i) { return corner(hard.b, i); }));
        }
        EXPECT_GT(asked, 40U);
    }

    void expect_right_turn(const Posed<MeshShape>& a, const Turn& turn, const Posed<MeshShape>& b) {
        try {
            const judge::TurnTruth truth({*a.what, a.pose, turn}, b, 2);
            expect_none(truth.ask(memory_, witness_));
            ++asked_;
        } catch (const NotSupported&) {
        }
    }

    scenes::HardCases known_;
    QueryMemory memory_;
    PairWitness witness_;
    int asked_ = 0;
};

TEST_F(HardCases, Distances) {
    for_each([&](const auto& a, const auto& b, const auto&, const auto&) {
        expect_right(judge::DistanceTruth(a, b), memory_, witness_);
    });
}

TEST_F(HardCases, Hits) {
    for_each([&](const auto&, const auto& b, const auto& of_a, const auto& of_b) {
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t next = (i + 1) % 3;
            for (const Segment& segment : {Segment{of_a(i), of_a(next)}, Segment{of_a(i), of_b(i)},
                                           Segment{of_a(i), 2 * of_b(next) - of_a(i)}, Segment{of_b(i), of_b(next)}}) {
                ASSERT_NO_FATAL_FAILURE(expect_right(judge::HitTruth(segment, b), memory_, witness_));
            }
        }
    });
}

TEST_F(HardCases, Casts) {
    for_each([&](const auto& a, const auto& b, const auto& of_a, const auto& of_b) {
        const Vec3 way = of_b(0) - of_a(0);
        Posed<MeshShape> back = a;
        back.pose.t -= 2 * (of_b(1) - of_b(0)) + (of_b(2) - of_b(0));
        for (const Vec3& motion : {way, Vec3(2 * way), Vec3(of_a(1) - of_a(0))}) {
            ASSERT_NO_FATAL_FAILURE(expect_right(judge::CastTruth(a, motion, b, 2), memory_, witness_));
        }
        ASSERT_NO_FATAL_FAILURE(expect_right(judge::CastTruth(back, a.pose.t - back.pose.t, b, 2), memory_, witness_));
    });
}

TEST_F(HardCases, Moves) {
    for_each([&](const auto& a, const auto& b, const auto& of_a, const auto& of_b) {
        Pose to = a.pose, from_b = b.pose;
        to.t += 2 * (of_b(0) - of_a(0));
        to.R = 0.5 * to.R + 0.5 * b.pose.R;
        from_b.t += of_b(1) - of_b(2);
        const Moving<MeshShape> first(*a.what, a.pose, to), second(*b.what, from_b, b.pose);
        ASSERT_NO_FATAL_FAILURE(expect_right(judge::CastTruth(first, {*b.what, b.pose, b.pose}, 2), memory_, witness_));
        ASSERT_NO_FATAL_FAILURE(expect_right(judge::CastTruth(first, second, 2), memory_, witness_));
    });
}

// By half a turn, by small integers about a corner, and by a turn that glides.
TEST_F(HardCases, Turns) {
    for_each([&](const auto& a, const auto& b, const auto& of_a, const auto& of_b) {
        const Vec3 way = of_b(0) - of_a(0);
        for (const Turn& turn : {Turn{{0, 0, 0, 1}, of_b(0), of_b(0)}, Turn{{1, 1, -2, 0.5}, of_a(0), of_a(0)},
                                 Turn{{1, 0, 0.5, 0}, of_a(1), of_a(1) + way}}) {
            if (!turn.pivot_from.allFinite() || !turn.pivot_to.allFinite()) continue;
            expect_right_turn(a, turn, b);
        }
    });
    EXPECT_GT(asked_, 100);
}

// Along three legs, of which the second glides, and back.
TEST_F(HardCases, Ways) {
    for_each([&](const auto& a, const auto& b, const auto& of_a, const auto& of_b) {
        const Vec3 pivot = of_a(0), there = of_b(0);
        if (!pivot.allFinite() || !there.allFinite()) return;
        const std::vector<WayNode> nodes{{{}, pivot}, {{1, 0, 1, 0}, pivot}, {{1, 0.5, 1, 0}, there}, {{}, pivot}};
        const Way<MeshShape> along(*a.what, a.pose, nodes);
        try {
            expect_none(judge::ask_about_way(along, b, {memory_, witness_}));
            expect_none(judge::ask_about_along(along, b, {memory_, witness_}));
            ++asked_;
        } catch (const NotSupported&) {
        }
    });
    EXPECT_GT(asked_, 30);
}

// The first body deforms: into itself by another order of vertices, or to one corner of the other body.
TEST_F(HardCases, DeformingMeshes) {
    for_each([&](const auto& a, const auto& b, const auto&, const auto& of_b) {
        std::vector<Vec3> from;
        for (const Vec3& v : a.what->mesh().vertices()) from.push_back(a.pose.R * v + a.pose.t);
        if (!std::ranges::all_of(from, [](const Vec3& v) { return v.allFinite(); })) return;
        const auto triangles = a.what->mesh().triangles();
        const auto start = std::make_shared<const MeshShape>(Mesh::create(from, {triangles.begin(), triangles.end()}));
        const oracle::Soup rests = judge::soup(b);
        for (const std::vector<Vec3>& to :
             {std::vector<Vec3>(from.rbegin(), from.rend()), std::vector<Vec3>(from.size(), of_b(0))}) {
            const Deforming mesh(start, to);
            const oracle::DeformingSoup moves{{start->mesh().vertices(), triangles, Pose()}, {to, triangles, Pose()}};
            const oracle::DeformingSoup other{rests, rests};
            const auto expected = judge::to_first_contact(oracle::first_contact(moves, other));
            const auto back = judge::to_first_contact(oracle::first_contact(other, moves));
            EXPECT_TRUE(judge::is_same(cast(mesh, b, 1, {memory_, witness_}), expected)) << judge::text(expected);
            EXPECT_TRUE(judge::is_same(cast(b, mesh, 1, {memory_, witness_}), back)) << judge::text(back);
            ++asked_;
        }
    });
    EXPECT_GT(asked_, 60);
}

// The ones that bound convex solids.
TEST_F(HardCases, ConvexSolids) {
    int asked = 0;
    for (const scenes::HardCase& hard : known_.cases) {
        SCOPED_TRACE(hard.id);
        if (!hard.solid_relation) continue;
        std::optional<ConvexSolid> a, b;
        try {
            a.emplace(hard.a.mesh);
            b.emplace(hard.b.mesh);
        } catch (const NotSolid& error) {
            ASSERT_EQ(error.reason, NotSolid::Reason::dent);
            continue;
        }
        ++asked;
        const judge::ConvexTruth truth({*a, hard.a.pose}, {*b, hard.b.pose});
        EXPECT_EQ(*hard.solid_relation == "apart", !truth.depth());
        EXPECT_EQ(*hard.solid_relation == "touching", truth.depth() && truth.depth()->depth == 0);
        ASSERT_NO_FATAL_FAILURE(expect_right(truth, memory_, witness_));
    }
    EXPECT_GT(asked, 30);
}

}  // namespace
}  // namespace ecods
