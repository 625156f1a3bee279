// A ContactAxis is the axis of two triangles, one of each body, that are in contact or closest to each other. The
// ContactAxis decides which boxes and triangles of the bodies the axis proves apart.
//
// A box of a is called inside if it is not beyond a's triangle along the axis; a box of b, if it is not before b's
// triangle. Along the axis, a box of a that is inside is at least as far from each box of b that is inside as the two
// triangles are from each other. So one axis in the proof separates all pairs of boxes of two faces that lie flush on
// each other, and all triangles that share the closest features. Bounds in doubles decide most boxes; near the planes,
// integers decide vertex by vertex. Each decision is cached.
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
    // Computes the planes of the two triangles to which axis.formula refers, and whose corners are `corners`. All
    // arguments must outlive this object.
    ContactAxis(const ProofAxis& axis, const SixCorners& corners, const ExactPoints& points,
                const std::array<BodyFrame, 2>& bodies);

    ProofAxis axis;
    Proof::Word named = Proof::no_axis;

    // Returns the lanes of x, a node or leaf of body 0 or 1, that are inside: they are not beyond the plane of that
    // body's triangle.
    template <class X>
    std::uint32_t lanes_inside(std::size_t body, const X& x);

  private:
    enum class Side : std::uint8_t { unknown, inside, outside };

    struct Half {
        const BodyFrame* body = nullptr;
        BodyAxis axis;      // along n in doubles, for b along -n: beyond the plane, coordinates are greater
        double plane = 0;   // coordinate of the triangle's plane
        double margin = 0;  // error bound of (coordinate of a point) - plane
        double near = 0;    // boxes that are further beyond the plane than this are outside
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
    exact::LongVector n_;  // normal of the planes; points from a to b
    std::array<Half, 2> halves_;
};

}  // namespace ecods
