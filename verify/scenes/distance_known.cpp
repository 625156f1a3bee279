// The families whose distances are known: integers all through, or half-way between two doubles by construction.
#include <cmath>

#include "scenes/distance_recipes.hpp"
#include "scenes/hard_pair_parts.hpp"
#include "scenes/integer_rotation.hpp"
#include "scenes/shapes.hpp"

namespace ecods::scenes::closeness {
namespace {

using hard::coin;
using hard::full;
using hard::integer;

// The two bodies in the common frame `a` and `b`, written each in an integer rotation of its own, at a scale: `height`
// is their distance before. All of it small integers, and so exact.
DistanceCase in_integer_rotations(const Corners& a, const Corners& b, double height, Random& random) {
    const IntegerRotation of_space(random), of_a(random), of_b(random);
    const double scale = std::ldexp(1.0, integer(random, -600, 600));
    Corners own_a = a, own_b = b;
    for (Vec3& v : own_a) v = of_a.R.transpose() * (of_b.norm * of_b.norm * v);
    for (Vec3& v : own_b) v = of_b.R.transpose() * (of_a.norm * of_a.norm * v);
    DistanceCase made{one_triangle(own_a), one_triangle(own_b), {}, {}, {}};
    made.pose_a.R = of_space.R * of_a.R * scale;
    made.pose_b.R = of_space.R * of_b.R * scale;
    for (int k = 0; k < 3; ++k) made.pose_a.t[k] = made.pose_b.t[k] = integer(random, -1000, 1000) * scale;
    // A matrix times its transpose is its norm squared.
    made.distance = height * of_a.norm * of_a.norm * of_b.norm * of_b.norm * of_space.norm * scale;
    return made;
}

}  // namespace

DistanceCase parallel_faces(Random& random) {
    Corners a, b;
    const int height = integer(random, 0, 5);
    for (Corners* corners : {&a, &b}) {
        do {
            for (Vec3& v : *corners) v = Vec3(integer(random, -3, 3), integer(random, -3, 3), 0);
        } while (((*corners)[1] - (*corners)[0]).cross((*corners)[2] - (*corners)[0]).z() == 0);
        // The origin is in both.
        (*corners)[0] = -((*corners)[1] + (*corners)[2]);
    }
    for (Vec3& v : b) v[2] = height;
    return in_integer_rotations(a, b, height, random);
}

// A vertex above the inside of a face; beside an edge by 3, 4, 5; beyond a vertex by 2, 3, 6; crossed edges.
DistanceCase lattice_features(Random& random) {
    const Corners face{Vec3(0, 0, 0), Vec3(9, 0, 0), Vec3(0, 9, 0)};
    const auto up = [&] { return integer(random, 1, 9); };
    switch (random.below(4)) {
        case 0: {
            const Vec3 foot(integer(random, 1, 4), integer(random, 1, 4), 0);
            const int height = up();
            const Vec3 tip = foot + Vec3(0, 0, height);
            return in_integer_rotations(face, {tip + Vec3(up(), -up(), up()), tip, tip + Vec3(-up(), up(), up())},
                                        height, random);
        }
        case 1: {
            const Vec3 tip(integer(random, 1, 8), -3, 4);
            return in_integer_rotations({face[1], face[2], face[0]},
                                        {tip, tip + Vec3(up(), -up(), up()), tip + Vec3(-up(), -up(), up())}, 5,
                                        random);
        }
        case 2: {
            const Vec3 tip(-2, -3, 6);
            return in_integer_rotations(face, {tip + Vec3(-up(), -up(), up()), tip + Vec3(-up(), -up(), up()), tip}, 7,
                                        random);
        }
        default: {
            const int height = up();
            const Corners a{Vec3(0, -up(), 0), Vec3(0, up(), 0), Vec3(up(), 0, -up())};
            return in_integer_rotations(
                a, {Vec3(-up(), 0, height), Vec3(0, up(), height + up()), Vec3(up(), 0, height)}, height, random);
        }
    }
}

// A plane's height is n + 1/2 in units of the last place of a double, which R v + t can be: t is n, and v the rest.
DistanceCase half_way(Random& random) {
    const double n = 0x1p52 + std::floor(full(random, 0, 0x1p52 - 2));
    double rest = 0.5;
    double expected = std::fmod(n, 2) == 0 ? n : n + 1;
    if (random.below(3) != 0) {
        const bool is_above = coin(random);
        rest += std::ldexp(is_above ? 1.0 : -1.0, -integer(random, 3, 50));
        expected = is_above ? n + 1 : n;
    }
    // Above a face, beside an edge or beyond a corner, one axis of space being the distance.
    Corners a{Vec3(-4, -4, 0), Vec3(8, -4, 0), Vec3(-4, 8, 0)};
    if (coin(random)) a = {Vec3(-4, 0, 0), Vec3(4, 0, 0), Vec3(0, 0, -3)};
    if (random.below(3) == 0) a = {Vec3(0, 0, 0), Vec3(4, 1, -2), Vec3(0, 0, -3)};
    const Corners b{Vec3(0, 0, rest), Vec3(1, 2, 1 + rest), Vec3(-3, 1, 2 + rest)};
    const double scale = std::ldexp(1.0, integer(random, -900, 900));
    DistanceCase made{one_triangle(a), one_triangle(b), {}, {}, expected * scale};
    made.pose_b.t[2] = n;
    const int axis = integer(random, 0, 2);
    for (Pose* pose : {&made.pose_a, &made.pose_b}) {
        pose->R.row(2).swap(pose->R.row(axis));
        std::swap(pose->t[2], pose->t[axis]);
        pose->R *= scale;
        pose->t *= scale;
    }
    return made;
}

}  // namespace ecods::scenes::closeness
