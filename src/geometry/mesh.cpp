#include "ecods/mesh.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/hash.hpp"
#include "ecods/error.hpp"
#include "geometry/find_invalid.hpp"

namespace ecods {
namespace {

void validate(std::span<const Vec3> vertices, std::span<const Triangle> triangles) {
    constexpr std::size_t count_max = std::numeric_limits<std::uint32_t>::max();
    if (triangles.empty()) throw EmptyMesh();
    if (vertices.size() > count_max || triangles.size() > count_max) {
        throw MeshTooLarge(vertices.size(), triangles.size());
    }
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            if (!is_finite(vertices[i][axis])) throw InvalidVertex(i, axis, vertices[i][axis]);
        }
    }
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        for (int corner = 0; corner < 3; ++corner) {
            const std::uint32_t index = triangles[i][static_cast<std::size_t>(corner)];
            if (index >= vertices.size()) throw InvalidIndex(i, corner, index, vertices.size());
        }
    }
}

bool are_all_used(std::span<const Vec3> vertices, std::span<const Triangle> triangles) {
    std::vector<bool> is_used(vertices.size());
    for (const Triangle& triangle : triangles) {
        for (const std::uint32_t index : triangle) is_used[index] = true;
    }
    return std::ranges::all_of(is_used, [](bool used) { return used; });
}

std::uint64_t digest_of(std::span<const Vec3> vertices, std::span<const Triangle> triangles) {
    std::uint64_t digest = combine(vertices.size(), triangles.size());
    for (const Vec3& vertex : vertices) {
        for (int axis = 0; axis < 3; ++axis) digest = combine(digest, coordinate_bits(vertex[axis]));
    }
    for (const Triangle& triangle : triangles) {
        for (const std::uint32_t index : triangle) digest = combine(digest, index);
    }
    return digest;
}

}  // namespace

std::shared_ptr<const Mesh> Mesh::create(std::vector<Vec3> vertices, std::vector<Triangle> triangles) {
    validate(vertices, triangles);
    return std::shared_ptr<const Mesh>(new Mesh(std::move(vertices), std::move(triangles)));
}

Mesh::Mesh(std::vector<Vec3> vertices, std::vector<Triangle> triangles)
    : vertices_(std::move(vertices)),
      triangles_(std::move(triangles)),
      uses_all_vertices_(are_all_used(vertices_, triangles_)),
      digest_(digest_of(vertices_, triangles_)) {}

}  // namespace ecods
