// Lines that begin inside solids.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "ecods/error.hpp"
#include "ecods/hit.hpp"
#include "ecods/world.hpp"
#include "scenes/expect_invalid.hpp"
#include "unit/query/bodies.hpp"

namespace ecods::body_hits_test {
namespace {

using namespace bodies;

// The first hits with one witness all along, and the first of all hits: one answer.
template <class SegmentOrRay>
Hit first_of(const SegmentOrRay& line, const Posed<MeshShape>& body) {
    QueryMemory memory;
    PairWitness witness;
    const auto hits = all_hits(line, body, memory);
    const auto expected = first_hit(line, body);
    EXPECT_EQ(expected.has_value(), !hits.empty());
    if (!expected) return {};
    for (int round = 0; round < 3; ++round) {
        const auto hit = first_hit(line, body, {memory, witness});
        EXPECT_TRUE(hit && hit->feature == expected->feature && hit->kind == expected->kind);
    }
    EXPECT_EQ(hits[0].feature, expected->feature);
    EXPECT_EQ(hits[0].kind, expected->kind);
    EXPECT_EQ(hits[0].parameter, expected->parameter);
    EXPECT_EQ(hits[0].rank, 0U);
    EXPECT_EQ(expected->rank, 0U);
    return *expected;
}

void expect_inside(const Hit& hit, const Vec3& begin) {
    EXPECT_EQ(hit.kind, HitKind::inside);
    EXPECT_EQ(hit.feature, no_feature);
    EXPECT_EQ(hit.parameter, 0);
    EXPECT_EQ(hit.leave_parameter, 0);
    EXPECT_EQ(hit.rank, 0U);
    EXPECT_EQ(hit.point, begin);
    EXPECT_EQ(hit.leave_point, begin);
}

// A room from 0 to 9 with a cavity from 2 to 7.
Soup room() {
    Soup soup = soup_of_box({0, 0, 0}, {9, 9, 9});
    soup.add_box({2, 2, 2}, {7, 7, 7});
    return soup;
}

TEST(BodyHits, ALineThatBeginsInside) {
    const Vec3 in_wall(1, 4, 5), in_cavity(3, 4, 5), outside(-1, 4, 5);
    const Vec3 along(1, 0, 0);
    for (const bool is_solid : {false, true}) {
        const ShapePtr shape = is_solid ? solid_of(room()) : surface_from(room());
        const Posed<MeshShape> body(shape, Pose());
        const Hit hit = first_of(Ray{in_wall, along}, body);
        if (is_solid) {
            expect_inside(hit, in_wall);
        } else {
            EXPECT_EQ(hit.parameter, 1);
            EXPECT_EQ(hit.kind, HitKind::back);
        }
        EXPECT_EQ(first_of(Ray{in_cavity, along}, body).parameter, 4);
        EXPECT_EQ(first_of(Ray{outside, along}, body).parameter, 1);
        EXPECT_EQ(first_of(Ray{Vec3(2, 4, 5), along}, body).parameter, 0) << "on the cavity's wall";
        EXPECT_NE(first_of(Ray{Vec3(2, 4, 5), along}, body).kind, HitKind::inside);
        // The ranks of all hits count the point where the line begins.
        const auto hits = all_hits(Segment{in_wall, Vec3(11, 4, 5)}, body);
        const std::vector<double> expected = is_solid ? std::vector{0.0, 0.1, 0.6, 0.8} : std::vector{0.1, 0.6, 0.8};
        ASSERT_EQ(hits.size(), expected.size());
        for (std::size_t i = 0; i < hits.size(); ++i) {
            EXPECT_EQ(hits[i].parameter, expected[i]);
            EXPECT_EQ(hits[i].rank, i);
        }
        if (is_solid) expect_inside(hits[0], in_wall);
    }
}

// Lines that begin where another one hit, or between two hits: they begin inside where the one that came there was.
TEST(BodyHits, ALineGoesOnFromItsHits) {
    const ShapePtr shape = solid_of(room());
    const Posed<MeshShape> body(shape, Pose());
    const Ray ray{Vec3(-1, 4, 5), Vec3(1, 0, 0)};
    const auto hits = all_hits(ray, body);
    ASSERT_EQ(hits.size(), 4U);
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const Hit again = first_of(Ray{hits[i].point, ray.direction}, body);
        EXPECT_EQ(again.feature, hits[i].feature);
        EXPECT_EQ(again.parameter, 0);
        const Vec3 next = i + 1 < hits.size() ? hits[i + 1].point : Vec3(100, 4, 5);
        const auto between = first_hit(Segment{0.5 * (hits[i].point + next), next}, body);
        EXPECT_EQ(between && between->kind == HitKind::inside, i % 2 == 0);
    }
}

TEST(BodyHits, PointsAndShortLinesInside) {
    for (const MeshForm form : {MeshForm::solid, MeshForm::convex}) {
        const ShapePtr shape = make(form, box({-1, -1, -1}, {1, 1, 1}));
        const Posed<MeshShape> body(shape, Pose());
        const Vec3 in(0.5, -0.0, 0.25);
        const Hit hit = first_of(Segment{in, in}, body);
        expect_inside(hit, Vec3(0.5, 0, 0.25));
        EXPECT_FALSE(std::signbit(hit.point[1])) << "a zero is +0";
        expect_inside(first_of(Segment{in, Vec3(0.5, 0.125, 0.25)}, body), in);  // ends inside
        EXPECT_EQ(all_hits(Segment{in, Vec3(0.5, 0.125, 0.25)}, body).size(), 1U);
        const double infinity = std::numeric_limits<double>::infinity();
        expect_inside(first_of(Ray{in, Vec3(0, 0, 1), 0}, body), in);
        expect_inside(first_of(Ray{in, Vec3(0, 0, 1), infinity}, body), in);
        for (const Vec3& on : {Vec3(1, 0.25, 0.5), Vec3(1, 1, 0.5), Vec3(1, 1, 1)}) {
            EXPECT_NE(first_of(Segment{on, Vec3(0, 0, 0)}, body).kind, HitKind::inside);
            EXPECT_EQ(first_of(Segment{on, Vec3(0, 0, 0)}, body).parameter, 0);
        }
        // A parameter that is not 0, but rounds to it, is of the next rank.
        const Vec3 far = Vec3(0x1p1000, 0, 0);
        const Vec3 near_face(1 - 0x1p-53, 0.25, 0.5);
        const Ray ray{near_face, far, 1};
        const auto hits = all_hits(ray, body);
        ASSERT_EQ(hits.size(), 2U);
        EXPECT_EQ(hits[0].kind, HitKind::inside);
        EXPECT_EQ(hits[1].rank, 1U);
        EXPECT_INVALID(first_hit(Segment{in, Vec3(0, infinity, 0)}, body), Argument::segment);
        EXPECT_INVALID(all_hits(Ray{in, Vec3(0, 0, 1), -1}, body), Argument::ray);
    }
}

// At every pose that is a map, the line mapped with it.
TEST(BodyHits, AtPosesOfAnyKindAndScale) {
    const ShapePtr solid = solid_of(room());
    for (const int exponent : {-900, -200, 0, 200, 900}) {
        for (const double sign : {1.0, -1.0}) {
            Pose pose;
            pose.R << 0, -sign, 0, 1, 0, 0, 0, 0, 2;
            pose.R *= std::ldexp(1.0, exponent);
            pose.t = std::ldexp(1.0, exponent) * Vec3(1, 2, 3);
            const auto place = [&](const Vec3& v) { return Vec3(pose.R * v + pose.t); };
            const Posed<MeshShape> body(solid, pose);
            expect_inside(first_of(Segment{place({1, 1, 1}), place({5, 5, 5})}, body), place({1, 1, 1}));
            EXPECT_EQ(first_of(Segment{place({3, 3, 3}), place({3, 3, 11})}, body).parameter, 0.5);
            Pose flat = pose;
            flat.R.col(2).setZero();
            const Vec3 on = flat.R * Vec3(3, 3, 0) + flat.t;
            EXPECT_NE(first_of(Segment{on, place({3, 3, 3})}, {solid, flat}).kind, HitKind::inside) << "no inside";
            EXPECT_EQ(all_hits(Segment{place({3, 3, 3}), place({3, 3, 4})}, {solid, flat}).size(), 0U);
        }
    }
}

// In a World, what begins inside a solid is a hit of it at 0; ids decide between bodies that hold the point.
TEST(BodyHits, OfAWorld) {
    for (const MeshForm form : {MeshForm::solid, MeshForm::convex}) {
        World world;
        const BodyId small = world.create_body(surface_from(soup_of_box({-1, -1, -1}, {1, 1, 1})), at(0));
        const BodyId outer = world.create_body(make(form, box({-2, -2, -2}, {2, 2, 2})), at(0));
        const BodyId outermost = world.create_body(make(form, box({-3, -3, -3}, {3, 3, 3})), at(0));
        const Ray ray{Vec3(0, 0.25, 0.5), Vec3(1, 0, 0)};
        const auto first = world.first_hit(ray);
        ASSERT_TRUE(first);
        EXPECT_EQ(first->body, outer);
        expect_inside(first->hit, ray.origin);
        const auto hits = world.all_hits(ray);
        const std::vector<BodyId> bodies{outer, outermost, small, outer, outermost};
        const std::vector<std::uint32_t> ranks{0, 0, 1, 2, 3};
        ASSERT_EQ(hits.size(), bodies.size());
        for (std::size_t i = 0; i < hits.size(); ++i) {
            EXPECT_EQ(hits[i].body, bodies[i]);
            EXPECT_EQ(hits[i].hit.rank, ranks[i]);
            EXPECT_EQ(hits[i].hit.parameter, ranks[i]);
        }
        // On the first one's surface, inside the others: three bodies at parameter 0, in the order of their ids.
        const Segment segment{Vec3(1, 0.25, 0.5), Vec3(2, 0.25, 0.5)};
        EXPECT_EQ(world.first_hit(segment)->body, small);
        const auto of_segment = world.all_hits(segment);
        ASSERT_EQ(of_segment.size(), 4U);
        EXPECT_EQ(of_segment[2].hit.rank, 0U);
        EXPECT_EQ(of_segment[3].hit.rank, 1U);
        world.set_filter(outer, {.groups = 2});
        EXPECT_EQ(world.first_hit(ray, CollisionFilter{.groups = 1, .mask = 1})->body, outermost);
        world.set_pose(outermost, at(100));
        EXPECT_EQ(world.first_hit(ray, CollisionFilter{.groups = 1, .mask = 1})->body, small);
    }
}

}  // namespace
}  // namespace ecods::body_hits_test
