// Plane figures: what lies between an outline and the holes in it, as flat meshes and as prisms. So questions about
// meshes and solids are questions about figures: of flat meshes at z = 0 whether they meet, in what, and how far they
// are apart; of prisms, how deep they are in each other, and the normals of contacts.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "ecods/mesh.hpp"
#include "ecods/primitives.hpp"

namespace ecods::scenes {

// The corners of a polygon, in either direction; side i goes from corner i to the next one, the last to corner 0.
using Outline = std::vector<Vec2>;

struct PlaneFigure {
    Outline outline;
    std::vector<Outline> holes;

    // Outlines are counted so everywhere below: 0 is the figure's own, i that of hole i - 1.
    std::size_t outline_count() const { return 1 + holes.size(); }
    const Outline& outline_at(std::size_t i) const { return i == 0 ? outline : holes[i - 1]; }
};

// A side of a figure, or its corner of that index.
struct FigurePlace {
    std::size_t outline = 0;
    std::size_t index = 0;

    friend auto operator<=>(const FigurePlace&, const FigurePlace&) = default;
};

// "side 3 of the outline", "side 3 of hole 0".
std::ostream& operator<<(std::ostream& out, const FigurePlace& place);

// What is given is no figure. Everything is decided exactly, for the coordinates as they are.
class FigureError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

// A coordinate of a corner is NaN or infinite.
class CornerNotFinite final : public FigureError {
  public:
    CornerNotFinite(const FigurePlace& corner, int axis, double value);

    FigurePlace corner;
    int axis;  // 0 or 1
    double value;
};

// An outline has fewer than three corners.
class TooFewCorners final : public FigureError {
  public:
    TooFewCorners(std::size_t outline, std::size_t corner_count);

    std::size_t outline;
    std::size_t corner_count;
};

// Both ends of a side are the same point.
class SideWithoutLength final : public FigureError {
  public:
    explicit SideWithoutLength(const FigurePlace& side);

    FigurePlace side;
};

// Two sides share a point which is not merely the corner between them: an outline crosses itself, touches itself or
// goes back on itself, or two outlines meet.
class SidesMeet final : public FigureError {
  public:
    SidesMeet(const FigurePlace& a, const FigurePlace& b);

    FigurePlace a, b;  // of several pairs the least; a < b
};

// A hole is not inside the outline, or is inside another hole.
class HoleMisplaced final : public FigureError {
  public:
    explicit HoleMisplaced(std::size_t hole, std::optional<std::size_t> inside = {});

    std::size_t hole;                   // its index among the holes
    std::optional<std::size_t> inside;  // of the hole that it is in; nothing if it is outside the outline
};

// The height of a prism is not positive and finite.
class InvalidHeight final : public FigureError {
  public:
    explicit InvalidHeight(double value);

    double value;
};

// Throws the first of the errors above that applies, in their order; of one kind, the one of the least place.
void check_figure(const PlaneFigure& figure);

// A figure as triangles: the constrained Delaunay triangulation of its sides. Its vertices are all corners, outline by
// outline, and no others; triangles are counterclockwise, each beginning with its least vertex, and ascend. Which
// triangles they are, of corners on one circle, is a matter of the version of CGAL.
struct FigureTriangles {
    std::vector<Vec2> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::array<std::uint32_t, 2>> sides;  // in the order of places; the figure is on the left of each
};
FigureTriangles triangulate(const PlaneFigure& figure);  // throws as check_figure() does

// The figure at z = 0; triangles are counterclockwise seen from above.
std::shared_ptr<const Mesh> flat_mesh(const PlaneFigure& figure);

// All points of the figure with z from -height / 2 to height / 2, as a closed surface turned outwards. Triangles:
// below, above, then two for each side, in the order of places; vertices: those below, then those above. Of a convex
// figure it is convex.
std::shared_ptr<const Mesh> prism(const PlaneFigure& figure, double height);

// The side of a figure that a triangle of its prism belongs to; nothing of those below and above.
std::optional<FigurePlace> side_of_prism(const PlaneFigure& figure, const Mesh& prism, std::size_t triangle);

}  // namespace ecods::scenes
