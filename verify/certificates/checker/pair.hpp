// Posed meshes in integers, and proofs that their parts are apart.
#pragma once

#include <unordered_map>

#include "mesh.hpp"
#include "vectors.hpp"

namespace certificate_checker {

// All posed corners are multiples of 2^unit_of.
inline int unit_of(const PosedMesh& posed) {
    const auto& [R, t] = posed.pose;
    return std::min(posed.mesh->low + std::min({unit_of(R[0]), unit_of(R[1]), unit_of(R[2])}), unit_of(t));
}

// A posed mesh: its corners in units of 2^unit, at most unit_of.
struct Body {
    Body(const PosedMesh& posed_mesh, int unit_exponent, Budget& work)
        : posed(posed_mesh), mesh(*posed_mesh.mesh), unit(unit_exponent), budget(work) {}
    const Vector<Integer>& point(std::uint32_t vertex) {
        const auto [place, is_new] = points.try_emplace(vertex);
        if (!is_new) return place->second;
        if (pose.empty()) {
            for (const auto& row : posed.pose.R) pose.push_back(integers(row, unit - mesh.low));
            pose.push_back(integers(posed.pose.t, unit));
        }
        const Vector<Integer> v = integers(mesh.vertices[vertex], mesh.low);
        budget.spend(64 + 3 * limbs(v) * (limbs(pose[0]) + limbs(pose[1]) + limbs(pose[2])));
        for (std::size_t k = 0; k < 3; ++k) place->second[k] = dot(pose[k], v) + pose[3][k];
        return place->second;
    }
    const Vector<Integer>& corner(std::uint32_t part, std::size_t k) { return point(mesh.corners(part)[k % 3]); }

    const PosedMesh& posed;
    const Mesh& mesh;
    int unit;
    Budget& budget;
    std::vector<Vector<Integer>> pose;                          // R's rows and t, once a point is asked for
    std::unordered_map<std::uint32_t, Vector<Integer>> points;  // those asked for so far
};

// When two parts are apart along a vector (README.md, "Apart"). The last two: the gap beside the distance m.
enum class Gap : std::uint8_t { positive, weak, half_open, at_least, more_than };
struct Rule {
    Gap gap = Gap::positive;
    Integer m = 0;  // in the bodies' unit
};
// The ranges of a body along the coordinate axes, in its unit.
struct Span {
    Integer low, high;
};

// Both bodies are in the same unit. Throws Refusal unless the steps prove that all of a is apart from all of b.
void check_steps(Body& a, Body& b, const Rule& rule, const Proof& proof, Budget& budget);
// Whether one of the 32 formulas has the claim's triangles apart.
bool are_separated(Body& a, Body& b, Gap gap, const Claim& claim, Budget& budget);
Vector<Span> box_of(Body& body, Budget& budget);

}  // namespace certificate_checker
