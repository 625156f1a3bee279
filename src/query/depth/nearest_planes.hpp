// Proves which faces of the Minkowski difference are nearest to the origin, from the faces of a polytope in doubles.
//
// Theorem. Let S be the closed surface of an InnerPolytope, M the Minkowski difference, and d >= 0. Let every face of S
// either
//     (1) have the origin strictly on its inner side, and its plane further away than d, or
//     (2) lie in the plane of a face of M, at a distance of d or more.
// If some plane of (2) has the distance d, then the depth is d, and all planes of faces of M at that distance are among
// the planes of (2).
//
// Proof. Let o be the origin; if d = 0, moved toward the interior of M by as little as needed. The point o is strictly
// on the inner side of all faces of S; for the faces of (2), because the interior of M is on the inner side of their
// planes. So S winds around o a positive number of times. S winds equally often around all points of the ball of radius
// d around the origin, since no face enters this ball. Points around which a surface winds are in the hull of its
// corners, and so in M. Hence the origin is in M, and no plane of a face of M is nearer than d.
//
// Now suppose that F is a face of M whose plane is at distance d and is not among the planes of (2). Let x be the point
// of that plane nearest to the origin, or if d = 0 a point inside F as close to the origin as needed. Then x is on the
// border of M. But x is strictly on the inner side of every face of S, or in the closed ball and not on S: faces of (1)
// are further away; and a plane of (2) that contains x touches M there, and the ball if d > 0, so it is the plane of F.
// So S winds around a neighborhood of x, which then is in M: x is not on the border of M, a contradiction.
#pragma once

#include <optional>
#include <vector>

#include "exact/measure/round/fixed_plane.hpp"
#include "query/depth/exact_depth.hpp"
#include "query/depth/inner_polytope.hpp"

namespace ecods::depths {

using exact::FixedPlane;

class NearestPlanes {
  public:
    // Returns the nearest plane (the first one of ties), or an inner nullopt if the solids share no point. Returns an
    // outer nullopt if neither the nearest plane nor a separation is proven.
    //
    // If a face of the polytope may be nearest, but is in no plane of a face of M, a vertex beyond this face is added
    // to the polytope. The tests of such a step are exact.
    using Shown = std::optional<ExactDepth>;
    std::optional<Shown> find(const ConvexPair& pair, convex::PosedHulls& hulls, InnerPolytope& polytope);

  private:
    // A Level lists the vertices of a solid that are, or may be, equally far along a normal.
    using Level = std::vector<std::uint32_t>;

    // A Plane holds the plane of a face of M, and the features of both solids that are in the plane.
    struct Plane {
        std::array<DifferenceVertex, 3> corners;
        FixedPlane fixed;
        DifferenceFace face;
        std::size_t levels;  // index in levels_
        int side = 0;        // sign of the plane's distance from the origin
    };

    // Found classifies a face of S by its plane.
    enum class Found : std::uint8_t { in_plane, thin, not_in_plane, unknown };

    bool find_planes(InnerPolytope& polytope);
    Found add(const InnerPolytope::Face& face, DifferenceVertex& beyond);
    bool thin_faces_are_further(const Plane& nearest) const;
    bool is_beyond(const InnerPolytope::Face& face, const DifferenceVertex& v) const;
    FixedPlane plane_of(const std::array<DifferenceVertex, 3>& corners) const;
    FixedPlane::Vector difference(const DifferenceVertex& v) const;
    bool is_in_known_plane(const std::array<DifferenceVertex, 3>& corners) const noexcept;
    void find_level(std::size_t side, const InnerPolytope::Face& face, Level& level);
    void climb_to_level(std::size_t side, const convex::PosedHulls::Heights& heights, std::uint32_t top, Level& level);
    std::uint32_t next_mark() noexcept;
    bool ties_for_certain(const Plane& plane, const DifferenceFace& features) const;
    std::optional<DifferenceVertex> keep_ties(const Plane& plane);
    std::optional<convex::HullFeature> feature_of(std::size_t side, const Level& level) const noexcept;
    std::size_t first_plane() const;
    int compare(const Plane& x, const Plane& y) const;
    FixedPlane::Vector point(std::size_t side, std::uint32_t vertex) const;

    // Limits the number of exact steps. If the limit is reached, integers alone find the depth.
    static constexpr int steps_max = 64;

    const ConvexPair* pair_ = nullptr;
    convex::PosedHulls* hulls_ = nullptr;
    bool is_exact_ = false;  // true if the fixed points of both solids are exact
    std::vector<Plane> planes_;
    // Lists the corners of faces of S that are too thin to have a normal in doubles.
    std::vector<std::array<DifferenceVertex, 3>> thin_;
    std::array<std::vector<std::uint32_t>, 2> marks_;  // by vertex
    std::uint32_t mark_ = 0;
    std::vector<std::array<Level, 2>> levels_;  // by plane; entries after the last plane keep their memory
};

}  // namespace ecods::depths
