// A plane figure at its place, and what is asked of two of them.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ecods/ecods.hpp"
#include "scenes/plane/plane_figure.hpp"

namespace ecods::examples {

// Figures that are moved in their plane, and turned about its normal. Prisms are asked where a plane alone has no
// normals, and no way out.
class PlacedFigure {
  public:
    // The sine and the cosine of the turn are given as they are, rounded or not.
    PlacedFigure(const std::string& name, const scenes::PlaneFigure& figure, const Vec2& cosine_and_sine,
                 const Vec2& at);

    std::string name;
    scenes::PlaneFigure figure;
    Pose pose;

    Vec2 to_plane(const Vec2& corner) const;  // rounded: for pictures
    double diameter() const;                  // at most so much, and about
    Posed<MeshShape> flat() const { return {*flat_, pose}; }

  private:
    std::shared_ptr<const MeshShape> flat_;
};

// Where the figures overlap, in convex pieces, one for each pair of triangles that share more than a segment.
std::vector<std::vector<Vec2>> intersection(const PlacedFigure& a, const PlacedFigure& b);

// Where sides cross or touch: points, each coordinate rounded once, ascending.
std::vector<Vec2> crossings(const PlacedFigure& a, const PlacedFigure& b);

// A corner of one figure on or near a side or a corner of the other.
struct PlaneContact {
    double gap = 0;              // rounded once, as all numbers here
    Vec2 on_a, on_b;             // the closest points
    std::optional<Vec2> normal;  // from a to b; nothing where corner touches corner
    std::string what;            // "corner 2 of b's outline, side 0 of a's outline"
};

// All within the distance, of figures that do not overlap.
std::vector<PlaneContact> contacts(const PlacedFigure& a, const PlacedFigure& b, double distance);

// How deep convex figures are in each other: the shortest way out for b, and the side of which it is the normal.
// Nothing where they share no point.
struct PlaneDepth {
    double depth = 0;
    Vec2 direction = Vec2::Zero();
    std::string side;
};
std::optional<PlaneDepth> convex_depth(const PlacedFigure& a, const PlacedFigure& b);

// Proven bounds of the same for any figures, and where b is parted from a.
struct PlaneDepthBounds {
    double lower = 0, upper = 0;
    Vec2 parted = Vec2::Zero();
};
std::optional<PlaneDepthBounds> depth_bounds(const PlacedFigure& a, const PlacedFigure& b);

}  // namespace ecods::examples
