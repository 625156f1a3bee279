// Pieces of triangles that no other triangle crosses, and lines through them.
#pragma once

#include <array>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "oracle/solid_points.hpp"

namespace ecods::oracle {

// The corners of a convex polygon in order; two of a segment, one of a point.
using RationalPolygon = std::vector<RationalPoint>;

// The triangle in pieces: no triangle of the others crosses the inside of a piece, and none has it in part only. A
// triangle without area is the segment or the point that it spans.
std::vector<RationalPolygon> pieces(const IntegerTriangle& triangle, const std::vector<IntegerTriangle>& others);

// A point as integers over one denominator.
struct HomogeneousPoint {
    SolidPoint x;
    mpz_class denominator = 1;
};

// Directions without meaning, the same each time. One is used until a line of it is in no general position.
class Directions {
  public:
    Directions() { take_next(); }
    const SolidPoint& current() const { return current_; }
    void take_next();
    std::uint32_t weight() { return 1 + static_cast<std::uint32_t>(generator_() % 97); }

  private:
    std::mt19937_64 generator_{1};
    SolidPoint current_;
};

// How many triangles a line passes through behind a point, before it, and at it.
struct Crossings {
    int after = 0, before = 0, at = 0;
};

// A surface as lines of one direction see it: most of them pass most triangles by, outside their boxes in the plane
// across the direction.
class CrossedSurface {
  public:
    explicit CrossedSurface(const std::vector<IntegerTriangle>& triangles) : triangles_(triangles) {}

    // None if the line meets an edge, or is in a triangle's plane: another direction may do.
    std::optional<Crossings> count(const HomogeneousPoint& point, const SolidPoint& direction);

  private:
    struct Box {
        std::array<mpz_class, 2> low, high;
    };
    void look_along(const SolidPoint& direction);

    const std::vector<IntegerTriangle>& triangles_;
    SolidPoint direction_{0, 0, 0};
    std::vector<Box> boxes_;
};

// Along a line through some inner point of the piece: the crossings with one surface, or with two.
Crossings count_one(const RationalPolygon& piece, CrossedSurface& surface, Directions& directions);
std::pair<Crossings, Crossings> count_both(const RationalPolygon& piece, CrossedSurface& own, CrossedSurface& other,
                                           Directions& directions);

}  // namespace ecods::oracle
