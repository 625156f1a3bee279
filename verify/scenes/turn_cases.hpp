// Bodies that turn towards bodies at rest, by family; some with times that are known without computing one.
// The table of turn_cases.cpp says what each family makes.
#pragma once

#include <memory>

#include "ecods/mesh.hpp"
#include "ecods/turn.hpp"
#include "scenes/cast_cases.hpp"
#include "scenes/families.hpp"

namespace ecods::scenes {

// a turns.
struct TurnCase {
    std::shared_ptr<const Mesh> a, b;
    Pose pose_a, pose_b;
    Turn turn = {};
    KnownTime time = {};
};

Families<TurnCase> turn_families();

// Small integers that are a turn.
Quaternion small_quaternion(Random& random, int size);

// A turn of b, for a case in which b is at rest: no turn, that of a, its reverse, the same about another axis, or any.
Turn turn_beside(Random& random, const TurnCase& made);

// A pose to which b goes straight, for a case in which b is at rest: elsewhere only, or also mirrored at the origin or
// on a plane, turned, flat, larger, smaller, or a point.
Pose pose_beside(Random& random, const TurnCase& made);

}  // namespace ecods::scenes
