// Describes the vertices, edges and faces of a convex solid. They do not depend on how the solid's mesh divides faces
// into triangles and edges into pieces. A polygon has one face, which counts for both of its sides; a segment has one
// edge and no face; a point has only one vertex.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "ecods/pose.hpp"
#include "ecods/results.hpp"

namespace ecods::convex {

// A Hull holds the vertices, edges and faces, each sorted by their names, so a lesser index means a lesser name.
struct Hull {
    static constexpr std::uint32_t no_face = ~std::uint32_t{0};

    struct Edge {
        Feature name;
        std::array<std::uint32_t, 2> ends;   // vertices of the hull, the lesser first
        std::array<std::uint32_t, 2> faces;  // the faces on the left and on the right of the
                                             // direction from ends[0] to ends[1], seen from outside;
                                             // twice the face of a polygon, and no_face for a segment
    };
    struct Face {
        Feature name;
        std::uint32_t first;  // index of its first vertex in face_cycles
        std::uint32_t count;  // number of vertices, and of edges
    };
    struct Neighbor {
        std::uint32_t vertex;
        std::uint32_t edge;
    };

    std::vector<Feature> vertex_names;         // by vertex
    std::vector<std::uint32_t> mesh_vertices;  // by vertex: index in the Solid's proper mesh
    std::vector<Edge> edges;
    std::vector<Face> faces;

    // Lists, by face, its vertices counterclockwise, seen from outside. Each vertex is stored with the edge that leads
    // to the next one.
    std::vector<Neighbor> face_cycles;
    // Lists, for each vertex v, the other ends of its edges, in no promised order, from neighbors_first[v] to
    // neighbors_first[v + 1].
    std::vector<Neighbor> neighbors;
    std::vector<std::uint32_t> neighbors_first;

    // Returns true for a polygon, a segment and a point.
    bool is_flat() const noexcept { return faces.size() <= 1; }
    std::size_t vertex_count() const noexcept { return mesh_vertices.size(); }
    std::span<const Neighbor> neighbors_of(std::uint32_t vertex) const noexcept {
        return std::span(neighbors).subspan(neighbors_first[vertex],
                                            neighbors_first[vertex + 1] - neighbors_first[vertex]);
    }
    std::span<const Neighbor> cycle_of(std::uint32_t face) const noexcept {
        return std::span(face_cycles).subspan(faces[face].first, faces[face].count);
    }
};

}  // namespace ecods::convex
