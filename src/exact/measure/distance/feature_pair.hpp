// A FeaturePair names a feature (a vertex, an edge or a face) of each of two triangles, by corners.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace ecods::exact {

enum class FeatureKind : std::uint8_t { vertex_vertex, vertex_edge, vertex_face, edge_edge };

// `a` names the feature of the first triangle and `b` the feature of the second: corner i names vertex i, or the edge
// from corner i to the next corner; 0 names the face.
struct FeaturePair {
    FeatureKind kind = FeatureKind::vertex_vertex;
    std::uint8_t vertex_side = 0;  // for vertex_edge and vertex_face: the triangle that has the vertex
    std::uint8_t a = 0, b = 0;

    // corner(side) returns the corner that names the feature of triangle `side` (see above), and corner_count(side) the
    // number of corners of that feature.
    constexpr std::size_t corner(std::size_t side) const noexcept { return side == 0 ? a : b; }
    constexpr std::size_t corner_count(std::size_t side) const noexcept {
        if (kind == FeatureKind::vertex_vertex) return 1;
        if (kind == FeatureKind::edge_edge) return 2;
        if (vertex_side == side) return 1;
        return kind == FeatureKind::vertex_edge ? 2 : 3;
    }
    constexpr bool has_vertex(std::size_t side) const noexcept { return corner_count(side) == 1; }

    friend bool operator==(const FeaturePair&, const FeaturePair&) = default;
};

constexpr FeaturePair pair_of(FeatureKind kind, std::size_t vertex_side, std::size_t a, std::size_t b) noexcept {
    return {kind, static_cast<std::uint8_t>(vertex_side), static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(b)};
}

// Returns the pair of vertex `vertex` of triangle `side` and feature `other` of the other triangle: an edge or a face,
// by `kind`.
constexpr FeaturePair vertex_and(FeatureKind kind, std::size_t side, std::size_t vertex, std::size_t other) noexcept {
    return side == 0 ? pair_of(kind, 0, vertex, other) : pair_of(kind, 1, other, vertex);
}

// Returns a pair of features that have count_a and count_b corners; each is named by corner 0.
constexpr FeaturePair features_of_counts(std::size_t count_a, std::size_t count_b) noexcept {
    const std::size_t most = count_a > count_b ? count_a : count_b;
    const FeatureKind kind =
        count_a + count_b == 4 && most == 2 ? FeatureKind::edge_edge : static_cast<FeatureKind>(most - 1);
    return pair_of(kind, count_a > count_b, 0, 0);
}

constexpr std::size_t next_corner(std::size_t i) noexcept {
    return i == 2 ? 0 : i + 1;
}

// Lists all pairs of features of two triangles. If several pairs are equally close, the first one in this list is
// chosen. The order is by kind, then by the corner of the first triangle, then by the corner of the second; a pair with
// the vertex on the first triangle comes before one with the vertex on the second.
inline constexpr std::array<FeaturePair, 42> feature_pairs = [] {
    std::array<FeaturePair, 42> pairs;
    std::size_t count = 0;
    const auto add = [&](FeatureKind kind, std::uint8_t side, std::uint8_t a, std::uint8_t b) {
        pairs[count++] = {kind, side, a, b};
    };
    for (const FeatureKind kind :
         {FeatureKind::vertex_vertex, FeatureKind::vertex_edge, FeatureKind::vertex_face, FeatureKind::edge_edge}) {
        for (std::uint8_t a = 0; a < 3; ++a) {
            for (std::uint8_t b = 0; b < 3; ++b) {
                const bool is_face = kind == FeatureKind::vertex_face;
                if (!is_face || b == 0) add(kind, 0, a, b);
                if (kind == FeatureKind::vertex_edge || (is_face && a == 0)) add(kind, 1, a, b);
            }
        }
    }
    return pairs;
}();

}  // namespace ecods::exact
