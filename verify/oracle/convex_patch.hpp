// The oracle's contact patches: what include/ecods/contact.hpp promises of two convex solids, from the definition, in
// rational numbers and over all choices.
//
// Vertices of both features are seen along the normal, as points of a plane. What the two polygons share is the hull of
// the vertices of each that are inside the other, and of all points where a segment between two vertices of one crosses
// a segment of the other. Its corners are then located in both polygons: at a vertex, on a side, or inside.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstddef>
#include <vector>

#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"
#include "oracle/distance.hpp"
#include "oracle/vector.hpp"

namespace ecods::oracle {

class ConvexPatch {
  public:
    // Of solids whose normal is known; poses are regular. The solids face each other within the tilt.
    ConvexPatch(const std::array<const Mesh*, 2>& meshes, const std::array<Pose, 2>& poses,
                const std::array<mpz_class, 3>& normal, double min_cos_squared);

    struct Corner {
        NamedFeature a, b;
        std::array<Vector<mpq_class>, 2> at;
        mpq_class height;  // n . (second - first)
    };
    // Counterclockwise around the normal; the first is the one of least height, of ties the first by name.
    const std::vector<Corner>& corners() const { return corners_; }

    // Which `count` corners of the given ones, in order, span the largest area, with the first among them.
    std::vector<std::size_t> chosen(const std::vector<Corner>& corners, std::size_t count) const;

    // The corner's numbers, rounded, of bodies with these radii; sign_of_gap is that of the gap less d.
    Vec3 point(const Corner& corner, std::size_t side, const std::array<double, 2>& radii) const;
    Vec3 middle(const Corner& corner, const std::array<double, 2>& radii) const;
    double gap(const Corner& corner, const std::array<double, 2>& radii) const;
    int sign_of_gap(const Corner& corner, const std::array<double, 2>& radii, double d) const;

  private:
    mpq_class area_of(const std::vector<Corner>& corners, const std::vector<std::size_t>& chosen) const;

    Vector<mpq_class> normal_;
    mpq_class square_;
    std::vector<Corner> corners_;
};

}  // namespace ecods::oracle
