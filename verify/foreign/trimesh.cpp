// Rays, points and distances of boxes and a ball (trimesh, tests/test_ray.py, test_proximity.py and test_collision.py),
// with shapes that are made by formulas.
#include <cmath>
#include <optional>

#include "ecods/cast.hpp"
#include "foreign/shapes.hpp"
#include "foreign/sources.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"

namespace ecods::foreign::trimesh {
namespace {

std::size_t places(const std::vector<Hit>& hits) {
    return hits.empty() ? 0 : hits.back().rank + 1u;
}

void ask_rays(Expectations& expect) {
    const Vec3 half = Vec3::Constant(0.5);
    const ConvexSolid cube = box(half);
    expect.from("test_on_vertex");
    for (const Vec3& corner : box_corners(-half, half)) {
        const auto hits = all_hits(Ray{Vec3::Zero(), corner}, {surface_of(cube), Pose{}});
        expect.is(places(hits), std::size_t{1});
        expect.is(hits[0].parameter, 1.0);
    }

    expect.from("test_box");
    for (int i = 0; i < 100; ++i) {
        for (int j = 0; j < 100; ++j) {
            const double x = -0.52 + 1.04 / 99 * i, y = -0.52 + 1.04 / 99 * j;
            const bool hits = std::abs(x) <= 0.5 && std::abs(y) <= 0.5;
            const auto found = all_hits(Ray{{x, y, -100}, Vec3::UnitZ()}, {cube, Pose{}});
            expect.is(places(found), hits ? std::size_t{2} : std::size_t{0});
            for (const Hit& hit : found) {
                expect.is(hit.point[0] == x && hit.point[1] == y && std::abs(hit.point[2]) == 0.5, true);
            }
        }
    }

    expect.from("test_embree_duplicate_hits");
    for (const double scale : {1e-4, 0.1, 1.0, 10.0, 1e4, 1e8}) {
        const ConvexSolid scaled = box(Vec3::Constant(scale / 2));
        expect.is(places(all_hits(Ray{{0, 0, scale / 2}, {0, 0, -1}}, {surface_of(scaled), Pose{}})), std::size_t{2});
    }
}

void ask_contains(Expectations& expect) {
    expect.from("test_contains");
    const Vec3 half = Vec3::Constant(0.5);
    const ConvexSolid cube = box(half);
    const auto is_in = [&](const Vec3& p) { return locate(p, {cube, Pose{}}).side == Side::inside; };
    for (const Vec3& corner : box_corners(-half, half)) {
        expect.is(is_in(corner * (1 / 1.5)), true);
        expect.is(is_in(corner * 1.5), false);
        expect.is(locate(corner, {cube, Pose{}}).side == Side::on, true);
    }
    expect.is(is_in(Vec3::Zero()), true);
    scenes::Random random(30);
    for (int i = 0; i < 30; ++i) {
        expect.is(is_in(Vec3(random.uniform(0, 100), random.uniform(0, 100), random.uniform(0, 100)) + 3 * half),
                  false);
    }

    expect.from("test_contains_cavity");  // issue 2534
    const Mat3 I = Mat3::Identity();
    const Solid hollow(both(cube.mesh(), {I, Vec3::Zero()}, {0.1 * I, Vec3::Zero()}));
    expect.is(locate(Vec3::Zero(), {hollow, Pose{}}).side == Side::outside, true);
    expect.is(locate(Vec3(0.2, 0, 0), {hollow, Pose{}}).side == Side::inside, true);
}

void ask_proximity(Expectations& expect) {
    expect.from("test_naive");
    const MeshShape ball(scenes::sphere(64, 48));
    scenes::Random random(100);
    for (int i = 0; i < 100; ++i) {
        const Vec3 p = 2 * random.direction();
        const MeshShape at_p = point(p);
        const ClosestPoints found = closest({at_p, Pose{}}, {ball, Pose{}});
        expect.near(found.distance, 1, 0.01);
        expect.near(found.point_b.dot(p / 2), 1, 0.01);
    }

    expect.from("test_acute_edge_case");  // all are nearest to the point (0, 0.5, 0) of the sharp edge
    const std::vector<Vec3> vertices{{-1, 0.5, 0}, {1, 0.5, 0}, {0, -1, -0.5}, {0, -1, 0.5}};
    const MeshShape acute(Mesh::create(vertices, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {3, 2, 1}}));
    for (int i = 0; i < 20; ++i) {
        const double z = -1 + 2. / 19 * i;
        const MeshShape p = point({0, 1, z});
        const ClosestPoints found = closest({p, Pose{}}, {acute, Pose{}});
        expect.is(found.point_b == Vec3(0, 0.5, 0), true);
        // The source expects the face that the point is before, -z or +z. Both hold the edge: the least is named.
        expect.is(found.b == Feature{Feature::Kind::edge, 0, 0}, true);
    }

    expect.from("test_returns_correct_point_in_ambiguous_cases");
    const std::vector<Vec3> corner{{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 0, -1}};
    const MeshShape two(Mesh::create(corner, {{0, 1, 2}, {0, 1, 3}}));
    const MeshShape p = point({-0.25 - 1e-9, 0, -0.25});
    const ClosestPoints found = closest({p, Pose{}}, {two, Pose{}});
    // The source expects triangle 1 and the point (0, 0, -0.25), to seven decimals. Triangle 0 is at 0.25, triangle 1
    // at 0.25 + 1e-9, so it is triangle 0.
    expect.is(found.b.triangle, 0u);
    expect.is(found.distance, 0.25);
    expect.is(found.point_b == Vec3(-0.25 - 1e-9, 0, 0), true);

    expect.from("test_unreferenced_vertex");
    const std::vector<Vec3> unused{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-0.5, -0.5, -0.5}};
    const MeshShape one(Mesh::create(unused, {{0, 1, 2}}));
    const MeshShape q = point({-1, -1, -1});
    expect.is(closest({q, Pose{}}, {one, Pose{}}).point_b == Vec3(1 / 3., 1 / 3., 1 / 3.), true);
}

// Unit cubes along the x axis.
struct AlongX {
    double a, b, distance;
};
constexpr AlongX along_x[] = {{5, 0, 4},  {5, 5.75, -0.25}, {5, 2, 2},  {-5, -2, 2}, {5, -5, 9},
                              {5, -2, 6}, {0, -5, 4},       {0, -2, 1}, {5, -5, 9},  {5, 5, -1}};

void ask_collisions(Expectations& expect) {
    expect.from("test_distance and test_collision");
    const ConvexSolid cube = box(Vec3::Constant(0.5));
    for (const AlongX& x : along_x) {
        const Posed<ConvexSolid> a{cube, at(x.a, 0, 0)}, b{cube, at(x.b, 0, 0)};
        expect.is(signed_number(a, b), x.distance);
        expect.is(signed_number(b, a), x.distance);
        expect.is(relation(a, b) != Relation::apart, x.distance <= 0);
        const auto closest = closest_apart(a, b);
        expect.is(closest.has_value(), x.distance > 0);
        if (closest) expect.is((closest->point_a - closest->point_b).norm() >= x.distance, true);
    }

    expect.from("test_coplanar_signed_distance");  // the least corner moved along x: no longer in the box
    for (const Vec3& by : {Vec3(100, 0, 0), Vec3(100, 100, 100)}) {
        expect.is(locate(Vec3::Constant(-0.5) + by, {cube, Pose{}}).side == Side::outside, true);
    }
}

}  // namespace

void ask(Expectations& expect) {
    ask_rays(expect);
    ask_contains(expect);
    ask_proximity(expect);
    ask_collisions(expect);
}

}  // namespace ecods::foreign::trimesh
