#include <cmath>

#include "oracle/float_environment.hpp"
#include "oracle/mesh_impl.hpp"
#include "oracle/oracle.hpp"

namespace ecods::oracle {
namespace {

// Whether the exact number x is at least the bound, which may be infinite.
bool at_least(const ExactNumber& x, double bound) {
    return std::isinf(bound) ? bound < 0 : x >= ExactNumber(bound);
}

bool at_most(const ExactNumber& x, double bound) {
    return std::isinf(bound) ? bound > 0 : x <= ExactNumber(bound);
}

bool contains_coordinate(const Aabb& box, const OracleMesh::Impl& mesh, std::uint32_t vertex, int axis) {
    const Interval& around = mesh.intervals[vertex][axis];
    if (box.min[axis] <= around.inf() && around.sup() <= box.max[axis]) return true;
    const auto exact = posed_coordinate<ExactNumber>(mesh.pose, mesh.mesh->vertices()[vertex], axis);
    return at_least(exact, box.min[axis]) && at_most(exact, box.max[axis]);
}

}  // namespace

bool box_contains(const Aabb& box, const OracleMesh& mesh) {
    const FloatEnvironment environment;
    for (const Triangle& triangle : mesh.impl().mesh->triangles()) {
        for (const std::uint32_t vertex : triangle) {
            for (int axis = 0; axis < 3; ++axis) {
                if (!contains_coordinate(box, mesh.impl(), vertex, axis)) return false;
            }
        }
    }
    return true;
}

bool boxes_overlap(const Aabb& a, const Aabb& b) noexcept {
    for (int axis = 0; axis < 3; ++axis) {
        if (a.min[axis] > b.max[axis] || b.min[axis] > a.max[axis]) return false;
    }
    return true;
}

std::vector<std::pair<std::size_t, std::size_t>> overlapping_boxes(std::span<const Aabb> boxes) {
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (std::size_t j = i + 1; j < boxes.size(); ++j) {
            if (boxes_overlap(boxes[i], boxes[j])) pairs.emplace_back(i, j);
        }
    }
    return pairs;
}

}  // namespace ecods::oracle
