// Pairs of posed triangles on which predicates fail, by family; some with answers that are known without any predicate.
// The table of hard_pairs.cpp says what each family makes.
#pragma once

#include <array>
#include <optional>

#include "ecods/pose.hpp"
#include "scenes/families.hpp"

namespace ecods::scenes {

struct PosedPair {
    Pose pose_a;
    Pose pose_b;
    std::array<Vec3, 3> a;
    std::array<Vec3, 3> b;
    std::optional<bool> intersects;  // where the recipe knows it
};

Families<PosedPair> hard_families();

}  // namespace ecods::scenes
