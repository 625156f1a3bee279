// Which faces of the set of differences are nearest to the origin: proven from the faces of a polytope in doubles.
//
// Let S be the closed surface of an InnerPolytope, M the set of differences, d >= 0, and let every face of S either
//   (1) have the origin strictly on its inner side, further than d from its plane, or
//   (2) lie in the plane of a face of M, at a distance of d or more.
// Then the depth is d, if some plane of (2) has that distance, and all planes of faces of M at that distance are among
// those of (2):
//
// Let o be the origin, moved toward the inside of M by as little as need be where d = 0. It is strictly on the inner
// side of all faces, of those of (2) since M's inside is, so around it the surface winds a positive number of times;
// that is so throughout the ball of radius d around the origin, which no face enters. Points around which a surface
// winds are in the hull of its corners, and so in M. Hence the origin is in M, and no plane of a face of M is nearer
// than d. Now let F be a face of M whose plane is at distance d and none of (2), and x the point of that plane that is
// nearest to the origin, or where d = 0 one inside F as close to the origin as need be. It is on the border of M. But
// it is strictly on the inner side of every face of S, or strictly inside the ball's closure and not on S: faces of (1)
// are further away, and a plane of (2) that has x has it on M's border, where it touches the ball, too, and is F's. So
// the surface winds around a neighborhood of x, which then is in M: x is not on its border.
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
    // What is shown: the nearest plane, the first of those that tie, or none where the solids share no point. Nothing
    // where this way shows neither.
    //
    // Where a face of the polytope that may be nearest is in no plane of a face of M, a vertex beyond it is added, in
    // exact steps.
    using Shown = std::optional<ExactDepth>;
    std::optional<Shown> find(const ConvexPair& pair, convex::PosedHulls& hulls, InnerPolytope& polytope);

  private:
    // Vertices of a solid.
    using Level = std::vector<std::uint32_t>;

    // A plane of a face of M, and what of each solid is in it.
    struct Plane {
        std::array<DifferenceVertex, 3> corners;
        FixedPlane fixed;
        DifferenceFace face;
        std::size_t levels;  // its place in levels_
        int side = 0;        // the sign of its distance
    };

    // What a face of S turns out to be.
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

    // Exact steps before integers take over.
    static constexpr int steps_max = 64;

    const ConvexPair* pair_ = nullptr;
    convex::PosedHulls* hulls_ = nullptr;
    bool is_exact_ = false;  // whether the points are
    std::vector<Plane> planes_;
    // Faces of S that are too thin for a normal in doubles.
    std::vector<std::array<DifferenceVertex, 3>> thin_;
    std::array<std::vector<std::uint32_t>, 2> marks_;  // by vertex
    std::uint32_t mark_ = 0;
    std::vector<std::array<Level, 2>> levels_;  // by plane; more than there are keep their memory
};

}  // namespace ecods::depths
