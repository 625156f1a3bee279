// Bodies that jump in and out of each other, and change between surfaces and solids: every list and question of a world
// against the questions about two bodies, one pair after the other.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "ecods/cast.hpp"
#include "ecods/distance.hpp"
#include "ecods/hit.hpp"
#include "ecods/intersection.hpp"
#include "ecods/solid.hpp"
#include "scenes/random.hpp"
#include "unit/world/world_fixture.hpp"

namespace ecods::world_bodies_test {
namespace {

class WorldBodiesTest : public EachWorld {
  protected:
    Posed<MeshShape> posed(BodyId body) const {
        return {static_cast<const MeshShape&>(*world.shape(body)), world.pose(body)};
    }
    template <class Look>
    void for_all_pairs(const Look& look) const {
        const std::vector<BodyId> bodies = world.bodies();
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            for (std::size_t j = i + 1; j < bodies.size(); ++j) look(BodyPair{bodies[i], bodies[j]});
        }
    }

    // The distance that ClosestPair promises; all poses here are regular.
    double signed_distance(const BodyPair& pair) {
        const bool are_convex =
            posed(pair.a).what->form() == MeshForm::convex && posed(pair.b).what->form() == MeshForm::convex;
        return are_convex ? world.signed_distance(pair.a, pair.b).distance
                          : distance(posed(pair.a), posed(pair.b), memory);
    }

    void expect_lists(double clearance) {
        std::vector<BodyPair> colliding, close;
        std::vector<PairRelation> relations;
        for_all_pairs([&](const BodyPair& pair) {
            const auto a = posed(pair.a), b = posed(pair.b);
            const Relation relation = ecods::relation(a, b, memory);
            ++relation_counts[relation];
            if (intersects(a, b, memory)) {
                colliding.push_back(pair);
                relations.push_back({pair, relation});
                contained_count += intersecting_triangles(a, b, memory).empty();
            }
            if (within(a, b, clearance, memory)) close.push_back(pair);
        });
        EXPECT_EQ(list(world.colliding_pairs()), colliding);
        EXPECT_EQ(list(world.close_pairs()), close);
        const std::span<const PairRelation> listed = world.relations();
        EXPECT_EQ(std::vector<PairRelation>(listed.begin(), listed.end()), relations);
        for (const BodyPair& pair : world.began()) EXPECT_FALSE(std::ranges::binary_search(last_colliding, pair));
        for (const BodyPair& pair : world.ended()) EXPECT_TRUE(std::ranges::binary_search(last_colliding, pair));
        EXPECT_EQ(colliding.size() + world.ended().size(), last_colliding.size() + world.began().size());
        last_colliding = colliding;
        world.check_invariants();
    }

    void expect_nearest(BodyId subject) {
        std::optional<NearestBody> expected;
        std::vector<BodyId> met;
        for (const BodyId body : world.bodies()) {
            if (body == subject) continue;
            const double d = distance(posed(subject), posed(body), memory);
            if (!expected || d < expected->distance) expected = {body, d};
            if (d == 0) met.push_back(body);
        }
        EXPECT_EQ(world.nearest(subject), expected);
        EXPECT_EQ(world.intersecting_bodies(subject, memory), met);
        std::optional<std::pair<double, BodyPair>> closest;
        for_all_pairs([&](const BodyPair& pair) {
            const double d = signed_distance(pair);
            if (!closest || d < closest->first) closest = {d, pair};
        });
        const auto found = world.closest_pair();
        ASSERT_TRUE(found && closest);
        EXPECT_EQ(std::pair(found->distance, found->bodies), *closest);
    }

    // Ranks are those of real parameters, which are not rounded here or differ when rounded.
    void expect_hits(const Segment& segment) {
        std::vector<BodyHit> expected;
        for (const BodyId body : world.bodies()) {
            for (const Hit& hit : all_hits(segment, posed(body), memory)) expected.push_back({body, hit});
        }
        std::ranges::stable_sort(expected, {}, [](const BodyHit& each) { return each.hit.parameter; });
        rank_by_parameter(expected);
        const auto got = world.all_hits(segment);
        ASSERT_EQ(got.size(), expected.size());
        for (std::size_t i = 0; i < got.size(); ++i) {
            EXPECT_EQ(got[i].body, expected[i].body);
            EXPECT_EQ(got[i].hit.feature, expected[i].hit.feature);
            EXPECT_EQ(got[i].hit.kind, expected[i].hit.kind);
            EXPECT_EQ(got[i].hit.parameter, expected[i].hit.parameter);
            EXPECT_EQ(got[i].hit.rank, expected[i].hit.rank);
            inside_count += got[i].hit.kind == HitKind::inside;
        }
        const auto first = world.first_hit(segment, {}, memory);
        ASSERT_EQ(first.has_value(), !got.empty());
        if (!first) return;
        EXPECT_EQ(first->body, got[0].body);
        EXPECT_EQ(first->hit.feature, got[0].hit.feature);
        EXPECT_EQ(first->hit.kind, got[0].hit.kind);
    }

    void expect_casts(BodyId subject, const Vec3& motion) {
        std::optional<BodyContact> expected;
        std::vector<Meeting> meetings;
        Pose to = world.pose(subject);
        to.t += motion;
        for (const BodyId body : world.bodies()) {
            if (body == subject) continue;
            const auto contact = cast(posed(subject), motion, posed(body), 1, memory);
            if (contact && (!expected || contact->time < expected->contact.time)) expected = {body, *contact};
        }
        EXPECT_EQ(world.cast(subject, motion), expected);
        for_all_pairs([&](const BodyPair& pair) {
            const auto moving = [&](BodyId body) {
                const Pose from = world.pose(body);
                return Moving<MeshShape>(*posed(body).what, from, body == subject ? to : from);
            };
            const auto contact = cast(moving(pair.a), moving(pair.b), 1, memory);
            if (contact) meetings.push_back({pair, *contact});
        });
        std::ranges::stable_sort(meetings, {}, [](const Meeting& each) { return each.contact.time; });
        EXPECT_EQ(world.meetings(std::vector{subject}, std::vector{to}), meetings);
    }

    std::map<Relation, std::size_t> relation_counts;
    std::size_t contained_count = 0, inside_count = 0;
    std::vector<BodyPair> last_colliding;
};

INSTANTIATE_TEST_SUITE_P(BroadPhases, WorldBodiesTest, broad_phases(), broad_phase_name);

// A box with a cavity, a box with an antenna, and boxes and a sphere in every form.
std::vector<std::shared_ptr<const MeshShape>> shapes() {
    const auto joined = [](const Mesh& a, const Mesh& b) {
        std::vector<Vec3> vertices(a.vertices().begin(), a.vertices().end());
        std::vector<Triangle> triangles(a.triangles().begin(), a.triangles().end());
        const auto from = static_cast<std::uint32_t>(vertices.size());
        vertices.insert(vertices.end(), b.vertices().begin(), b.vertices().end());
        for (const Triangle& t : b.triangles()) triangles.push_back({from + t[0], from + t[1], from + t[2]});
        return Mesh::create(std::move(vertices), std::move(triangles));
    };
    const auto antenna = Mesh::create({Vec3(0, 0, 0), Vec3(4, 0, 0)}, {{0, 1, 0}});
    std::vector<std::shared_ptr<const MeshShape>> all{
        std::make_shared<const Solid>(joined(*scenes::cube(3), *scenes::cube(1.5))),
        std::make_shared<const Solid>(joined(*antenna, *scenes::cube(2))),
        std::make_shared<const ConvexSolid>(scenes::sphere(7, 5)->vertices())};
    for (const double half : {0.25, 1.0, 2.0}) {
        const auto solid = std::make_shared<const Solid>(scenes::cube(half));
        all.push_back(solid);
        all.push_back(surface_of(*solid));
        all.push_back(std::make_shared<const ConvexSolid>(scenes::cube(half)));
    }
    return all;
}

TEST_P(WorldBodiesTest, RandomJumps) {
    const auto all = shapes();
    scenes::Random random(12);
    const auto place = [&] {
        const auto coordinate = [&] { return 0.5 * (static_cast<double>(random.below(13)) - 6); };
        Pose pose = at(coordinate(), coordinate(), coordinate());
        switch (random.below(4)) {
            case 0:
                pose.R.row(1) *= -1;
                break;
            case 1:
                pose.R = random.rotation().toRotationMatrix();
                break;
            case 2:
                if (random.below(4) == 0) pose.R.col(2) = pose.R.col(0);  // flat
                break;
            default:
                break;
        }
        return pose;
    };
    const auto shape = [&] { return all[random.below(static_cast<std::uint32_t>(all.size()))]; };
    std::vector<BodyId> bodies;
    for (int i = 0; i < 14; ++i) bodies.push_back(world.create_body(shape(), place()));
    world.set_relations(true);
    for (int frame = 0; frame < 40; ++frame) {
        SCOPED_TRACE(frame);
        const auto pick = [&] { return bodies[random.below(static_cast<std::uint32_t>(bodies.size()))]; };
        for (int change = 0; change < 3; ++change) world.set_pose(pick(), place());
        world.set_shape(pick(), shape());
        const double clearance = frame % 8 < 4 ? 0.25 : 0;
        world.set_clearance(clearance);
        world.update();
        expect_lists(clearance);
        expect_nearest(pick());
        // A number below 1 that has few digits, so that no parameters but equal ones round alike.
        const Vec3 begin = world.pose(pick()).t + Vec3(0.375, 0.4375, 0.40625);
        expect_hits({begin, begin + Vec3(7, 1, -3)});
        expect_casts(pick(), Vec3(3, 1, 0.5));
    }
    EXPECT_GE(relation_counts.size(), 6U);
    EXPECT_GT(contained_count, 50U);
    EXPECT_GT(inside_count, 5U);
}

}  // namespace
}  // namespace ecods::world_bodies_test
