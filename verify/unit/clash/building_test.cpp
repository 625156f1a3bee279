// The building of 10,000 parts, every relation of which is known from how it was made: what ecods_clash finds is that,
// and nothing else.
#include "scenes/building/building.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <utility>

#include "programs/clash/inputs.hpp"
#include "programs/clash/judge.hpp"
#include "programs/clash/penetration.hpp"
#include "scenes/building/building_relations.hpp"

namespace ecods::clash {
namespace {

using scenes::Contact;
using scenes::Element;
using scenes::KnownRelation;

constexpr scenes::Length clearance = 10;  // 1 mm

ClashReport report_of(const std::vector<Element>& elements) {
    // Two tests of this file may run at once, each in a process of its own.
    const std::string file = testing::TempDir() + "clash_building_" + std::to_string(getpid()) + ".obj";
    std::ofstream out(file);
    write_obj(out, elements);
    out.close();
    const JudgeOptions options{.clearance = scenes::meters(clearance), .has_touching = true, .jobs = 2};
    const ClashReport report = judge(read_inputs({file}, {.jobs = 2}), options);
    std::filesystem::remove(file);
    return report;
}

std::string word_of(Contact contact, bool is_exchanged) {
    switch (contact) {
        case Contact::apart:
            return "clearance apart";
        case Contact::touching:
            return "touching touching";
        case Contact::overlapping:
            return "overlapping overlapping";
        case Contact::inside:
            return is_exchanged ? "inside contains" : "inside inside";
        case Contact::contains:
            return is_exchanged ? "inside inside" : "inside contains";
        case Contact::equal:
            return "equal equal";
        case Contact::partly_inside:
            return "crossing partly_inside";
    }
    return "";
}

std::string word_of(const Clash& clash) {
    return std::string(name_of(clash.kind)) + " " + std::string(clash.relation);
}

using Names = std::pair<std::string, std::string>;

std::map<Names, const Clash*> by_names(const ClashReport& report) {
    std::map<Names, const Clash*> clashes;
    for (const Clash& clash : report.clashes)
        clashes[{report.parts[clash.a].name, report.parts[clash.b].name}] = &clash;
    return clashes;
}

void expect_numbers(const KnownRelation& known, const Clash& clash, const std::string& names) {
    EXPECT_EQ(known.distance, clash.distance) << names;
    if (known.common) {
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_EQ(clash.place.box.min[axis], scenes::meters(known.common->min[static_cast<std::size_t>(axis)]))
                << names;
            EXPECT_EQ(clash.place.box.max[axis], scenes::meters(known.common->max[static_cast<std::size_t>(axis)]))
                << names;
        }
    }
    if (known.depth) {
        ASSERT_TRUE(clash.depth) << names;
        EXPECT_EQ(clash.depth->lower, *known.depth) << names;
        EXPECT_EQ(clash.depth->upper, *known.depth) << names;
    }
    if (clash.depth) {
        EXPECT_LE(clash.depth->lower, clash.depth->upper) << names;
    }
}

void expect_all_known(const std::vector<Element>& elements) {
    const ClashReport report = report_of(elements);
    ASSERT_EQ(report.parts.size(), elements.size());
    auto clashes = by_names(report);
    ASSERT_EQ(clashes.size(), report.clashes.size());
    for (const KnownRelation& known : known_relations(elements, clearance)) {
        Names names{elements[known.a].name, elements[known.b].name};
        const bool is_exchanged = names.second < names.first;
        if (is_exchanged) std::swap(names.first, names.second);
        const std::string both = names.first + " | " + names.second;
        const auto found = clashes.find(names);
        ASSERT_NE(found, clashes.end()) << both << " is missing: " << word_of(known.contact, is_exchanged);
        EXPECT_EQ(word_of(*found->second), word_of(known.contact, is_exchanged)) << both;
        expect_numbers(known, *found->second, both);
        clashes.erase(found);
    }
    for (const auto& [names, clash] : clashes)
        ADD_FAILURE() << names.first << " | " << names.second << " is " << word_of(*clash) << ", and should be apart";
}

TEST(ClashBuilding, EveryRelationIsTheKnownOne) {
    const auto elements = scenes::make_large_building();
    ASSERT_EQ(elements.size(), 10000U);
    expect_all_known(elements);
}

// The wall has a window, so it is not convex; out of it the cabinet gets by the 50 mm, and by no less.
TEST(ClashBuilding, BoundsHoldTheDepthOfASolidWithDents) {
    const ClashReport report = report_of(scenes::make_building(1, 1, 1));
    const double depth = scenes::meters(3000) - scenes::meters(2500);
    const auto clash = std::find_if(report.clashes.begin(), report.clashes.end(), [&](const Clash& each) {
        return report.parts[each.a].name.ends_with("cabinet 50 mm in the wall") && each.kind == Kind::overlapping;
    });
    ASSERT_NE(clash, report.clashes.end());
    ASSERT_TRUE(clash->depth);
    EXPECT_LE(clash->depth->lower, depth);
    EXPECT_GE(clash->depth->upper, depth);
    EXPECT_GT(clash->depth->lower, 0);
    EXPECT_LT(clash->depth->upper, 2 * depth);
    QueryMemory memory;
    const Interval quick = depth_of(report.parts[clash->a], report.parts[clash->b], clash->place.box, memory);
    EXPECT_LE(quick.lower, depth);
    EXPECT_GE(quick.lower, depth * 0.99);  // the ball around the middle touches both
    EXPECT_EQ(quick.upper, depth);
}

// Those that every bay has, counted by hand, beside what touches.
TEST(ClashBuilding, CountsAreTheKnownOnes) {
    const ClashReport report = report_of(scenes::make_building(1, 1, 2));
    const auto count = [&](Kind kind) { return report.counts[static_cast<std::size_t>(kind)]; };
    EXPECT_EQ(count(Kind::equal), 2U + 1U);        // chairs; lampshades in one of the two
    EXPECT_EQ(count(Kind::inside), 2U * 3U);       // two conduits, a drawer
    EXPECT_EQ(count(Kind::overlapping), 2U * 5U);  // walls, cabinet, pipe through the wall and through the riser, duct
    EXPECT_EQ(count(Kind::crossing), 2U * 1U);     // tray
    EXPECT_EQ(count(Kind::clearance), 2U * 3U);    // cabinet, pipe, valve
    std::size_t surfaces = 0;
    for (const Part& part : report.parts) {
        if (part.is_solid) continue;
        ++surfaces;
        const bool is_crate = part.name.find("crate") != std::string::npos;
        EXPECT_NE(part.not_solid_because.find(is_crate ? "triangles" : "edge"), std::string::npos) << part.name;
    }
    EXPECT_EQ(surfaces, 2U * 4U);
}

}  // namespace
}  // namespace ecods::clash
