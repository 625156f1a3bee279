// A thousand polytopes that move in a box, as in I-COLLIDE's experiment, in a world: who is near and who is how deep,
// each frame, as the oracle has it.
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <memory>
#include <vector>

#include "ecods/world.hpp"
#include "oracle/convex.hpp"
#include "oracle/nearest.hpp"
#include "scenes/moving_polytopes.hpp"
#include "scenes/thread_executor.hpp"

namespace ecods::world_polytopes_test {
namespace {

constexpr double limit = 0.25;

using Pairs = std::map<BodyPair, double>;

// What the oracle says of all whose balls, of radius 1, are within the limit.
struct Truth {
    Pairs distances, depths;

    Truth(const scenes::MovingPolytopes& polytopes, const std::vector<BodyId>& ids) {
        const auto& meshes = polytopes.meshes();
        const auto& poses = polytopes.poses();
        for (std::size_t i = 0; i < ids.size(); ++i) {
            for (std::size_t j = i + 1; j < ids.size(); ++j) {
                if ((poses[i].t - poses[j].t).norm() > 2 + limit + 0x1p-20) continue;
                const oracle::ConvexPair pair(*meshes[i], poses[i], *meshes[j], poses[j]);
                const double distance = oracle::nearest(pair.distance());
                // Only of a distance that rounds to the limit it would be left open.
                if (distance <= limit) distances[{ids[i], ids[j]}] = distance;
                if (distance > 0) continue;
                const double depth = oracle::nearest(pair.depth()->depth);
                depths[{ids[i], ids[j]}] = depth;
                distances[{ids[i], ids[j]}] = -depth;
            }
        }
    }
};

template <class Found, class Number>
Pairs pairs_of(const std::vector<Found>& found, const Number& number) {
    Pairs pairs;
    for (const Found& one : found) pairs[one.bodies] = number(one);
    EXPECT_EQ(pairs.size(), found.size());
    return pairs;
}

// Of two worlds with the same bodies.
template <class Found, class IsSame>
void expect_same(const std::vector<Found>& x, const std::vector<Found>& y, const IsSame& is_same) {
    ASSERT_EQ(x.size(), y.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        EXPECT_EQ(x[i].bodies.a.slot, y[i].bodies.a.slot);
        EXPECT_EQ(x[i].bodies.b.slot, y[i].bodies.b.slot);
        EXPECT_TRUE(is_same(x[i], y[i]));
    }
}

// By ECODS_POLYTOPES and ECODS_POLYTOPE_FRAMES there are more or fewer.
TEST(WorldPolytopes, AThousandInEachFrameAsTheOracle) {
    const auto number = [](const char* name, int otherwise) {
        const char* text = std::getenv(name);
        return text != nullptr ? std::atoi(text) : otherwise;
    };
    scenes::MovingPolytopes polytopes({.count = static_cast<std::size_t>(number("ECODS_POLYTOPES", 1000))});
    World world, parallel({.executor = std::make_shared<ThreadExecutor>(2)});
    std::vector<BodyId> ids, parallel_ids;
    for (std::size_t i = 0; i < polytopes.meshes().size(); ++i) {
        const auto solid = std::make_shared<const ConvexSolid>(polytopes.meshes()[i]);
        ids.push_back(world.create_body(solid, polytopes.poses()[i]));
        parallel_ids.push_back(parallel.create_body(solid, polytopes.poses()[i]));
    }
    std::size_t near = 0, deep = 0;
    for (int frame = number("ECODS_POLYTOPE_FRAMES", 3); frame > 0; --frame) {
        polytopes.step();
        world.set_poses(ids, polytopes.poses());
        parallel.set_poses(parallel_ids, polytopes.poses());
        const Truth truth(polytopes, ids);
        const std::vector<PairDistance> distances = world.signed_distances(limit);
        const std::vector<BodyDepth> depths = world.depths();
        EXPECT_EQ(pairs_of(distances, [](const PairDistance& found) { return found.distance; }), truth.distances);
        EXPECT_EQ(pairs_of(depths, [](const BodyDepth& found) { return found.depth.depth; }), truth.depths);
        expect_same(distances, parallel.signed_distances(limit),
                    [](const PairDistance& a, const PairDistance& b) { return a.distance == b.distance; });
        expect_same(depths, parallel.depths(),
                    [](const BodyDepth& a, const BodyDepth& b) { return a.depth.depth == b.depth.depth; });
        near += distances.size();
        deep += depths.size();
    }
    EXPECT_GE(near, 100u);
    EXPECT_GE(deep, 20u);
}

}  // namespace
}  // namespace ecods::world_polytopes_test
