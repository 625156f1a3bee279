// Puts meshes together from rings of vertices.
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "ecods/mesh.hpp"

namespace ecods::scenes {

// The nearest multiple of 2^-20. Shapes that are computed with sines and cosines are rounded to this grid, because the
// last bits of those functions differ between mathematical libraries, and a shape must be the same everywhere.
inline double on_grid(double x) {
    return std::ldexp(std::round(std::ldexp(x, 20)), -20);
}
inline Vec3 on_grid(const Vec3& v) {
    return {on_grid(v.x()), on_grid(v.y()), on_grid(v.z())};
}

// Vertices in a closed loop, by index, counter-clockwise when seen against the direction in which rings follow each
// other.
using Ring = std::vector<std::uint32_t>;

struct MeshBuilder {
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;

    // The grid holds for all vertices.
    std::uint32_t add(const Vec3& vertex) {
        vertices.push_back(on_grid(vertex));
        return static_cast<std::uint32_t>(vertices.size() - 1);
    }

    Ring add_ring(std::span<const Vec3> points) {
        Ring ring;
        for (const Vec3& point : points) ring.push_back(add(point));
        return ring;
    }

    // Two triangles for each edge of the rings, which must have the same size.
    void bridge(const Ring& from, const Ring& to) {
        for (std::size_t i = 0; i < from.size(); ++i) {
            const std::size_t next = (i + 1) % from.size();
            triangles.push_back({from[i], from[next], to[next]});
            triangles.push_back({from[i], to[next], to[i]});
        }
    }

    // One triangle for each edge of the ring; the tip precedes or follows the ring.
    void fan_from(std::uint32_t tip, const Ring& ring) {
        for (std::size_t i = 0; i < ring.size(); ++i) triangles.push_back({tip, ring[(i + 1) % ring.size()], ring[i]});
    }
    void fan_to(const Ring& ring, std::uint32_t tip) {
        for (std::size_t i = 0; i < ring.size(); ++i) triangles.push_back({ring[i], ring[(i + 1) % ring.size()], tip});
    }

    // Two triangles; the corners counter-clockwise when seen from outside.
    void add_quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        triangles.push_back({a, b, c});
        triangles.push_back({a, c, d});
    }

    std::shared_ptr<const Mesh> finish() { return Mesh::create(std::move(vertices), std::move(triangles)); }
};

}  // namespace ecods::scenes
