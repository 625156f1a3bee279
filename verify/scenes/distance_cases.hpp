// Pairs of posed meshes on which distances go wrong, by family; some with distances that are known without computing
// one.
// The table of distance_cases.cpp says what each family makes.
#pragma once

#include <memory>
#include <optional>

#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"
#include "scenes/families.hpp"

namespace ecods::scenes {

struct DistanceCase {
    std::shared_ptr<const Mesh> a;
    std::shared_ptr<const Mesh> b;
    Pose pose_a;
    Pose pose_b;
    std::optional<double> distance;  // rounded once, where the recipe knows it
};

Families<DistanceCase> distance_families();

}  // namespace ecods::scenes
