// The oracle's half spaces: what include/ecods/solid.hpp promises, from the definition, over all vertices.
//
// A point x is in the image of { y : n . y <= d } under R y + t exactly if n . y <= d for the y that solves R y = x -
// t. That y is computed in fractions, by elimination, and never a normal of the image: its direction G, by which n . y
// grows, is the solution of R^T G = n. Exact for all finite doubles, in any rounding mode.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"
#include "oracle/distance.hpp"

namespace ecods::oracle {

struct HalfSpaceSet {
    Vec3 normal;
    double offset;
    Pose pose;  // its matrix must be regular
};

// How high points are: n . y - d, which is positive outside.
class ExactHeights {
  public:
    explicit ExactHeights(const HalfSpaceSet& set);

    mpq_class at(const std::array<mpq_class, 3>& x) const;
    mpq_class at(const Vec3& v, const Pose& pose) const;  // of the point R v + t
    mpq_class rise(const Vec3& step) const;               // by which heights grow along a step

    // The distance of a height from the plane, without its sign; and the foot of the perpendicular of a point.
    ExactRoot distance(const mpq_class& height) const;
    ExactPoint foot(const Vec3& v, const Pose& pose) const;
    ExactRoot share(int axis) const;  // the size of a coordinate of the unit vector along G
    const std::array<mpq_class, 3>& direction() const noexcept { return direction_; }

  private:
    std::array<mpq_class, 3> direction_;  // G
    mpq_class at_origin_;
};

std::array<mpq_class, 3> exact_posed(const Vec3& v, const Pose& pose);
ExactPoint exact_point(const std::array<mpq_class, 3>& x);

// A corner of a triangle at the least height: the first of these, by triangle and corner.
struct LowestCorner {
    mpq_class height;
    std::uint32_t triangle, corner, vertex;
};
LowestCorner lowest_corner(const ExactHeights& heights, const Mesh& mesh, const Pose& pose);
mpq_class greatest_height(const ExactHeights& heights, const Mesh& mesh, const Pose& pose);

// The first time, at most 1, at which a corner that moves on a straight line reaches the plane, which moves with the
// half space by `shift`; and the first such corner. None may reach it at the start.
struct FirstCorner {
    mpq_class time;
    std::uint32_t triangle, corner;
};
std::optional<FirstCorner> first_corner(const HalfSpaceSet& set, const Vec3& end, const Mesh& mesh, const Pose& from,
                                        const Pose& to);

}  // namespace ecods::oracle
