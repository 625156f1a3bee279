// Points in solids, and the closest points of triangles (Jolt, UnitTests/Physics/CollidePointTests.cpp and
// UnitTests/Geometry/ClosestPointTests.cpp).
#include <array>
#include <optional>

#include "foreign/shapes.hpp"
#include "foreign/sources.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"

namespace ecods::foreign::jolt_points {
namespace {

const Vec3 half(0.1, 0.2, 0.3);

// The center and points just inside of the six faces are inside; points just outside are not. `own` leads from the box
// around the origin to the solid's coordinates.
void ask_box(Expectations& expect, const Posed<Solid>& solid, const Pose& own = {}) {
    const auto side = [&](const Vec3& p) { return locate(own.R * p + own.t, solid).side; };
    expect.is(side(Vec3::Zero()) == Side::inside, true);
    for (int axis = 0; axis < 3; ++axis) {
        for (const double sign : {-1.0, 1.0}) {
            const Vec3 probe = sign * half[axis] * Vec3::Unit(axis);
            expect.is(side(0.99 * probe) == Side::inside, true);
            expect.is(side(1.01 * probe) == Side::outside, true);
        }
    }
}

void ask_solids(Expectations& expect) {
    expect.from("TestCollidePointVsBox");
    const ConvexSolid plain = box(half);
    ask_box(expect, {plain, Pose{}});
    expect.from("TestCollidePointVsConvexHull");
    const Vec3 offset(10, 11, 12);
    const ConvexSolid hull = hull_of(box_corners(offset - half, offset + half));
    ask_box(expect, {hull, Pose{}}, {Mat3::Identity(), offset});
    expect.from("TestCollidePointVsRotatedTranslated");
    const Pose first{turn(0.3 * pi, {1, 2, 3}), offset}, second{turn(0.2 * pi, {4, 5, 6}), Vec3(-1, -2, -3)};
    ask_box(expect, {plain, first}, first);
    expect.from("TestCollidePointVsScaled");
    Pose scaled;
    scaled.R = Vec3(2, 3, -4).asDiagonal();
    ask_box(expect, {plain, scaled}, scaled);
    expect.from("TestCollidePointVsStaticCompound");
    const Solid compound(both(plain.mesh(), first, second));
    ask_box(expect, {compound, Pose{}}, first);
    ask_box(expect, {compound, Pose{}}, second);
}

// A grid of 125 bodies with eight corners each, a tenth to three tenths from the center along every axis: one mesh.
// Every second layer is inside out, which is the same solid.
void ask_grid(Expectations& expect) {
    expect.from("TestCollidePointVsMesh");
    scenes::Random random(125);
    const auto cube = scenes::cube(1);
    std::vector<Vec3> vertices, centers;
    std::vector<Triangle> triangles;
    for (int i = 0; i < 125; ++i) {
        const Vec3 center(i % 5 - 2, i / 5 % 5 - 2, i / 25 - 2);
        centers.push_back(center);
        const auto offset = static_cast<std::uint32_t>(vertices.size());
        for (const Vec3& v : cube->vertices()) {
            vertices.push_back(center);
            for (int k = 0; k < 3; ++k) vertices.back()[k] += v[k] * random.uniform(0.1, 0.3);
        }
        const std::size_t turned = i / 5 % 2 == 0 ? 1 : 0;
        for (const Triangle& t : cube->triangles()) {
            triangles.push_back({t[0] + offset, t[1 + turned] + offset, t[2 - turned] + offset});
        }
    }
    const Solid grid(Mesh::create(std::move(vertices), std::move(triangles)));
    const Pose pose{random.rotation().toRotationMatrix(), random.direction()};
    for (const Pose& own : {Pose{}, pose}) {
        const auto side = [&](const Vec3& p) { return locate(own.R * p + own.t, {grid, own}).side; };
        for (const Vec3& center : centers) {
            expect.is(side(center) == Side::inside, true);
            for (int axis = 0; axis < 3; ++axis) {
                expect.is(side(center + 0.4 * Vec3::Unit(axis)) == Side::outside, true);
                expect.is(side(center - 0.4 * Vec3::Unit(axis)) == Side::outside, true);
            }
        }
    }
}

// The closest point of the triangle and the corners that it is between, as bits.
void ask_triangle(Expectations& expect, const std::array<Vec3, 3>& t, const Vec3& p, const Vec3& nearest,
                  unsigned corners) {
    const MeshShape at_p = point(p);
    for (const auto& order : orders) {
        const MeshShape shape = triangle(t[order[0]], t[order[1]], t[order[2]]);
        const ClosestPoints found = closest({at_p, Pose{}}, {shape, Pose{}});
        const std::uint32_t c = found.b.corner;
        const unsigned bits = found.b.kind == Feature::Kind::vertex ? 1u << order[c]
                              : found.b.kind == Feature::Kind::edge ? 1u << order[c] | 1u << order[(c + 1) % 3]
                                                                    : 7u;
        expect.is(bits, corners);
        for (int k = 0; k < 3; ++k) expect.near(found.point_b[k], nearest[k], 2e-5);
    }
}

Vec3 onto_line(const Vec3& a, const Vec3& b, const Vec3& p) {
    return a + (p - a).dot(b - a) / (b - a).squaredNorm() * (b - a);
}

void ask_triangles(Expectations& expect) {
    expect.from("TestLongTriangle");
    const std::array<Vec3, 3> t{Vec3(100, 1, 0), Vec3(100, 1, 1), Vec3(-100, 1, 0)};
    ask_triangle(expect, t, {0, 0, 0.1}, {0, 1, 0.1}, 7);
    ask_triangle(expect, t, {101, 0, 0.5}, {100, 1, 0.5}, 3);
    ask_triangle(expect, t, {0, 0, -0.1}, {0, 1, 0}, 5);
    ask_triangle(expect, t, {0, 0, 1}, onto_line(t[1], t[2], {0, 0, 1}), 6);
    ask_triangle(expect, t, {101, 0, -1}, t[0], 1);
    ask_triangle(expect, t, {101, 0, 2}, t[1], 2);
    ask_triangle(expect, t, {-101, 0, 0}, t[2], 4);

    expect.from("TestNearColinearTriangle");
    const auto f = [](float x, float y, float z) { return Vec3(x, y, z); };
    const std::array<Vec3, 3> thin{f(99.9999847f, 0.946687222f, 99.9999847f),
                                   f(-100.010002f, 0.977360725f, -100.010002f),
                                   f(-100.000137f, 0.977310658f, -100.000137f)};
    ask_triangle(expect, thin, Vec3::Zero(), onto_line(thin[0], thin[2], Vec3::Zero()), 5);
}

}  // namespace

void ask(Expectations& expect) {
    ask_solids(expect);
    ask_grid(expect);
    ask_triangles(expect);
}

}  // namespace ecods::foreign::jolt_points
