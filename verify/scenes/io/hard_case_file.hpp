// Known configurations of two meshes with their exact answers.
//
// A file of cases is JSON: {"cases": [{"id": ..., "shapes": {"A": mesh, "B": mesh}, "transforms": {"A": pose, "B":
// pose}, "expected_true_answer": {"surfaces_intersect_exact_affine": bool, "n_pairs_exact_affine": count,
// "solid_relation_exact_affine": "apart", if both bound solids}}, ...]}, where a mesh is {"vertices", "triangles"} and
// a pose is {"R", "t"}; other keys are ignored. Cases without a shape "A", such as sequences of moves described in
// words, are skipped.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"

namespace ecods::scenes {

struct HardCase {
    struct Body {
        std::shared_ptr<const Mesh> mesh;
        Pose pose;
    };
    std::string id;
    Body a, b;
    bool intersects = false;
    std::size_t triangle_pair_count = 0;
    std::optional<std::string> solid_relation;  // as its operator<< writes it
};

struct HardCases {
    std::vector<HardCase> cases;
    std::size_t skipped = 0;
};

// Throws ReadError.
HardCases read_hard_cases(const std::filesystem::path& file);

}  // namespace ecods::scenes
