// Segments and rays beside posed meshes on which hits go wrong, by family; some with answers that are known without
// computing one.
// The table of hit_cases.cpp says what each family makes.
#pragma once

#include <memory>
#include <optional>
#include <variant>

#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"
#include "ecods/primitives.hpp"
#include "ecods/results.hpp"
#include "scenes/families.hpp"

namespace ecods::scenes {

struct HitCase {
    std::shared_ptr<const Mesh> mesh;
    Pose pose;
    std::variant<Segment, Ray> line;
    // Of the first hit, where the recipe knows it: rounded once; and what is hit.
    struct Known {
        double parameter;
        Feature feature;
    };
    std::optional<Known> known = {};
};

Families<HitCase> hit_families();

}  // namespace ecods::scenes
