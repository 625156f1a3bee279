// Known configurations with their exact answers.
//
// A file of cases is JSON: {"cases": [{"id": ..., "shapes": {"A": mesh, "B": mesh}, "transforms": {"A": pose, "B":
// pose}, "expected_true_answer": {"surfaces_intersect_exact_affine": bool, "n_pairs_exact_affine": count}}, ...]},
// where a mesh is {"vertices", "triangles"} and a pose is {"R", "t"}; other keys are ignored. Cases without a shape
// "A", such as sequences of moves described in words, are skipped.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace ecods::check {

struct CaseAnswer {
    std::string id;
    bool intersects = false;
    std::size_t triangle_pair_count = 0;
    bool is_ok = false;  // as expected in both orders of arguments, each way of asking, and the oracle if asked
};

struct CasesReport {
    std::vector<CaseAnswer> cases;
    std::size_t skipped = 0;
};

// Throws scenes::ReadError.
CasesReport run_cases(const std::filesystem::path& file, bool with_oracle);

}  // namespace ecods::check
