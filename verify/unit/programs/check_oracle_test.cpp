// The judge must notice wrong answers, of each kind. The library gives none, so they are made here.
#include "programs/check_oracle.hpp"

#include <gtest/gtest.h>

namespace ecods::check {
namespace {

// Bodies 0 and 1 cross, 1 and 2 touch, 0 and 2 are apart.
scenes::Scene make_scene() {
    const auto flat = Mesh::create({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{0, 1, 2}});
    const auto upright = Mesh::create({{1, 1, -1}, {1, 1, 1}, {2, 1, 1}}, {{0, 1, 2}});
    scenes::Scene scene;
    scene.meshes = {{"flat", flat}, {"upright", upright}};
    scene.bodies = {{"ground", 0, {}}, {"blade", 1, {}}, {"roof", 0, {Mat3::Identity(), Vec3(0, 0, 1)}}};
    scene.frames = {{{{2, {Mat3::Identity(), Vec3(0, 0, 5)}}}}};
    return scene;
}

TEST(OracleJudge, FindsNothingWrongInRightAnswers) {
    const scenes::Scene scene = make_scene();
    SceneWorld world(scene, BroadPhaseKind::brute_force);
    OracleJudge judge(scene);
    ASSERT_TRUE(world.next_frame());
    const FrameAnswer rest = world.answer();
    ASSERT_EQ(rest.colliding.size(), 2U);
    EXPECT_EQ(rest.colliding[0].relation, Relation::crossing);
    EXPECT_EQ(rest.colliding[1].relation, Relation::touching);
    judge.check_frame(world, rest);
    ASSERT_TRUE(world.next_frame());
    EXPECT_EQ(world.moved(), std::vector<std::size_t>{2});
    judge.check_frame(world, world.answer());
    EXPECT_FALSE(world.next_frame());
    EXPECT_TRUE(judge.report().differences.empty());
    EXPECT_EQ(judge.report().body_pairs, 6U);
    EXPECT_EQ(judge.report().triangle_pairs, 3U);
    EXPECT_EQ(judge.report().boxes, 4U);
}

TEST(OracleJudge, NoticesAWrongDistance) {
    const scenes::Scene scene = make_scene();
    SceneWorld world(scene, BroadPhaseKind::sweep_and_prune, {.has_distances = true});
    world.next_frame();
    FrameAnswer answer = world.answer();
    ASSERT_EQ(answer.distances.size(), 3U);
    OracleJudge right(scene), wrong(scene);
    right.check_frame(world, answer);
    EXPECT_TRUE(right.report().differences.empty());
    EXPECT_EQ(right.report().distances, 3U);
    answer.distances[1].closest.point_b[2] += 0x1p-52;
    wrong.check_frame(world, answer);
    ASSERT_EQ(wrong.report().differences.size(), 1U);
    EXPECT_NE(wrong.report().differences[0].find("ground, roof: distance "), std::string::npos);
}

TEST(OracleJudge, NoticesAWrongListOfClosePairs) {
    const scenes::Scene scene = make_scene();
    SceneWorld world(scene, BroadPhaseKind::sweep_and_prune, {.clearance = 1e6});
    world.next_frame();
    FrameAnswer answer = world.answer();
    ASSERT_EQ(answer.close.size(), 3U);
    OracleJudge right(scene), none(scene), wrong(scene);
    right.check_frame(world, answer);
    EXPECT_TRUE(right.report().differences.empty());
    EXPECT_EQ(right.report().clearances, 3U);
    FrameAnswer less = answer;
    less.close.pop_back();
    none.check_frame(world, less);
    ASSERT_EQ(none.report().differences.size(), 1U);
    EXPECT_NE(none.report().differences[0].find("not listed as close, but is"), std::string::npos);
    answer.clearance = 0;
    wrong.check_frame(world, answer);
    EXPECT_FALSE(wrong.report().differences.empty());
}

TEST(OracleJudge, NoticesEachKindOfWrongAnswer) {
    const scenes::Scene scene = make_scene();
    SceneWorld world(scene, BroadPhaseKind::sweep_and_prune);
    world.next_frame();
    const FrameAnswer right = world.answer();
    const auto first_difference = [&](const FrameAnswer& answer) {
        OracleJudge judge(scene);
        judge.check_frame(world, answer);
        return judge.report().differences.empty() ? std::string() : judge.report().differences[0];
    };
    EXPECT_EQ(first_difference(right), "");

    FrameAnswer missed = right;
    missed.colliding.erase(missed.colliding.begin());
    EXPECT_EQ(first_difference(missed), "frame 0: ground, blade: not listed as colliding, but crossing");

    FrameAnswer invented = right;
    invented.colliding.push_back({0, 2, Relation::touching, {}});
    EXPECT_EQ(first_difference(invented), "frame 0: ground, roof: listed as colliding, but apart");

    FrameAnswer weak = right;
    weak.colliding[0].relation = Relation::touching;
    EXPECT_EQ(first_difference(weak), "frame 0: ground, blade: touching, but exactly crossing");

    FrameAnswer incomplete = right;
    incomplete.colliding[1].triangles.clear();
    EXPECT_EQ(first_difference(incomplete), "frame 0: blade, roof: 0 triangle pairs, but exactly 1 (or others)");

    FrameAnswer other = right;
    other.colliding[1].triangles = {{0, 7}};
    EXPECT_NE(first_difference(other), "");

    FrameAnswer lost = right;
    lost.overlapping.pop_back();
    EXPECT_EQ(first_difference(lost), "frame 0: all bodies: the overlapping pairs are not those of all pairs of boxes");
}

// A solid, one within it, and a triangle within both.
TEST(OracleJudge, NoticesWrongRelationsOfSolids) {
    const std::vector<Vec3> corners{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {0, 0, 8}};
    const Pose half{Mat3::Identity() / 2, Vec3(1, 1, 1)}, quarter{Mat3::Identity() / 4, Vec3(1.5, 1.5, 1.5)};
    scenes::Scene scene;
    scene.meshes = {{"corner", Mesh::create(corners, {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}})},
                    {"flat", Mesh::create(corners, {{0, 1, 2}})}};
    scene.bodies = {{"large", 0, {}}, {"small", 0, half}, {"leaf", 1, quarter}};
    SceneWorld world(scene, BroadPhaseKind::brute_force, {.has_solids = true});
    world.next_frame();
    const FrameAnswer right = world.answer();
    ASSERT_EQ(right.colliding.size(), 3U);
    const std::vector<Relation> others{Relation::overlapping, Relation::crossing, Relation::inside};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(right.colliding[i].relation, Relation::contains);
        FrameAnswer missed = right, wrong = right;
        missed.colliding.erase(missed.colliding.begin() + static_cast<std::ptrdiff_t>(i));
        wrong.colliding[i].relation = others[i];
        OracleJudge same(scene), of_missed(scene), of_wrong(scene);
        same.check_frame(world, right);
        of_missed.check_frame(world, missed);
        of_wrong.check_frame(world, wrong);
        EXPECT_TRUE(same.report().differences.empty());
        ASSERT_EQ(of_missed.report().differences.size(), 1U);
        EXPECT_TRUE(of_missed.report().differences[0].ends_with(": not listed as colliding, but contains"));
        ASSERT_EQ(of_wrong.report().differences.size(), 1U);
        EXPECT_TRUE(of_wrong.report().differences[0].ends_with(", but exactly contains"));
    }
}

}  // namespace
}  // namespace ecods::check
