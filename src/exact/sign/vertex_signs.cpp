#include "exact/sign/vertex_signs.hpp"

#include <array>

#include "base/double_key.hpp"
#include "ecods/primitives.hpp"
#include "exact/sign/plain_signs.hpp"

namespace ecods::exact {
namespace {

// Returns true if a simple reason shows that the four points are in one plane: they have one coordinate in common, or
// their projections along some axis are at most two points. Faces of boxes and prisms are like this. Compares keys, so
// the result does not depend on a mode that takes subnormal numbers for zero.
bool are_level(const std::array<const Vec3*, 4>& points) noexcept {
    std::array<std::array<std::int64_t, 4>, 3> keys;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t i = 0; i < 4; ++i) keys[axis][i] = key_of((*points[i])[static_cast<int>(axis)]);
        const auto& k = keys[axis];
        if (k[0] == k[1] && k[0] == k[2] && k[0] == k[3]) return true;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto &u = keys[(axis + 1) % 3], &v = keys[(axis + 2) % 3];
        const auto are_one = [&](std::size_t i, std::size_t k) { return u[i] == u[k] && v[i] == v[k]; };
        std::size_t other = 1;
        while (other < 4 && are_one(0, other)) ++other;
        std::size_t next = other;
        while (next < 4 && (are_one(0, next) || are_one(other, next))) ++next;
        if (next >= 4) return true;
    }
    return false;
}

}  // namespace

DeterminantBounds own_bounds(std::span<const Vec3> points) noexcept {
    Vec3 min = points[0], max = points[0];
    for (const Vec3& v : points) {
        min = min.cwiseMin(v);
        max = max.cwiseMax(v);
    }
    return determinant_bounds({max[0] - min[0], max[1] - min[1], max[2] - min[2]}, own_delta);
}

int VertexSigns::orient3d(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const noexcept {
    const double height = plain_orient3d(point(a), point(b), point(c), point(d));
    if (const int sign = certain_sign(height, bounds_.orient3d)) return sign;
    const std::array<const Vec3*, 4> points{&vertices_[a], &vertices_[b], &vertices_[c], &vertices_[d]};
    if (are_level(points)) return 0;
    return static_cast<int>(ecods::orient3d(*points[0], *points[1], *points[2], *points[3]));
}

int VertexSigns::orient2d(std::uint32_t a, std::uint32_t b, std::uint32_t c, int axis) const noexcept {
    const double turned = plain_orient2d(point(a), point(b), point(c), axis);
    if (const int sign = certain_sign(turned, bounds_.orient2d[static_cast<std::size_t>(axis)])) return sign;
    const Vec3 &p = vertices_[a], &q = vertices_[b], &r = vertices_[c];
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const auto are_level = [&](int k) { return key_of(p[k]) == key_of(q[k]) && key_of(p[k]) == key_of(r[k]); };
    if (are_level(u) || are_level(v)) return 0;
    return static_cast<int>(ecods::orient2d(Vec2(p[u], p[v]), Vec2(q[u], q[v]), Vec2(r[u], r[v])));
}

}  // namespace ecods::exact
