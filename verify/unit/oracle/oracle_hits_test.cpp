// The oracle's hits: answers made by hand, and what must hold of any.
#include "oracle/hits.hpp"

#include <gtest/gtest.h>

#include <cfenv>
#include <limits>

#include "scenes/hit_cases.hpp"

namespace ecods::oracle::oracle_hits_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Body {
    std::vector<Vec3> vertices{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};
    std::vector<Triangle> triangles{{0, 1, 2}};
    Pose pose;

    std::vector<ExactHit> hits(const ExactLine& line) const { return all_hits(line, {vertices, triangles, pose}); }
    ExactHit hit(const Vec3& from, const Vec3& to) const {
        const auto all = hits({from, to});
        EXPECT_EQ(all.size(), 1U);
        return all.empty() ? ExactHit() : all[0];
    }
};

void expect(const ExactHit& hit, HitWay way, const NamedFeature& feature, const mpq_class& enter,
            const mpq_class& leave) {
    EXPECT_EQ(hit.way, way);
    EXPECT_EQ(hit.feature, feature);
    EXPECT_EQ(hit.enter, enter);
    EXPECT_EQ(hit.leave, leave);
}

void expect(const ExactHit& hit, HitWay way, const NamedFeature& feature, const mpq_class& at) {
    expect(hit, way, feature, at, at);
}

TEST(OracleHits, ThroughAFaceAnEdgeAndAVertex) {
    const Body body;
    expect(body.hit(Vec3(1, 1, 1), Vec3(1, 1, -2)), HitWay::front, {2, 0, 0}, mpq_class(1, 3));
    expect(body.hit(Vec3(1, 1, -2), Vec3(1, 1, 1)), HitWay::back, {2, 0, 0}, mpq_class(2, 3));
    expect(body.hit(Vec3(2, 0, 1), Vec3(2, 0, -1)), HitWay::edge, {1, 0, 0}, mpq_class(1, 2));
    expect(body.hit(Vec3(1, 3, 1), Vec3(1, 3, 0)), HitWay::edge, {1, 0, 1}, 1);
    expect(body.hit(Vec3(0, 4, 0), Vec3(0, 4, 7)), HitWay::vertex, {0, 0, 2}, 0);
    EXPECT_TRUE(body.hits({Vec3(3, 3, 1), Vec3(3, 3, -1)}).empty());
    EXPECT_TRUE(body.hits({Vec3(1, 1, 2), Vec3(1, 1, 0x1p-1074)}).empty());
}

TEST(OracleHits, InThePlane) {
    const Body body;
    expect(body.hit(Vec3(-1, 1, 0), Vec3(5, 1, 0)), HitWay::along, {2, 0, 0}, mpq_class(1, 6), mpq_class(2, 3));
    expect(body.hit(Vec3(-4, 0, 0), Vec3(4, 0, 0)), HitWay::along, {1, 0, 0}, mpq_class(1, 2), 1);
    expect(body.hit(Vec3(1, 1, 0), Vec3(2, 1, 0)), HitWay::along, {2, 0, 0}, 0, 1);
    expect(body.hit(Vec3(-1, 1, 0), Vec3(1, -1, 0)), HitWay::vertex, {0, 0, 0}, mpq_class(1, 2));
    expect(body.hit(Vec3(-1, 1, 0), Vec3(0, 1, 0)), HitWay::edge, {1, 0, 2}, 1);
    EXPECT_TRUE(body.hits({Vec3(-1, 0, 0), Vec3(0, -1, 0)}).empty());
    EXPECT_TRUE(body.hits({Vec3(-1, 1, 1), Vec3(5, 1, 1)}).empty());
}

TEST(OracleHits, OfOnePoint) {
    const Body body;
    expect(body.hit(Vec3(1, 1, 0), Vec3(1, 1, 0)), HitWay::face, {2, 0, 0}, 0);
    expect(body.hit(Vec3(2, 2, 0), Vec3(2, 2, 0)), HitWay::edge, {1, 0, 1}, 0);
    expect(body.hit(Vec3(4, 0, 0), Vec3(4, 0, 0)), HitWay::vertex, {0, 0, 1}, 0);
    EXPECT_TRUE(body.hits({Vec3(1, 1, 1), Vec3(1, 1, 1)}).empty());
    // A ray that ends where it begins has a direction.
    const auto of_ray = [&](const Vec3& direction) { return body.hits({Vec3(1, 1, 0), direction, true, 0}).at(0).way; };
    EXPECT_EQ(of_ray(Vec3(0, 0, -1)), HitWay::front);
    EXPECT_EQ(of_ray(Vec3(0, 0, 1)), HitWay::back);
    EXPECT_EQ(of_ray(Vec3(1, 0, 0)), HitWay::face);
}

TEST(OracleHits, OfTrianglesWithoutArea) {
    Body body;
    body.vertices = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(4, 0, 0)};  // edge 2 is all of it
    expect(body.hit(Vec3(-1, 0, 0), Vec3(3, 0, 0)), HitWay::along, {1, 0, 2}, mpq_class(1, 4), 1);
    expect(body.hit(Vec3(2, 0, 0), Vec3(3, 0, 0)), HitWay::along, {1, 0, 1}, 0, 1);
    expect(body.hit(Vec3(1, -1, 0), Vec3(1, 1, 0)), HitWay::vertex, {0, 0, 1}, mpq_class(1, 2));
    expect(body.hit(Vec3(0.5, -1, 0), Vec3(0.5, 1, 0)), HitWay::edge, {1, 0, 0}, mpq_class(1, 2));
    expect(body.hit(Vec3(4, 0, 0), Vec3(5, 0, 0)), HitWay::vertex, {0, 0, 2}, 0);
    body.vertices = {Vec3(1, 1, 1), Vec3(1, 1, 1), Vec3(1, 1, 2)};  // edge 0 is a point, edges 1 and 2 are one
    expect(body.hit(Vec3(1, 1, 0), Vec3(1, 1, 4)), HitWay::along, {1, 0, 1}, mpq_class(1, 4), mpq_class(1, 2));
    expect(body.hit(Vec3(0, 0, 0), Vec3(1, 1, 1)), HitWay::vertex, {0, 0, 0}, 1);
    body.pose.R.setZero();
    expect(body.hit(Vec3(0, 0, 0), Vec3(1, 0, 0)), HitWay::vertex, {0, 0, 0}, 0);
}

TEST(OracleHits, TheEndOfARay) {
    const Body body;
    const auto hits = [&](double end) { return body.hits({Vec3(1, 1, 1), Vec3(0, 0, -3), true, end}); };
    EXPECT_EQ(hits(infinity).size(), 1U);
    // A third lies above the nearest double.
    EXPECT_EQ(hits(1.0 / 3).size(), 0U);
    EXPECT_EQ(hits(0x1.5555555555556p-2).size(), 1U);
    EXPECT_EQ(nearest_parameter(hits(infinity)[0].enter), 1.0 / 3);
    expect(body.hits({Vec3(1, 1, 0), Vec3(1, 0, 0), true, 0.25}).at(0), HitWay::along, {2, 0, 0}, 0, mpq_class(1, 4));
    EXPECT_EQ(nearest_parameter(mpq_class(1, mpz_class(1) << 2000)), 0x1p-1074);
}

TEST(OracleHits, AscendingWithRanks) {
    Body body;
    body.vertices = {Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0), Vec3(0, 0, 1), Vec3(4, 0, 1), Vec3(0, 4, 1)};
    body.triangles = {{3, 4, 5}, {0, 1, 2}, {0, 2, 1}, {3, 4, 5}};
    const auto hits = body.hits({Vec3(1, 1, -1), Vec3(1, 1, 3)});
    ASSERT_EQ(hits.size(), 4U);
    const std::uint32_t triangles[] = {1, 2, 0, 3}, ranks[] = {0, 0, 1, 1};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(hits[i].feature.triangle, triangles[i]);
        EXPECT_EQ(hits[i].rank, ranks[i]);
    }
    EXPECT_EQ(hits[0].way, HitWay::back);
    EXPECT_EQ(hits[1].way, HitWay::front);
    EXPECT_EQ(hits[2].point.nearest(), Vec3(1, 1, 1));
}

TEST(OracleHits, KnownByTheirRecipes) {
    scenes::Random random(1);
    for (int i = 0; i < 500; ++i) {
        const auto made = scenes::family_named(scenes::hit_families(), "rational").make(random);
        const Ray ray = std::get<Ray>(made.line);
        std::fesetround(FE_DOWNWARD);
        const auto hits = all_hits({ray.origin, ray.direction, true, ray.max_parameter},
                                   {made.mesh->vertices(), made.mesh->triangles(), made.pose});
        std::fesetround(FE_TONEAREST);
        ASSERT_EQ(hits.size(), 1U) << i;
        EXPECT_EQ(nearest_parameter(hits[0].enter), made.known->parameter) << i;
        EXPECT_EQ(hits[0].feature.dimension, static_cast<int>(made.known->feature.kind)) << i;
        EXPECT_EQ(hits[0].feature.corner, made.known->feature.corner) << i;
    }
}

}  // namespace
}  // namespace ecods::oracle::oracle_hits_test
