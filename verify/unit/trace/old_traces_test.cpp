// Traces of version 1, in which solids collided as their surfaces.
#include <gtest/gtest.h>

#include <memory>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "ecods/solid.hpp"
#include "ecods/trace.hpp"
#include "ecods/world.hpp"
#include "scenes/pose_at.hpp"
#include "unit/trace/replay_text.hpp"

namespace ecods::old_traces_test {
namespace {

// Written by ECoDS 0.4: a large solid, a convex solid in it, which a mesh crosses; and a solid out of which a segment
// of zero area sticks, where the mesh is later.
const char* const old_trace = R"(ecods-trace 1
world automatic 0
solid 1 4 4
v 0x0p+0 0x0p+0 0x0p+0
v 0x1p+3 0x0p+0 0x0p+0
v 0x0p+0 0x1p+3 0x0p+0
v 0x0p+0 0x0p+0 0x1p+3
t 0 2 1
t 0 1 3
t 0 3 2
t 1 2 3
create 1.0 1 0x1p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x1p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x1p+0 0x0p+0
convex 2 4 4
v 0x0p+0 0x0p+0 0x0p+0
v 0x1p+0 0x0p+0 0x0p+0
v 0x0p+0 0x1p+0 0x0p+0
v 0x0p+0 0x0p+0 0x1p+0
t 0 2 1
t 0 1 3
t 0 3 2
t 1 2 3
create 2.0 2 0x1p+0 0x0p+0 0x0p+0 0x1p+0 0x0p+0 0x1p+0 0x0p+0 0x1p+0 0x0p+0 0x0p+0 0x1p+0 0x1p+0
mesh 3 4 4
v 0x0p+0 0x0p+0 0x0p+0
v 0x1p+0 0x0p+0 0x0p+0
v 0x0p+0 0x1p+0 0x0p+0
v 0x0p+0 0x0p+0 0x1p+0
t 0 2 1
t 0 1 3
t 0 3 2
t 1 2 3
create 3.0 3 0x1p+0 0x0p+0 0x0p+0 0x1.8p+0 0x0p+0 0x1p+0 0x0p+0 0x1p+0 0x0p+0 0x0p+0 0x1p+0 0x1.4p+0
solid 4 5 5
v 0x0p+0 0x0p+0 0x0p+0
v 0x1p+1 0x0p+0 0x0p+0
v 0x0p+0 0x1p+1 0x0p+0
v 0x0p+0 0x0p+0 0x1p+1
v 0x1.2p+3 0x0p+0 0x0p+0
t 1 4 1
t 0 2 1
t 0 1 3
t 0 3 2
t 1 2 3
create 4.0 4 0x1p+0 0x0p+0 0x0p+0 0x1.4p+4 0x0p+0 0x1p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x1p+0 0x0p+0
set_solids 1
set_clearance 0x1p-1
update 4914af843e664191 1
nearest 9145b7903466d3fd 2.0 inf
closest_pair 7f8ef2e4ca9c90e2 inf
first_hit_of_ray 27c9f88756bb3ec8 0x1.4p+0 0x1.2p+0 0x1.2p+0 0x1p+0 0x1p-1 0x1p-2 inf none
all_hits b3358a06e74cfc00 0x1.4p+0 0x1.2p+0 0x1.2p+0 0x1.2p+3 0x1.2p+3 0x1.2p+3 none
first_hit 6cc204480ca4f6d0 0x1.ap+4 -0x1p+0 0x0p+0 0x1.ap+4 0x1p+0 0x0p+0 none
cast ce39dd81c72dd90d 2.0 -0x1.8p+1 0x0p+0 0x0p+0 0x1p+0
bodies_containing 42df1141926964ce 0x1.4p+0 0x1.2p+0 0x1.2p+0
depths e220a8397b1dcdaf
solid_distances e220a8397b1dcdaf 0x1p+0
set_pose 3.0 0x1p+0 0x0p+0 0x0p+0 0x1.ap+4 0x0p+0 0x1p+0 0x0p+0 -0x1p-2 0x0p+0 0x0p+0 0x1p+0 -0x1p-2
meetings edf1f137d58b7030 1
p 2.0 0x1p+0 0x0p+0 0x0p+0 0x1.8p+0 0x0p+0 0x1p+0 0x0p+0 0x1p+0 0x0p+0 0x0p+0 0x1p+0 0x1p+0
update a8af0e17baf9b6b2 1
set_pose 2.0 0x1p+0 0x0p+0 0x0p+0 0x1.8p+1 0x0p+0 0x1p+0 0x0p+0 0x1.8p+1 0x0p+0 0x0p+0 0x1p+0 0x1.8p+1
update fb8dbbc8001dc10 1
set_pose 2.0 0x1p+0 0x0p+0 0x0p+0 0x1p+0 0x0p+0 0x1p+0 0x0p+0 0x1p+0 0x0p+0 0x0p+0 0x1p+0 0x1p+0
set_solids 0
update fba668c79da93af6 1
)";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
        text.replace(at, what.size(), by);
    return text;
}

TEST(OldTraces, ReplayWithTheirOldMeaning) {
    for (const BroadPhaseKind kind : {BroadPhaseKind::brute_force, BroadPhaseKind::sweep_and_prune,
                                      BroadPhaseKind::kept_candidates, BroadPhaseKind::automatic}) {
        std::istringstream in(old_trace);
        const ReplayReport report = replay(in, {.broad_phase = kind});
        ASSERT_FALSE(report.difference) << report.difference->what;
        EXPECT_EQ(report.update_count, 4U);
        EXPECT_EQ(report.question_count, 10U);
    }
}

// As one of version 2, the first update has other answers.
TEST(OldTraces, HaveAnotherMeaningThanNewOnes) {
    const std::string text =
        replaced(replaced(old_trace, "ecods-trace 1", "ecods-trace 2"), "set_solids", "set_relations");
    const auto difference = replay_text(text).difference;
    ASSERT_TRUE(difference);
    EXPECT_EQ(difference->update, 0U) << difference->what;
}

std::shared_ptr<const Mesh> tetrahedron(double side) {
    return Mesh::create({Vec3(0, 0, 0), Vec3(side, 0, 0), Vec3(0, side, 0), Vec3(0, 0, side)},
                        {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
}

// The same scene, written as of today.
TEST(OldTraces, ANewOneReplaysWithTheNewMeaning) {
    World world;
    std::ostringstream out;
    world.trace_to(out, {.questions = true});
    world.create_body(std::make_shared<const Solid>(tetrahedron(8)), at(0));
    const BodyId b = world.create_body(std::make_shared<const ConvexSolid>(tetrahedron(1)), at(1, 1, 1));
    const BodyId c = world.create_body(tetrahedron(1), at(1.5, 1, 1.25));
    world.set_relations(true);
    world.set_clearance(0.5);
    world.update();
    EXPECT_EQ(world.colliding_pairs().size(), 3U);
    std::ignore = world.nearest(b);
    std::ignore = world.closest_pair();
    std::ignore = world.first_hit(Ray{Vec3(1.25, 1.125, 1.125), Vec3(1, 0.5, 0.25)});
    std::ignore = world.all_hits(Segment{Vec3(1.25, 1.125, 1.125), Vec3(9, 9, 9)});
    std::ignore = world.cast(b, Vec3(-3, 0, 0));
    std::ignore = world.meetings(std::vector<BodyId>{b}, std::vector<Pose>{at(1.5, 1, 1)});
    world.set_pose(c, at(26));
    world.update();
    world.set_relations(false);
    world.update();
    world.end_trace();
    EXPECT_EQ(out.str().find("ecods-trace 2\n"), 0U);
    const ReplayReport report = replay_text(out.str());
    EXPECT_FALSE(report.difference) << report.difference->what;
    EXPECT_EQ(report.question_count, 6U);
    EXPECT_EQ(report.update_count, 3U);

    const std::string old =
        replaced(replaced(out.str(), "ecods-trace 2", "ecods-trace 1"), "set_relations", "set_solids");
    EXPECT_TRUE(replay_text(old).difference);
}

}  // namespace
}  // namespace ecods::old_traces_test
