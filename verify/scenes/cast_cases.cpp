#include "scenes/cast_cases.hpp"

#include <array>
#include <cmath>
#include <vector>

#include "scenes/distance_cases.hpp"
#include "scenes/hard_pair_parts.hpp"
#include "scenes/integer_rotation.hpp"
#include "scenes/lattice_bodies.hpp"

namespace ecods::scenes {
namespace {

using hard::Basis;
using hard::coin;
using hard::integer;

CastCase on_lattice(Random& random, int size, bool is_flat) {
    CastCase made{lattice_mesh(random, size, 3, is_flat), lattice_mesh(random, size, 3, is_flat), {}, {}, {}};
    made.pose_a.t = lattice_point(random, size);
    made.motion = random.below(16) == 0 ? Vec3(Vec3::Zero()) : lattice_point(random, 2 * size);
    if (coin(random)) made.motion = -2 * made.pose_a.t + lattice_point(random, 1);
    if (is_flat) made.pose_a.t[2] = made.motion[2] = 0;
    return made;
}

// Small integers times vectors of 45 bits are doubles.
void change_basis(CastCase& made, Random& random) {
    const Basis basis(random);
    made.a = in_basis(*made.a, basis);
    made.b = in_basis(*made.b, basis);
    made.pose_a.t = in_basis(made.pose_a.t, basis);
    made.motion = in_basis(made.motion, basis);
}

CastCase lattice(Random& random) {
    CastCase made = on_lattice(random, 2, false);
    if (coin(random)) change_basis(made, random);
    return made;
}

CastCase lattice_one_ulp(Random& random) {
    CastCase made = lattice(random);
    hard::nudge((coin(random) ? made.motion : made.pose_a.t)[integer(random, 0, 2)], random);
    return made;
}

CastCase integer_matrix(Random& random) {
    CastCase made = on_lattice(random, 2, false);
    const double scale = std::ldexp(1.0, integer(random, -900, 900));
    for (Pose* pose : {&made.pose_a, &made.pose_b}) {
        if (random.below(4) != 0) pose->R = integer_entries(random, 2);
        pose->R *= scale;
        pose->t *= scale;
    }
    made.motion *= random.below(8) == 0 ? std::ldexp(scale, integer(random, -60, 60)) : scale;
    return made;
}

CastCase in_one_plane(Random& random) {
    CastCase made = on_lattice(random, 3, true);
    if (coin(random)) change_basis(made, random);
    return made;
}

// A vertex, or an edge, of a comes down at q a time on a feature of b that is p below, moved sideways so that it just
// gets there.
CastCase rational(Random& random) {
    const double p = integer(random, 1, 300), q = coin(random) ? p : integer(random, 1, 600);
    const Vec3 slope(integer(random, -3, 3), integer(random, -3, 3), 0);
    const std::array<Vec3, 7> feet{Vec3(1, 1, 0), Vec3(2, 0, 0), Vec3(2, 2, 0), Vec3(0, 3, 0),
                                   Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};
    const Vec3 foot = feet[random.below(feet.size())];
    const auto up = [&] { return double(integer(random, 1, 9)) * q; };
    std::vector<Vec3> a{Vec3(0, 0, 0), Vec3(up(), -up(), up()), Vec3(-up(), up(), up())};
    // Across the edge from (0, 0) to (4, 0), and level.
    if (coin(random) && foot[1] == 0) a = {Vec3(0, -q, 0), Vec3(0, 2 * q, 0), Vec3(up(), 0, up())};
    CastCase made{Mesh::create(std::move(a), {{0, 1, 2}}),
                  Mesh::create({Vec3(0, 0, 0), Vec3(4 * q, 0, 0), Vec3(0, 4 * q, 0)}, {{0, 1, 2}}),
                  {},
                  {},
                  {}};
    const IntegerRotation of_space(random);
    const Mat3 R = std::ldexp(1.0, integer(random, -800, 800)) * of_space.R;
    made.pose_a.R = made.pose_b.R = R;
    made.pose_a.t = R * (q * foot - p * slope + Vec3(0, 0, p * q));
    made.motion = R * (q * (slope - Vec3(0, 0, q)));
    made.time = p <= q ? p / q : -1;
    return made;
}

CastCase boxes(Random& random) {
    CastCase made{lattice_box(random), lattice_box(random), {}, {}, {}};
    made.pose_a.t = lattice_point(random, 9);
    made.motion = -made.pose_a.t + lattice_point(random, 3);
    if (coin(random)) made.motion *= 3;
    if (coin(random)) {
        made.pose_a.R = made.pose_b.R = hard::rotation(random);
        made.pose_a.t = made.pose_a.R * made.pose_a.t;
        made.motion = made.pose_a.R * made.motion;
    }
    return made;
}

CastCase from_distance_case(Random& random) {
    const DistanceCase pair = any_family(distance_families(), random).make(random);
    CastCase made{pair.a, pair.b, pair.pose_a, pair.pose_b, {}};
    // Back by some sizes of the bodies first, since many of them touch.
    const Vec3 corner_a = any_corner(*made.a, made.pose_a, random), corner_b = any_corner(*made.b, made.pose_b, random);
    const Vec3 back = integer(random, -2, 2) * (corner_b - any_corner(*made.b, made.pose_b, random)) +
                      integer(random, -1, 1) * (corner_a - corner_b);
    made.pose_a.t += back;
    made.motion = corner_b - (corner_a + back);
    switch (random.below(6)) {
        case 0:
            made.motion *= 2;
            break;
        case 1:
            hard::nudge(made.motion[integer(random, 0, 2)], random);
            break;
        case 2:
            made.motion *= std::ldexp(1.0, integer(random, -60, 60));
            break;
        case 3:
            made.motion = -back;
            break;
        default:
            break;
    }
    if (!made.pose_a.t.allFinite()) made.pose_a.t = pair.pose_a.t;
    if (!made.motion.allFinite()) made.motion = Vec3(0x1p900, 0, 0);
    return made;
}

constexpr Family<CastCase> table[] = {
    // Small lattice triangles and steps in a basis of full mantissas: grazing, sliding, at 0, at 1
    {"lattice", lattice},
    {"lattice, one ulp", lattice_one_ulp},  // the same, one number a unit in the last place off
    // Small lattices under matrices of small integers, singular ones and reflections among them
    {"integer matrix", integer_matrix},
    // Known: lattice features that meet at p / q, or just not, in an integer rotation
    {"rational", rational},
    {"in one plane", in_one_plane},  // lattice triangles that slide in the plane of both
    {"boxes", boxes},                // boxes of small integer sizes: many triangles and features meet at once
    // The bodies of distance_cases.hpp, sent at each other's corners, past them, and just not so far
    {"bodies of distances", from_distance_case},
};

}  // namespace

Families<CastCase> cast_families() {
    return table;
}

}  // namespace ecods::scenes
