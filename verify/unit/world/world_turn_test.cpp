// Which body is met first by one that turns, and which pairs meet while bodies turn, are translated, or go straight to
// new poses: what asking all of them one by one says.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <tuple>

#include "ecods/builders.hpp"
#include "ecods/cast.hpp"
#include "ecods/intersection.hpp"
#include "ecods/rounded.hpp"
#include "ecods/turn.hpp"
#include "scenes/expect_invalid.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"
#include "unit/world/world_fixture.hpp"

namespace ecods::world_turn_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr ShapeKind own_kind{9};
const Turn half_turn{{0, 0, 0, 1}, Vec3::Zero(), Vec3::Zero()};

std::shared_ptr<const Mesh> triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
    return Mesh::create({a, b, c}, {Triangle{0, 1, 2}});
}

// The point (5, 0, 0), which is at (3, 4, 0) at a third of half a turn, and a wall whose edge is there.
const auto point = triangle({5, 0, 0}, {5, 0, 0}, {5, 0, 0});
const auto wall = triangle({3, 4, -1}, {3, 4, 1}, {9, 12, 0});

// A mesh of a kind of the caller's own, and the test of two such, or of a mesh that comes second.
class OwnShape final : public Shape {
  public:
    explicit OwnShape(std::shared_ptr<const Mesh> mesh) : mesh_(std::move(mesh)) {}
    ShapeKind kind() const noexcept override { return own_kind; }
    Aabb box(const Pose& pose) const override { return mesh_.box(pose); }
    std::uint64_t digest() const noexcept override { return mesh_.digest() + 1; }
    const MeshShape& as_mesh() const { return mesh_; }

  private:
    MeshShape mesh_;
};

Posed<MeshShape> mesh_at(const Posed<Shape>& posed) {
    const auto* const own = dynamic_cast<const OwnShape*>(posed.what);
    return {own != nullptr ? own->as_mesh() : dynamic_cast<const MeshShape&>(*posed.what), posed.pose};
}

class OwnTest final : public TwoBodyTest {
  public:
    explicit OwnTest(bool answers_any_motion) : answers_any_motion_(answers_any_motion) {}
    bool intersects(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const override {
        return ecods::intersects(mesh_at(a), mesh_at(b), ask);
    }
    bool answers(Question question) const noexcept override {
        return question == Question::cast_moving || (question == Question::cast_any_motion && answers_any_motion_);
    }
    std::optional<FirstContact> cast_moving(const Moving<Shape>& a, const Moving<Shape>& b, double max_time,
                                            const Ask& ask) const override {
        const auto moving = [](const Moving<Shape>& body) {
            return Moving<MeshShape>(*mesh_at({*body.what, body.from}).what, body.from, body.to);
        };
        return ecods::cast(moving(a), moving(b), max_time, ask);
    }
    std::optional<FirstContact> cast_any_motion(const Posed<Shape>& a, const Motion& motion_of_a,
                                                const Posed<Shape>& b, const Motion& motion_of_b, double max_time,
                                                const Ask& ask) const override {
        if (a.what->kind() != own_kind) throw std::logic_error("the kinds are in the wrong order");
        return ecods::cast(mesh_at(a), motion_of_a, mesh_at(b), motion_of_b, max_time, ask);
    }

  private:
    bool answers_any_motion_;
};

class WorldTurnTest : public EachWorld {
  protected:
    Posed<Shape> posed(BodyId body) { return {world.shape(body), world.pose(body)}; }

    // What asking all says.
    std::optional<BodyContact> first_met(BodyId own, const Turn& turn, double max_time) {
        std::optional<BodyContact> first;
        const Posed<MeshShape> moved = mesh_at(posed(own));
        for (const BodyId body : world.bodies()) {
            if (body == own || !world.is_pair_enabled(own, body)) continue;
            const auto kept = world.shape(body);
            const auto contact = cast(Turning<MeshShape>(*moved.what, moved.pose, turn),
                                      mesh_at({*kept, world.pose(body)}), max_time, memory);
            if (contact && (!first || contact->time < first->contact.time)) first = BodyContact{body, *contact};
        }
        return first;
    }
    std::vector<Meeting> all_meetings(const std::vector<BodyId>& moved, const std::vector<Motion>& motions) {
        std::vector<Meeting> meetings;
        const auto bodies = world.bodies();
        const auto motion_of = [&](BodyId body) {
            const auto found = std::ranges::find(moved, body);
            return found == moved.end() ? Motion() : motions[static_cast<std::size_t>(found - moved.begin())];
        };
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            for (std::size_t j = i + 1; j < bodies.size(); ++j) {
                const auto a = world.shape(bodies[i]), b = world.shape(bodies[j]);
                const auto contact =
                    cast(mesh_at({*a, world.pose(bodies[i])}), motion_of(bodies[i]),
                         mesh_at({*b, world.pose(bodies[j])}), motion_of(bodies[j]), 1, memory);
                if (contact) meetings.push_back({{bodies[i], bodies[j]}, *contact});
            }
        }
        std::ranges::stable_sort(meetings, {}, [](const Meeting& m) { return m.contact.time; });
        return meetings;
    }
};

INSTANTIATE_TEST_SUITE_P(BroadPhases, WorldTurnTest, broad_phases(), broad_phase_name);

TEST_P(WorldTurnTest, KnownTimesAndTies) {
    const BodyId a = world.create_body(point, Pose());
    EXPECT_EQ(world.cast(a, half_turn), std::nullopt);
    const BodyId b = world.create_body(wall, at(0)), c = world.create_body(wall, at(0));
    const auto first = world.cast(a, half_turn);
    ASSERT_TRUE(first);
    EXPECT_EQ(first->body, b);
    EXPECT_EQ(first->contact.time, 1.0 / 3);
    EXPECT_EQ(first->contact.kind, ClosestKind::vertex_edge);
    EXPECT_EQ(world.cast(a, half_turn, infinity, memory), first);
    // The double nearest to a third is below it.
    EXPECT_EQ(world.cast(a, half_turn, 1.0 / 3), std::nullopt);
    EXPECT_EQ(world.cast(a, half_turn, std::nextafter(1.0 / 3, 1)), first);
    EXPECT_EQ(world.cast({point, Pose()}, half_turn)->body, a) << "which it touches at the start";
    EXPECT_EQ(world.cast({point, Pose()}, half_turn)->contact.time, 0);
    world.set_pair_enabled(a, b, false);
    EXPECT_EQ(world.cast(a, half_turn)->body, c);
    world.set_filter(c, {.groups = 2});
    EXPECT_EQ(world.cast({{point, Pose()}, CollisionFilter{.mask = 2}}, half_turn)->body, c);
    EXPECT_EQ(world.cast({{point, Pose()}, CollisionFilter{.mask = 4}}, half_turn), std::nullopt);
    const BodyId d = world.create_body(triangle({-3, 4, -1}, {-3, 4, 1}, {-9, 12, 0}), at(0));
    world.set_pair_enabled(a, c, false);
    EXPECT_EQ(world.cast(a, half_turn)->body, d);
    EXPECT_EQ(world.cast(a, {{0, 0, 0, -1}, Vec3::Zero(), Vec3::Zero()}), std::nullopt) << "the other way";
    EXPECT_EQ(world.cast(a, {{0, 0, 0, 1}, Vec3::Zero(), {0, 0, 6}}), std::nullopt) << "above it by then";
}

// The body of the greater id is met in the first piece of the turn, the other one by the rounded time of the same.
TEST_P(WorldTurnTest, TiesOfRoundedTimesAreFoundInAllPieces) {
    const BodyId a = world.create_body(point, Pose());
    const auto large = Mesh::create({{3, 4, -1}, {3, 4, 1}, {9, 12, 0}, {5, 0, 4}, {5, 1, 4}, {5, 1, 5}},
                                    {Triangle{0, 1, 2}, Triangle{3, 4, 5}});
    const BodyId b = world.create_body(wall, at(0)), c = world.create_body(large, at(0));
    EXPECT_EQ(world.cast(a, half_turn)->body, b);
    world.destroy_body(b);
    EXPECT_EQ(world.cast(a, half_turn)->body, c);
}

TEST_P(WorldTurnTest, SolidsAreMetInside) {
    const BodyId room = world.create_body(box({8, 8, 8}), at(0));
    const BodyId a = world.create_body(box({1, 1, 1}), at(1));
    const auto contact = world.cast(a, half_turn);
    ASSERT_TRUE(contact);
    EXPECT_EQ(contact->body, room);
    EXPECT_EQ(contact->contact.kind, ClosestKind::contained);
    EXPECT_EQ(world.meetings(std::vector{a}, std::vector<Motion>{half_turn}).size(), 1u);
}

TEST_P(WorldTurnTest, IsWhatAskingAllSays) {
    scenes::Random random(17);
    const std::array meshes = {scenes::cube(0.5), scenes::cube(0.125), scenes::cube(1)};
    const auto any_pose = [&] { return at(0.5 * random.below(16), random.uniform(0, 8), 0.25 * random.below(8)); };
    world.set_test(own_kind, own_kind, std::make_shared<OwnTest>(true));
    world.set_test(own_kind, ShapeKind::mesh(), std::make_shared<OwnTest>(true));
    for (int i = 0; i < 50; ++i) {
        const auto& mesh = meshes[random.below(3)];
        if (i % 5 == 0) {
            world.create_body(std::make_shared<OwnShape>(mesh), any_pose());
        } else if (i % 3 == 0) {
            world.create_body(std::make_shared<ConvexSolid>(mesh), any_pose());
        } else {
            world.create_body(mesh, any_pose());
        }
    }
    const auto bodies = world.bodies();
    const auto any_turn = [&](BodyId body) {
        const auto part = [&] { return 0.25 * (static_cast<double>(random.below(9)) - 4); };
        Turn turn{{part(), part(), part(), part()}, world.pose(body).t, world.pose(body).t};
        if (random.below(4) == 0) turn.q = {1, 0, 0, 0};
        if (turn.q == Quaternion{0, 0, 0, 0} || (turn.q.w < 0 && turn.q.x == 0 && turn.q.y == 0 && turn.q.z == 0)) {
            turn.q = {0, 0, 1, 0};
        }
        if (random.below(2) == 0) turn.pivot_from = turn.pivot_to = any_pose().t;
        if (random.below(2) == 0) turn.pivot_to += 0.25 * (any_pose().t - any_pose().t);
        return turn;
    };
    std::size_t met = 0, moved_count = 0;
    for (int frame = 0; frame < 5; ++frame) {
        for (int i = 0; i < 6; ++i) {
            const BodyId own = bodies[random.below(50)];
            const Turn turn = any_turn(own);
            const double max_time = random.below(3) == 0 ? random.uniform(0, 1) : 1;
            const auto expected = first_met(own, turn, max_time);
            const auto got = world.cast(own, turn, max_time);
            ASSERT_EQ(got.has_value(), expected.has_value());
            if (!got) continue;
            EXPECT_EQ(got->body, expected->body);
            EXPECT_EQ(got->contact.time, expected->contact.time);
            if (world.shape(got->body)->kind() == world.shape(own)->kind()) {
                EXPECT_EQ(got->contact, expected->contact);
            }
            ++met;
        }
        std::vector<BodyId> moved;
        std::vector<Motion> motions;
        for (const BodyId body : bodies) {
            if (random.below(frame % 2 == 0 ? 10 : 2) != 0) continue;
            moved.push_back(body);
            const Vec3 by = 0.25 * (any_pose().t - any_pose().t);
            if (frame == 4) {
                motions.emplace_back(Straight{any_pose()});
            } else {
                motions.emplace_back(Translation{random.below(3) == 0 ? Vec3(0, 0, 0) : by});
            }
        }
        if (frame < 4 && !moved.empty()) motions.front() = any_turn(moved.front());
        const auto expected = all_meetings(moved, motions);
        const auto got = world.meetings(moved, motions);
        ASSERT_EQ(got.size(), expected.size());
        for (std::size_t i = 0; i < got.size(); ++i) {
            ASSERT_EQ(got[i].bodies, expected[i].bodies) << frame;
            ASSERT_EQ(got[i].contact.time, expected[i].contact.time);
            const BodyPair& pair = got[i].bodies;
            if (world.shape(pair.a)->kind() == world.shape(pair.b)->kind()) {
                EXPECT_EQ(got[i].contact, expected[i].contact);
            }
        }
        if (frame == 4) {
            std::vector<Pose> poses;
            for (const Motion& motion : motions) poses.push_back(std::get<Straight>(motion).to);
            EXPECT_EQ(world.meetings(moved, poses), got);
        }
        moved_count += got.size();
        if (frame == 2) world.update();
        for (int i = 0; i < 10; ++i) world.set_pose(bodies[random.below(50)], any_pose());
    }
    EXPECT_GT(met, 15u);
    EXPECT_GT(moved_count, 100u);
}

TEST_P(WorldTurnTest, BadArgumentsAreRefused) {
    const BodyId a = world.create_body(point, Pose()), b = world.create_body(wall, Pose());
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {-1.0, -infinity, nan}) EXPECT_INVALID(world.cast(a, half_turn, bad), Argument::time);
    EXPECT_INVALID(world.cast(a, {{0, 0, 0, nan}, Vec3::Zero(), Vec3::Zero()}), Argument::turn);
    EXPECT_INVALID(world.cast(a, {{-1, 0, 0, 0}, Vec3::Zero(), Vec3::Zero()}), Argument::turn);
    EXPECT_THROW(std::ignore = world.cast(BodyId{}, half_turn), StaleBody);
    EXPECT_INVALID(world.cast({std::shared_ptr<const Mesh>(), Pose()}, half_turn), Argument::null);
    const std::vector bodies = {a, b};
    const auto refused = [&](const Motion& motion, Argument argument, const std::string& part) {
        try {
            std::ignore = world.meetings(bodies, std::vector<Motion>{half_turn, motion});
            ADD_FAILURE() << part;
        } catch (const InvalidArgument& error) {
            EXPECT_EQ(error.argument, argument);
            EXPECT_EQ(error.part, part);
            EXPECT_EQ(error.index, 1u);
            EXPECT_EQ(error.body, b);
        }
    };
    refused(Turn{{nan, 0, 0, 1}, Vec3::Zero(), Vec3::Zero()}, Argument::turn, "q.w");
    refused(Turn{{1, 0, 0, 1}, Vec3::Zero(), {0, infinity, 0}}, Argument::turn, "pivot_to(1)");
    refused(Translation{{0, 0, nan}}, Argument::motion, "(2)");
    refused(Straight{at(infinity)}, Argument::pose, "t(0)");
    try {
        std::ignore = world.meetings(bodies, std::vector<Motion>{half_turn});
        ADD_FAILURE();
    } catch (const InvalidArgument& error) {
        EXPECT_EQ(error.argument, Argument::list_length);
        EXPECT_EQ(error.part, "motions");
    }
    world.destroy_body(b);
    try {
        std::ignore = world.meetings(bodies, std::vector<Motion>{half_turn, Translation()});
        ADD_FAILURE();
    } catch (const StaleBody& error) {
        EXPECT_EQ(error.index, 1u);
    }
}

TEST_P(WorldTurnTest, MotionsWithoutACastAreRefusedByKind) {
    const BodyId a = world.create_body(cube, at(0)), b = world.create_body(cube, at(500)), c = world.create_body(cube, at(900));
    const Translation up{{0, 0, 1}};
    const Straight there{at(0, 100)};
    const auto ask = [&](const Motion& first, const Motion& second) {
        return world.meetings(std::vector{a, b}, std::vector{first, second}).size();
    };
    EXPECT_EQ(ask(half_turn, half_turn), 0u);
    EXPECT_THROW(ask(half_turn, there), NotSupported);
    EXPECT_THROW(ask(there, up), NotSupported);
    EXPECT_EQ(ask(half_turn, up), 0u);
    EXPECT_EQ(ask(up, up), 0u);
    EXPECT_EQ(ask(half_turn, Straight{at(500)}), 0u) << "which rests";
    EXPECT_EQ(ask(there, Translation()), 0u);
    // The later motion counts.
    const std::vector twice = {a, b, a};
    EXPECT_EQ(world.meetings(twice, std::vector<Motion>{half_turn, half_turn, up}).size(), 0u);
    const auto met = world.meetings(twice, std::vector<Motion>{half_turn, Translation{{400, 0, 0}}, up});
    ASSERT_EQ(met.size(), 1u);
    EXPECT_EQ(met[0].bodies, (BodyPair{b, c}));
    EXPECT_EQ(met[0].contact.time, 399.0 / 400);

    world.create_body(sphere(1), at(0, 700));
    const ShapeKind round = world.shape(world.bodies().back())->kind();
    expect_not_supported([&] { std::ignore = world.cast(a, half_turn); }, Question::cast_any_motion, ShapeKind::mesh(),
                         round);
    EXPECT_THROW(ask(half_turn, up), NotSupported);
    world.destroy_body(world.bodies().back());
    const auto own = std::make_shared<OwnShape>(cube);
    world.set_test(own_kind, own_kind, std::make_shared<OwnTest>(false));
    world.set_test(own_kind, ShapeKind::mesh(), std::make_shared<OwnTest>(false));
    const BodyId d = world.create_body(own, at(0, 700));
    const auto refuse = [&](const auto& call) {
        expect_not_supported(call, Question::cast_any_motion, own_kind, ShapeKind::mesh());
    };
    refuse([&] { std::ignore = world.cast(a, half_turn); });
    refuse([&] { std::ignore = world.cast(d, half_turn); });
    refuse([&] { ask(half_turn, up); });
    EXPECT_EQ(ask(there, Straight{at(600)}), 0u);
}

// A turn of which no bound in doubles holds is refused, wherever other bodies are.
TEST_P(WorldTurnTest, NearlyWholeTurnsAreRefused) {
    const BodyId a = world.create_body(cube, at(0));
    const Turn nearly{{-1, 0, 0, 0x1p-40}, Vec3::Zero(), Vec3::Zero()};
    EXPECT_EQ(world.cast(a, nearly), std::nullopt);
    world.create_body(cube, at(500));
    EXPECT_THROW(std::ignore = world.cast(a, nearly), NotSupported);
    EXPECT_THROW(std::ignore = world.meetings(std::vector{a}, std::vector<Motion>{nearly}), NotSupported);
}

// A long arm in a field of posts: only bodies near the way are asked, and none after the first that it meets.
TEST_P(WorldTurnTest, FarBodiesAreNotAsked) {
    const auto arm = box({8, 0.25, 0.25}), post = box({0.25, 0.25, 1});
    const BodyId a = world.create_body(arm, {.t = {4, 0, 0}});
    for (int x = -20; x <= 20; ++x) {
        for (int y = -20; y <= 20; ++y) {
            if (x * x + y * y > 100) world.create_body(post, {.t = {1.0 * x, 1.0 * y, 0}});
        }
    }
    QueryCounts counts;
    EXPECT_EQ(world.cast(a, half_turn, 1, {counts}), std::nullopt);
    EXPECT_LT(counts.queries, 100u);
    counts = {};
    const BodyId b = world.create_body(post, {.t = {6, 2, 0}});
    EXPECT_EQ(world.cast(a, half_turn, 1, {counts})->body, b);
    EXPECT_LT(counts.queries, 20u);
}

}  // namespace
}  // namespace ecods::world_turn_test
