// Defines the data that a ConvexSolid holds in addition to the data of a Solid.
#pragma once

#include "base/lazy.hpp"
#include "ecods/shape.hpp"
#include "ecods/solid.hpp"
#include "query/convex/face_triangles.hpp"
#include "query/convex/hull.hpp"
#include "query/convex/support_points.hpp"

namespace ecods {

struct ConvexSolid::ConvexParts {
    convex::Hull hull;
    convex::SupportPoints points;
    Lazy<convex::FaceTriangles> face_triangles;
};

// ConvexSolidAccess gives the library access to the parts of a ConvexSolid.
struct ConvexSolidAccess {
    static const convex::Hull& hull(const ConvexSolid& solid) noexcept { return solid.convex_parts_->hull; }
    static const convex::SupportPoints& points(const ConvexSolid& solid) noexcept {
        return solid.convex_parts_->points;
    }
    // Returns the triangles of the hull's faces, which are listed on first use.
    static const convex::FaceTriangles& face_triangles(const ConvexSolid& solid) {
        return solid.convex_parts_->face_triangles.get([&] { return convex::FaceTriangles(solid); });
    }
};

}  // namespace ecods
