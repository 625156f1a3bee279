// This header finds the face or edge of a convex body that faces a normal within a tilt, if the support feature is an
// edge or a vertex.
#pragma once

#include "query/patch/seen_along.hpp"

namespace ecods::patches {

// HullInSpace is a hull with its vertices and its pose.
struct HullInSpace {
    HullInSpace(const convex::Hull& of, const Mesh& vertices, const Pose& at, bool reflects) noexcept
        : hull(of), mesh(vertices), pose(at), is_mirrored(reflects) {}
    HullInSpace(const convex::PosedHulls& hulls, std::size_t side) noexcept
        : HullInSpace(hulls.hull(side), hulls.mesh(side), *hulls.reference({side, 0}).pose, hulls.is_mirrored(side)) {}

    const Vec3& vertex(std::uint32_t v) const noexcept { return mesh.vertices()[hull.mesh_vertices[v]]; }
    ScaledLongVector point(std::uint32_t v) const;  // in world coordinates

    const convex::Hull& hull;
    const Mesh& mesh;
    const Pose& pose;
    bool is_mirrored;
};

// Returns a normal of a face: the cross product of two vectors between the first three vertices of its cycle.
ScaledLongVector face_normal(const HullInSpace& body, std::uint32_t face);

// Returns the feature as a polygon, counterclockwise around the normal. The feature must be extreme along the normal,
// or against it if `is_against`. `normal` is used only for the face of a flat hull, which has two sides.
Polygon polygon_of(const HullInSpace& body, const HullFeature& part, const ExactNormal& normal, bool is_against);

// Returns the face or edge that replaces a support feature by the rule of PatchLimits::min_cos_squared; the support
// feature if none does. The support feature is extreme along the normal, or against it if `is_against`. Exact.
HullFeature facing_feature(const HullInSpace& body, const HullFeature& support, const ExactNormal& normal,
                           bool is_against, double min_cos_squared);

}  // namespace ecods::patches
