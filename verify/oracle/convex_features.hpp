// The vertices, edges and faces of the convex set that a mesh bounds, and whether it is convex: by the signs of every
// point to every plane, in integers.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "ecods/mesh.hpp"
#include "oracle/distance.hpp"

namespace ecods::oracle {

// Each list is ascending by name. Triangles of zero area name nothing.
struct ConvexFeatures {
    struct Vertex {
        NamedFeature name;
        std::uint32_t in_mesh = 0;  // the index of a vertex of the mesh
    };
    struct Edge {
        NamedFeature name;
        std::array<std::uint32_t, 2> ends{};  // in `vertices`, ascending
    };
    struct Face {
        NamedFeature name;
        std::vector<std::uint32_t> corners;  // in `vertices`, one after the other around the face
    };
    std::vector<Vertex> vertices;
    std::vector<Edge> edges;
    std::vector<Face> faces;

    // The vertex, edge or face with just these vertices, which are ascending.
    const NamedFeature& name_of(const std::vector<std::uint32_t>& corners) const;
};

// Returns the features of a mesh that bounds a solid, or covers a polygon, a segment or a point; nothing if it is not
// convex, or empty. The polygon has one face, around which its corners go as those of its first triangle.
std::optional<ConvexFeatures> convex_features(const Mesh& mesh);

// Whether the edge from a corner of a triangle to the next one is also one of a triangle whose third corner is at the
// vertex `beyond`, and that is not in the plane of the first.
bool is_bent(const Mesh& mesh, std::uint32_t triangle, std::uint32_t corner, std::uint32_t beyond);

}  // namespace ecods::oracle
