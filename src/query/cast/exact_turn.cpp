#include "query/cast/exact_turn.hpp"

#include <utility>

namespace ecods {

using exact::BinaryFraction;

ExactTurn::ExactTurn(const Quaternion& q, BinaryFraction s) : time(std::move(s)) {
    const exact::TurnIntegers turn(q.w, {q.x, q.y, q.z});
    a = (turn.e << time.bits) + time.m * turn.u;
    b = time.m;
    v = turn.v;
}

}  // namespace ecods
