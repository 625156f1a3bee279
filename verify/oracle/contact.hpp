// Triangles that share a point: what holds it, whether they cross, and what is normal to it.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "oracle/triangle_distance.hpp"

namespace ecods::oracle {

// Two triangles that share a point.
class Contact {
  public:
    Contact(const TriangleOf<mpz_class>& a, const TriangleOf<mpz_class>& b);

    // Ascending; of a polygon counterclockwise around the normal of `a`, from the least on.
    const std::vector<IntegerPoint>& corners() const { return corners_; }

    // They are not in one plane, and a point is in the relative interior of both.
    bool is_crossing() const;

    // All of feature_pairs() that hold a common point inside both and no other.
    std::vector<std::size_t> features() const;

    // Of the face, or the product of two edges, where one of these is defined.
    std::optional<Vector<mpz_class>> normal() const;

  private:
    // The lowest dimension of the vertices, edges and faces of a triangle that hold all of what is shared, and the
    // first of these.
    struct Holder {
        int dimension;
        std::size_t index;
    };
    Holder holder(const TriangleOf<mpz_class>& triangle) const;
    bool is_in_one_plane() const;
    void sort_around();

    const TriangleOf<mpz_class>& a_;
    const TriangleOf<mpz_class>& b_;
    std::vector<IntegerPoint> corners_;
    IntegerPoint middle_;  // of the corners: in the relative interior of what is shared
};

// From the closest point of `a` to that of `b`, of two features that are apart; the normal of a face or of two edges
// that touch; nothing otherwise.
std::optional<Vector<mpz_class>> direction(const FeaturePair& pair, const TriangleOf<mpz_class>& a,
                                           const TriangleOf<mpz_class>& b);

}  // namespace ecods::oracle
