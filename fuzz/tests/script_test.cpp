// Scripts: generated, repaired, written and read, shrunk.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "environment/instruction_sets.hpp"
#include "fuzz/motion/generate.hpp"
#include "fuzz/script/trace.hpp"
#include "fuzz/shrink/shrink.hpp"
#include "fuzz/shrink/simpler.hpp"
#include "scenes/shapes.hpp"

namespace ecods::fuzz {
namespace {

std::string trace_of(const Script& script) {
    std::ostringstream out;
    write_trace(script, out);
    return out.str();
}

Script small_script(std::string_view profile, std::uint32_t seed) {
    Counters counters;
    return generate(*find_profile(profile), seed, counters);
}

class ProfileTest : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Profiles, ProfileTest,
                         testing::Values("tiny", "stacks", "far", "sizes", "shapes", "filters", "bad", "nested",
                                         "round"),
                         [](const auto& test) { return std::string(test.param); });

TEST_P(ProfileTest, TracesAreReadAsTheyWereWritten) {
    for (std::uint32_t seed = 1; seed <= 3; ++seed) {
        const std::string text = trace_of(small_script(GetParam(), seed));
        std::istringstream in(text);
        const Script read = read_trace(in);
        EXPECT_EQ(trace_of(read), text);
        Counters counters;
        EXPECT_NO_THROW(play(read, {}, counters));  // compares digests, too
    }
}

TEST_P(ProfileTest, RepairLeavesWhatIsWhole) {
    const Script script = small_script(GetParam(), 4);
    EXPECT_EQ(trace_of(repaired(script)), trace_of(script));
}

// On this processor, whichever sets it has: the schedule is the one that schedule_test.cpp checks for all numbers of
// sets.
TEST(Play, WorldsAreUpdatedAndAskedEquallyOftenWithEveryInstructionSet) {
    constexpr std::uint32_t script_count = 3;
    Counters counters;
    for (std::uint32_t seed = 1; seed <= script_count; ++seed) play(small_script("tiny", seed), {}, counters);
    for (const std::string of : {"updates with instructions of ", "checked: answers with instructions of "}) {
        std::vector<std::uint64_t> counts;
        for (const InstructionSet set : environment::supported_instruction_sets()) {
            counts.push_back(counters[of + environment::name(set)]);
        }
        const auto [least, most] = std::ranges::minmax(counts);
        EXPECT_GT(least, 0U) << of;
        // Each script begins with the first turn.
        EXPECT_LE(most - least, script_count) << of;
    }
    EXPECT_EQ(instruction_set(), environment::widest_instruction_set()) << "afterwards it is as it was";
}

TEST(Generate, EveryMotionThatHurtsHappens) {
    Counters counters;
    for (const Profile& profile : profiles()) {
        for (std::uint32_t seed = 1; seed <= 20 && profile.bodies_max < 100; ++seed) generate(profile, seed, counters);
    }
    for (const char* name : {"motions: size change",
                             "motions: exact contact: face to face",
                             "motions: exact contact: vertex onto a point of the other",
                             "motions: one ulp",
                             "motions: teleport",
                             "motions: equal pose",
                             "motions: permutation matrix",
                             "motions: integer rotation",
                             "motions: far from the origin",
                             "motions: extreme: the other's size",
                             "motions: extreme: beyond the largest double",
                             "motions: extreme: near the largest double",
                             "meshes: sliver",
                             "meshes: zero area",
                             "scenes: subnormal",
                             "scenes: huge",
                             "scenes: far from the origin",
                             "scenes: of extremes",
                             "changes: removal in order of insertion",
                             "changes: removal of most",
                             "changes: shape change",
                             "changes: refit",
                             "changes: bad input",
                             "changes: filter",
                             "changes: pair switched",
                             "changes: room reserved",
                             "motions: within the other",
                             "meshes: hollow cube",
                             "changes: relations listed",
                             "changes: another form",
                             "changes: another radius",
                             "changes: any call"}) {
        EXPECT_GT(counters[name], 0U) << name;
    }
    for (const std::string_view name : calls::row_names<Call>) {
        EXPECT_GT(counters["calls: " + std::string(name)], 0U) << name;
    }
}

TEST(Play, AWrongDigestOfATraceFails) {
    Counters counters;
    Script script = small_script("tiny", 1);
    for (Call& call : script) {
        if (auto* update = std::get_if<Update>(&call)) update->digest = 17;
    }
    try {
        play(script, {}, counters);
        FAIL();
    } catch (const Failure& failure) {
        EXPECT_EQ(failure.check, "digest of the trace");
        EXPECT_EQ(failure.update, 0U);
    }
}

// To one world the part goes as a part, to the others as the shape that the body has: nothing is set in any of them.
TEST(Play, ThePartThatABodyHasIsNoOtherShapeInAnyManner) {
    const Part part{scenes::cube(1)};
    for (const bool is_made_with_options : {false, true}) {
        Script script;
        if (is_made_with_options) {
            script.emplace_back(calls::CreateWith<InScript>{0, part, Pose(), {}, 0});
        } else {
            script.emplace_back(Create{0, part, Pose()});
        }
        script.emplace_back(Update{});
        script.emplace_back(Manner{.choice = 0, .kind = "own answers"});
        script.emplace_back(SetShape{0, part});
        script.emplace_back(Update{});
        Counters counters;
        EXPECT_NO_THROW(play(script, {}, counters)) << "with options: " << is_made_with_options;
        EXPECT_EQ(counters["manners: own answers, set_shape"], 3U);
    }
}

TEST(Shrink, LeavesWhatTheFailureNeeds) {
    // Fails while bodies 3 and 7 of some script are there, one of them moved to x >= 3, and an update comes after.
    Script script;
    for (Label label = 0; label < 10; ++label) script.emplace_back(Create{label, {scenes::cube(0.75)}, Pose()});
    Pose moved;
    moved.t = Vec3(4.7, 0.3, 1e-9);
    script.emplace_back(SetPoses{{2, 7, 5}, {Pose(), moved, Pose()}});
    script.emplace_back(Update{});
    script.emplace_back(SetUserData{4, 2});
    script.emplace_back(Update{});
    const auto fails = [](const Script& tried) {
        Model model;
        bool is_updated = false;
        double x = 0;
        for (const Call& call : tried) {
            model.apply(call);
            is_updated = std::holds_alternative<Update>(call);
            for (const auto& [label, body] : model.bodies) x = std::max(x, body.pose.t[0]);
        }
        return is_updated && model.bodies.size() >= 2 && x >= 3;
    };
    ASSERT_TRUE(fails(script));
    const Script shrunk = shrink(script, {fails, 60});
    ASSERT_EQ(shrunk.size(), 3U);
    const auto meshes = meshes_of(shrunk);
    for (const auto& mesh : meshes) {
        EXPECT_EQ(mesh->triangles().size(), 1U);
        for (const Vec3& vertex : mesh->vertices()) EXPECT_TRUE(vertex.isZero(0));
    }
    double x = 0;
    for (const Call& call : shrunk) {
        const auto* create = std::get_if<Create>(&call);
        if (create == nullptr) continue;
        EXPECT_TRUE(create->pose.t[1] == 0 && create->pose.t[2] == 0);
        x = std::max(x, create->pose.t[0]);
    }
    EXPECT_EQ(x, 4);
}

TEST(Shrink, SolidsStaySolidsWhereTheFailureNeedsOne) {
    Script script;
    script.emplace_back(Create{0, {.mesh = scenes::cube(0.75), .form = MeshForm::solid}, Pose()});
    script.emplace_back(Create{1, {.mesh = scenes::sphere(5, 3), .form = MeshForm::solid}, Pose()});
    script.emplace_back(Update{});
    const auto fails = [](const Script& tried) {
        Model model;
        for (const Call& call : tried) model.apply(call);
        return std::ranges::any_of(model.bodies, [](const auto& body) {
            const Part& part = body.second.part;
            return part.form == MeshForm::solid && part.mesh->vertices()[0] != part.mesh->vertices()[1];
        });
    };
    const Script shrunk = shrink(script, {fails, 60});
    ASSERT_EQ(shrunk.size(), 1U);
    EXPECT_TRUE(have_their_forms(shrunk)) << "or it could not be played";
    Counters counters;
    EXPECT_NO_THROW(play(shrunk, {}, counters));
}

TEST(Play, ASolidIsTheSameObjectEachTime) {
    const Part part{.mesh = scenes::cube(1), .form = MeshForm::solid};
    PartWorld world;
    const BodyId a = world.create_body(part, Pose()), b = world.create_body(part, Pose());
    EXPECT_EQ(world.shape(a), world.shape(b));
    EXPECT_EQ(form_of(*world.shape(a)), MeshForm::solid);
    world.set_shape(b, Part{part.mesh});
    EXPECT_EQ(form_of(*world.shape(b)), MeshForm::surface);
    EXPECT_FALSE(has_form(without_triangles(*part.mesh, 0, 1), MeshForm::solid));
}

TEST(Simpler, RoundNumbersHaveFewerDigits) {
    EXPECT_EQ(rounder(4.7, 0), 0);
    EXPECT_EQ(rounder(4.7, 1), 5);
    EXPECT_EQ(rounder(4.7, 2), 4);
    EXPECT_EQ(rounder(4.0, 1), 4);
    EXPECT_EQ(rounder(0x1p-1074, 1), 0);
    EXPECT_EQ(rounder(0x1.8p1000, 2), 0x1p1001);
    EXPECT_EQ(rounder(0x1.fffffffffffffp1023, 2), 0x1.fffffffffffffp1023);  // infinity is no rounder number
    EXPECT_FALSE(std::signbit(rounder(-0.3, 1)));
}

TEST(Simpler, TrianglesGoWithTheirVertices) {
    const auto cube = scenes::cube(1);
    const auto one = without_triangles(*cube, 1, 11);
    ASSERT_TRUE(one);
    EXPECT_EQ(one->triangles().size(), 1U);
    EXPECT_EQ(one->vertices().size(), 3U);
    EXPECT_FALSE(without_triangles(*cube, 0, 12));
}

}  // namespace
}  // namespace ecods::fuzz
