// The axis of two triangles that are in contact or closest, and which parts of both bodies are on its two sides.
//
// What is not beyond the triangle of a along the axis, and what is not before that of b, is apart as the two triangles
// are: one line then proves all parts of two faces that lie flush on each other, and all triangles that share the
// closest features. Decided by bounds in doubles, and near the planes in integers, a vertex at a time; each is kept.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "query/certificate/exact_axis.hpp"
#include "query/certificate/proof_axes.hpp"

namespace ecods {

class ContactAxis {
  public:
    struct Body {
        const MeshBvh* tree;
        const Mesh* mesh;
        const BodyFrame* frame;
    };

    // `corners` are the points of the triangles that `formula` is of; everything must outlive this. `towards_b` is
    // about the direction from a to b, for triangles in one plane.
    ContactAxis(const ProofAxis& named, const SixCorners& corners, const ExactPoints& points,
                const std::array<Body, 2>& bodies, const Vec3& towards_b);

    const ProofAxis& named() const noexcept { return named_; }

    // The lanes of a node or leaf of body 0 or 1 that are on its side.
    std::uint32_t lanes_inside(std::size_t body, const BvhNode& node);
    std::uint32_t lanes_inside(std::size_t body, const TreeLeaf& leaf);

  private:
    enum class Side : std::uint8_t { unknown, inside, outside };

    struct Half {
        Body body{};
        double sign = 1;    // of a's half 1, of b's -1: inside is sign (n.x) <= plane
        BodyAxis axis;      // n, as doubles, times the sign
        double plane = 0;   // of the triangle, along the axis
        double margin = 0;  // of errors
        double near = 0;    // what may be inside all the same is no further beyond the plane
        exact::Integer exact_plane;
        std::vector<Side> vertices;
        std::vector<Side> nodes, leaves;
    };

    std::array<std::uint32_t, 2> classify(const Half& half, const Reaches& reaches, std::uint32_t lanes) const;
    bool is_inside(std::size_t body, TreeRef part);
    bool is_vertex_inside(std::size_t body, std::uint32_t vertex);

    ProofAxis named_;
    const ExactPoints& points_;
    IntegerVector3 n_;  // from a to b
    std::array<Half, 2> halves_;
};

}  // namespace ecods
