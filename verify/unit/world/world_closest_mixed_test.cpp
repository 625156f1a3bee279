// The closest pairs of worlds of all kinds of bodies: with the oracle, and what they must not depend on.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <sstream>
#include <utility>
#include <vector>

#include "ecods/export.hpp"
#include "ecods/rounded.hpp"
#include "ecods/solid.hpp"
#include "ecods/trace.hpp"
#include "judge/mixed_bodies.hpp"
#include "scenes/expect_invalid.hpp"
#include "scenes/random.hpp"
#include "scenes/thread_executor.hpp"
#include "unit/world/world_fixture.hpp"

namespace ecods::world_closest_mixed_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::uint64_t everything = ~std::uint64_t{0};

using ShapePtr = std::shared_ptr<const Shape>;

using Body = judge::MixedBody;

double distance_of(const Body& a, const Body& b) {
    return judge::MixedDistance(a, b).nearest();
}

// Two bodies and their distance.
struct Near {
    BodyPair bodies;
    double distance;
};

bool is_first(const Near& x, const Near& y) {
    return std::pair(x.distance, x.bodies) < std::pair(y.distance, y.bodies);
}

class MixedWorld : public testing::TestWithParam<BroadPhaseKind> {
  protected:
    double eighths(std::uint32_t count) { return 0.125 * random.below(count); }
    Vec3 point() { return {eighths(9) - 0.5, eighths(9) - 0.5, eighths(9) - 0.5}; }
    ShapePtr any_shape() {
        switch (random.below(9)) {
            case 0:
                return std::make_shared<MeshShape>(scenes::cube(0.5 + eighths(4)));
            case 1:
                return std::make_shared<Solid>(scenes::torus(4, 3, 0.5));
            case 2:
                return rounded(std::make_shared<MeshShape>(scenes::one_triangle({point(), point(), point()})),
                               eighths(4));
            case 3:
                return sphere(eighths(6), point());
            case 4:
                return std::make_shared<Solid>(scenes::cube(1));
            case 5:
                return std::make_shared<HalfSpace>(Vec3(random.below(3) - 1.0, random.below(3) - 1.0, 2),
                                                   -3 - eighths(9));
            default:
                return std::make_shared<ConvexSolid>(scenes::cube(0.25 + eighths(5)));
        }
    }
    Pose any_pose() {
        Pose pose = random.below(2) == 0 ? random.turned() : Pose();
        if (random.below(4) == 0) pose.R.col(0) *= -0.5;
        pose.t = 6 * point();
        return pose;
    }
    CollisionFilter any_filter() { return {1 + std::uint64_t{random.below(7)}, random.below(6) == 0 ? 0 : everything}; }
    void create() {
        Body body{{}, any_shape(), any_pose(), any_filter()};
        body.id = world.create_body({.shape = body.shape, .pose = body.pose, .filter = body.filter});
        bodies.push_back(std::move(body));
    }
    void change() {
        const std::size_t at = random.below(static_cast<std::uint32_t>(bodies.size()));
        switch (random.below(6)) {
            case 0:
                world.destroy_body(bodies[at].id);
                bodies.erase(bodies.begin() + static_cast<std::ptrdiff_t>(at));
                create();
                return;
            case 1:
                world.set_shape(bodies[at].id, bodies[at].shape = any_shape());
                return;
            case 2:
                world.set_filter(bodies[at].id, bodies[at].filter = any_filter());
                return;
            default:
                world.set_pose(bodies[at].id, bodies[at].pose = any_pose());
        }
    }
    std::vector<Near> expected_pairs() const {
        std::vector<Near> all;
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            for (std::size_t j = i + 1; j < bodies.size(); ++j) {
                if (!may_meet(bodies[i].filter, bodies[j].filter)) continue;
                const bool is_turned = bodies[j].id < bodies[i].id;
                const Body &a = bodies[is_turned ? j : i], &b = bodies[is_turned ? i : j];
                all.push_back({{a.id, b.id}, distance_of(a, b)});
            }
        }
        std::ranges::sort(all, is_first);
        return all;
    }
    const Body& body(BodyId id) const { return *std::ranges::find(bodies, id, &Body::id); }

    // Expects the points that the questions about the pair give.
    void expect_points(const ClosestPair& pair) const {
        const auto [a, b] = pair.bodies;
        const bool has_plane = body(a).is_half_space() || body(b).is_half_space();
        ASSERT_EQ(pair.points.has_value(), !body(a).is_half_space() || !body(b).is_half_space());
        if (!pair.points) return;
        EXPECT_EQ(pair.points->distance, pair.distance);
        if (!has_plane && !(body(a).is_convex() && body(b).is_convex())) {
            EXPECT_EQ(*pair.points, world.closest(a, b));
            EXPECT_FALSE(pair.direction);
            return;
        }
        const SignedDistance found = world.signed_distance(a, b);
        EXPECT_EQ(*pair.points,
                  (ClosestPoints{found.distance, found.kind, found.a, found.b, found.point_a, found.point_b}));
        EXPECT_EQ(pair.direction, found.distance <= 0 ? std::optional(found.direction) : std::nullopt);
    }

    void expect(double limit, std::uint64_t groups_a, std::uint64_t groups_b, std::vector<Near> all) {
        std::erase_if(all, [&](const Near& pair) {
            const std::uint64_t x = body(pair.bodies.a).filter.groups, y = body(pair.bodies.b).filter.groups;
            const bool counts =
                ((x & groups_a) != 0 && (y & groups_b) != 0) || ((x & groups_b) != 0 && (y & groups_a) != 0);
            return !counts || pair.distance > limit;
        });
        const std::vector<ClosestPair> got = world.closest_pairs(limit, groups_a, groups_b);
        ASSERT_EQ(got.size(), all.size());
        for (std::size_t i = 0; i < all.size(); ++i) {
            EXPECT_EQ(got[i].bodies, all[i].bodies);
            EXPECT_EQ(got[i].distance, all[i].distance);
            expect_points(got[i]);
        }
        EXPECT_EQ(world.closest_pairs(limit, groups_b, groups_a, memory), got);
        const auto first = got.empty() ? std::optional<ClosestPair>() : got.front();
        EXPECT_EQ(world.closest_pair(limit, groups_a, groups_b, memory), first);
        EXPECT_EQ(world.closest_pair(limit, groups_b, groups_a), first);
        QueryMemory unused;
        EXPECT_EQ(world.closest_pair(limit, groups_a, groups_b, unused), first);
        if (groups_a != everything || groups_b != everything) return;
        EXPECT_EQ(world.closest_pairs(limit), got);
        EXPECT_EQ(world.closest_pair(limit, memory), first);
    }

    scenes::Random random{29};
    World world{WorldOptions{GetParam()}};
    std::vector<Body> bodies;
    QueryMemory memory;
};

INSTANTIATE_TEST_SUITE_P(BroadPhases, MixedWorld, broad_phases(), broad_phase_name);

// The limits are no distances of the scene, which has them in eighths and as roots.
TEST_P(MixedWorld, AsTheOracleWhileBodiesChange) {
    constexpr double limit = 0.7001;
    for (int i = 0; i < 14; ++i) create();
    for (int frame = 0; frame < 5; ++frame) {
        const std::vector<Near> all = expected_pairs();
        expect(infinity, everything, everything, all);
        expect(limit, everything, everything, all);
        expect(limit, 1, 2, all);
        expect(infinity, 3, 6, all);  // which overlap
        expect(infinity, 4, 4, all);
        expect(limit, 0, 1, all);
        for (int i = 0; i < 4; ++i) change();
        if (frame % 2 == 0) world.update();  // on which no answer depends
    }
}

// A world of the same bodies, made at once and in the same order of ids.
TEST_P(MixedWorld, AsAFreshWorldInEverySetAndWithThreads) {
    for (int i = 0; i < 12; ++i) create();
    for (int frame = 0; frame < 4; ++frame) {
        for (int i = 0; i < 5; ++i) change();
        std::ranges::sort(bodies, {}, &Body::id);
        World fresh({.executor = std::make_shared<ThreadExecutor>(2)});
        for (const Body& body : bodies) {
            fresh.create_body({.shape = body.shape, .pose = body.pose, .filter = body.filter});
        }
        const auto slots_of = [&](const World& of, const std::vector<ClosestPair>& pairs) {
            const std::vector<BodyId> ids = of.bodies();
            std::vector<std::pair<std::ptrdiff_t, std::ptrdiff_t>> places;
            for (const ClosestPair& pair : pairs) {
                places.emplace_back(std::ranges::find(ids, pair.bodies.a) - ids.begin(),
                                    std::ranges::find(ids, pair.bodies.b) - ids.begin());
            }
            return places;
        };
        const std::vector<ClosestPair> got = world.closest_pairs(2, 3, 5), other = fresh.closest_pairs(2, 3, 5);
        EXPECT_EQ(slots_of(world, got), slots_of(fresh, other));
        for (std::size_t i = 0; i < std::min(got.size(), other.size()); ++i) {
            EXPECT_EQ(got[i].distance, other[i].distance);
            EXPECT_EQ(got[i].points, other[i].points);
        }
        for (const InstructionSet set : {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512}) {
            limit_instruction_set(set);
            EXPECT_EQ(world.closest_pairs(2, 3, 5), got);
            EXPECT_EQ(world.closest_pair(2, 3, 5), got.empty() ? std::optional<ClosestPair>() : got.front());
        }
        limit_instruction_set(supported_instruction_set());
    }
}

}  // namespace
}  // namespace ecods::world_closest_mixed_test
