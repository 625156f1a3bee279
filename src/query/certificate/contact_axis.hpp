// The axis of two triangles that are in contact or closest, and which parts of both bodies are on its two sides.
//
// What is not beyond the triangle of a along the axis, and what is not before that of b, is apart as the two triangles
// are: one line then proves all parts of two faces that lie flush on each other, and all triangles that share the
// closest features. Decided by bounds in doubles, and near the planes in integers, a vertex at a time; each is kept.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "query/certificate/body_axis.hpp"
#include "query/certificate/exact_axis.hpp"
#include "query/certificate/proof.hpp"

namespace ecods {

class ContactAxis {
  public:
    // `corners` are the points of the triangles that the formula of `axis` is of; everything must outlive this.
    ContactAxis(const ProofAxis& axis, const SixCorners& corners, const ExactPoints& points,
                const std::array<BodyFrame, 2>& bodies);

    ProofAxis axis;
    Proof::Word named = Proof::no_axis;

    // The lanes of a node or leaf of body 0 or 1 that are on its side.
    template <class X>
    std::uint32_t lanes_inside(std::size_t body, const X& x);

  private:
    enum class Side : std::uint8_t { unknown, inside, outside };

    struct Half {
        const BodyFrame* body = nullptr;
        BodyAxis axis;  // n, as doubles, times 1 for a's half, and -1 for b's: inside is what is not beyond the plane
        double plane = 0;   // of the triangle, along the axis
        double margin = 0;  // of errors
        double near = 0;    // what may be inside all the same is no further beyond the plane
        exact::Integer exact_plane;
        std::vector<Side> vertices;
        std::vector<Side> nodes, leaves;
    };

    template <class X>
    std::array<std::uint32_t, 2> classify(const Half& half, const X& x) const;
    bool is_part_inside(std::size_t body, const BvhNode& node, std::size_t lane);
    bool is_part_inside(std::size_t body, const TreeLeaf& leaf, std::size_t lane);
    bool is_vertex_inside(std::size_t body, std::uint32_t vertex);

    const ExactPoints& points_;
    IntegerVector3 n_;  // from a to b
    std::array<Half, 2> halves_;
};

}  // namespace ecods
