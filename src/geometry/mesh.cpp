#include "ecods/mesh.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

#include "base/hash.hpp"
#include "base/make_error.hpp"
#include "geometry/find_invalid.hpp"

namespace ecods {
namespace {

void require_counts(std::size_t vertex_count, std::size_t triangle_count) {
    constexpr std::size_t count_max = std::numeric_limits<std::uint32_t>::max();
    if (triangle_count == 0) throw empty_mesh();
    if (vertex_count > count_max || triangle_count > count_max) throw mesh_too_large(vertex_count, triangle_count);
}

void require_finite(std::span<const Vec3> vertices) {
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            if (!is_finite(vertices[i][axis])) throw invalid_vertex(i, axis, vertices[i][axis]);
        }
    }
}

// Returns the number of groups of three numbers in a list in which each group begins `stride` numbers after the one
// before. The numbers between groups may be missing after the last group. Throws InvalidMesh if the numbers do not fit.
std::size_t count_groups(std::size_t number_count, std::size_t stride) {
    if (stride < 3) throw invalid_layout(number_count, stride);
    const std::size_t rest = number_count % stride;
    if (rest != 0 && rest < 3) throw invalid_layout(number_count, stride);
    return number_count / stride + (rest != 0);
}

double exact_double(double x) noexcept {
    return x;
}

// Converts a float to the double of the same value. If the processor takes subnormal floats for zero, a plain
// conversion would lose them.
double exact_double(float x) noexcept {
    const auto bits = std::bit_cast<std::uint32_t>(x);
    if ((bits & 0x7f800000u) != 0) return x;
    const double magnitude = static_cast<double>(static_cast<std::int32_t>(bits & 0x007fffffu)) * 0x1p-149;
    return bits >> 31 != 0 ? -magnitude : magnitude;
}

template <class Coordinate>
std::vector<Vec3> vertices_of(std::span<const Coordinate> numbers, std::size_t stride, std::size_t count) {
    std::vector<Vec3> vertices;
    vertices.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Coordinate* const at = &numbers[i * stride];
        vertices.emplace_back(exact_double(at[0]), exact_double(at[1]), exact_double(at[2]));
    }
    return vertices;
}

std::uint32_t checked_index(std::uint64_t value, std::size_t triangle, std::size_t corner, std::size_t vertex_count) {
    if (value >= vertex_count) throw invalid_index(triangle, static_cast<int>(corner), value, vertex_count);
    return static_cast<std::uint32_t>(value);
}

template <class Index>
std::vector<Triangle> triangles_of(std::span<const Index> indices, std::size_t vertex_count) {
    std::vector<Triangle> triangles(indices.size() / 3);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) triangles[i][k] = checked_index(indices[3 * i + k], i, k, vertex_count);
    }
    return triangles;
}

struct Lists {
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
};

template <class Coordinate, class Index>
Lists lists_of(std::span<const Coordinate> coordinates, std::span<const Index> indices, std::size_t stride) {
    const std::size_t vertex_count = count_groups(coordinates.size(), stride);
    if (indices.size() % 3 != 0) throw invalid_layout(indices.size(), 3);
    require_counts(vertex_count, indices.size() / 3);
    Lists lists{.vertices = vertices_of(coordinates, stride, vertex_count), .triangles = {}};
    require_finite(lists.vertices);
    lists.triangles = triangles_of(indices, vertex_count);
    return lists;
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
    require_counts(vertices.size(), triangles.size());
    require_finite(vertices);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) checked_index(triangles[i][k], i, k, vertices.size());
    }
    return std::shared_ptr<const Mesh>(new Mesh(std::move(vertices), std::move(triangles)));
}

std::shared_ptr<const Mesh> Mesh::create_from(std::span<const double> coordinates,
                                              std::span<const std::uint32_t> indices, std::size_t stride) {
    Lists lists = lists_of(coordinates, indices, stride);
    return std::shared_ptr<const Mesh>(new Mesh(std::move(lists.vertices), std::move(lists.triangles)));
}

std::shared_ptr<const Mesh> Mesh::create_from(std::span<const double> coordinates,
                                              std::span<const std::uint64_t> indices, std::size_t stride) {
    Lists lists = lists_of(coordinates, indices, stride);
    return std::shared_ptr<const Mesh>(new Mesh(std::move(lists.vertices), std::move(lists.triangles)));
}

std::shared_ptr<const Mesh> Mesh::create_from(std::span<const float> coordinates,
                                              std::span<const std::uint32_t> indices, std::size_t stride) {
    Lists lists = lists_of(coordinates, indices, stride);
    return std::shared_ptr<const Mesh>(new Mesh(std::move(lists.vertices), std::move(lists.triangles)));
}

std::shared_ptr<const Mesh> Mesh::create_from(std::span<const float> coordinates,
                                              std::span<const std::uint64_t> indices, std::size_t stride) {
    Lists lists = lists_of(coordinates, indices, stride);
    return std::shared_ptr<const Mesh>(new Mesh(std::move(lists.vertices), std::move(lists.triangles)));
}

Mesh::Mesh(std::vector<Vec3> vertices, std::vector<Triangle> triangles)
    : vertices_(std::move(vertices)),
      triangles_(std::move(triangles)),
      uses_all_vertices_(are_all_used(vertices_, triangles_)),
      digest_(digest_of(vertices_, triangles_)) {}

}  // namespace ecods
