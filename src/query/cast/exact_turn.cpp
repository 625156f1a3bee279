#include "query/cast/exact_turn.hpp"

#include <algorithm>

#include "exact/point/vectors.hpp"

namespace ecods {

using exact::BinaryFraction;
using exact::Dyadic;
using exact::Integer;
using exact::LongVector3;

ExactTurn::ExactTurn(const Quaternion& q, BinaryFraction s) : time(std::move(s)) {
    const exact::TurnIntegers turn(q.w, {q.x, q.y, q.z});
    a = (turn.e << time.bits) + time.m * turn.u;
    b = time.m;
    v = turn.v;
    norm = a * a + (b * b) * exact::dot(v, v);
}

// With u = b v: Q g = N g + 2 a u x g + 2 u x (u x g) (turning_triangles.hpp).
LongVector3 ExactTurn::rotated(const LongVector3& g) const {
    const LongVector3 once = exact::cross(v, g), twice = exact::cross(v, once);
    const Integer ab = a * b, bb = b * b;
    LongVector3 result;
    for (std::size_t k = 0; k < 3; ++k) {
        const Integer half = ab * once[k] + bb * twice[k];
        result[k] = norm * g[k] + (half + half);
    }
    return result;
}

BinaryFraction binary_fraction(double x) {
    const Dyadic d = exact::decode(x);
    return d.e >= 0 ? BinaryFraction{Integer(d.m) << d.e, 0} : BinaryFraction{Integer(d.m), -d.e};
}

BinaryFraction middle_of(double x, double y) {
    const BinaryFraction first = binary_fraction(x), second = binary_fraction(y);
    const int bits = std::max(first.bits, second.bits);
    return {(first.m << (bits - first.bits)) + (second.m << (bits - second.bits)), bits + 1};
}

}  // namespace ecods
