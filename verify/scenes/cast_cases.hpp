// Bodies on their way to each other on which casts go wrong, by family; some with times that are known without
// computing one.
// The tables of cast_cases.cpp and move_cases.cpp say what each family makes.
#pragma once

#include <memory>
#include <optional>

#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"
#include "scenes/families.hpp"

namespace ecods::scenes {

// The first contact, where the recipe knows it: its time rounded once, or negative if there is none.
using KnownTime = std::optional<double>;

// a is translated.
struct CastCase {
    std::shared_ptr<const Mesh> a, b;
    Pose pose_a, pose_b;
    Vec3 motion = Vec3::Zero();
    KnownTime time = {};
};

Families<CastCase> cast_families();

// Both go from one pose to another.
struct MoveCase {
    std::shared_ptr<const Mesh> a, b;
    Pose from_a, to_a, from_b, to_b;
    KnownTime time = {};
};

Families<MoveCase> move_families();

}  // namespace ecods::scenes
