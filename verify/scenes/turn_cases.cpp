#include "scenes/turn_cases.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "scenes/distance_cases.hpp"
#include "scenes/hard_pair_parts.hpp"
#include "scenes/integer_rotation.hpp"
#include "scenes/lattice_bodies.hpp"
#include "scenes/shapes.hpp"

namespace ecods::scenes {
namespace {

using hard::coin;
using hard::full;
using hard::integer;

Quaternion unit_quaternion(Random& random) {
    const auto q = random.rotation();
    return {q.w(), q.x(), q.y(), q.z()};
}

Quaternion about_z(Quaternion q) {
    q.x = q.y = 0;
    if (q.z == 0 && q.w <= 0) q.w = 1;
    return q;
}

TurnCase lattice(Random& random) {
    TurnCase made{lattice_mesh(random, 2, 3, false), lattice_mesh(random, 2, 3, false), {}, {}};
    made.pose_a.t = lattice_point(random, 3);
    made.turn.q = small_quaternion(random, 2);
    made.turn.pivot_from = made.turn.pivot_to = lattice_point(random, 3);
    if (coin(random)) made.turn.pivot_to += lattice_point(random, 2);
    return made;
}

TurnCase lattice_one_ulp(Random& random) {
    TurnCase made = lattice(random);
    const std::array<double*, 6> numbers{&made.turn.q.w,
                                         &made.turn.q.z,
                                         &made.pose_a.t[integer(random, 0, 2)],
                                         &made.turn.pivot_to[integer(random, 0, 2)],
                                         &made.turn.pivot_from[integer(random, 0, 2)],
                                         &made.pose_b.t[integer(random, 0, 2)]};
    double& x = *numbers[random.below(6)];
    if (x != 0) hard::nudge(x, random);
    return made;
}

TurnCase integer_matrix(Random& random) {
    TurnCase made = lattice(random);
    const double scale = std::ldexp(1.0, integer(random, -900, 900));
    for (Pose* pose : {&made.pose_a, &made.pose_b}) {
        if (random.below(4) != 0) pose->R = integer_entries(random, 2);
        pose->R *= scale;
        pose->t *= scale;
    }
    made.turn.pivot_from *= scale;
    made.turn.pivot_to *= scale;
    return made;
}

TurnCase in_one_plane(Random& random) {
    TurnCase made{lattice_mesh(random, 3, 3, true), lattice_mesh(random, 3, 3, true), {}, {}};
    made.pose_a.t = lattice_point(random, 4);
    made.turn = {about_z(small_quaternion(random, 3)), lattice_point(random, 3), lattice_point(random, 3)};
    if (coin(random)) made.turn.pivot_to = made.turn.pivot_from;
    for (Vec3* v : {&made.pose_a.t, &made.turn.pivot_from, &made.turn.pivot_to}) (*v)[2] = 0;
    return made;
}

// Rotates all of space by an integer matrix, multiplies it by a power of two, and puts the pivot, which is at the
// origin, elsewhere. The axis must not become longer, since a factor on q would change the speed: the matrix is one
// whose norm divides out of the axis.
void place(TurnCase& made, Random& random) {
    const auto is_multiple = [](const Vec3& v, double norm) {
        double significand = norm;
        while (significand > 1) significand /= 2;
        return significand == 1 ||
               (std::fmod(v[0], norm) == 0 && std::fmod(v[1], norm) == 0 && std::fmod(v[2], norm) == 0);
    };
    for (int i = 0; i < 20; ++i) {
        const IntegerRotation of_space(random);
        const Vec3 axis = of_space.R * Vec3(made.turn.q.x, made.turn.q.y, made.turn.q.z);
        if (!is_multiple(axis, of_space.norm)) continue;
        made.turn.q = {made.turn.q.w, axis[0] / of_space.norm, axis[1] / of_space.norm, axis[2] / of_space.norm};
        const double scale = std::ldexp(1.0, integer(random, -200, 200));
        const Mat3 R = scale * of_space.R;
        const Vec3 pivot = scale * lattice_point(random, 9);
        made.turn.pivot_from = R * made.turn.pivot_from + pivot;
        made.turn.pivot_to = R * made.turn.pivot_to + pivot;
        for (Pose* pose : {&made.pose_a, &made.pose_b}) *pose = {R * pose->R, R * pose->t + pivot};
        return;
    }
}

// The turn about z by (w, 0, 0, z) at the time p / d, times its squared length.
struct FlatRotation {
    double real, axis, norm;

    FlatRotation(int w, int z, int p, int d)
        : real(d + p * (w - 1)), axis(double(p) * z), norm(real * real + axis * axis) {}
    Vec3 operator()(double x, double y, double height) const {
        return {(real * real - axis * axis) * x - 2 * real * axis * y,
                2 * real * axis * x + (real * real - axis * axis) * y, norm * height};
    }
};

// A spike leads in the half-plane of the axis and the x axis; a triangle is in the half-plane to which it turns until
// the time p / d, and has the spike's tip in it, on an edge, at a corner, or not at all.
TurnCase rational(Random& random) {
    const int d = integer(random, 1, 12), p = integer(random, 1, d), w = integer(random, 0, 3);
    const int z = integer(random, 1, 4);
    const FlatRotation turn(w, z, p, d);
    const double radius = integer(random, 2, 9), height = integer(random, -3, 3), glide = integer(random, -2, 2) * d;
    // Up to half a turn: behind the tip is never before the triangle.
    const double reached = height + glide * p / d;
    const auto behind = [&] {
        return Vec3(radius - integer(random, 0, 1), -integer(random, 1, 4) / 8.0, height + integer(random, -2, 2));
    };
    const std::vector<Vec3> spike{turn.norm * Vec3(radius, 0, height), turn.norm * behind(), turn.norm * behind()};
    const std::array<std::array<std::array<double, 2>, 3>, 4> profiles{{{{{-1, -1}, {2, -1}, {-1, 3}}},
                                                                        {{{-1, 0}, {2, 0}, {0, 3}}},
                                                                        {{{0, 0}, {1, 2}, {1, -2}}},
                                                                        {{{1, 0}, {2, 1}, {2, -1}}}}};
    const std::size_t which = random.below(4);
    std::vector<Vec3> wall;
    for (const auto& [r, h] : profiles[which]) wall.push_back(turn(radius + r, 0, reached + h));
    TurnCase made{Mesh::create(spike, {{0, 1, 2}}), Mesh::create(std::move(wall), {{0, 1, 2}}), {}, {}};
    made.turn.q = {double(w), 0, 0, double(z)};
    made.turn.pivot_to = turn.norm * Vec3(0, 0, glide);
    // Beyond the tip other points of the spike may still meet the triangle.
    if (which < 3) made.time = double(p) / d;
    place(made, random);
    return made;
}

// The corner of a triangle that is farthest from the axis reaches a plane, parallel to the axis, for a moment at p / d;
// or the plane is a little farther.
TurnCase grazing(Random& random) {
    const int d = integer(random, 1, 8), p = integer(random, 1, d), w = integer(random, 0, 2);
    const int z = integer(random, 1, 3);
    const FlatRotation turn(w, z, p, d);
    const double radius = integer(random, 4, 9);
    const auto inside = [&]() -> Vec3 {
        return turn.norm * Vec3(integer(random, 0, 2), integer(random, -2, 2), integer(random, -2, 2));
    };
    const double off = coin(random) ? 0 : std::ldexp(1.0, -integer(random, 0, 25));
    std::vector<Vec3> plane;
    for (const auto& [y, h] : {std::array{-1.0, -1.0}, {2.0, -1.0}, {-1.0, 3.0}}) {
        plane.push_back((1 + off) * turn(radius, y * radius, h * radius));
    }
    TurnCase made{Mesh::create({turn.norm * Vec3(radius, 0, 0), inside(), inside()}, {{0, 1, 2}}),
                  Mesh::create(std::move(plane), {{0, 1, 2}}),
                  {},
                  {}};
    made.turn.q = {double(w), 0, 0, double(z)};
    made.time = off == 0 ? double(p) / d : -1;
    place(made, random);
    return made;
}

// A translation with a length of its own for 1: known where the family is.
TurnCase glides(Random& random) {
    const Family<CastCase>& family = any_family(cast_families(), random);
    const CastCase cast = family.make(random);
    TurnCase made{cast.a, cast.b, cast.pose_a, cast.pose_b};
    made.turn.q.w = std::ldexp(1.0, integer(random, -3, 3));
    if (coin(random)) made.turn.pivot_from = -cast.motion;
    made.turn.pivot_to = made.turn.pivot_from + cast.motion;
    if (made.turn.pivot_to.allFinite()) {
        if (made.turn.pivot_from.isZero() || made.turn.pivot_to.isZero()) made.time = cast.time;
    } else {
        made.turn.pivot_from = made.turn.pivot_to = Vec3::Zero();
    }
    return made;
}

std::shared_ptr<const Mesh> box(const Vec3& min, const Vec3& max) {
    return mapped(*cube(1), [&](const Vec3& v) -> Vec3 {
        return {v[0] < 0 ? min[0] : max[0], v[1] < 0 ? min[1] : max[1], v[2] < 0 ? min[2] : max[2]};
    });
}

// A rod turns in place, or about one of its ends, past a post.
TurnCase rods(Random& random) {
    const double length = full(random, 0.5, 2), width = full(random, 0.01, 0.2), away = full(random, 0.1, 0.8);
    const double angle = full(random, 0.2, 3), half = width / 2;
    const Vec3 foot(length * away * std::sqrt(full(random, 0, 1)), length * away, -1);
    TurnCase made{box({coin(random) ? 0 : -length, -half, -half}, {length, half, half}),
                  box(foot, foot + Vec3(width, width, 2)),
                  {},
                  {}};
    made.turn.q = {1 - angle / 2, 0, 0, angle};
    if (coin(random)) made.turn.q = about_z(unit_quaternion(random));
    return made;
}

// A door slides on its sill, which ends at its hinge: coplanar faces all the way, or a bit apart.
TurnCase doors(Random& random) {
    const double width = integer(random, 2, 9) / 8.0,
                 height = coin(random) ? 0 : std::ldexp(1.0, -integer(random, 4, 50));
    const double thick = 0x1p-5;
    const Vec3 wedge(width * full(random, 0.2, 0.9), width * full(random, 0.1, 0.9), 0);
    TurnCase made{box({0, 0, height}, {width, thick, 2}), box(wedge, wedge + Vec3(thick, thick, thick)), {}, {}};
    if (coin(random)) made.b = box(wedge - Vec3(0, 0, 1), wedge + Vec3(1, 1, -1 + (coin(random) ? 0 : height)));
    made.turn.q = coin(random) ? Quaternion{1, 0, 0, 1} : about_z(unit_quaternion(random));
    return made;
}

// Teeth about an axis past teeth about another one.
std::shared_ptr<const Mesh> gear(int teeth, double inner, double outer) {
    static constexpr std::array<std::array<double, 2>, 12> circle{
        {{5, 0}, {4, 3}, {3, 4}, {0, 5}, {-3, 4}, {-4, 3}, {-5, 0}, {-4, -3}, {-3, -4}, {0, -5}, {3, -4}, {4, -3}}};
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
    for (int i = 0; i < teeth; ++i) {
        const auto at = [&](int k, double radius, double h) {
            const auto& [x, y] = circle[static_cast<std::size_t>((3 * i + k) % 12)];
            return Vec3(radius * x, radius * y, h);
        };
        const auto first = static_cast<std::uint32_t>(vertices.size());
        vertices.insert(vertices.end(), {at(0, inner, -1), at(1, outer, 0), at(2, inner, 1)});
        triangles.push_back({first, first + 1, first + 2});
    }
    return Mesh::create(std::move(vertices), std::move(triangles));
}

TurnCase gears(Random& random) {
    TurnCase made{gear(integer(random, 1, 4), 2, 4), gear(integer(random, 1, 4), integer(random, 1, 3), 4), {}, {}};
    // Outermost points, at 20, 12 and 16: from where they graze to where they overlap.
    made.pose_b.t = {double(integer(random, 30, 41)), coin(random) ? 0.0 : double(integer(random, -8, 8)), 0};
    made.turn.q = about_z(small_quaternion(random, 3));
    if (random.below(4) == 0) made.turn.q = about_z(unit_quaternion(random));
    return made;
}

double rounded(double x, int digits) {
    return std::ldexp(std::round(std::ldexp(x, digits)), -digits);
}

// Meshes at random poses, by any turn; of components rounded to 30 digits, or not; small turns, too.
TurnCase small_meshes(Random& random) {
    const DistanceCase pair = family_named(distance_families(), "small meshes").make(random);
    TurnCase made{pair.a, pair.b, random.turned(), random.turned()};
    made.pose_a.t = full(random, 0.5, 4) * random.direction();
    made.turn.q = unit_quaternion(random);
    made.turn.pivot_from = made.turn.pivot_to = full(random, 0, 3) * random.direction();
    if (coin(random)) made.turn.pivot_to += random.direction();
    if (random.below(4) == 0) {
        const double share = std::ldexp(1.0, -integer(random, 1, 40));
        made.turn.q = {1, share * made.turn.q.x, share * made.turn.q.y, share * made.turn.q.z};
    }
    if (coin(random)) {
        for (double* x : {&made.turn.q.w, &made.turn.q.x, &made.turn.q.y, &made.turn.q.z}) *x = rounded(*x, 30);
    }
    if (made.turn.q.x == 0 && made.turn.q.y == 0 && made.turn.q.z == 0) made.turn.q = {};
    return made;
}

// The pivot is far away, and the turn small.
TurnCase far_pivots(Random& random) {
    TurnCase made = small_meshes(random);
    const int digits = integer(random, 4, 40);
    const Vec3 away = std::ldexp(1.0, digits) * random.direction();
    const Vec3 axis = std::ldexp(full(random, 0.5, 4), -digits) * random.direction();
    made.turn = {{1, axis[0], axis[1], axis[2]}, away, away};
    if (random.below(4) == 0) made.turn.pivot_to += random.direction();
    return made;
}

// The bodies of distance_cases.hpp, about one of their corners or a point between.
TurnCase from_distance_case(Random& random) {
    const DistanceCase pair = any_family(distance_families(), random).make(random);
    TurnCase made{pair.a, pair.b, pair.pose_a, pair.pose_b};
    const Vec3 corner_a = any_corner(*made.a, made.pose_a, random), corner_b = any_corner(*made.b, made.pose_b, random);
    const Vec3 between = corner_a + integer(random, -1, 3) * 0.5 * (corner_b - corner_a);
    made.turn.pivot_from = made.turn.pivot_to = between;
    if (random.below(4) == 0) made.turn.pivot_to += corner_b - corner_a;
    made.turn.q = coin(random) ? small_quaternion(random, 2) : unit_quaternion(random);
    if (random.below(3) == 0) made.pose_a.t += integer(random, -2, 2) * (corner_b - corner_a);
    for (Vec3* v : {&made.turn.pivot_from, &made.turn.pivot_to}) {
        if (!v->allFinite()) *v = Vec3::Zero();
    }
    if (!made.pose_a.t.allFinite()) made.pose_a.t = pair.pose_a.t;
    return made;
}

constexpr Family<TurnCase> table[] = {
    {"lattice", lattice},                   // small lattice triangles, points and segments, by small quaternions
    {"lattice, one ulp", lattice_one_ulp},  // the same, one number a unit in the last place off
    // Small lattices under matrices of small integers, singular ones and reflections among them
    {"integer matrix", integer_matrix},
    {"in one plane", in_one_plane},  // lattice triangles that turn in the plane of both
    // Known: the tip of a spike meets a face, an edge or a corner at p / d, in an integer rotation
    {"rational", rational},
    {"grazing", grazing},  // known: the farthest point of a triangle touches a plane for a moment, or just not
    {"glides", glides},    // translations, with an idle quaternion
    {"rods", rods},        // rods past posts: many triangles, and irrational times
    {"doors", doors},      // boxes about a hinge, with faces in one plane all the way
    {"gears", gears},      // teeth past teeth, in planes through the axis and across it
    {"small meshes", small_meshes},  // any poses and any turns, small ones too
    {"far pivots", far_pivots},      // turns that are nearly translations
    // The bodies of distance_cases.hpp, about their corners: 2^-900 to 2^900, needles, and neighbours of contact
    {"bodies of distances", from_distance_case},
};

}  // namespace

Families<TurnCase> turn_families() {
    return table;
}

}  // namespace ecods::scenes
