// Triangles of no area beside an edge of another: kept apart by the filter where they are clear of it, and never where
// they touch.

#include "exact/simplex/edge_axes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ecods/mesh.hpp"
#include "exact/sign/filter_bound.hpp"
#include "oracle/oracle.hpp"
#include "query/intersection/triangle_relations.hpp"
#include "scenes/random.hpp"

namespace ecods::exact::edge_axes_test {
namespace {

using Corners = std::array<Vec3, 3>;

// A segment across the edge from corner 0 to corner 1 of `face`, `gap` beyond it; named as a triangle.
Corners segment_across(const Pose& face_pose, const Corners& face, const Pose& pose, double gap,
                       scenes::Random& random) {
    const Vec3 from = face_pose.R * face[0] + face_pose.t, to = face_pose.R * face[1] + face_pose.t;
    const Vec3 third = face_pose.R * face[2] + face_pose.t;
    const Vec3 edge = (to - from).normalized();
    const Vec3 outwards = ((from - third) - edge * edge.dot(from - third)).normalized();
    const Vec3 across = outwards.cross(edge);
    const Vec3 middle = from + (to - from) * random.uniform(0.2, 0.8) + gap * outwards;
    const Vec3 half = across + 0.3 * edge;
    const auto own = [&](const Vec3& x) -> Vec3 { return pose.R.transpose() * (x - pose.t); };
    const Vec3 a = own(middle - half), b = own(middle + half);
    return random.below(2) == 0 ? Corners{a, b, a} : Corners{a, b, b};
}

struct Asked {
    Relation relation;
    std::uint64_t by_filter;
};

Asked ask(const Pose& pose_a, const Corners& a, const Pose& pose_b, const Corners& b) {
    const auto mesh_a = Mesh::create({a.begin(), a.end()}, {{0, 1, 2}}),
               mesh_b = Mesh::create({b.begin(), b.end()}, {{0, 1, 2}});
    const MeshExtent extent_a = measure(*mesh_a), extent_b = measure(*mesh_b);
    TriangleRelations bodies;
    bodies.bind({mesh_a.get(), &extent_a, &pose_a}, {mesh_b.get(), &extent_b, &pose_b});
    const Relation relation = bodies.relation(0, 0);
    return {relation, bodies.counts().semi_static_passes};
}

TEST(EdgeAxes, SegmentsAreKeptApartAndNeverLost) {
    scenes::Random random(11);
    std::array<int, 3> counts{};
    int clear_count = 0, clear_by_filter = 0;
    for (int i = 0; i < 4000; ++i) {
        Pose face_pose = random.turned(), pose = random.turned();
        face_pose.t = std::ldexp(1.0, static_cast<int>(random.below(30))) * random.direction();
        pose.t = face_pose.t + random.direction();
        const Corners face{Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(0, 1, 0)};
        const bool is_clear = i % 4 == 0;
        const double gap = is_clear ? 0.01 : (random.below(9) - 4.0) * std::ldexp(1.0, -52) * face_pose.t.norm();
        const Corners segment = segment_across(face_pose, face, pose, gap, random);

        const Relation expected = oracle::triangle_triangle(face_pose, face, pose, segment);
        ++counts[static_cast<std::size_t>(expected)];
        const Asked there = ask(face_pose, face, pose, segment), back = ask(pose, segment, face_pose, face);
        ASSERT_EQ(there.relation, expected) << i;
        ASSERT_EQ(back.relation, expected) << i;
        if (!is_clear) continue;
        clear_count += 2;
        clear_by_filter += static_cast<int>(there.by_filter + back.by_filter);
    }
    EXPECT_EQ(clear_by_filter, clear_count);
    EXPECT_GT(counts[static_cast<std::size_t>(Relation::apart)], 1000);
    EXPECT_GT(counts[static_cast<std::size_t>(Relation::crossing)], 500);
}

double bound_of(const Points<6>& w) {
    return determinant_bounds(w, 0).orient3d;
}

// Triangles with an edge of each across the other at a multiple of `gap`, and third corners anywhere.
Points<6> crossed_edges(double gap, scenes::Random& random) {
    const auto point = [](const Vec3& x) { return Point{x[0], x[1], x[2]}; };
    const Vec3 u = random.direction(), e = random.direction(), middle = random.direction();
    const Vec3 n = u.cross(e).normalized();
    const Vec3 beyond = middle + (random.below(9) - 4.0) * gap * n;
    const Vec3 r = middle + random.direction(), c = beyond + random.direction();
    const double s = random.uniform(0.2, 0.8), t = random.uniform(0.2, 0.8);
    std::array<Point, 3> x{point(middle - s * u), point(middle + (1 - s) * u), point(r)};
    std::array<Point, 3> y{point(beyond - t * e), point(beyond + (1 - t) * e), point(c)};
    std::ranges::rotate(x, x.begin() + static_cast<int>(random.below(3)));
    std::ranges::rotate(y, y.begin() + static_cast<int>(random.below(3)));
    return {x[0], x[1], x[2], y[0], y[1], y[2]};
}

Relation relation_of(const Points<6>& w) {
    const auto at = [&](std::size_t i) { return Vec3(w[i][0], w[i][1], w[i][2]); };
    return oracle::triangle_triangle({}, {at(0), at(1), at(2)}, {}, {at(3), at(4), at(5)});
}

TEST(EdgeAxes, OnlyDisjointTrianglesAreSeparated) {
    scenes::Random random(12);
    int separated_count = 0, contact_count = 0;
    for (int i = 0; i < 10000; ++i) {
        const Points<6> w = crossed_edges(i % 2 == 0 ? 0x1p-53 : 0.1, random);
        const bool is_contact = relation_of(w) != Relation::apart;
        contact_count += is_contact;
        if (!edges_separate(w, bound_of(w))) continue;
        ++separated_count;
        ASSERT_FALSE(is_contact) << i;
    }
    EXPECT_GT(separated_count, 1500);
    EXPECT_GT(contact_count, 1500);
}

}  // namespace
}  // namespace ecods::exact::edge_axes_test
