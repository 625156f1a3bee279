// Worlds of rounded bodies among meshes and solids: their lists, events and questions against the oracle.
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "ecods/rounded.hpp"
#include "ecods/trace.hpp"
#include "oracle/rounded.hpp"
#include "oracle/solid.hpp"
#include "scenes/random.hpp"
#include "unit/world/world_fixture.hpp"

namespace ecods::rounded_world_test {
namespace {

using ShapePtr = std::shared_ptr<const Shape>;
using Pairs = std::vector<BodyPair>;

struct Body {
    BodyId id;
    ShapePtr shape;
    Pose pose;

    const MeshShape& core() const {
        const auto* rounded = dynamic_cast<const Rounded*>(shape.get());
        return rounded != nullptr ? rounded->core() : dynamic_cast<const MeshShape&>(*shape);
    }
    double radius() const {
        const auto* rounded = dynamic_cast<const Rounded*>(shape.get());
        return rounded != nullptr ? rounded->radius() : 0;
    }
    bool is_rounded() const { return dynamic_cast<const Rounded*>(shape.get()) != nullptr; }
    bool is_convex() const { return core().form() == MeshForm::convex || core().mesh().triangles().size() == 1; }
    bool is_solid() const { return core().form() != MeshForm::surface; }
    oracle::Soup soup() const { return {core().mesh().vertices(), core().mesh().triangles(), pose}; }
};

// All poses here are regular, and the solids have no triangles without an area.
oracle::RoundedDistance distance_of(const Body& a, const Body& b) {
    oracle::ExactClosest cores = oracle::MeshDistances(a.soup(), b.soup()).closest();
    const bool is_inside = (b.is_solid() && oracle::has_piece_inside(a.soup(), b.soup())) ||
                           (a.is_solid() && oracle::has_piece_inside(b.soup(), a.soup()));
    if (is_inside) cores.distance = {};
    return {cores, a.radius(), b.radius()};
}

class RoundedWorld : public testing::TestWithParam<BroadPhaseKind> {
  protected:
    Vec3 point(double unit) {
        return unit * Vec3(random.below(9) - 4.0, random.below(9) - 4.0, random.below(9) - 4.0) / 4;
    }
    double radius() { return 0.25 * random.below(5); }
    ShapePtr any_shape(bool are_convex) {
        const auto surface = [](std::shared_ptr<const Mesh> mesh) { return std::make_shared<const MeshShape>(mesh); };
        switch (random.below(are_convex ? 5 : 8)) {
            case 0:
                return sphere(radius(), point(0.5));
            case 1:
                return capsule(point(1), point(1), radius());
            case 2:
                return rounded(surface(scenes::one_triangle({point(1), point(1), point(1)})), radius());
            case 3:
                return rounded(std::make_shared<const ConvexSolid>(scenes::cube(0.5)), radius());
            case 4:
                return surface(scenes::one_triangle({point(1), point(1), point(1)}));
            case 5:
                return rounded(std::make_shared<const Solid>(scenes::torus(4, 3, 0.5)), radius());
            case 6:
                return rounded(surface(scenes::cube(1)), radius());
            default:
                return std::make_shared<const Solid>(scenes::cube(1));
        }
    }
    Pose any_pose() {
        Pose pose = random.below(2) == 0 ? random.turned() : Pose();
        if (random.below(4) == 0) pose.R.col(0) *= -0.5;
        if (random.below(4) == 0) pose.R(0, 1) += 1;
        pose.t = point(spread);
        return pose;
    }
    void create(bool are_convex) {
        Body body{{}, any_shape(are_convex), any_pose()};
        body.id = world.create_body(body.shape, body.pose);
        bodies.push_back(std::move(body));
    }
    void change(bool are_convex) {
        Body& body = bodies[random.below(static_cast<std::uint32_t>(bodies.size()))];
        switch (random.below(4)) {
            case 0:
                world.set_shape(body.id, body.shape = any_shape(are_convex));
                return;
            case 1:  // the same core with another radius
                if (!dynamic_cast<const Rounded*>(body.shape.get())) break;
                body.shape =
                    std::make_shared<const Rounded>(dynamic_cast<const Rounded&>(*body.shape).core_ptr(), radius());
                world.set_shape(body.id, body.shape);
                return;
            case 2:
                body.pose.t += Vec3(0.25, 0, -0.25);
                break;
            default:
                body.pose = any_pose();
        }
        world.set_pose(body.id, body.pose);
    }

    // Returns the distance as ClosestPair has it. That of convex bodies that meet has tests of its own.
    double signed_distance_of(const Body& a, const Body& b, const oracle::RoundedDistance& d) const {
        const double distance = d.distance();
        const bool is_rounded = a.is_rounded() || b.is_rounded();
        if (distance > 0 || !is_rounded || !a.is_convex() || !b.is_convex()) return distance;
        const double found = world.signed_distance(a.id, b.id).distance;
        EXPECT_LE(found, 0);
        return found;
    }

    // Expects the lists of the world, and the events since `before`.
    void expect_lists(const Pairs& before, const Pairs& close_before) {
        Pairs colliding, close;
        std::optional<double> least;
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            for (std::size_t j = i + 1; j < bodies.size(); ++j) {
                const oracle::RoundedDistance d = distance_of(bodies[i], bodies[j]);
                const auto [first, second] = std::minmax({bodies[i].id, bodies[j].id});
                const BodyPair pair{first, second};
                if (d.compare(0) <= 0) colliding.push_back(pair);
                if (world.clearance() && d.compare(*world.clearance()) <= 0) close.push_back(pair);
                const double from_each_other = signed_distance_of(bodies[i], bodies[j], d);
                least = least ? std::min(*least, from_each_other) : from_each_other;
                EXPECT_EQ(world.distance(pair.a, pair.b), d.distance());
            }
        }
        std::ranges::sort(colliding);
        std::ranges::sort(close);
        EXPECT_EQ(list(world.colliding_pairs()), colliding);
        EXPECT_EQ(list(world.close_pairs()), close);
        const auto expect_events = [](const Pairs& first, const Pairs& second, std::span<const BodyPair> got) {
            Pairs expected;
            std::ranges::set_difference(first, second, std::back_inserter(expected));
            EXPECT_EQ(list(got), expected);
        };
        expect_events(colliding, before, world.began());
        expect_events(before, colliding, world.ended());
        expect_events(close, close_before, world.close_began());
        const auto nearest = world.closest_pair();
        ASSERT_EQ(nearest.has_value(), least.has_value());
        if (nearest) {
            EXPECT_EQ(nearest->distance, *least);
        }
    }
    void expect_questions_about(const Body& body) {
        std::vector<BodyId> meeting;
        std::optional<NearestBody> nearest;
        for (const Body& other : bodies) {
            const oracle::RoundedDistance d = distance_of(body, other);
            if (other.id == body.id || d.compare(0) <= 0) meeting.push_back(other.id);
            if (other.id == body.id) continue;
            const NearestBody found{other.id, d.distance()};
            if (!nearest || std::pair(found.distance, found.body) < std::pair(nearest->distance, nearest->body))
                nearest = found;
        }
        std::ranges::sort(meeting);
        EXPECT_EQ(world.intersecting_bodies({body.shape, body.pose}), meeting);
        EXPECT_EQ(world.nearest(body.id), nearest);
    }

    // Convex bodies with an inside that meet, as two by two.
    void expect_depths() {
        std::vector<BodyDepth> expected;
        const auto is_listed = [](const Body& body) {
            return body.shape->kind() == ShapeKind::rounded_convex() || (body.is_convex() && body.is_solid());
        };
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            for (std::size_t j = i + 1; j < bodies.size(); ++j) {
                if (!is_listed(bodies[i]) || !is_listed(bodies[j])) continue;
                const auto [a, b] = std::minmax({bodies[i].id, bodies[j].id});
                if (const std::optional<Depth> depth = world.depth(a, b)) expected.push_back({{a, b}, *depth});
            }
        }
        std::ranges::sort(expected, {}, &BodyDepth::bodies);
        EXPECT_EQ(world.depths(), expected);
        depth_count += expected.size();
    }
    void expect_bodies_at(const Vec3& at) {
        std::vector<BodyAt> expected;
        std::size_t skipped = 0;
        for (const Body& body : bodies) {
            Side side = Side::outside;
            if (body.is_rounded()) {
                side = locate(at, Posed<Rounded>(dynamic_cast<const Rounded&>(*body.shape), body.pose)).side;
            } else if (body.is_solid()) {
                side = locate(at, {dynamic_cast<const Solid&>(*body.shape), body.pose}).side;
            } else {
                ++skipped;
            }
            if (side != Side::outside) expected.push_back({body.id, side});
        }
        std::ranges::sort(expected, {}, &BodyAt::body);
        const BodiesContaining got = world.bodies_containing(at);
        EXPECT_EQ(got.bodies, expected);
        EXPECT_EQ(got.skipped_count, skipped);
        containing_count += expected.size();
    }

    std::size_t depth_count = 0, containing_count = 0;
    double spread = 4;
    scenes::Random random{7};
    World world{WorldOptions{GetParam()}};
    std::vector<Body> bodies;
};
INSTANTIATE_TEST_SUITE_P(BroadPhases, RoundedWorld, broad_phases(), broad_phase_name);

TEST_P(RoundedWorld, ListsAndQuestionsAsTheOracle) {
    std::ostringstream trace;
    world.trace_to(trace, {.questions = true});
    for (int i = 0; i < 10; ++i) create(false);
    for (int frame = 0; frame < 25; ++frame) {
        SCOPED_TRACE(frame);
        if (frame == 3) world.set_clearance(0.5);
        if (frame == 18) world.set_clearance(0x1p-60);
        if (frame == 6) {
            world.destroy_body(bodies.back().id);
            bodies.pop_back();
        }
        if (frame == 9) create(false);
        const Pairs before = list(world.colliding_pairs()), close_before = list(world.close_pairs());
        for (std::uint32_t i = random.below(4); i > 0; --i) change(false);
        world.update();
        expect_lists(before, close_before);
        expect_questions_about(bodies[random.below(static_cast<std::uint32_t>(bodies.size()))]);
        world.check_invariants();
        if (HasFailure()) return;
    }
    World again;
    for (const Body& body : bodies) again.create_body(body.shape, body.pose);
    again.set_clearance(world.clearance());
    again.update();
    EXPECT_EQ(again.digest(), world.digest());
    world.end_trace();
    std::istringstream in(trace.str());
    const ReplayReport report = replay(in, {.checks_invariants = true});
    EXPECT_FALSE(report.difference) << report.difference->what;
    EXPECT_EQ(report.update_count, 25U);
    EXPECT_GT(report.question_count, 25U);
    EXPECT_NE(trace.str().find("\nrounded "), std::string::npos);
}

TEST_P(RoundedWorld, RelationsOfConvexBodies) {
    world.set_relations(true);
    spread = 1;
    std::set<Relation> seen;
    for (int i = 0; i < 12; ++i) create(true);
    for (int frame = 0; frame < 20; ++frame) {
        for (std::uint32_t i = random.below(4); i > 0; --i) change(true);
        world.update();
        ASSERT_EQ(world.relations().size(), world.colliding_pairs().size());
        for (const PairRelation& pair : world.relations()) {
            EXPECT_NE(pair.relation, Relation::apart);
            seen.insert(pair.relation);
            EXPECT_EQ(pair.relation, world.relation(pair.bodies.a, pair.bodies.b));
        }
        expect_depths();
        expect_bodies_at(point(1));
        expect_bodies_at(bodies[0].pose.t);
        world.check_invariants();
    }
    EXPECT_GE(seen.size(), 5U);
    EXPECT_GT(depth_count, 50U);
    EXPECT_GT(containing_count, 20U);
    // One of which it is not decided what it contains is refused, and changes nothing.
    const ShapePtr general = rounded(std::make_shared<const MeshShape>(scenes::cube(1)), 0.5);
    const std::uint64_t digest = world.digest();
    EXPECT_THROW(world.create_body(general, Pose()), NotSupported);
    EXPECT_THROW(world.set_shape(bodies[0].id, general), NotSupported);
    EXPECT_EQ(world.digest(), digest);
    world.set_relations(false);
    world.create_body(general, Pose());
    EXPECT_THROW(world.set_relations(true), NotSupported);
    World of_meshes;
    of_meshes.create_body(scenes::cube(1), Pose());
    of_meshes.set_relations(true);
    EXPECT_THROW(of_meshes.create_body(general, Pose()), NotSupported);
}

TEST_P(RoundedWorld, WhatIsNotDecidedIsRefusedByName) {
    const BodyId ball = world.create_body(ShapePtr(sphere(1)), Pose());
    const BodyId cube = world.create_body(scenes::cube(0.5), at(2));
    world.update();
    const ShapeKind mesh = ShapeKind::mesh(), convex = ShapeKind::rounded_convex();
    const std::vector<BodyId> ids{ball, cube};
    const std::vector<Pose> poses{at(1), at(2)}, turned{at(1), {Vec3(-1, -1, 1).asDiagonal(), Vec3(2, 0, 0)}};
    EXPECT_EQ(world.meetings(ids, poses).size(), 1U);
    expect_not_supported([&] { (void)world.meetings(ids, turned); }, Question::cast_moving, mesh, convex);
    expect_not_supported([&] { (void)world.certify(); }, Question::certify, convex, convex);
    expect_not_supported([&] { (void)world.intersecting_triangles(ball, cube); }, Question::intersecting_triangles,
                         convex, mesh);
    expect_not_supported([&] { (void)world.close_features(ball, cube, 1); }, Question::close_features, convex, mesh);
    EXPECT_THROW((void)world.depth(ball, cube), NotSupported);
    EXPECT_EQ(world.closest(ball, cube).point_a, Vec3(1, 0, 0));
    EXPECT_EQ(world.closest(cube, ball).point_b, Vec3(1, 0, 0)) << "of the cube, then of the ball";
    EXPECT_EQ(world.bodies_containing(Vec3(0, 0, 0)).bodies, (std::vector<BodyAt>{{ball, Side::inside}}));
    EXPECT_EQ(world.bodies_containing(Vec3(0, 0, 0)).skipped_count, 1U);
}

// Whatever kinds they are of.
TEST_P(RoundedWorld, TiesAreBrokenByIds) {
    const auto rod =
        std::make_shared<const MeshShape>(Mesh::create({Vec3(0, 0, 1), Vec3(0, 0, 0)}, {Triangle{0, 1, 1}}));
    const auto bone = capsule({0, 0, 0}, {0, 0, 1}, 0.25);
    const auto expect_first = [&](BodyId a, BodyId b, const ClosestPoints& expected) {
        const ClosestPoints got = world.closest(a, b), turned = world.closest(b, a);
        EXPECT_EQ(std::tuple(got.a, got.b, got.point_a, got.point_b),
                  std::tuple(expected.a, expected.b, expected.point_a, expected.point_b));
        EXPECT_EQ(std::tuple(turned.b, turned.a, turned.point_b, turned.point_a),
                  std::tuple(expected.a, expected.b, expected.point_a, expected.point_b));
    };
    const BodyId a = world.create_body(ShapePtr(bone), Pose()), b = world.create_body(ShapePtr(rod), at(1));
    const BodyId c = world.create_body(ShapePtr(bone), at(2));
    expect_first(a, b, closest(Posed<Rounded>(bone, Pose()), Posed<MeshShape>(rod, at(1))));
    expect_first(b, c, closest(Posed<MeshShape>(rod, at(1)), Posed<Rounded>(bone, at(2))));
}

// A class of the caller's own cannot take the kinds.
TEST_P(RoundedWorld, ItsKindsAreTaken) {
    class Other final : public Shape {
        ShapeKind kind() const noexcept override { return ShapeKind::rounded(); }
        Aabb box(const Pose&) const override { return {}; }
        std::uint64_t digest() const noexcept override { return 0; }
    };
    EXPECT_THROW(world.create_body(ShapePtr(std::make_shared<const Other>()), Pose()), NotSupported);
    EXPECT_EQ(world.bodies().size(), 0U);
}

}  // namespace
}  // namespace ecods::rounded_world_test
