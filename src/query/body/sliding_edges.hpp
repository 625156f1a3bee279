// Computes the time at which an edge of a translated solid, sliding in the plane of a face, enters the other solid.
//
// Let n be the outer normal of a face f. Near a point of the edge e, the edge's solid is a union of wedges around e,
// whose sides are the half-planes of the triangles at e. The wedges reach strictly below f, into the directions d with
// n.d < 0, if one of the half-planes does; or if no half-plane does and all directions below f belong to a wedge. In
// the second case, the half-plane that is nearest to the directions below f decides if they belong to a wedge. If this
// half-plane is in the plane of f, the directions below f are on its inner or its outer side. Otherwise this half-plane
// has all other half-planes on one side, and the directions below f on the other side.
//
// If the wedges reach below f, e's solid and f's solid share inner points beside f while the open segment e is in the
// open triangle f. Let e and f be in one plane that is parallel to the motion. Then e enters f like a segment enters a
// triangle of the plane: at the first time of an interval, provided that their projections along the motion overlap in
// inner points.
#pragma once

#include <array>
#include <optional>

#include "ecods/solid.hpp"
#include "exact/number/long_vector.hpp"
#include "query/cast/entering.hpp"
#include "query/solid/solid_parts.hpp"

namespace ecods {

// SlidingSolids are two solids with inner points, of which the first one is translated.
class SlidingSolids final : public SlidingEdges {
  public:
    SlidingSolids(const Posed<Solid>& a, const Vec3& motion, const Posed<Solid>& b);

    // Return the mesh with split edges that is searched, and the triangle of the solid's mesh that contains a triangle
    // of the mesh with split edges.
    Posed<MeshShape> mesh(std::size_t side) const;
    std::uint32_t name(std::size_t side, std::uint32_t triangle) const;

    bool counts(std::size_t side, std::uint32_t triangle) const override;
    std::optional<double> time(std::size_t side, std::uint32_t triangle, std::uint32_t corner, std::uint32_t face,
                               double end) override;

  private:
    struct Body {
        const Solid* solid;
        const SolidAccess::Parts* parts;
        const Shells* shells;
        Pose pose;
        bool is_mirrored;

        const Mesh& mesh() const { return *parts->proper.mesh; }
        exact::ScaledLongVector point(std::uint32_t vertex) const;
        std::array<exact::ScaledLongVector, 3> corners(std::uint32_t triangle) const;
        exact::ScaledLongVector outer_normal(std::uint32_t triangle) const;
    };
    static Body body_of(const Posed<Solid>& posed);
    bool reaches_below(const Body& body, const SideRef& edge, const exact::ScaledLongVector& n) const;

    std::array<Body, 2> bodies_;
    exact::ScaledLongVector motion_;
};

}  // namespace ecods
