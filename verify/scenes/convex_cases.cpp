#include "scenes/convex_cases.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "scenes/convex_recipes.hpp"
#include "scenes/hard_pair_parts.hpp"
#include "scenes/lattice_hull.hpp"

namespace ecods::scenes {
namespace {

using hard::coin;
using hard::full;
using hard::integer;
using hard::random_pose;
using hard::rotation;

PosedMesh any_hull(Random& random, const Vec3& radii = Vec3(1, 1, 1)) {
    const LatticeMesh hull = ellipsoid_hull(integer(random, 4, random.below(4) == 0 ? 32 : 14), radii, random);
    return {to_mesh(hull, ellipsoid_unit), random_pose(random)};
}

Vec3 any_radii(Random& random) {
    return {full(random, 0.2, 1), full(random, 0.2, 1), full(random, 0.2, 1)};
}

PosedMesh any_box(const Vec3& half, Random& random) {
    const LatticeMesh unit = box({-1, -1, -1}, {1, 1, 1});
    std::vector<Vec3> vertices;
    for (const LatticePoint& p : unit.vertices) vertices.push_back(Vec3(p[0], p[1], p[2]).cwiseProduct(half));
    return {Mesh::create(std::move(vertices), unit.triangles), random_pose(random)};
}

// A gap or a depth: 2^-1 to 2^-52, or nothing but what rounding leaves.
double any_gap(Random& random) {
    if (random.below(6) == 0) return 0;
    return std::ldexp(coin(random) ? 0.75 : -0.75, -integer(random, 0, 52));
}

ConvexCase make_hulls(Random& random) {
    ConvexCase made{any_hull(random, any_radii(random)), any_hull(random, any_radii(random))};
    made.b.pose.t = made.a.pose.t + full(random, 0, 2.5) * random.direction();
    return made;
}

ConvexCase make_near_contact(Random& random) {
    ConvexCase made{any_hull(random, any_radii(random)), any_hull(random, any_radii(random))};
    bring_near(made, any_gap(random), random);
    return made;
}

ConvexCase make_turned_boxes(Random& random) {
    ConvexCase made{any_box(any_radii(random), random), any_box(any_radii(random), random)};
    if (coin(random)) {
        made.b.pose.t = made.a.pose.t + full(random, 0, 1) * random.direction();
    } else {
        bring_near(made, any_gap(random), random);
    }
    return made;
}

// Both under one map.
ConvexCase placed(LatticeMesh a, LatticeMesh b, Random& random) {
    if (random.below(8) == 0) add_zero_area(a, random);
    const LatticeMap map = random_map(random);
    constexpr int exponents[] = {0, 0, 0, 0, -1, 20, -60, 300};
    const int exponent = exponents[random.below(std::size(exponents))];
    return {place(a, map, exponent, random), place(b, map, exponent, random)};
}

LatticeMesh shifted(LatticeMesh mesh, int size, Random& random) {
    LatticePoint by{};
    for (int& x : by) x = integer(random, -size, size);
    for (LatticePoint& p : mesh.vertices) {
        for (std::size_t k = 0; k < 3; ++k) p[k] += by[k];
    }
    return mesh;
}

LatticeMesh small_lattice_hull(Random& random) {
    return random_lattice_hull(integer(random, 1, 3), integer(random, 4, 9), random);
}

ConvexCase make_lattice_hulls(Random& random) {
    return placed(small_lattice_hull(random), shifted(small_lattice_hull(random), integer(random, 0, 4), random),
                  random);
}

ConvexCase make_prisms(Random& random) {
    const auto any = [&] {
        const int radius = integer(random, 2, 9);
        return prism(integer(random, 3, random.below(4) == 0 ? 24 : 8), radius, integer(random, 1, 6));
    };
    LatticeMesh a = any(), b = shifted(any(), 8, random);
    return placed(std::move(a), std::move(b), random);
}

ConvexCase make_plates(Random& random) {
    ConvexCase made{any_box({0.5, 0.5, 0.001}, random), any_box({0.5, 0.5, 0.001}, random)};
    const std::uint32_t choice = random.below(4);
    if (choice == 0) {  // nearly coplanar
        Mat3 tilt = Mat3::Identity();
        tilt(2, 0) = full(random, -0.002, 0.002);
        tilt(2, 1) = full(random, -0.002, 0.002);
        made.b.pose.R = made.a.pose.R * tilt;
        made.b.pose.t =
            made.a.pose.t + made.a.pose.R * Vec3(full(random, -1, 1), full(random, -1, 1), full(random, -0.002, 0.002));
    } else if (choice == 1) {
        bring_near(made, any_gap(random), random);
    } else {
        made.b.pose.t = made.a.pose.t + full(random, 0, 0.5) * random.direction();
        if (choice == 2) made.b.pose.R = made.a.pose.R;
    }
    return made;
}

ConvexCase make_needles(Random& random) {
    const auto needle = [&] {
        PosedMesh body = any_hull(random);
        body.pose.R.col(0) *= std::ldexp(1.0, -integer(random, 10, 40));
        if (coin(random)) body.pose.R.col(1) *= std::ldexp(1.0, -integer(random, 10, 40));
        return body;
    };
    ConvexCase made{needle(), coin(random) ? needle() : any_hull(random)};
    bring_near(made, random.below(4) == 0 ? -0.25 : any_gap(random), random);
    if (coin(random)) std::swap(made.a, made.b);
    return made;
}

// Where it has many vertices, no search of supports finds the depth, and of three of that face doubles may know no
// normal.
ConvexCase make_arcs(Random& random) {
    const int half = random.below(4) == 0 ? integer(random, 46, 52) : integer(random, 3, 12);
    std::vector<LatticePoint> points;
    for (int i = -half; i <= half; ++i) points.push_back({i, i * i, 0});
    for (int i = 0; i < 3; ++i) {
        points.push_back({integer(random, -half, half), integer(random, 0, half * half), half / 2 + i});
    }
    const double unit = half < 16 ? 0x1p-3 : 0x1p-5;  // a power of two: the arc is convex as it is
    ConvexCase made{{to_mesh(lattice_hull(points), unit), random_pose(random)},
                    any_hull(random, 0.1 * any_radii(random))};
    const Vec3 inside(full(random, -1, 1), full(random, 0, half), full(random, -0.1, 0.5));
    made.a.pose.R.col(1) *= std::ldexp(1.0, -integer(random, 8, 44));
    made.b.pose.t = made.a.pose.t + made.a.pose.R * inside;
    if (random.below(4) == 0) bring_near(made, any_gap(random), random);
    if (coin(random)) std::swap(made.a, made.b);
    return made;
}

// At most 64 in size, which place() maps exactly.
ConvexCase make_many_in_one_plane(Random& random) {
    const auto any = [&] {
        LatticeMesh mesh = coin(random) ? box({0, 0, 0}, {integer(random, 1, 3), integer(random, 1, 3), 1})
                                        : random_lattice_hull(2, integer(random, 4, 6), random);
        for (int times = integer(random, 1, random.below(8) == 0 ? 3 : 2); times > 0; --times) mesh = refined(mesh);
        return mesh;
    };
    LatticeMesh a = any();
    return placed(std::move(a), coin(random) ? shifted(any(), 8, random) : small_lattice_hull(random), random);
}

ConvexCase make_inside(Random& random) {
    ConvexCase made{any_hull(random), any_hull(random, 0.2 * any_radii(random))};
    made.b.pose.t = made.a.pose.t + full(random, 0, 0.3) * random.direction();
    if (coin(random)) std::swap(made.a, made.b);
    return made;
}

ConvexCase make_equal(Random& random) {
    const std::uint32_t choice = random.below(3);
    const LatticeMesh mesh = choice == 0   ? small_lattice_hull(random)
                             : choice == 1 ? prism(integer(random, 3, 8), integer(random, 2, 9), 2)
                                           : ellipsoid_hull(integer(random, 4, 14), any_radii(random), random);
    const Pose pose = random_pose(random);
    ConvexCase made{place_at(mesh, pose, random), place_at(mesh, pose, random)};
    if (random.below(4) == 0) made.b.pose.t += 0x1p-30 * random.direction();
    if (random.below(4) == 0) made.b.pose.R *= 0.5;
    return made;
}

ConvexCase make_far(Random& random) {
    ConvexCase made = coin(random) ? make_near_contact(random) : make_turned_boxes(random);
    const double far = random.below(3) == 0 ? 1e8 : std::ldexp(1.0, integer(random, 20, 60));
    const Vec3 away(far * full(random, -1, 1), far * full(random, -1, 1), far * full(random, -1, 1));
    made.a.pose.t += away;
    made.b.pose.t += away;
    return made;
}

ConvexCase make_squeezed(Random& random) {
    ConvexCase made{any_hull(random), any_hull(random)};
    for (Pose* pose : {&made.a.pose, &made.b.pose}) {
        const int column = integer(random, 0, 2);
        if (coin(random)) pose->R.col(column) *= std::ldexp(coin(random) ? 1.0 : -1.0, -integer(random, 10, 60));
        if (coin(random)) pose->R.col(column) += full(random, -4, 4) * pose->R.col((column + 1) % 3);
    }
    bring_near(made, any_gap(random), random);
    return made;
}

ConvexCase make_scaled(Random& random) {
    ConvexCase made = coin(random) ? make_near_contact(random) : make_hulls(random);
    const double scale = std::ldexp(1.0, integer(random, -900, 900));
    for (Pose* pose : {&made.a.pose, &made.b.pose}) {
        pose->R *= scale;
        pose->t *= scale;
    }
    return made;
}

ConvexCase make_subnormal(Random& random) {
    const int size = 1 << integer(random, 1, 14);
    const auto hull = [&] { return to_mesh(random_lattice_hull(size, integer(random, 4, 8), random), 0x1p-1074); };
    ConvexCase made{{hull(), {}}, {hull(), {}}};
    for (int k = 0; k < 3; ++k) made.b.pose.t[k] = integer(random, -2 * size, 2 * size) * 0x1p-1074;
    if (coin(random)) made.a.pose.R = rotation(random);
    return made;
}

// Nearly always with an inside.
PosedMesh far_flung(Random& random) {
    std::vector<Vec3> vertices(4);
    const int range = coin(random) ? 3 : 300;
    for (Vec3& v : vertices) {
        for (int k = 0; k < 3; ++k) v[k] = std::ldexp(full(random, -1, 1), integer(random, -range, range));
    }
    return {Mesh::create(std::move(vertices), {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}), random_pose(random)};
}

ConvexCase make_exponents(Random& random) {
    return {far_flung(random), far_flung(random)};
}

ConvexCase make_nudged(Random& random) {
    ConvexCase made = random.below(3) == 0 ? make_lattice_hulls(random)
                      : coin(random)       ? convexity::aligned_boxes(random)
                                           : convexity::integer_rotations(random);
    Pose& pose = coin(random) ? made.a.pose : made.b.pose;
    hard::nudge(coin(random) ? pose.t[integer(random, 0, 2)] : pose.R(integer(random, 0, 2), integer(random, 0, 2)),
                random);
    made.distance.reset();
    made.depth.reset();
    return made;
}

constexpr Family<ConvexCase> table[] = {
    {"hulls", make_hulls},  // of points on ellipsoids, in random rotations: apart, or deep in each other
    // Hulls whose vertex and face, or two edges, are apart or deep by 2^-1 to 2^-52, or by rounding
    {"near contact", make_near_contact},
    {"aligned boxes", convexity::aligned_boxes},  // known: two boxes of the lattice in one signed permutation
    {"turned boxes", make_turned_boxes},          // boxes in rotations of their own, near contact or deep
    // Known: one box, and a vertex, an edge or a face of another, each in an integer rotation
    {"integer rotations", convexity::integer_rotations},
    // Hulls of a few small integers under one affine map: contacts and ties of many features
    {"lattice hulls", make_lattice_hulls},
    {"prisms", make_prisms},    // of 3 to 24 sides, in one frame: parallel faces and edges
    {"plates", make_plates},    // boxes of 500 by 500 by 1, crossed, in each other or nearly coplanar
    {"needles", make_needles},  // 2^-10 to 2^-40 as thick as long
    // A face of up to 105 vertices nearly on a line: an arc 2^-14 to 2^-50 as high as long
    {"arcs", make_arcs},
    // Lattice hulls and boxes whose faces are cut in hundreds of triangles
    {"many in one plane", make_many_in_one_plane},
    {"inside", make_inside},  // a small one in a large one
    {"equal", make_equal},    // a solid and itself, or another mesh of it, at one pose or nearly
    {"far", make_far},        // near contact, and 1e8, 2^50 or more from the origin
    // A column of the matrix is 2^-10 to 2^-60 of the others, or they are sheared, or reflect
    {"squeezed", make_squeezed},
    {"scaled", make_scaled},              // at scales of 2^-900 to 2^900
    {"subnormal", make_subnormal},        // integers of some digits, times 2^-1074
    {"exponents", make_exponents},        // tetrahedra of coordinates of any exponents
    {"flat sets", convexity::flat_sets},  // polygons, segments and points, and such a set and a lattice hull
    {"nudged", make_nudged},              // one of the above, a number of a pose moved by one ulp
};

}  // namespace

Families<ConvexCase> convex_families() {
    return table;
}

}  // namespace ecods::scenes
