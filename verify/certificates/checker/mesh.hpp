// A mesh, as its file gives it, with the boxes of the parts of its tree.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "text.hpp"

namespace certificate_checker {

// Coordinate k of all points is in [k].
using Points = std::array<std::vector<double>, 3>;

// The parts of a node or of a leaf: `count` of them, from part `first` on. A leaf's corners are some of
// Mesh::leaf_corners.
struct Node {
    std::uint32_t first = 0;
    std::uint32_t count = 1;
    std::uint32_t first_corner = 0;
    std::uint32_t corner_count = 0;  // 0 of what is no leaf
    std::uint32_t number = 0;        // its own as a part; 0 where this is one part that is not opened, or the root
};

inline constexpr std::uint32_t parts_max = 64;  // of a node or of a leaf

// Parts are numbered: first the nodes and leaves, the root 0, each one's parts behind it and next to each other; then
// the triangles in the order of the tree.
struct Mesh {
    std::string digest;  // of the file
    std::vector<std::array<double, 3>> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;  // in the order of the tree
    std::vector<std::uint32_t> position;                  // of the caller's triangles in this order
    std::vector<Node> nodes;
    std::vector<std::uint32_t> leaf_corners;               // the vertices of each leaf's triangles, each once
    Points leaf_points;                                    // their coordinates
    std::vector<std::array<std::uint8_t, 3>> leaf_places;  // of each triangle's corners, among those of its leaf
    std::array<Points, 2> boxes;                           // of the nodes: their least and their greatest corners
    std::array<double, 3> magnitude = {};                  // the greatest absolute value of each coordinate
    int low = 0;                                           // all coordinates are multiples of 2^low

    bool is_leaf(std::uint32_t part) const { return !is_triangle(part) && nodes[part].corner_count > 0; }
    bool is_triangle(std::uint32_t part) const { return part >= nodes.size(); }
    // Of a triangle or a leaf.
    std::span<const std::uint32_t> all_corners(std::uint32_t part) const {
        if (is_triangle(part)) return corners(part);
        return {leaf_corners.data() + nodes[part].first_corner, nodes[part].corner_count};
    }
    const std::array<std::uint32_t, 3>& corners(std::uint32_t part) const { return triangles[part - nodes.size()]; }
    // The part that is the caller's triangle of this number; throws Refusal for the line if there is none.
    std::uint32_t part(std::uint32_t number, std::size_t line) const {
        if (number >= position.size()) throw Refusal{line, "no such triangle"};
        return static_cast<std::uint32_t>(nodes.size()) + position[number];
    }
    // Calls use(vertex) for all corners of a part, some twice. The depth of the tree is limited.
    template <class Use>
    void for_corners(std::uint32_t part, Use& use) const {
        if (is_triangle(part) || is_leaf(part)) {
            for (const std::uint32_t vertex : all_corners(part)) use(vertex);
        } else {
            for (std::uint32_t i = 0; i < nodes[part].count; ++i) for_corners(nodes[part].first + i, use);
        }
    }
};

// Throws Unreadable.
Mesh read_mesh(const char* path);
Mesh parse_mesh(std::string_view text);

// A mesh of one triangle, with the corners 0, 1 and 1. Its vertices, in units of 2^low, need not be doubles: for the
// filter, which allows for it, they are wrong by at most 2u of themselves.
Mesh mesh_of(const std::array<std::array<mpz_class, 3>, 2>& vertices, int low);

// Sets what follows from vertices, triangles and nodes: what leaves hold, boxes, magnitude, low.
void measure(Mesh& mesh);

}  // namespace certificate_checker
