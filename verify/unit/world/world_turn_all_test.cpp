// Casts and meetings of bodies in any motion are what asking all of them one by one says.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "scenes/random.hpp"
#include "unit/world/own_meshes.hpp"
#include "unit/world/world_fixture.hpp"

namespace ecods::world_turn_all_test {
namespace {

class WorldTurnAllTest : public EachWorld {
  protected:
    void create_bodies() {
        world.set_test(own_kind, own_kind, std::make_shared<OwnTest>(true));
        world.set_test(own_kind, ShapeKind::mesh(), std::make_shared<OwnTest>(true));
        const std::array meshes = {scenes::cube(0.5), scenes::cube(0.125), scenes::cube(1)};
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
    }

    Pose any_pose() { return at(0.5 * random.below(16), random.uniform(0, 8), 0.25 * random.below(8)); }
    Vec3 any_way() { return any_pose().t - any_pose().t; }
    Turn any_turn(BodyId body) {
        const auto part = [&] { return 0.25 * (static_cast<double>(random.below(9)) - 4); };
        Turn turn{{part(), part(), part(), part()}, world.pose(body).t, world.pose(body).t};
        if (random.below(4) == 0) turn.q = {1, 0, 0, 0};
        if (turn.q.w <= 0 && turn.q.x == 0 && turn.q.y == 0 && turn.q.z == 0) turn.q = {0, 0, 1, 0};
        if (random.below(2) == 0) turn.pivot_from = turn.pivot_to = any_pose().t;
        if (random.below(2) == 0) turn.pivot_to += 0.25 * any_way();
        return turn;
    }
    Along any_nodes(BodyId body) {
        Along along{{{{1, 0, 0, 0}, random.below(2) == 0 ? world.pose(body).t : any_pose().t}}};
        for (auto left = 2 + random.below(3); left > 0; --left) {
            const Turn turn = any_turn(body);
            along.nodes.push_back({turn.q, random.below(2) == 0 ? along.nodes.back().pivot : turn.pivot_to});
        }
        try {
            validate(along.nodes);
        } catch (const InvalidArgument&) {  // a quaternion opposite to the one before
            along.nodes.resize(2);
            along.nodes[1].q = {1, 0, 0, 1};
        }
        return along;
    }
    Motion any_motion(BodyId body) {
        const auto kind = random.below(9);
        if (kind < 4) return any_turn(body);
        if (kind < 7) return any_nodes(body);
        return kind == 7 ? Motion(Straight{any_pose()}) : Translation{any_way()};
    }

    bool are_of_one_kind(BodyId a, BodyId b) const { return world.shape(a)->kind() == world.shape(b)->kind(); }
    Posed<MeshShape> posed(BodyId body) {
        kept.push_back(world.shape(body));
        return mesh_at({*kept.back(), world.pose(body)});
    }

    std::optional<BodyContact> first_met(BodyId own, const Motion& motion, double max_time) {
        std::optional<BodyContact> first;
        const Posed<MeshShape> moved = posed(own);
        for (const BodyId body : world.bodies()) {
            if (body == own) continue;
            const auto* const turn = std::get_if<Turn>(&motion);
            const auto contact = turn != nullptr ? cast(Turning<MeshShape>(*moved.what, moved.pose, *turn), posed(body),
                                                        max_time, memory)
                                                 : cast(moved, motion, posed(body), Motion(), max_time, memory);
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
                const auto contact =
                    cast(posed(bodies[i]), motion_of(bodies[i]), posed(bodies[j]), motion_of(bodies[j]), 1, memory);
                if (contact) meetings.push_back({{bodies[i], bodies[j]}, *contact});
            }
        }
        std::ranges::stable_sort(meetings, {}, [](const Meeting& m) { return m.contact.time; });
        return meetings;
    }

    // Where kinds differ, the test gets its own kind first, and chooses among ties so.
    void expect_same(const std::vector<Meeting>& got, const std::vector<Meeting>& expected) {
        ASSERT_EQ(got.size(), expected.size());
        for (std::size_t i = 0; i < got.size(); ++i) {
            ASSERT_EQ(got[i].bodies, expected[i].bodies);
            ASSERT_EQ(got[i].contact.time, expected[i].contact.time);
            EXPECT_TRUE(got[i].contact == expected[i].contact || !are_of_one_kind(got[i].bodies.a, got[i].bodies.b));
        }
    }

    scenes::Random random{17};
    std::vector<std::shared_ptr<const Shape>> kept;
};

INSTANTIATE_TEST_SUITE_P(BroadPhases, WorldTurnAllTest, broad_phases(), broad_phase_name);

TEST_P(WorldTurnAllTest, Casts) {
    create_bodies();
    const auto bodies = world.bodies();
    std::size_t met = 0;
    for (int i = 0; i < 40; ++i) {
        const BodyId own = bodies[random.below(50)];
        const Motion motion = any_motion(own);
        const double max_time = random.below(3) == 0 ? random.uniform(0, 1) : 1;
        const auto expected = first_met(own, motion, max_time);
        const auto got = world.cast(own, motion, max_time);
        ASSERT_EQ(got.has_value(), expected.has_value());
        if (i % 8 == 0) world.update();
        if (i % 4 == 0) world.set_pose(bodies[random.below(50)], any_pose());
        if (!got) continue;
        EXPECT_EQ(got->body, expected->body);
        EXPECT_EQ(got->contact.time, expected->contact.time);
        EXPECT_TRUE(got->contact == expected->contact || !are_of_one_kind(got->body, own));
        ++met;
    }
    EXPECT_GT(met, 15u);
}

TEST_P(WorldTurnAllTest, Meetings) {
    create_bodies();
    const auto bodies = world.bodies();
    std::size_t met = 0;
    for (int frame = 0; frame < 8; ++frame) {
        const bool are_straight = frame >= 4, is_way = frame >= 6;
        std::vector<BodyId> moved;
        std::vector<Motion> motions;
        for (const BodyId body : bodies) {
            if (is_way ? !moved.empty() : random.below(frame % 2 == 0 ? 10 : 2) != 0) continue;
            moved.push_back(body);
            const Translation by{random.below(3) == 0 ? Vec3(0, 0, 0) : Vec3(0.25 * any_way())};
            motions.push_back(are_straight || random.below(3) == 0 ? Motion(Straight{any_pose()}) : by);
        }
        if (!are_straight && !moved.empty()) motions.front() = any_turn(moved.front());
        if (is_way) motions.front() = any_nodes(moved.front());
        const auto got = world.meetings(moved, motions);
        expect_same(got, all_meetings(moved, motions));
        if (are_straight && !is_way) {
            std::vector<Pose> poses;
            for (const Motion& motion : motions) poses.push_back(std::get<Straight>(motion).to);
            EXPECT_EQ(world.meetings(moved, poses), got);
        }
        met += got.size();
        if (frame == 2) world.update();
        for (int i = 0; i < 10; ++i) world.set_pose(bodies[random.below(50)], any_pose());
    }
    EXPECT_GT(met, 100u);
}

}  // namespace
}  // namespace ecods::world_turn_all_test
