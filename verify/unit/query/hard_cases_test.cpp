// The configurations on which other libraries fail, asked about distances, hits, casts, moves and depths beside the
// oracle: by lines through their corners and along their edges, and on ways that end at a corner, pass it, or begin in
// contact.
#include <gtest/gtest.h>

#include <optional>

#include "ecods/error.hpp"
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

    scenes::HardCases known_;
    QueryMemory memory_;
    PairWitness witness_;
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
