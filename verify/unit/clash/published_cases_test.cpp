// Cases that were published by users of other programs, as files in cases/.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "programs/clash/inputs.hpp"
#include "programs/clash/judge.hpp"

namespace ecods::clash {
namespace {

std::vector<std::string> clashes_of(const std::string& file, JudgeOptions options) {
    const ClashReport report = judge(read_inputs({std::string(ECODS_CLASH_CASES) + "/" + file}, {.jobs = 1}), options);
    std::vector<std::string> clashes;
    for (const Clash& clash : report.clashes) {
        clashes.push_back(std::string(name_of(clash.kind)) + ": " + report.parts[clash.a].name + ", " +
                          report.parts[clash.b].name);
    }
    return clashes;
}

using Words = std::vector<std::string>;

TEST(PublishedCases, AlignedWallsOverlap) {
    const Words overlap{"overlapping: wall A, wall B"};
    EXPECT_EQ(clashes_of("ifcopenshell_4594_aligned.obj", {}), overlap);
    EXPECT_EQ(clashes_of("ifcopenshell_4594_nudged.obj", {}), overlap);
    EXPECT_EQ(clashes_of("ifcopenshell_4594_abutting.obj", {}), Words{});
    EXPECT_EQ(clashes_of("ifcopenshell_4594_abutting.obj", {.has_touching = true}), Words{"touching: wall A, wall B"});
    EXPECT_EQ(clashes_of("ifcopenshell_4594_gap.obj", {.clearance = 0.049, .has_touching = true}), Words{});
    EXPECT_EQ(clashes_of("ifcopenshell_4594_gap.obj", {.clearance = 0.051}), Words{"clearance: wall A, wall B"});
}

TEST(PublishedCases, AlignedWallsAreDeepInEachOther) {
    const auto path = std::string(ECODS_CLASH_CASES) + "/ifcopenshell_4594_aligned.obj";
    const ClashReport report = judge(read_inputs({path}, {.jobs = 1}), {.line_limit = 100});
    ASSERT_EQ(report.clashes.size(), 1U);
    EXPECT_EQ(report.clashes[0].depth->lower, 4 - 3.95);
    EXPECT_EQ(report.clashes[0].depth->upper, 4 - 3.95);
    EXPECT_EQ(report.clashes[0].place.box.min, Vec3(3.95, -0.1, 0));
    EXPECT_EQ(report.clashes[0].place.box.max, Vec3(4, 0.1, 3));
    EXPECT_GT(report.clashes[0].place.line_count, 0U);
}

TEST(PublishedCases, SixKinds) {
    EXPECT_EQ(clashes_of("ifcopenshell_4278.obj", {.clearance = 0.02, .has_touching = true}),
              (Words{"equal: duplication copy, duplication wall", "inside: envelope block, envelope wall",
                     "overlapping: piercing block, piercing wall", "overlapping: protrusion block, protrusion wall",
                     "touching: touching block, touching wall", "clearance: encroaching block, encroaching wall"}));
}

TEST(PublishedCases, BoxesWithoutVolumeTouch) {
    EXPECT_EQ(clashes_of("ifc_lite_2292.obj", {.has_touching = true}), Words{"touching: plate A, plate B"});
    EXPECT_EQ(clashes_of("ifc_lite_2292.obj", {.clearance = 0}), Words{});
}

}  // namespace
}  // namespace ecods::clash
