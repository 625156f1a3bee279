#include "scenes/distance_cases.hpp"

#include <array>
#include <cmath>
#include <vector>

#include "scenes/distance_recipes.hpp"
#include "scenes/hard_pair_parts.hpp"
#include "scenes/hard_pairs.hpp"
#include "scenes/shapes.hpp"

namespace ecods::scenes {
namespace {

using hard::coin;
using hard::full;
using hard::integer;
using hard::make_singular;
using hard::random_pose;
using hard::rotation;

using closeness::Corners;
using closeness::half_way;
using closeness::lattice_features;
using closeness::parallel_faces;

Corners random_corners(Random& random) {
    Corners corners;
    for (Vec3& corner : corners) {
        for (int k = 0; k < 3; ++k) corner[k] = full(random, -1, 1);
    }
    return corners;
}

DistanceCase apart(Random& random) {
    DistanceCase made{one_triangle(random_corners(random)),
                      one_triangle(random_corners(random)),
                      random_pose(random),
                      random_pose(random),
                      {}};
    made.pose_b.t = made.pose_a.t + full(random, 0, 4) * random.direction();
    return made;
}

DistanceCase from_hard_pair(Random& random) {
    const PosedPair pair = any_family(hard_families(), random).make(random);
    DistanceCase made{one_triangle(pair.a), one_triangle(pair.b), pair.pose_a, pair.pose_b, {}};
    if (pair.intersects && *pair.intersects) made.distance = 0;
    if (!coin(random)) return made;
    made.distance.reset();
    // By a corner of its own, so that the move is of the bodies' size.
    const Vec3 move = integer(random, -2, 2) * pair.b[0] + integer(random, -2, 2) * pair.b[1];
    for (int k = 0; k < 3; ++k) {
        const double sum = made.pose_b.t[k] + move[k];
        if (std::isfinite(sum)) made.pose_b.t[k] = sum;
    }
    return made;
}

// Triangles that share a tip at the origin and are long in the direction of -x.
std::shared_ptr<const Mesh> fan_of_needles(Random& random) {
    std::vector<Vec3> vertices{Vec3::Zero()};
    std::vector<Triangle> triangles;
    const int count = integer(random, 1, 5);
    for (int i = 0; i < count; ++i) {
        const double thickness = std::ldexp(full(random, 0.5, 1), -integer(random, 20, 45));
        const Vec3 end(-full(random, 0.5, 1), full(random, -0.25, 0.25), full(random, -0.25, 0.25));
        const auto first = static_cast<std::uint32_t>(vertices.size());
        vertices.push_back(end);
        vertices.push_back(end * full(random, 0.25, 1) + thickness * Vec3(0, full(random, -1, 1), 1));
        triangles.push_back({0, first, first + 1});
    }
    return Mesh::create(std::move(vertices), std::move(triangles));
}

// Half a turn for the second: the tips point at each other, past each other, or needles lie side by side.
DistanceCase needles(Random& random) {
    DistanceCase made{fan_of_needles(random), fan_of_needles(random), random_pose(random), {}, {}};
    Mat3 turn = Mat3::Identity();
    turn(0, 0) = turn(1, 1) = coin(random) ? -1 : 1;
    made.pose_b.R = coin(random) ? Mat3(made.pose_a.R * turn) : rotation(random);
    const double gap = std::ldexp(full(random, 0.5, 1), -integer(random, 0, 50));
    made.pose_b.t = made.pose_a.t + made.pose_a.R * Vec3(coin(random) ? gap : -0.25, coin(random) ? 0 : gap, gap);
    return made;
}

double tenth(int n) {
    return static_cast<double>(n) / 10;
}

// Each side in squares, its coordinates tenths; they are not multiples of one binary fraction.
std::shared_ptr<const Mesh> brick(Random& random) {
    const int most = random.below(8) == 0 ? 3 : 2;
    const std::array<int, 3> size{integer(random, 1, most), integer(random, 1, most), integer(random, 1, most)};
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        for (const int level : {0, size[static_cast<std::size_t>(axis)]}) {
            for (int i = 0; i < size[static_cast<std::size_t>(u)]; ++i) {
                for (int j = 0; j < size[static_cast<std::size_t>(v)]; ++j) {
                    const auto first = static_cast<std::uint32_t>(vertices.size());
                    for (const auto [s, t] : {std::array{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
                        Vec3 corner;
                        corner[axis] = tenth(level);
                        corner[u] = tenth(i + s);
                        corner[v] = tenth(j + t);
                        vertices.push_back(corner);
                    }
                    triangles.push_back({first, first + 1, first + 2});
                    triangles.push_back({first, first + 2, first + 3});
                }
            }
        }
    }
    return Mesh::create(std::move(vertices), std::move(triangles));
}

DistanceCase bricks(Random& random) {
    DistanceCase made{brick(random), brick(random), {}, {}, {}};
    Vec3 offset;
    for (int k = 0; k < 3; ++k) offset[k] = tenth(integer(random, -4, 4));
    if (random.below(3) == 0) offset[integer(random, 0, 2)] += std::ldexp(1.0, -integer(random, 20, 60));
    if (coin(random)) made.pose_a.R = made.pose_b.R = rotation(random);
    if (random.below(4) == 0) made.pose_b.R = rotation(random);
    made.pose_b.t = made.pose_a.R * offset;
    return made;
}

// The tip of the second is above an inner point of the first, in a frame that is rotated, and so with rounding.
DistanceCase above_a_face(Random& random, double gap) {
    DistanceCase made{nullptr, nullptr, random_pose(random), {}, {}};
    const Corners face{Vec3(-1, -full(random, 0.5, 1), 0), Vec3(1, -full(random, 0.5, 1), 0), Vec3(0, 1, 0)};
    const Corners other{Vec3(0, 0, 0), Vec3(full(random, 0, 1), 0.5, full(random, 0.125, 1)),
                        Vec3(-0.5, full(random, -1, 1), full(random, 0.125, 1))};
    made.a = one_triangle(face);
    made.b = one_triangle({other[1], other[2], other[0]});
    made.pose_b = made.pose_a;
    made.pose_b.t += made.pose_a.R * Vec3(full(random, -0.25, 0.25), full(random, -0.25, 0.25), gap);
    if (coin(random)) std::swap(made.a, made.b), std::swap(made.pose_a, made.pose_b);
    return made;
}

DistanceCase gaps(Random& random) {
    return above_a_face(random, std::ldexp(full(random, 0.5, 1), -integer(random, 0, 60)));
}

DistanceCase far(Random& random) {
    DistanceCase made = gaps(random);
    Vec3 away;
    const double far = random.below(3) == 0 ? 1e8 : std::ldexp(1.0, integer(random, 20, 60));
    for (int k = 0; k < 3; ++k) away[k] = far * full(random, -1, 1);
    made.pose_a.t += away;
    made.pose_b.t += away;
    return made;
}

DistanceCase singular(Random& random) {
    DistanceCase made = apart(random);
    for (Pose* pose : {&made.pose_a, &made.pose_b}) {
        if (!make_singular(*pose, random) && random.below(4) == 0) pose->R.setZero();
    }
    return made;
}

DistanceCase scaled(Random& random) {
    DistanceCase made = coin(random) ? apart(random) : bricks(random);
    const double scale = std::ldexp(1.0, integer(random, -900, 900));
    for (Pose* pose : {&made.pose_a, &made.pose_b}) {
        pose->R *= scale;
        pose->t *= scale;
    }
    return made;
}

DistanceCase subnormal(Random& random) {
    const int size = 1 << integer(random, 1, 20);
    const auto number = [&] { return static_cast<double>(integer(random, -size, size)) * 0x1p-1074; };
    Corners a, b;
    DistanceCase made;
    for (int k = 0; k < 3; ++k) {
        for (std::size_t i = 0; i < 3; ++i) {
            a[i][k] = number();
            b[i][k] = number();
        }
        made.pose_b.t[k] = 2 * number();
    }
    made.a = one_triangle(a);
    made.b = one_triangle(b);
    if (coin(random)) made.pose_a.R = rotation(random);
    if (random.below(4) == 0) made.pose_b.R *= 0x1p-30;
    return made;
}

DistanceCase wide_exponents(Random& random) {
    DistanceCase made;
    const int width = random.below(8) != 0 ? 60 : 400;
    const auto number = [&] {
        const double x = full(random, -1, 1);
        return random.below(8) == 0 ? 0 : std::ldexp(x, integer(random, -width, width));
    };
    Corners a, b;
    for (Corners* corners : {&a, &b}) {
        for (Vec3& v : *corners) {
            for (int k = 0; k < 3; ++k) v[k] = number();
        }
    }
    made.a = one_triangle(a);
    made.b = one_triangle(b);
    if (coin(random)) made.pose_a = random_pose(random);
    if (random.below(4) == 0) {
        for (int i = 0; i < 9; ++i) made.pose_b.R.data()[i] = number();
    }
    for (int k = 0; k < 3; ++k) made.pose_b.t[k] = number();
    return made;
}

std::shared_ptr<const Mesh> small_mesh(Random& random) {
    const bool is_large = random.below(8) == 0;
    switch (random.below(3)) {
        case 0:
            return is_large ? sphere(8, 6) : sphere(3 + random.below(3), 2 + random.below(2));
        case 1:
            return is_large ? torus(7, 6, 0.4) : torus(3 + random.below(2), 3, 0.4);
        default:
            return cube(0.5);
    }
}

DistanceCase small_meshes(Random& random) {
    DistanceCase made{small_mesh(random), small_mesh(random), random_pose(random), random_pose(random), {}};
    made.pose_b.t = made.pose_a.t + full(random, 0, 3) * random.direction();
    if (random.below(4) == 0) made.pose_b.R = made.pose_a.R;
    return made;
}

DistanceCase squeezed(Random& random) {
    DistanceCase made = coin(random) ? small_meshes(random) : coin(random) ? apart(random) : gaps(random);
    for (Pose* pose : {&made.pose_a, &made.pose_b}) {
        const int column = integer(random, 0, 2);
        if (coin(random)) pose->R.col(column) *= std::ldexp(full(random, 0.5, 1), -integer(random, 10, 60));
        if (coin(random)) pose->R.col(column) += 3 * pose->R.col((column + 1) % 3);
        if (coin(random)) made.pose_b.R = made.pose_a.R;
    }
    return made;
}

DistanceCase zero_area(Random& random) {
    Corners a = random_corners(random), b = random_corners(random);
    const bool is_lattice = coin(random);
    for (Corners* corners : {&a, &b}) {
        for (Vec3& v : *corners) {
            for (int k = 0; k < 3 && is_lattice; ++k) v[k] = integer(random, -2, 2);
        }
        switch (random.below(4)) {
            case 0:
                (*corners)[2] = (*corners)[0];
                break;
            case 1:
                (*corners)[1] = 0.5 * ((*corners)[0] + (*corners)[2]);
                break;
            case 2:
                (*corners)[1] = (*corners)[2] = (*corners)[0];
                break;
            default:
                break;
        }
    }
    DistanceCase made{one_triangle(a), one_triangle(b), {}, {}, {}};
    if (coin(random)) made.pose_a = random_pose(random);
    if (coin(random)) made.pose_b = made.pose_a;
    return made;
}

constexpr Family<DistanceCase> table[] = {
    {"apart", apart},                // two random triangles at any distance, in random poses
    {"hard pairs", from_hard_pair},  // those of hard_pairs.hpp, as they are or moved apart
    {"needles", needles},            // fans of triangles thin by 2^-20 to 2^-45, whose tips come near each other
    // Boxes of 12 to 108 triangles on a grid of tenths, in one pose or in two: ties of many features
    {"bricks", bricks},
    // Known: triangles in parallel planes of a lattice, each in an integer rotation of its own
    {"parallel faces", parallel_faces},
    // Known: a lattice feature at an integer distance, or that times 2^-k, in integer rotations
    {"lattice features", lattice_features},
    {"gaps", gaps},  // a vertex above a face by 2^-1 to 2^-60, in a random rotation
    // Gaps of nothing, or of what rounding leaves
    {"vertex on a face", [](Random& random) { return above_a_face(random, 0); }},
    {"far", far},                        // near each other, and 1e8, 2^50 or more from the origin
    {"squeezed", squeezed},              // a column of the matrix is 2^-10 to 2^-60 of the others, or they are sheared
    {"singular", singular},              // a matrix without an inverse
    {"scaled", scaled},                  // at scales of 2^-900 to 2^900
    {"subnormal", subnormal},            // integers of some digits, times 2^-1074
    {"wide exponents", wide_exponents},  // coordinates of any exponents
    {"half-way", half_way},              // known: distances half-way between two doubles, or a hair beside
    // Spheres, tori and boxes of 6 to 84 triangles in random poses, near each other or not
    {"small meshes", small_meshes},
    {"zero area", zero_area},  // segments and points among the triangles
};

}  // namespace

Families<DistanceCase> distance_families() {
    return table;
}

}  // namespace ecods::scenes
