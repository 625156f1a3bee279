// Motions of the second body of a turn case.
#include <algorithm>
#include <array>
#include <cmath>

#include "scenes/hard_pair_parts.hpp"
#include "scenes/lattice_bodies.hpp"
#include "scenes/turn_cases.hpp"

namespace ecods::scenes {
namespace {

using hard::coin;
using hard::integer;

// A power of two that is about the size of a: pivots are as far as the bodies are large.
double unit_of(const TurnCase& made) {
    double size = 0;
    for (const Vec3& v : made.a->vertices()) size = std::max(size, (made.pose_a.R * v).cwiseAbs().maxCoeff());
    return size > 0 && size < 0x1p1000 ? std::ldexp(1.0, std::ilogb(size)) : 1;
}

}  // namespace

Quaternion small_quaternion(Random& random, int size) {
    for (;;) {
        const Quaternion q{double(integer(random, -size, size)), double(integer(random, -size, size)),
                           double(integer(random, -size, size)), double(integer(random, -size, size))};
        if (q.w > 0 || q.x != 0 || q.y != 0 || q.z != 0) return q;
    }
}

Pose pose_beside(Random& random, const TurnCase& made) {
    Pose to = made.pose_b;
    const Vec3 away = to.t + unit_of(made) * lattice_point(random, random.below(3) == 0 ? 1 : 5);
    if (away.allFinite()) to.t = away;
    const int axis = integer(random, 0, 2);
    switch (random.below(8)) {
        case 0:
            to.R = -to.R;
            break;
        case 1:
            to.R.col(axis) = -to.R.col(axis);
            break;
        case 2:
            to.R.col(axis).swap(to.R.col((axis + 1) % 3));
            break;
        case 3:
            to.R.col(axis).setZero();
            break;
        case 4:
            to.R *= std::ldexp(1.0, integer(random, -3, 1));
            break;
        case 5:
            to.R.setZero();
            break;
        case 6:
            to.R.row(axis) = to.R.row((axis + 1) % 3) - 0.5 * to.R.row(axis);
            break;
        default:
            break;
    }
    if (!to.R.allFinite()) to.R = made.pose_b.R;
    return to;
}

Turn turn_beside(Random& random, const TurnCase& made) {
    const auto& [w, x, y, z] = made.turn.q;
    const double unit = unit_of(made);
    const auto point = [&](int most) { return Vec3(unit * lattice_point(random, most)); };
    const Turn &turn = made.turn, back{{w, -x, -y, -z}, turn.pivot_from, turn.pivot_to};
    const Vec3 by = point(2), pivot = point(3), to = coin(random) ? pivot : Vec3(pivot + point(2));
    const std::array<Turn, 5> turns{Turn{{double(integer(random, 1, 3)), 0, 0, 0}, turn.pivot_from, turn.pivot_from},
                                    turn, back, Turn{turn.q, turn.pivot_from + by, turn.pivot_to + by},
                                    Turn{back.q, turn.pivot_from + by, turn.pivot_to + by}};
    const std::size_t kind = random.below(7);
    return kind < turns.size() ? turns[kind] : Turn{small_quaternion(random, 2), pivot, to};
}

}  // namespace ecods::scenes
