#include <array>
#include <cmath>

#include "scenes/cast_cases.hpp"
#include "scenes/distance_cases.hpp"
#include "scenes/hard_pair_parts.hpp"
#include "scenes/integer_rotation.hpp"
#include "scenes/lattice_bodies.hpp"

namespace ecods::scenes {
namespace {

using hard::coin;
using hard::full;
using hard::integer;

// A triangle whose corners are the columns of its matrix: each goes where it will.
std::shared_ptr<const Mesh> columns() {
    return Mesh::create({Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()}, {{0, 1, 2}});
}

MoveCase of_columns() {
    return {columns(), columns(), {}, {}, {}, {}};
}

std::array<Pose*, 4> poses_of(MoveCase& made) {
    return {&made.from_a, &made.to_a, &made.from_b, &made.to_b};
}

MoveCase lattice(Random& random) {
    MoveCase made = of_columns();
    const int size = integer(random, 1, 4);
    for (Pose* pose : poses_of(made)) pose->R = integer_entries(random, size);
    // Apart at the start, mostly; and mostly some corners stay.
    made.from_a.t = made.to_a.t = lattice_point(random, size + 1);
    if (coin(random)) made.to_a.t -= 2 * made.from_a.t;
    if (random.below(3) == 0) made.to_b = made.from_b;
    if (random.below(3) == 0) made.to_a.R.col(0) = made.from_a.R.col(0);
    return made;
}

MoveCase lattice_one_ulp(Random& random) {
    MoveCase made = lattice(random);
    Pose& pose = *poses_of(made)[random.below(4)];
    hard::nudge(pose.R(integer(random, 0, 2), integer(random, 0, 2)), random);
    return made;
}

MoveCase integer_matrix(Random& random) {
    MoveCase made{lattice_mesh(random, 2, 3, false), lattice_mesh(random, 2, 3, false), {}, {}, {}, {}};
    const double scale = std::ldexp(1.0, integer(random, -900, 900));
    for (Pose* pose : poses_of(made)) {
        pose->R = scale * integer_entries(random, 2);
        pose->t = scale * lattice_point(random, 3);
    }
    if (random.below(3) == 0) made.to_b = made.from_b;
    return made;
}

MoveCase in_one_plane(Random& random) {
    MoveCase made = lattice(random);
    const hard::Basis basis(random);
    const bool is_tilted = coin(random);
    for (Pose* pose : poses_of(made)) {
        pose->R.row(2).setZero();
        pose->t[2] = 0;
        if (!is_tilted) continue;
        for (int column = 0; column < 3; ++column) pose->R.col(column) = in_basis(Vec3(pose->R.col(column)), basis);
        pose->t = in_basis(Vec3(pose->t), basis);
    }
    return made;
}

// A vertex goes from x = -1 to 1. The ends of an edge go so that its height above the vertex is k (1 - 2 s)^2 + lift:
// at half-way they touch, or just not.
MoveCase double_roots(Random& random) {
    MoveCase made = of_columns();
    const double k = integer(random, 1, 7);
    const int which = integer(random, 0, 2);
    const double lift =
        which == 0 ? 0 : std::ldexp(which == 1 ? 1.0 : -k / 16, which == 1 ? -integer(random, 0, 40) : 0);
    made.from_a.R << -1, -2, -2, 0, -1, 1, 0, -5, -6;
    made.to_a.R << 1, 2, -2, 0, -1, 1, 0, -6, -5;
    made.from_b.R << -1, 1, 0, 0, 0, 2, k + lift, lift, 500;
    made.to_b.R << -1, 1, 0, 0, 0, 2, -2 * k + lift, k + lift, 500;
    // 1 - 4 s + 4 s^2 = 1 / 16 at 3 / 8.
    made.time = which == 0 ? 0.5 : which == 1 ? -1 : 0.375;
    const IntegerRotation of_space(random);
    const double scale = std::ldexp(1.0, integer(random, -300, 300));
    for (Pose* pose : poses_of(made)) pose->R = scale * (of_space.R * pose->R);
    if (coin(random)) {
        std::swap(made.from_a, made.from_b);
        std::swap(made.to_a, made.to_b);
    }
    return made;
}

MoveCase turned_over(Random& random) {
    MoveCase made{lattice_mesh(random, 2, 3, false), lattice_mesh(random, 2, 3, false), {}, {}, {}, {}};
    made.from_a.R = integer_entries(random, 2);
    made.to_a.R = made.from_a.R;
    const int axis = integer(random, 0, 2);
    for (int k = 0; k < 3; ++k) {
        if (k == axis || random.below(4) == 0) made.to_a.R.row(k) *= -1;
    }
    made.from_a.t = made.to_a.t = lattice_point(random, 3);
    if (coin(random)) made.to_a.t += lattice_point(random, 1);
    if (coin(random)) made.to_b.R = integer_entries(random, 1);
    return made;
}

MoveCase casts(Random& random) {
    const Family<CastCase>& family = any_family(cast_families(), random);
    const CastCase cast = family.make(random);
    MoveCase made{cast.a, cast.b, cast.pose_a, cast.pose_a, cast.pose_b, cast.pose_b};
    made.to_a.t += cast.motion;
    if (made.to_a.t - made.from_a.t == cast.motion && family.name == "rational") made.time = cast.time;
    if (!made.to_a.t.allFinite()) made.to_a.t = made.from_a.t;
    return made;
}

double rounded(double x, int digits) {
    return std::ldexp(std::round(std::ldexp(x, digits)), -digits);
}

MoveCase short_numbers(Random& random) {
    const DistanceCase pair = family_named(distance_families(), "small meshes").make(random);
    MoveCase made{pair.a, pair.b, {}, {}, {}, {}};
    const Vec3 way = 3 * random.direction();
    const double aside = full(random, -1, 1);
    for (Pose* pose : poses_of(made)) {
        pose->R = hard::rotation(random);
        pose->t = aside * random.direction();
    }
    made.to_a.R = made.from_a.R + 0.25 * made.to_a.R;
    made.to_b.R = made.from_b.R + 0.25 * made.to_b.R;
    made.from_a.t += way;
    made.to_a.t -= way;
    for (Pose* pose : poses_of(made)) {
        for (int i = 0; i < 9; ++i) pose->R.data()[i] = rounded(pose->R.data()[i], 20);
        for (int k = 0; k < 3; ++k) pose->t[k] = rounded(pose->t[k], 20);
    }
    return made;
}

MoveCase from_distance_case(Random& random) {
    const Family<DistanceCase>& family = any_family(distance_families(), random);
    const DistanceCase pair = family.make(random), other = family.make(random);
    MoveCase made{pair.a, pair.b, pair.pose_a, pair.pose_a, pair.pose_b, pair.pose_b};
    const double share = std::ldexp(1.0, -integer(random, 0, 40));
    made.to_a.R += share * (other.pose_a.R - made.to_a.R);
    if (coin(random)) made.to_b.R += share * (other.pose_b.R - made.to_b.R);
    const Vec3 corner_a = any_corner(*made.a, made.from_a, random), corner_b = any_corner(*made.b, made.from_b, random);
    made.from_a.t += integer(random, -1, 1) * (corner_a - corner_b);
    made.to_a.t += integer(random, 0, 2) * (corner_b - corner_a);
    for (Pose* pose : poses_of(made)) {
        if (!pose->R.allFinite()) pose->R = pair.pose_a.R;
        if (!pose->t.allFinite()) pose->t = pair.pose_a.t;
    }
    return made;
}

constexpr Family<MoveCase> table[] = {
    {"lattice", lattice},                   // corners that go from lattice point to lattice point, each by itself
    {"lattice, one ulp", lattice_one_ulp},  // the same, one number a unit in the last place off
    // Small lattices between matrices of small integers: flat bodies at the ends and on the way
    {"integer matrix", integer_matrix},
    {"in one plane", in_one_plane},  // the first, all corners in one plane all the time
    // Known: a vertex and an edge that only graze each other half-way, or just not
    {"double roots", double_roots},
    {"turned over", turned_over},      // bodies that go through a flat pose
    {"casts", casts},                  // those above, as motions; known where these are
    {"short numbers", short_numbers},  // rotations of 20 bits a bit apart: poses on the way are doubles
    // The bodies of distance_cases.hpp, each on its way to another pose of its own kind
    {"bodies of distances", from_distance_case},
};

}  // namespace

Families<MoveCase> move_families() {
    return table;
}

}  // namespace ecods::scenes
