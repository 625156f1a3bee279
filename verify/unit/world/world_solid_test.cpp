// Solids in a world: which pairs of them are not apart, as updates keep it, and which contain a point.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <sstream>
#include <tuple>
#include <vector>

#include "ecods/error.hpp"
#include "ecods/trace.hpp"
#include "scenes/expect_invalid.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"
#include "scenes/thread_executor.hpp"
#include "unit/world/slab_shapes.hpp"
#include "unit/world/world_fixture.hpp"

namespace ecods::world_solid_test {
namespace {

using SolidPairs = std::vector<SolidPair>;

SolidPairs list(std::span<const SolidPair> pairs) {
    return {pairs.begin(), pairs.end()};
}

std::shared_ptr<const Solid> solid_cube(double half) {
    return std::make_shared<const Solid>(scenes::cube(half));
}

class WorldSolidTest : public EachWorld {
  protected:
    // All pairs, one by one.
    SolidPairs expected() {
        SolidPairs pairs;
        const std::vector<BodyId> bodies = world.bodies();
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            for (std::size_t j = i + 1; j < bodies.size(); ++j) {
                const BodyPair pair{std::min(bodies[i], bodies[j]), std::max(bodies[i], bodies[j])};
                const auto a = std::dynamic_pointer_cast<const Solid>(world.shape(pair.a));
                const auto b = std::dynamic_pointer_cast<const Solid>(world.shape(pair.b));
                if (!a || !b || !may_meet(world.filter(pair.a), world.filter(pair.b))) continue;
                if (!world.is_pair_enabled(pair.a, pair.b)) continue;
                const Relation relation = solid_relation({*a, world.pose(pair.a)}, {*b, world.pose(pair.b)}, memory);
                if (relation != Relation::apart) pairs.push_back({pair, relation});
            }
        }
        std::ranges::sort(pairs, {}, &SolidPair::bodies);
        return pairs;
    }

    std::shared_ptr<const Solid> large = solid_cube(1), small = solid_cube(0.25);
    std::shared_ptr<const Mesh> surface = scenes::cube(0.25);
};

INSTANTIATE_TEST_SUITE_P(BroadPhases, WorldSolidTest, broad_phases(), broad_phase_name);

TEST_P(WorldSolidTest, PairsAreListedFromTheNextUpdateOn) {
    const BodyId a = world.create_body(large, at(0)), b = world.create_body(small, at(0.125));
    const BodyId c = world.create_body(surface, at(-0.5));
    world.update();
    EXPECT_FALSE(world.are_solids_related());
    EXPECT_TRUE(world.solid_pairs().empty());
    EXPECT_TRUE(world.colliding_pairs().empty()) << "of surfaces";
    world.set_solids(true);
    EXPECT_TRUE(world.are_solids_related());
    EXPECT_TRUE(world.solid_pairs().empty());
    world.update();
    EXPECT_EQ(list(world.solid_pairs()), (SolidPairs{{{a, b}, Relation::contains}}));
    EXPECT_TRUE(world.colliding_pairs().empty());
    world.check_invariants();
    world.set_pose(b, at(0.75));  // touching from inside
    world.update();
    EXPECT_EQ(list(world.solid_pairs()), (SolidPairs{{{a, b}, Relation::contains}}));
    EXPECT_EQ(list(world.colliding_pairs()), (std::vector<BodyPair>{{a, b}}));
    world.set_pose(b, at(1));
    world.update();
    EXPECT_EQ(list(world.solid_pairs()), (SolidPairs{{{a, b}, Relation::overlapping}}));
    world.set_pose(b, at(1.25));
    world.update();
    EXPECT_EQ(list(world.solid_pairs()), (SolidPairs{{{a, b}, Relation::touching}}));
    world.set_pose(b, at(2));
    world.update();
    EXPECT_TRUE(world.solid_pairs().empty());
    world.set_shape(c, small);
    world.update();
    EXPECT_EQ(list(world.solid_pairs()), (SolidPairs{{{a, c}, Relation::contains}}));
    world.set_shape(c, std::make_shared<const MeshShape>(surface));
    world.update();
    EXPECT_TRUE(world.solid_pairs().empty()) << "a body that is no solid any more";
    world.set_pose(b, at(0));
    world.update();
    EXPECT_EQ(world.solid_pairs().size(), 1u);
    world.check_invariants();
    world.set_solids(false);
    EXPECT_EQ(world.solid_pairs().size(), 1u);
    world.update();
    EXPECT_TRUE(world.solid_pairs().empty());
    world.check_invariants();
}

TEST_P(WorldSolidTest, FilteredPairsAreNotThere) {
    const BodyId a = world.create_body(large, at(0)), b = world.create_body(small, at(0));
    world.set_solids(true);
    world.set_pair_enabled(a, b, false);
    world.update();
    EXPECT_TRUE(world.solid_pairs().empty());
    world.set_pair_enabled(b, a, true);
    world.update();
    EXPECT_EQ(list(world.solid_pairs()), (SolidPairs{{{a, b}, Relation::contains}}));
    world.set_filter(b, {.groups = 2, .mask = 0});
    world.update();
    EXPECT_TRUE(world.solid_pairs().empty());
    world.set_filter(b, {});
    world.update();
    EXPECT_EQ(world.solid_pairs().size(), 1u);
    world.destroy_body(b);
    world.update();
    EXPECT_TRUE(world.solid_pairs().empty());
    // In the slot of the one before, and with the other as the greater id.
    const BodyId c = world.create_body(solid_cube(3), at(0));
    world.update();
    ASSERT_EQ(world.solid_pairs().size(), 1u);
    EXPECT_EQ(world.solid_pairs()[0].relation, c < a ? Relation::contains : Relation::inside);
    EXPECT_EQ(world.solid_relation(a, c), Relation::inside);
    EXPECT_EQ(world.solid_relation(c, a), Relation::contains);
}

TEST_P(WorldSolidTest, QuestionsAboutAPair) {
    const BodyId a = world.create_body(large, at(0)), b = world.create_body(small, at(0.5));
    const BodyId c = world.create_body(surface, at(0.5));
    EXPECT_EQ(world.solid_relation(a, b), Relation::contains);
    EXPECT_EQ(world.solid_relation(b, a), Relation::inside);
    EXPECT_EQ(world.solid_relation(b, a, memory), Relation::inside);
    EXPECT_THROW(static_cast<void>(world.solid_relation(a, c)), NotSupported);
    EXPECT_THROW(static_cast<void>(world.solid_relation(c, a)), NotSupported);
    EXPECT_THROW(static_cast<void>(world.solid_relation(a, a)), SameBody);
    EXPECT_THROW(static_cast<void>(world.solid_relation(a, BodyId{})), StaleBody);
}

TEST_P(WorldSolidTest, BodiesContainingAPoint) {
    const BodyId a = world.create_body(large, at(0)), b = world.create_body(small, at(0.5));
    world.create_body(surface, at(0.5));
    const BodyId c = world.create_body(small, at(5));
    using Found = std::vector<BodyAt>;
    const auto found = world.bodies_containing(Vec3(0.5, 0, 0));
    EXPECT_EQ(found.bodies, (Found{{a, Side::inside}, {b, Side::inside}}));
    EXPECT_EQ(found.skipped_count, 1u);
    EXPECT_EQ(world.bodies_containing(Vec3(0.75, 0.25, 0), memory).bodies, (Found{{a, Side::inside}, {b, Side::on}}));
    EXPECT_EQ(world.bodies_containing(Vec3(1, 1, 1)).bodies, (Found{{a, Side::on}}));
    EXPECT_TRUE(world.bodies_containing(Vec3(2, 0, 0)).bodies.empty());
    EXPECT_EQ(world.bodies_containing(Vec3(5, 0, 0)).bodies, (Found{{c, Side::inside}}));
    world.create_body(std::make_shared<const Solid>(scenes::torus(12, 8, 0.25)), at(20));
    EXPECT_TRUE(world.bodies_containing(Vec3(20, 0, 0)).bodies.empty()) << "in its box, and in the hole";
    EXPECT_EQ(world.bodies_containing(Vec3(21, 0, 0)).bodies.size(), 1u);
    EXPECT_INVALID(world.bodies_containing(Vec3(0, std::nan(""), 0)), Argument::point);
    world.set_shape(c, std::make_shared<const MeshShape>(surface));
    EXPECT_EQ(world.bodies_containing(Vec3(5, 0, 0)).skipped_count, 2u);
    world.destroy_body(c);
    EXPECT_EQ(world.bodies_containing(Vec3(5, 0, 0)).skipped_count, 1u);
}

// Bodies on a lattice, so that all relations are there, that move, come, go, change their shapes and are switched off.
TEST_P(WorldSolidTest, TheListIsThatFromScratch) {
    world = World({GetParam(), std::make_shared<ThreadExecutor>(2)});
    const std::array<std::shared_ptr<const MeshShape>, 4> shapes = {solid_cube(0.5), solid_cube(1), solid_cube(2),
                                                                    std::make_shared<const MeshShape>(scenes::cube(1))};
    scenes::Random random(5);
    const auto place = [&] {
        const auto coordinate = [&] { return 0.5 * (static_cast<double>(random.below(7)) - 3); };
        return at(coordinate(), coordinate(), coordinate());
    };
    std::vector<BodyId> bodies;
    std::map<Relation, std::size_t> counts;
    std::uint64_t digest_with_solids = 0;
    for (int frame = 0; frame < 60; ++frame) {
        if (frame == 10 || frame == 45) world.set_solids(true);
        if (frame == 40) world.set_solids(false);
        for (int change = 0; change < 4; ++change) {
            if (bodies.size() < 24) bodies.push_back(world.create_body(shapes[random.below(4)], place()));
            const auto pick = [&] { return bodies[random.below(static_cast<std::uint32_t>(bodies.size()))]; };
            world.set_pose(pick(), place());
            if (change == 0) world.set_shape(pick(), shapes[random.below(4)]);
            const BodyId x = pick(), y = pick();
            if (change == 1 && x != y) world.set_pair_enabled(x, y, !world.is_pair_enabled(x, y));
            if (change == 2 && frame % 3 == 0) {
                world.destroy_body(x);
                std::erase(bodies, x);
            }
        }
        world.update();
        world.check_invariants();
        const bool are_listed = (frame >= 10 && frame < 40) || frame >= 45;
        const SolidPairs got = list(world.solid_pairs());
        ASSERT_EQ(got, are_listed ? expected() : SolidPairs{}) << frame;
        for (const SolidPair& pair : got) ++counts[pair.relation];
        if (are_listed) digest_with_solids = world.digest();
        world.update();
        ASSERT_EQ(list(world.solid_pairs()), got);
    }
    EXPECT_EQ(counts.size(), 5u);  // all but apart
    EXPECT_EQ(digest_with_solids, world.digest());
    world.set_solids(false);
    world.update();
    EXPECT_NE(digest_with_solids, world.digest());
}

TEST_P(WorldSolidTest, TracesHaveSolids) {
    std::ostringstream out;
    world.create_body(large, at(0));
    world.set_solids(true);
    world.trace_to(out, {.questions = true});
    const BodyId b = world.create_body(small, at(0.5));
    world.create_body(small, at(0.75));
    world.create_body(surface, at(0.75));
    world.update();
    EXPECT_EQ(world.solid_pairs().size(), 3u);
    world.set_pose(b, at(1));
    std::ignore = world.bodies_containing(Vec3(0.75, 0, 0));
    world.update();
    world.set_solids(false);
    world.update();
    world.end_trace();
    std::istringstream in(out.str());
    const ReplayReport report = replay(in, {.broad_phase = GetParam()});
    EXPECT_FALSE(report.difference) << report.difference->what;
    EXPECT_EQ(report.update_count, 3u);
    EXPECT_EQ(report.question_count, 1u);
    EXPECT_NE(out.str().find("\nsolid 1 "), std::string::npos) << out.str();
    EXPECT_NE(out.str().find("\nset_solids 1\n"), std::string::npos);

    // A mesh in place of the solid would give other digests.
    std::string other = out.str();
    other.replace(other.find("\nsolid 1 "), 9, "\nmesh 1 ");
    std::istringstream changed(other);
    EXPECT_TRUE(replay(changed, {.broad_phase = GetParam()}).difference.has_value());
}

}  // namespace
}  // namespace ecods::world_solid_test
