// Boxes, a pyramid and rays (Parry, crates/parry3d/tests/geometry: epa3, still_objects_toi, trimesh_trimesh_toi,
// cuboid_ray_cast).
#include <optional>

#include "ecods/cast.hpp"
#include "foreign/shapes.hpp"
#include "foreign/sources.hpp"
#include "scenes/random.hpp"

namespace ecods::foreign::parry {
namespace {

void ask_depths(Expectations& expect) {
    expect.from("epa3, cuboid_cuboid_EPA");
    const ConvexSolid c = box({2, 1, 1});
    const auto check = [&](const Pose& pose, double deep, const Vec3& direction) {
        const auto found = depth({c, pose}, {c, Pose{}});
        expect.is(found.has_value(), true);
        if (!found) return;
        // 2 - 0.2 is a rounding away from 1.8: the real number is rounded once.
        expect.is(found->depth, deep);
        for (int k = 0; k < 3; ++k) expect.is(found->direction[k], direction[k]);
    };
    check(at(3.5, 0, 0), 0.5, {-1, 0, 0});
    check(at(0, 0.2, 0), 1.8, {0, -1, 0});
}

// Issue 246. The floats do not touch: the edge of the lower triangle passes the upper one at 4.07e-8. The source allows
// its point an error of 0.001.
void ask_almost_touching(Expectations& expect) {
    expect.from("epa3, triangle_vertex_touches_triangle_edge_epa");
    const auto f = [](float x, float y, float z) { return Vec3(x, y, z); };
    const MeshShape upper =
        triangle(f(-13.174434f, 1, 8.736801f), f(3.5251038f, 1, 12.1f), f(3.2048466f, 1, 12.218325f));
    const MeshShape lower = triangle(f(-1.63f, 0, 11.19f), f(-2.349647f, 0, 11.037681f), f(-2.349647f, 1, 11.037681f));
    const ClosestPoints found = closest({upper, Pose{}}, {lower, Pose{}});
    expect.near(found.point_a[1], 1, 0.001);
    expect.near(found.point_a[0], -2.349647, 0.001);
    expect.near(found.distance, 4.07e-8, 5e-11);
}

void ask_casts(Expectations& expect) {
    expect.from("still_objects_toi");  // issue 141
    const ConvexSolid cube = box({0.5, 0.5, 0.5});
    for (const double speed : {0.0, 1.0, -1.0}) {
        const auto contact = cast({cube, at(0, 1.1, 0)}, Vec3(0, speed, 0), {cube, Pose{}});
        expect.is(contact.has_value(), speed < 0);
        if (contact) expect.is(contact->time, 1.1 - 1);  // exact: 1.1 and 1 are near each other
    }

    expect.from("trimesh_trimesh_toi");  // issue 194; a speed of 100,000 over all times up to 1
    const MeshShape pyramid(
        Mesh::create({{0, 1, 0}, {-1, -0.5, 0}, {0, -0.5, -1}, {1, -0.5, 0}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}}));
    const auto contact = cast({pyramid, Pose{}}, Vec3(100000, 0, 0), {pyramid, at(1000, 0, 0)});
    expect.is(contact.has_value(), true);
    if (contact) expect.is(contact->time, 0.00998);
}

// Issue 242. Rays from a sphere to the center, and back from where they come.
void ask_rays(Expectations& expect, const Vec3& half) {
    scenes::Random random(42);
    const ConvexSolid shape = box(half);
    for (int i = 0; i < 500; ++i) {
        const Vec3 origin = 5 * random.direction();
        const Pose pose = i % 100 == 0 ? Pose{} : random.turned();
        const Posed<ConvexSolid> posed{shape, pose};
        const auto hit = first_hit(Ray{origin, -origin}, posed);
        expect.is(hit.has_value(), true);
        if (!hit) continue;
        const Triangle& t = shape.mesh().triangles()[hit->triangle()];
        const auto v = shape.mesh().vertices();
        const Vec3 normal = pose.R * (v[t[1]] - v[t[0]]).cross(v[t[2]] - v[t[0]]).normalized();
        const Vec3 inside = hit->point - 0.001 * normal, outside = hit->point + 0.001 * normal;
        expect.is(locate(inside, posed).side == Side::inside, true);
        expect.is(locate(outside, posed).side == Side::outside, true);
        expect.is(first_hit(Ray{outside, origin - outside}, posed).has_value(), false);
    }
}

}  // namespace

void ask(Expectations& expect) {
    ask_depths(expect);
    ask_almost_touching(expect);
    ask_casts(expect);
    expect.from("cuboid_ray_cast");
    for (const Vec3& half : {Vec3(1, 1, 1), Vec3(1, 1, 0.5), Vec3(0.5, 1, 0.5)}) ask_rays(expect, half);
}

}  // namespace ecods::foreign::parry
