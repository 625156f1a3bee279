// Convex solids of every family of convex_cases.hpp beside the oracle and beside how they were made; what parts them;
// the polytopes of I-COLLIDE's experiment, frame by frame; and numbers that other libraries got wrong.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "ecods/error.hpp"
#include "scenes/hard_pair_parts.hpp"
#include "scenes/lattice_hull.hpp"
#include "scenes/moving_polytopes.hpp"
#include "unit/query/expect_right.hpp"

namespace ecods {
namespace {

using judge::ConvexTruth;
using scenes::ConvexCase;
using scenes::Random;

// Of memory that other pairs have used, and with witnesses that others left.
class ConvexJudged : public testing::Test {
  protected:
    template <class Call>
    void for_each(std::uint32_t seed, int count, const Call& call) {
        scenes::for_each_case(scenes::convex_families(), seed, count, [&](const ConvexCase& made, Random& random) {
            call(judge::Judged<ConvexCase>(made).truth, random);
        });
    }

    QueryMemory memory_;
};

TEST_F(ConvexJudged, AsTheOracleAndAsTheRecipe) {
    auto kinds = expect_all_right(scenes::convex_families(), 1, 30);
    for (const char* kind : {"apart, vertex-vertex", "apart, vertex-edge", "apart, vertex-face", "apart, edge-edge",
                             "deep, face of a", "deep, face of b", "deep, edges", "touching, face of a"}) {
        EXPECT_GE(kinds[kind], 3) << kind;
    }
}

// Vectors that reach the depth along the normal part the interiors; of a thousand shorter ones none does.
TEST_F(ConvexJudged, NoShorterTranslationParts) {
    for_each(2, 2, [&](const ConvexTruth& truth, Random& random) {
        if (!truth.depth()) return;
        std::vector<Vec3> directions;
        for (int i = 0; i < 950; ++i) directions.push_back(random.uniform(0.9, 1) * random.direction());
        for (int i = 1; i <= 50; ++i) {
            const Vec3 beside = truth.depth()->direction + std::ldexp(1.0, -i) * random.direction();
            directions.push_back((1 - std::ldexp(1.0, -i)) * beside.normalized());
        }
        expect_none(truth.ask_translations(memory_, directions));
    });
}

TEST_F(ConvexJudged, BoundsHold) {
    for_each(3, 1, [&](const ConvexTruth& truth, Random&) { expect_none(truth.ask_bounds(memory_)); });
}

TEST_F(ConvexJudged, HullsOfPoints) {
    Random random(4);
    for (int i = 0; i < 120; ++i) {
        SCOPED_TRACE(i);
        const int size = scenes::hard::integer(random, 1, 3);
        const bool is_lattice = scenes::hard::coin(random);
        std::vector<Vec3> points(3 + random.below(14));
        for (Vec3& p : points) {
            p = is_lattice
                    ? Vec3(scenes::hard::integer(random, -size, size), scenes::hard::integer(random, -size, size),
                           scenes::hard::integer(random, -size, size))
                    : random.direction();
        }
        if (random.below(4) == 0) {
            for (Vec3& p : points) p[2] = 1;
        }
        ASSERT_NO_FATAL_FAILURE(expect_none(judge::ask_for_hull(points)));
    }
}

// A dent of one ulp is one.
TEST_F(ConvexJudged, WhetherAMeshIsConvex) {
    Random random(5);
    std::array<int, 2> counts{};
    for (int i = 0; i < 150; ++i) {
        SCOPED_TRACE(i);
        const auto whole = scenes::to_mesh(scenes::refined(scenes::random_lattice_hull(3, 6, random)), 0.5);
        std::vector<Vec3> vertices(whole->vertices().begin(), whole->vertices().end());
        const auto index = random.below(static_cast<std::uint32_t>(vertices.size()));
        double& x = vertices[index][scenes::hard::integer(random, 0, 2)];
        if (random.below(3) != 0) scenes::hard::nudge(x, random);
        const auto mesh = Mesh::create(std::move(vertices), {whole->triangles().begin(), whole->triangles().end()});
        ++counts[oracle::convex_features(*mesh) ? 1 : 0];
        ASSERT_NO_FATAL_FAILURE(expect_none(judge::ask_whether_convex(mesh)));
        try {
            const ConvexSolid solid(mesh);
        } catch (const NotSolid& error) {
            ASSERT_EQ(error.reason, NotSolid::Reason::dent);
            const auto triangle = static_cast<std::uint32_t>(error.triangle);
            const auto corner = static_cast<std::uint32_t>(error.corner);
            EXPECT_EQ(error.vertices[0], mesh->triangles()[triangle][corner]);
            EXPECT_EQ(error.vertices[1], mesh->triangles()[triangle][(corner + 1) % 3]);
            EXPECT_TRUE(oracle::is_bent(*mesh, triangle, corner, static_cast<std::uint32_t>(error.beyond)));
        }
    }
    for (const int count : counts) EXPECT_GT(count, 10);
}

// Two tetrahedra of subnormal corners that are apart by less than the least double: it was 0 once.
TEST(ConvexTruths, DistancesBelowTheLeastDouble) {
    const double u = 0x1p-1074;
    Pose turned, moved;
    turned.R << 0x1.065e0b6984d66p-1, -0x1.cd358c7f6ff1cp-4, 0x1.b3df07b399f1dp-1,  //
        -0x1.b6387c9b71028p-1, 0x1.b68f9eba595p-7, 0x1.08b01c9c01a6fp-1,            //
        -0x1.1d19828faf5d8p-4, -0x1.fcb29eef3f521p-1, -0x1.6ea82fbfa13cp-4;
    moved.t = Vec3(-3 * u, -3 * u, -2 * u);
    const ConvexSolid a(
        Mesh::create({Vec3(-2 * u, 2 * u, -2 * u), Vec3(2 * u, u, -2 * u), Vec3(u, 0, 2 * u), Vec3(u, -u, u)},
                     {{0, 1, 3}, {0, 2, 1}, {0, 3, 2}, {1, 2, 3}}));
    const ConvexSolid b(
        Mesh::create({Vec3(-2 * u, -u, u), Vec3(2 * u, -u, 0), Vec3(u, 2 * u, u), Vec3(2 * u, 2 * u, -2 * u)},
                     {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {2, 1, 3}}));
    const ConvexTruth truth({a, turned}, {b, moved});
    EXPECT_EQ(truth.distance(), u);
    QueryMemory memory;
    PairWitness witness;
    expect_none(truth.ask(memory, witness));
}

// Pairs whose centers are near each other are judged in each frame, with a witness each, as a program keeps them. By
// ECODS_POLYTOPES and ECODS_POLYTOPE_FRAMES there are more: 1000 and 100 take some minutes.
TEST(Polytopes, EachFrameAsTheOracle) {
    const auto number = [](const char* name, int otherwise) {
        const char* text = std::getenv(name);
        return text != nullptr ? std::atoi(text) : otherwise;
    };
    scenes::MovingPolytopes polytopes(
        {.count = static_cast<std::size_t>(number("ECODS_POLYTOPES", 60)), .density = 0.2});
    std::deque<ConvexSolid> solids;  // which do not move
    for (const auto& mesh : polytopes.meshes()) solids.emplace_back(mesh);
    std::map<std::pair<std::size_t, std::size_t>, PairWitness> witnesses;
    std::map<std::string, int> kinds;
    QueryMemory memory;
    for (int frame = number("ECODS_POLYTOPE_FRAMES", 5); frame > 0; --frame) {
        polytopes.step();
        for (std::size_t i = 0; i < solids.size(); ++i) {
            for (std::size_t j = i + 1; j < solids.size(); ++j) {
                const Pose &p = polytopes.poses()[i], &q = polytopes.poses()[j];
                if ((p.t - q.t).norm() > 2) continue;
                const ConvexTruth truth({solids[i], p}, {solids[j], q});
                ++kinds[truth.depth() ? "deep" : "apart"];
                ASSERT_NO_FATAL_FAILURE(expect_none(truth.ask(memory, witnesses[{i, j}]))) << i << ", " << j;
            }
        }
    }
    EXPECT_GE(kinds["deep"], 5);
    EXPECT_GE(kinds["apart"], 5);
}

// Configurations that were reported and are no row of the hard cases. libccd's #25: cubes of side 2, of which GJK and
// EPA found a depth of 0 and no direction.
TEST(ConvexHardCases, KnownNumbers) {
    QueryMemory memory;
    const ConvexSolid cube(scenes::to_mesh(scenes::box({-1, -1, -1}, {1, 1, 1}), 1));
    Pose above;
    above.t = Vec3(0, 0, 1.9);
    const Depth found = depth({cube, Pose()}, {cube, above}, memory).value();
    EXPECT_EQ(found.depth, 2 - 1.9);
    EXPECT_EQ(found.direction, Vec3(0, 0, 1));
    // fcl#545: a small cube on the diagonal of a large one, of which collide() left along that diagonal.
    const ConvexSolid large(scenes::to_mesh(scenes::box({-1, -1, -1}, {1, 1, 1}), 0.5));
    const ConvexSolid small(scenes::to_mesh(scenes::box({-1, -1, -1}, {1, 1, 1}), 0x1p-3));
    Pose corner;
    corner.t = Vec3(0.375, 0.375, 0.375);
    const Depth out = depth({large, Pose()}, {small, corner}, memory).value();
    EXPECT_EQ(out.depth, 0.25);
    EXPECT_EQ(out.direction.cwiseAbs().sum(), 1);
    // fcl#508: unit cubes, 4 apart along y: 3, where FCL said 3.16.
    Pose beside;
    beside.t = Vec3(0, 4, 0);
    EXPECT_EQ(distance({large, beside}, {large, Pose()}, memory), 3);
}

}  // namespace
}  // namespace ecods
