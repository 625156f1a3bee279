// Solids in a world: how colliding pairs are to each other, as updates keep it, and which solids contain a point.

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

using Relations = std::vector<PairRelation>;

Relations list(std::span<const PairRelation> pairs) {
    return {pairs.begin(), pairs.end()};
}

std::shared_ptr<const Solid> solid_cube(double half) {
    return std::make_shared<const Solid>(scenes::cube(half));
}

class WorldSolidTest : public EachWorld {
  protected:
    // All pairs, one by one.
    Relations expected() {
        Relations pairs;
        const std::vector<BodyId> bodies = world.bodies();
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            for (std::size_t j = i + 1; j < bodies.size(); ++j) {
                const BodyPair pair{std::min(bodies[i], bodies[j]), std::max(bodies[i], bodies[j])};
                if (!may_meet(world.filter(pair.a), world.filter(pair.b))) continue;
                if (!world.is_pair_enabled(pair.a, pair.b)) continue;
                const Relation relation = ecods::relation(posed(pair.a), posed(pair.b), memory);
                if (relation != Relation::apart) pairs.push_back({pair, relation});
            }
        }
        std::ranges::sort(pairs, {}, &PairRelation::bodies);
        return pairs;
    }

    Posed<MeshShape> posed(BodyId body) const {
        return {static_cast<const MeshShape&>(*world.shape(body)), world.pose(body)};
    }

    std::shared_ptr<const Solid> large = solid_cube(1), small = solid_cube(0.25);
    std::shared_ptr<const Mesh> surface = scenes::cube(0.25);
};

INSTANTIATE_TEST_SUITE_P(BroadPhases, WorldSolidTest, broad_phases(), broad_phase_name);

TEST_P(WorldSolidTest, PairsAreListedFromTheNextUpdateOn) {
    const BodyId a = world.create_body(large, at(0)), b = world.create_body(small, at(0.125));
    const BodyId c = world.create_body(surface, at(-0.5));
    const PairRelation has_c{{a, c}, Relation::contains};
    const std::vector<BodyPair> both{{a, b}, {a, c}};
    world.update();
    EXPECT_FALSE(world.are_relations_listed());
    EXPECT_TRUE(world.relations().empty());
    EXPECT_EQ(list(world.colliding_pairs()), both) << "though no surface meets another one";
    world.set_relations(true);
    EXPECT_TRUE(world.are_relations_listed());
    EXPECT_TRUE(world.relations().empty());
    world.update();
    EXPECT_EQ(list(world.relations()), (Relations{{{a, b}, Relation::contains}, has_c}));
    EXPECT_EQ(list(world.colliding_pairs()), both);
    EXPECT_TRUE(world.began().empty());
    world.check_invariants();
    world.set_pose(b, at(0.75));  // touching from inside
    world.update();
    EXPECT_EQ(list(world.relations()), (Relations{{{a, b}, Relation::contains}, has_c}));
    EXPECT_EQ(list(world.colliding_pairs()), both);
    world.set_pose(b, at(1));
    world.update();
    EXPECT_EQ(list(world.relations()), (Relations{{{a, b}, Relation::overlapping}, has_c}));
    world.set_pose(b, at(1.25));
    world.update();
    EXPECT_EQ(list(world.relations()), (Relations{{{a, b}, Relation::touching}, has_c}));
    world.set_pose(b, at(2));
    world.update();
    EXPECT_EQ(list(world.relations()), (Relations{has_c}));
    EXPECT_EQ(list(world.ended()), (std::vector<BodyPair>{{a, b}}));
    world.set_shape(c, small);
    world.update();
    EXPECT_EQ(list(world.relations()), (Relations{has_c}));
    world.set_shape(a, surface_of(*large));
    world.update();
    EXPECT_TRUE(world.relations().empty()) << "a body that is no solid any more";
    EXPECT_EQ(list(world.ended()), (std::vector<BodyPair>{{a, c}}));
    world.set_shape(a, large);
    world.set_shape(c, std::make_shared<const MeshShape>(surface));
    world.set_pose(b, at(0));
    world.update();
    EXPECT_EQ(list(world.relations()), (Relations{{{a, b}, Relation::contains}, has_c, {{b, c}, Relation::touching}}));
    EXPECT_EQ(world.began().size(), 3u);
    world.check_invariants();
    world.set_relations(false);
    EXPECT_EQ(world.relations().size(), 3u);
    world.update();
    EXPECT_TRUE(world.relations().empty());
    EXPECT_EQ(world.colliding_pairs().size(), 3u);
    world.check_invariants();
}

TEST_P(WorldSolidTest, FilteredPairsAreNotThere) {
    const BodyId a = world.create_body(large, at(0)), b = world.create_body(small, at(0));
    world.set_relations(true);
    world.set_pair_enabled(a, b, false);
    world.update();
    EXPECT_TRUE(world.relations().empty());
    world.set_pair_enabled(b, a, true);
    world.update();
    EXPECT_EQ(list(world.relations()), (Relations{{{a, b}, Relation::contains}}));
    world.set_filter(b, {.groups = 2, .mask = 0});
    world.update();
    EXPECT_TRUE(world.relations().empty());
    world.set_filter(b, {});
    world.update();
    EXPECT_EQ(world.relations().size(), 1u);
    world.destroy_body(b);
    world.update();
    EXPECT_TRUE(world.relations().empty());
    // In the slot of the one before, and with the other as the greater id.
    const BodyId c = world.create_body(solid_cube(3), at(0));
    world.update();
    ASSERT_EQ(world.relations().size(), 1u);
    EXPECT_EQ(world.relations()[0].relation, c < a ? Relation::contains : Relation::inside);
    EXPECT_EQ(world.relation(a, c), Relation::inside);
    EXPECT_EQ(world.relation(c, a), Relation::contains);
}

TEST_P(WorldSolidTest, QuestionsAboutAPair) {
    const BodyId a = world.create_body(large, at(0)), b = world.create_body(small, at(0.5));
    const BodyId c = world.create_body(surface, at(0.5));
    EXPECT_EQ(world.relation(a, b), Relation::contains);
    EXPECT_EQ(world.relation(b, a), Relation::inside);
    EXPECT_EQ(world.relation(b, a, memory), Relation::inside);
    EXPECT_EQ(world.relation(a, c), Relation::contains);
    EXPECT_EQ(world.relation(c, a), Relation::inside);
    EXPECT_EQ(world.relation(b, c), Relation::touching);
    EXPECT_EQ(world.relation(c, b, memory), Relation::touching);
    EXPECT_THROW(static_cast<void>(world.relation(a, a)), SameBody);
    EXPECT_THROW(static_cast<void>(world.relation(a, BodyId{})), StaleBody);
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

// Answers about a shape of the caller's own and another one, always the same.
class InsideTest final : public TwoBodyTest {
  public:
    bool answers(Question question) const noexcept override { return question == Question::relation; }
    bool intersects(const Posed<Shape>& /*a*/, const Posed<Shape>& /*b*/, const Ask& /*ask*/) const override {
        return true;
    }
    // The first body given, of the first kind, is inside the other one.
    Relation relation(const Posed<Shape>& /*a*/, const Posed<Shape>& /*b*/, const Ask& /*ask*/) const override {
        return Relation::inside;
    }
};

TEST_P(WorldSolidTest, RelationsNeedTestsThatAnswerThem) {
    const auto slab = std::make_shared<const SlabShape>();
    const ShapeKind kind = slab_kind;
    world.set_test(kind, ShapeKind::mesh(), std::make_shared<SlabTest>());
    world.set_test(kind, kind, std::make_shared<SlabTest>());
    world.set_relations(true);
    const BodyId mesh = world.create_body(large, at(0));
    const auto refused = [&](const auto& call) {
        expect_not_supported(call, Question::relation, kind, ShapeKind::mesh());
    };
    refused([&] { world.create_body(slab, at(0)); });
    const BodyId other = world.create_body(small, at(0));
    refused([&] { world.set_shape(other, slab); });
    world.set_relations(false);
    world.set_shape(other, slab);
    refused([&] { world.set_relations(true); });
    EXPECT_FALSE(world.are_relations_listed());
    world.set_test(kind, ShapeKind::mesh(), std::make_shared<InsideTest>());
    world.set_relations(true);
    refused([&] { world.set_test(kind, ShapeKind::mesh(), std::make_shared<SlabTest>()); });
    world.update();
    EXPECT_EQ(list(world.relations()), (Relations{{{mesh, other}, Relation::contains}})) << "the lesser id's";
    EXPECT_EQ(world.relation(other, mesh), Relation::inside);
    world.check_invariants();
}

// Bodies on a lattice, so that all relations are there, that jump in and out of each other, come, go, change their
// shapes between surfaces, solids and convex solids, are mirrored, and are switched off.
TEST_P(WorldSolidTest, TheListIsThatFromScratch) {
    world = World({GetParam(), std::make_shared<ThreadExecutor>(2)});
    const std::array<std::shared_ptr<const MeshShape>, 6> shapes = {
        solid_cube(0.5),    solid_cube(1),
        solid_cube(2),      std::make_shared<const MeshShape>(scenes::cube(1)),
        surface_of(*large), std::make_shared<const ConvexSolid>(scenes::cube(0.75))};
    scenes::Random random(5);
    const auto place = [&] {
        const auto coordinate = [&] { return 0.5 * (static_cast<double>(random.below(7)) - 3); };
        Pose pose = at(coordinate(), coordinate(), coordinate());
        if (random.below(4) == 0) pose.R.row(0) *= -1;
        return pose;
    };
    std::vector<BodyId> bodies;
    std::map<Relation, std::size_t> counts;
    std::uint64_t digest_with_relations = 0;
    for (int frame = 0; frame < 60; ++frame) {
        if (frame == 10 || frame == 45) world.set_relations(true);
        if (frame == 40) world.set_relations(false);
        for (int change = 0; change < 4; ++change) {
            if (bodies.size() < 24) bodies.push_back(world.create_body(shapes[random.below(6)], place()));
            const auto pick = [&] { return bodies[random.below(static_cast<std::uint32_t>(bodies.size()))]; };
            world.set_pose(pick(), place());
            if (change == 0) world.set_shape(pick(), shapes[random.below(6)]);
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
        const Relations got = list(world.relations()), all = expected();
        ASSERT_EQ(got, are_listed ? all : Relations{}) << frame;
        std::vector<BodyPair> colliding;
        for (const PairRelation& pair : all) colliding.push_back(pair.bodies);
        ASSERT_EQ(list(world.colliding_pairs()), colliding) << frame;
        for (const PairRelation& pair : got) ++counts[pair.relation];
        if (are_listed) digest_with_relations = world.digest();
        world.update();
        ASSERT_EQ(list(world.relations()), got);
    }
    EXPECT_EQ(counts.size(), 6u);  // all but apart
    EXPECT_EQ(digest_with_relations, world.digest());
    world.set_relations(false);
    world.update();
    EXPECT_NE(digest_with_relations, world.digest());
}

TEST_P(WorldSolidTest, TracesHaveSolids) {
    std::ostringstream out;
    world.create_body(large, at(0));
    world.set_relations(true);
    world.trace_to(out, {.questions = true});
    const BodyId b = world.create_body(small, at(0.5));
    world.create_body(small, at(0.75));
    world.create_body(surface, at(0.75));
    world.update();
    EXPECT_EQ(world.relations().size(), 6u);
    world.set_pose(b, at(1));
    std::ignore = world.bodies_containing(Vec3(0.75, 0, 0));
    world.update();
    world.set_relations(false);
    world.update();
    world.end_trace();
    std::istringstream in(out.str());
    const ReplayReport report = replay(in, {.broad_phase = GetParam()});
    EXPECT_FALSE(report.difference) << report.difference->what;
    EXPECT_EQ(report.update_count, 3u);
    EXPECT_EQ(report.question_count, 1u);
    EXPECT_NE(out.str().find("\nsolid 1 "), std::string::npos) << out.str();
    EXPECT_NE(out.str().find("\nset_relations 1\n"), std::string::npos);

    // A mesh in place of the solid would give other digests.
    std::string other = out.str();
    other.replace(other.find("\nsolid 1 "), 9, "\nmesh 1 ");
    std::istringstream changed(other);
    EXPECT_TRUE(replay(changed, {.broad_phase = GetParam()}).difference.has_value());
}

}  // namespace
}  // namespace ecods::world_solid_test
