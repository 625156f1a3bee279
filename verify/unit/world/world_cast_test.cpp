// Which body is met first by one that is cast, and which pairs meet while bodies go to new poses: what asking all of
// them one by one says.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <tuple>

#include "ecods/cast.hpp"
#include "ecods/distance.hpp"
#include "ecods/error.hpp"
#include "ecods/intersection.hpp"
#include "environment/float_mode.hpp"
#include "scenes/expect_invalid.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"
#include "unit/world/world_fixture.hpp"

namespace ecods::world_cast_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

class WorldCastTest : public EachWorld {
  protected:
    Posed<MeshShape> posed(BodyId body) {
        kept.push_back(world.shape(body));
        return {dynamic_cast<const MeshShape&>(*kept.back()), world.pose(body)};
    }
    Moving<MeshShape> moving(BodyId body, const Pose& to) {
        const Posed<MeshShape> at_start = posed(body);
        return {*at_start.what, at_start.pose, to};
    }

    std::vector<std::shared_ptr<const Shape>> kept;
};

INSTANTIATE_TEST_SUITE_P(BroadPhases, WorldCastTest, broad_phases(), broad_phase_name);

// Times of 4.4 and 3.6 times the least double round to 4 of them, and with the mode that rounds up boxes are met from 5
// and 4 of them on.
TEST_P(WorldCastTest, TheLeastIdIsFirstOfTheShortestTimesInEveryFloatMode) {
    const auto triangle = [](double x) {
        const double y = 0x1p-72;
        return Mesh::create({Vec3(x, -y, -y), Vec3(x, y, -y), Vec3(x, 0, y)}, {Triangle{0, 1, 2}});
    };
    const BodyId a = world.create_body(triangle(0), at(0));
    const BodyId later = world.create_body(triangle(4.4 * 0x1p-74), at(0));
    world.create_body(triangle(3.6 * 0x1p-74), at(0));
    for (const environment::FloatMode& mode : environment::float_modes) {
        SCOPED_TRACE(mode.name);
        std::optional<BodyContact> first;
        {
            const environment::InFloatMode in(mode);
            first = world.cast(a, Vec3(0x1p1000, 0, 0), 1, memory);
        }
        ASSERT_TRUE(first);
        EXPECT_EQ(first->body, later);
        EXPECT_EQ(first->contact.time, 0x1p-1072);
    }
}

TEST_P(WorldCastTest, TheFirstIsOfNowAndTiesGoToTheLeastIds) {
    const BodyId a = world.create_body(cube, at(0));
    EXPECT_EQ(world.cast(a, Vec3(8, 0, 0)), std::nullopt);
    const BodyId b = world.create_body(cube, at(5));
    const BodyId c = world.create_body(cube, at(5, 0.5));
    ASSERT_TRUE(world.cast(a, Vec3(8, 0, 0)));
    EXPECT_EQ(world.cast(a, Vec3(8, 0, 0))->body, b);
    EXPECT_EQ(world.cast(a, Vec3(8, 0, 0))->contact.time, 0.5);
    EXPECT_EQ(world.cast(c, Vec3(-8, 0, 0))->body, b) << "which it touches at the start";
    EXPECT_EQ(world.cast(c, Vec3(-8, 0, 0))->contact.kind, ClosestKind::intersecting);
    world.set_pose(c, at(3, 0.5));
    EXPECT_EQ(world.cast(a, Vec3(8, 0, 0), 1, memory)->body, c);
    EXPECT_EQ(world.cast(a, Vec3(8, 0, 0), 0.25)->contact.time, 0.25);
    EXPECT_EQ(world.cast(a, Vec3(8, 0, 0), std::nextafter(0.25, 0)), std::nullopt);
    EXPECT_EQ(world.cast(a, Vec3(1, 0, 0), infinity), std::nullopt) << "no time is above 1";
    EXPECT_EQ(world.cast({cube, at(9)}, Vec3(-8, 0, 0))->body, b);
    EXPECT_EQ(world.cast({cube, at(9)}, Vec3(-8, 0, 0))->contact.time, 0.375);
}

// The time of the first contact is 1/3, above the double nearest to it.
TEST_P(WorldCastTest, TheLimitIsForTheRealTime) {
    const BodyId a = world.create_body(cube, at(0));
    const BodyId b = world.create_body(cube, at(2));
    const double third = 1.0 / 3;
    ASSERT_TRUE(world.cast(a, Vec3(3, 0, 0)));
    EXPECT_EQ(world.cast(a, Vec3(3, 0, 0))->contact.time, third);
    EXPECT_EQ(world.cast(a, Vec3(3, 0, 0), third), std::nullopt);
    EXPECT_EQ(world.cast(a, Vec3(3, 0, 0), std::nextafter(third, 1))->body, b);
    EXPECT_EQ(world.cast({cube, at(0, 100)}, Vec3(3, 0, 0), third), std::nullopt);
}

// The body of the greater id is asked first, as its box is met earlier; its time, rounded, is below the real one.
TEST_P(WorldCastTest, TiesOfRoundedTimesAreFoundAboveThem) {
    const Vec3 p(1.5, -2, -2), q(1.5, 2, -2), r(1.5, 0, 3), beside(0.75, 9, 0);
    const BodyId a = world.create_body(cube, at(0));
    const BodyId b = world.create_body(Mesh::create({p, q, r}, {{0, 1, 2}}), at(0));
    const BodyId c = world.create_body(Mesh::create({p, q, r, beside}, {{0, 1, 2}, {1, 2, 3}}), at(0));
    ASSERT_LT(b, c);
    ASSERT_EQ(world.cast(a, Vec3(3, 0, 0))->contact.time, 1.0 / 3);
    EXPECT_EQ(world.cast(a, Vec3(3, 0, 0))->body, b);
    world.set_pose(b, at(0x1p-50));
    EXPECT_EQ(world.cast(a, Vec3(3, 0, 0))->body, c);
}

TEST_P(WorldCastTest, FiltersApply) {
    const BodyId a = world.create_body(cube, at(0));
    const BodyId b = world.create_body(cube, at(2));
    const BodyId c = world.create_body(cube, at(4));
    world.set_pair_enabled(a, b, false);
    EXPECT_EQ(world.cast(a, Vec3(8, 0, 0))->body, c);
    world.set_filter(c, {.groups = 2});
    EXPECT_EQ(world.cast({{cube, at(0)}, CollisionFilter{.mask = 2}}, Vec3(8, 0, 0))->body, c);
    EXPECT_EQ(world.cast({{cube, at(0)}, CollisionFilter{.mask = 4}}, Vec3(8, 0, 0)), std::nullopt);
    const auto meetings = world.meetings({&a, 1}, std::vector{at(8)});
    ASSERT_EQ(meetings.size(), 1u);
    EXPECT_EQ(meetings[0].bodies, (BodyPair{a, c}));
    EXPECT_EQ(meetings[0].contact.time, 0.375);
}

// Pairs that stay where they are and collide are among those that meet, as filters and switches are now.
TEST_P(WorldCastTest, PairsThatStayMeetAtTheStart) {
    const BodyId a = world.create_body(cube, at(0)), b = world.create_body(cube, at(0.5));
    const BodyId c = world.create_body(cube, at(20)), d = world.create_body(cube, at(20.5));
    const BodyId far = world.create_body(cube, at(100));
    world.set_pair_enabled(a, b, false);
    world.update();
    const auto pairs_met = [&] {
        std::vector<BodyPair> pairs;
        for (const Meeting& meeting : world.meetings({&far, 1}, std::vector{at(200)})) {
            EXPECT_EQ(meeting.contact.time, 0);
            EXPECT_EQ(meeting.contact.kind, ClosestKind::intersecting);
            pairs.push_back(meeting.bodies);
        }
        return pairs;
    };
    using Pairs = std::vector<BodyPair>;
    EXPECT_EQ(pairs_met(), (Pairs{{c, d}}));
    world.set_pair_enabled(a, b, true);
    EXPECT_EQ(pairs_met(), (Pairs{{a, b}, {c, d}}));
    world.set_pair_enabled(c, d, false);
    EXPECT_EQ(pairs_met(), (Pairs{{a, b}}));
    world.set_filter(d, {.groups = 2, .mask = 2});
    world.set_pair_enabled(c, d, true);
    EXPECT_EQ(pairs_met(), (Pairs{{a, b}}));
    world.set_filter(d, {});
    EXPECT_EQ(pairs_met(), (Pairs{{a, b}, {c, d}}));
    world.set_pose(b, at(0.75));
    EXPECT_EQ(pairs_met(), (Pairs{{a, b}, {c, d}})) << "moved since the update";
    world.destroy_body(c);
    EXPECT_EQ(pairs_met(), (Pairs{{a, b}}));
    const BodyId fresh = world.create_body(cube, at(20.25));
    const BodyPair of_fresh = d < fresh ? BodyPair{d, fresh} : BodyPair{fresh, d};
    Pairs expected = {{a, b}, of_fresh};
    std::ranges::sort(expected);
    EXPECT_EQ(pairs_met(), expected);
    world.update();
    EXPECT_EQ(pairs_met(), expected);
}

TEST_P(WorldCastTest, BadArgumentsAreRefused) {
    const BodyId a = world.create_body(cube, at(0));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {-1.0, -infinity, nan}) {
        EXPECT_INVALID(world.cast(a, Vec3(1, 0, 0), bad), Argument::time);
        EXPECT_INVALID(world.cast({cube, at(0)}, Vec3(1, 0, 0), bad), Argument::time);
    }
    EXPECT_INVALID(world.cast(a, Vec3(1, infinity, 0)), Argument::motion);
    EXPECT_THROW(static_cast<void>(world.cast(BodyId{}, Vec3(1, 0, 0))), StaleBody);
    EXPECT_INVALID(world.cast({std::shared_ptr<const Mesh>(), at(0)}, Vec3(1, 0, 0)), Argument::null);
    EXPECT_INVALID(world.cast({cube, at(nan)}, Vec3(1, 0, 0)), Argument::pose);
    const std::vector<BodyId> bodies = {a, a};
    EXPECT_INVALID(world.meetings(bodies, std::vector{at(1)}), Argument::list_length);
    try {
        std::ignore = world.meetings(bodies, std::vector{at(1), at(0, infinity)});
        ADD_FAILURE();
    } catch (const InvalidArgument& error) {
        EXPECT_EQ(error.argument, Argument::pose);
        EXPECT_EQ(error.index, 1u);
        EXPECT_EQ(error.body, a);
    }
    try {
        std::ignore = world.meetings(std::vector{a, BodyId{}}, std::vector{at(1), at(0)});
        ADD_FAILURE();
    } catch (const StaleBody& error) {
        EXPECT_EQ(error.index, 1u);
    }
}

// Against asking all, while bodies move: casts, and moves of few and of many.
TEST_P(WorldCastTest, IsWhatAskingAllSays) {
    scenes::Random random(31);
    const std::array meshes = {scenes::cube(0.5), scenes::cube(0.125), scenes::cube(1)};
    const auto any_pose = [&] { return at(0.5 * random.below(16), random.uniform(0, 8), 0.25 * random.below(8)); };
    std::vector<BodyId> bodies;
    for (int i = 0; i < 70; ++i) bodies.push_back(world.create_body(meshes[random.below(3)], any_pose()));
    std::ranges::sort(bodies);
    std::size_t met = 0;
    for (int frame = 0; frame < 6; ++frame) {
        for (int i = 0; i < 5; ++i) {
            const BodyId own = bodies[random.below(70)];
            const Vec3 motion = 0.5 * (any_pose().t - any_pose().t);
            std::optional<BodyContact> expected;
            for (const BodyId body : bodies) {
                if (body == own) continue;
                const auto contact = ecods::cast(posed(own), motion, posed(body), 1, memory);
                if (contact && (!expected || contact->time < expected->contact.time)) {
                    expected = BodyContact{body, *contact};
                }
            }
            ASSERT_EQ(world.cast(own, motion), expected);
        }
        std::vector<BodyId> moved;
        std::vector<Pose> to;
        for (const BodyId body : bodies) {
            if (frame % 2 == 0 && random.below(20) != 0) continue;
            moved.push_back(body);
            to.push_back(world.pose(body));
            to.back().t += 0.25 * (any_pose().t - any_pose().t);
        }
        std::vector<Meeting> expected;
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            for (std::size_t j = i + 1; j < bodies.size(); ++j) {
                const auto way = [&](BodyId body) {
                    const auto found = std::ranges::find(moved, body);
                    return moving(body, found == moved.end() ? world.pose(body) : to[found - moved.begin()]);
                };
                const auto contact = ecods::cast(way(bodies[i]), way(bodies[j]), 1, memory);
                if (contact) expected.push_back({{bodies[i], bodies[j]}, *contact});
            }
        }
        std::ranges::stable_sort(expected, {}, [](const Meeting& m) { return m.contact.time; });
        ASSERT_EQ(world.meetings(moved, to), expected) << frame;
        met += expected.size();
        if (frame == 2) world.update();
        for (int i = 0; i < 15; ++i) world.set_pose(bodies[random.below(70)], any_pose());
        kept.clear();
    }
    EXPECT_GT(met, 100u);
}

}  // namespace
}  // namespace ecods::world_cast_test
