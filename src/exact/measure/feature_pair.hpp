// A vertex, an edge or a face of each of two triangles, by corners.
#pragma once

#include <cstdint>

namespace ecods::exact {

enum class FeatureKind : std::uint8_t { vertex_vertex, vertex_edge, vertex_face, edge_edge };

// `a` and `b` are corners of the first and the second triangle: a corner is a vertex, the edge that begins there, or 0
// for the face.
struct FeaturePair {
    FeatureKind kind = FeatureKind::vertex_vertex;
    std::uint8_t vertex_side = 0;  // of vertex_edge and vertex_face: the triangle that has the vertex
    std::uint8_t a = 0, b = 0;

    friend bool operator==(const FeaturePair&, const FeaturePair&) = default;
};

}  // namespace ecods::exact
