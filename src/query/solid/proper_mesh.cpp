#include "query/solid/proper_mesh.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>

#include "base/double_key.hpp"
#include "base/hash.hpp"
#include "exact/point/integer_points.hpp"
#include "exact/point/posed_points.hpp"
#include "exact/sign/filter_bound.hpp"
#include "exact/sign/filtered_signs.hpp"
#include "exact/sign/plain_signs.hpp"
#include "exact/sign/vertex_signs.hpp"
#include "geometry/same_bits.hpp"

namespace ecods {
namespace {

constexpr std::uint32_t no_vertex = ~std::uint32_t{0};

std::size_t hash_of(const Vec3& v) noexcept {
    return combine(combine(coordinate_bits(v[0]), coordinate_bits(v[1])), coordinate_bits(v[2]));
}

// AreaFilter proves that triangles have an area, with one error bound for all points of a mesh. The proof succeeds for
// most triangles, so few triangles need a bound of their own.
class AreaFilter {
  public:
    explicit AreaFilter(std::span<const Vec3> vertices) noexcept : bounds_(exact::own_bounds(vertices).orient2d) {}

    bool is_certain(const Vec3& a, const Vec3& b, const Vec3& c) const noexcept {
        const exact::PlainNormal n = exact::plain_normal({a[0], a[1], a[2]}, {b[0], b[1], b[2]}, {c[0], c[1], c[2]});
        return std::abs(n[0]) > bounds_[0] || std::abs(n[1]) > bounds_[1] || std::abs(n[2]) > bounds_[2];
    }

  private:
    std::array<double, 3> bounds_;
};

}  // namespace

// Returns the least equal vertices, by a hash table with linear probing that maps coordinates to the first vertex with
// the same coordinates.
std::vector<std::uint32_t> least_equals(std::span<const Vec3> vertices) {
    const std::size_t size = std::bit_ceil(2 * vertices.size());
    std::vector<std::uint32_t> table(size, no_vertex);
    std::vector<std::uint32_t> least;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const auto index = static_cast<std::uint32_t>(i);
        std::size_t at = hash_of(vertices[i]) & (size - 1);
        while (table[at] != no_vertex && !same_point(vertices[table[at]], vertices[i])) at = (at + 1) & (size - 1);
        if (table[at] == no_vertex) {
            table[at] = index;
            if (!least.empty()) least[i] = index;
            continue;
        }
        if (least.empty()) {
            least.resize(vertices.size());
            for (std::size_t k = 0; k < i; ++k) least[k] = static_cast<std::uint32_t>(k);
        }
        least[i] = table[at];
    }
    return least;
}

std::vector<std::uint32_t> distinct(std::span<const Vec3> points) {
    const std::vector<std::uint32_t> least = least_equals(points);
    std::vector<std::uint32_t> result;
    result.reserve(points.size());
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        if (least.empty() || least[i] == i) result.push_back(i);
    }
    return result;
}

bool have_area(const Vec3& a, const Vec3& b, const Vec3& c) noexcept {
    using namespace exact;
    static const Pose identity;
    const PosedPoints<3> points{PointRef{&identity, &a}, {&identity, &b}, {&identity, &c}};
    const RoundedPoints<3> rounded = plain_points(points);
    const DeterminantBounds bounds = determinant_bounds(rounded.points, rounded.delta);
    if (certain_normal_axis(rounded.points, 0, bounds) >= 0) return true;
    return with_integers(points, [](const auto& integers) { return ExactSigns(integers).normal_axis(0) >= 0; });
}

int compare_points(const Vec3& a, const Vec3& b) noexcept {
    for (int axis = 0; axis < 3; ++axis) {
        const std::int64_t x = key_of(a[axis]), y = key_of(b[axis]);
        if (x != y) return x < y ? -1 : 1;
    }
    return 0;
}

ProperMesh find_proper(std::shared_ptr<const Mesh> mesh) {
    ProperMesh result{std::move(mesh), {}};
    const auto vertices = result.mesh->vertices();
    const std::vector<std::uint32_t> least = least_equals(vertices);
    if (!least.empty()) {
        std::vector<Triangle> triangles(result.mesh->triangles().begin(), result.mesh->triangles().end());
        for (Triangle& triangle : triangles) {
            for (std::uint32_t& vertex : triangle) vertex = least[vertex];
        }
        result.mesh = Mesh::create({vertices.begin(), vertices.end()}, std::move(triangles));
    }
    const auto triangles = result.mesh->triangles();
    const auto points = result.mesh->vertices();
    const AreaFilter filter(points);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const auto& [a, b, c] = triangles[i];
        if (a != b && b != c && c != a &&
            (filter.is_certain(points[a], points[b], points[c]) || have_area(points[a], points[b], points[c]))) {
            continue;
        }
        if (result.has_area.empty()) result.has_area.assign(triangles.size(), 1);
        result.has_area[i] = 0;
    }
    return result;
}

}  // namespace ecods
