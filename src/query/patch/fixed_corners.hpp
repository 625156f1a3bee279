// FixedCorners rounds the corners of a patch in fixed precision, if the patch is made by features at the least
// difference.
//
// All pairs of points at the least difference differ by one vector w (closest_hulls.hpp). If a feature of a corner is a
// vertex, this vertex is one of the corner's two points, and the other point is the vertex plus or minus w. If the
// features are two edges, the point on the first edge is its intersection with the second edge moved by -w, computed in
// two of the coordinates.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "ecods/contact.hpp"
#include "exact/measure/round/fixed_shift.hpp"
#include "exact/measure/round/rounded_ends.hpp"
#include "query/convex/closest_hulls.hpp"

namespace ecods::patches {

class FixedCorners {
  public:
    // Returns the corners of `least`; nullopt if the points do not fit in fixed precision, or if it does not determine
    // w. The arguments must outlive the result.
    static std::optional<FixedCorners> of(convex::PosedHulls& hulls, const convex::LeastDifference& least,
                                          const exact::Radii& radii);

    // Sets both points and the middle of the corner at which the features of `pair` have the least difference. Returns
    // false if a rounding is not certain.
    bool round(const convex::HullFeaturePair& pair, PatchCorner& corner) const;
    // Returns w in units of fixed points (posed_hulls.hpp) if w is known exactly; otherwise nullopt.
    std::optional<exact::IntegerVector> way() const noexcept;
    // Returns the least difference less the radii, as a signed distance; nullopt if its rounding is not certain.
    std::optional<double> distance() const noexcept;

  private:
    // A WorldPoint is a posed vertex in units of 2^unit_, with the error bound of each coordinate.
    struct WorldPoint {
        exact::IntegerVector x;
        std::uint64_t error;
    };
    // Coordinates holds the coordinates of both points of a corner, and of the sum of the points.
    struct Coordinates {
        std::array<exact::FixedNumber, 3> a, b, sum;
    };

    FixedCorners(convex::PosedHulls& hulls, const exact::Radii& radii) noexcept : hulls_(&hulls), radii_(radii) {}
    bool bind();
    bool find_shift(const convex::LeastDifference& least);
    WorldPoint at(std::size_t side, std::uint32_t vertex) const;
    std::array<WorldPoint, 2> ends_of(std::size_t side, std::uint32_t edge) const;
    void set_vertex(const convex::HullFeaturePair& pair, Coordinates& at) const;
    bool set_crossing(const convex::HullFeaturePair& edges, Coordinates& at) const;
    void add_radii(Coordinates& at) const noexcept;

    convex::PosedHulls* hulls_;
    exact::Radii radii_;
    int unit_ = 0, up_ = 0;  // points of the hulls are shifted by up_ digits to this unit
    std::uint64_t error_ = 0;
    WorldPoint origin_{};
    std::optional<exact::FixedShift> shift_;  // w, and the normal
    std::size_t most_ = 0;                    // the largest coordinate of the normal
};

}  // namespace ecods::patches
