#include "query/patch/half_space_patch.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "base/double_key.hpp"
#include "base/limits.hpp"
#include "ecods/error.hpp"
#include "exact/point/posed_point.hpp"
#include "query/convex/convex_parts.hpp"
#include "query/convex/posed_hulls.hpp"
#include "query/half_space/heights.hpp"
#include "query/half_space/lowest.hpp"
#include "query/half_space/round.hpp"
#include "query/patch/facing.hpp"
#include "query/patch/hulls_patch.hpp"
#include "query/patch/patch_rounding.hpp"

namespace ecods::patches {
namespace {

using half_spaces::HeightBounds;

// Returns true if the pose reflects. Throws SingularPose, with `argument`, if the pose is singular.
bool is_mirrored(const Pose& pose, int argument) {
    const Sign sign = convex::orientation(convex::rows_of(pose, [](double r) { return r; }), pose);
    if (sign == Sign::zero) throw SingularPose(argument);
    return sign == Sign::negative;
}

class PlanePatch {
  public:
    PlanePatch(const ConvexBody& body, const Posed<HalfSpace>& half_space, int argument, const PatchLimits& limits)
        : pose_(body.core.pose),
          plane_(half_space, argument),
          heights_(plane_, pose_),
          hull_(ConvexSolidAccess::hull(*body.core.what), body.core.what->mesh(), pose_,
                is_mirrored(pose_, 1 - argument)),
          is_plane_first_(argument == 0),
          reach_(exact::Radii{body.radius, 0}),
          limits_(limits) {
        const half_spaces::Plane::Exact& exact = plane_.exact();
        normal_ = {{-exact.N[0], -exact.N[1], -exact.N[2]}, exact.square};
    }

    ContactPatch find() {
        const convex::Furthest lowest = find_lowest();
        const HullFeature support = lowest.level.feature(hull_.hull, lowest.vertex);
        ContactPatch patch;
        patch.normal = half_spaces::round_inward(plane_);
        PatchCorner deepest;
        round_corner(corner(lowest.vertex), reach_, normal_, deepest);
        patch.distance = deepest.gap;
        const HullFeature facing = limits_.min_cos_squared < 1
                                       ? facing_feature(hull_, support, normal_, false, limits_.min_cos_squared)
                                       : support;
        std::vector<LongPoint> points;
        for (const std::uint32_t vertex : corners_of(facing, facing != support)) {
            const LongCorner exact = corner(vertex);
            if (is_too_far(exact)) continue;
            PatchCorner& added = patch.corners.emplace_back();
            round_corner(exact, reach_, normal_, added);
            added.a = hull_.hull.vertex_names[vertex];
            added.b = half_spaces::plane_feature;
            points.push_back(exact.at[0]);
        }
        if (is_plane_first_) exchange(patch, points);
        keep_corners(patch, limits_.max_corners, ListedCorners(points, normal_.n));
        return patch;
    }

  private:
    // Exchanges the bodies of a patch. The first corner remains the first, since a half space has only one feature.
    void exchange(ContactPatch& patch, std::vector<LongPoint>& points) {
        for (double& x : patch.normal) x = opposite(x);
        for (ScaledInteger& x : normal_.n) x = -x;
        for (PatchCorner& corner : patch.corners) {
            std::swap(corner.point_a, corner.point_b);
            std::swap(corner.a, corner.b);
        }
        if (points.empty()) return;
        std::reverse(patch.corners.begin() + 1, patch.corners.end());
        std::reverse(points.begin() + 1, points.end());
    }

    // Returns the sign of (height of vertex x) - (height of vertex y).
    int compare_heights(std::uint32_t x, std::uint32_t y) const {
        const HeightBounds a = heights_.bounds(hull_.vertex(x)), b = heights_.bounds(hull_.vertex(y));
        if (a.low > b.high) return 1;
        if (a.high < b.low) return -1;
        return compare(heights_.exact(hull_.vertex(x)), heights_.exact(hull_.vertex(y)));
    }

    convex::Furthest find_lowest() const {
        return convex::climb(hull_.hull, 0, [&](std::uint32_t at, std::span<const convex::Hull::Neighbor> neighbors) {
            std::array<int, convex::signs_at_once> lower{};
            for (std::size_t i = 0; i < neighbors.size(); ++i) lower[i] = compare_heights(at, neighbors[i].vertex);
            return lower;
        });
    }

    // Returns the vertices of the feature counterclockwise around the normal, the lowest first; among equally low ones,
    // the least index. `is_tilted` must be false only for a support feature: all its vertices are equally low.
    std::vector<std::uint32_t> corners_of(const HullFeature& feature, bool is_tilted) const {
        std::vector<std::uint32_t> vertices;
        for (const auto& at : polygon_of(hull_, feature, normal_, false).corners) vertices.push_back(at.vertex);
        const auto first = std::ranges::min_element(vertices, [&](std::uint32_t x, std::uint32_t y) {
            const int higher = is_tilted ? compare_heights(x, y) : 0;
            return higher < 0 || (higher == 0 && x < y);
        });
        std::ranges::rotate(vertices, first);
        return vertices;
    }

    // Returns the corner whose points are a vertex p and its foot p - h N / N.N in the plane. N is the plane's normal,
    // and h the height of p, times |N|.
    LongCorner corner(std::uint32_t vertex) const {
        const half_spaces::Plane::Exact& exact = plane_.exact();
        LongCorner result;
        result.num = heights_.exact(hull_.vertex(vertex));
        result.den = ScaledInteger(1.0);
        result.at[0].num = hull_.point(vertex);
        result.at[1].den = exact.square;
        for (std::size_t k = 0; k < 3; ++k)
            result.at[1].num[k] = result.at[0].num[k] * exact.square - result.num * exact.N[k];
        return result;
    }

    bool is_too_far(const LongCorner& exact) const {
        return key_of(limits_.max_gap) != infinity_key && compare_gap(exact, reach_, normal_, limits_.max_gap) > 0;
    }

    Pose pose_;
    half_spaces::Plane plane_;
    half_spaces::Heights heights_;
    HullInSpace hull_;
    bool is_plane_first_;
    Reach reach_;
    const PatchLimits& limits_;
    ExactNormal normal_;
};

}  // namespace

ContactPatch patch_on_plane(const ConvexBody& body, const Posed<HalfSpace>& half_space, int argument,
                            const PatchLimits& limits) {
    return PlanePatch(body, half_space, argument, limits).find();
}

}  // namespace ecods::patches
