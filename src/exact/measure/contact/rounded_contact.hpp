// RoundedContact computes the times at which a translated triangle is within a distance p of another triangle.
//
// While the first triangle A goes along s m, it is within p of the second one B if and only if the point s m is in K +
// p: within p of the set of differences K = B - A. K is convex, so these s form a closed interval, or there are none. K
// + p is covered by the pieces that pairs of features have: a ball around b - a for two vertices; a cylinder without
// caps around a vertex and an edge, of the points whose foot on the edge's line is on the edge; and for a vertex and a
// face, and for two edges, two plates, of the points at the distance p from the plane of K's triangle or parallelogram
// whose foot is in it. All pieces are subsets of K + p, and together they contain its border. So the interval begins at
// the least time at which s m enters a piece, and ends at the greatest time at which it leaves one.
//
// Let w be the vector from the piece's first corner to the origin, so that s m is at w + s m from the corner. The
// pieces are entered and left at these times (d = m, n = u x v):
//
//     ball            (-d.w -+ sqrt(p^2 d.d - |d x w|^2)) / d.d
//     cylinder on u   (-(d x u).(w x u) -+ sqrt(u.u (p^2 |d x u|^2 - [d, w, u]^2))) / |d x u|^2; none if d x u = 0
//     plate           (-n.w -+ p sqrt(n.n)) / n.d if n.d > 0, the negative of both parts if n.d < 0; none if n.d = 0
//
// A foot on a line or in a plane depends on s linearly, so the sign of a RootSum says if it is in the feature. Where
// two pieces join, both have the same time. With differences below 2^k, x and z have up to 4k + 4 bits and y 8k + 8;
// the tests of feet up to 14k + 16.
#pragma once

#include <array>
#include <optional>

#include "ecods/pose.hpp"
#include "exact/measure/distance/feature_pair.hpp"
#include "exact/number/exact_sum.hpp"
#include "exact/number/long_vector.hpp"
#include "exact/number/root_sum.hpp"

namespace ecods::exact {

class RoundedContact {
  public:
    // Takes the three corners of A, then those of B; the motion of A; and the distance p, which must be positive.
    // interval() requires a motion that is not zero.
    RoundedContact(const std::array<ScaledLongVector, 6>& corners, const ScaledLongVector& motion, const ExactSum& p);

    // An End of the interval is its time, exact and rounded once, and the first pair of features, in the order of
    // feature_pairs, whose distance at this time is p. The rounded time is at least 2^-1074 in magnitude unless the
    // time is 0.
    struct End {
        RootSum time;
        double rounded = 0;
        FeaturePair features;
    };
    struct Interval {
        End first, last;
    };
    // Returns all times at which the triangles are within p of each other, of either sign; nullopt if there are none.
    std::optional<Interval> interval() const;

    // A Place holds the contact point and normal of two features at a time. `point` divides the segment between the
    // closest points of the features: it is at the part radius_a / p of the way from A to B. `normal` is the unit
    // vector along the segment, from A to B. Each coordinate is rounded once.
    struct Place {
        Vec3 point, normal;
    };
    // Returns the Place of the features of f at `time`; nullopt if the features are parallel, or an edge has no length.
    // The normal is correct if the segment has the length p; otherwise only the point has a meaning. radius_a must be
    // from 0 to p.
    std::optional<Place> place(const FeaturePair& f, const RootSum& time, const ScaledInteger& radius_a) const;

  private:
    // A Piece is a corner, an edge, a triangle or a parallelogram of K = B - A, whose first corner is at -w.
    struct Piece {
        ScaledLongVector w;
        std::size_t dimension = 0;
        ScaledLongVector u, v;
        bool is_triangle = false;
    };
    // Times holds the times at which the point s m (s is the time, m the motion) enters and leaves a piece. A time is
    // empty if the foot of s m is not in the piece's feature at that time.
    struct Times {
        std::optional<RootSum> enter, leave;
    };

    const ScaledLongVector& corner(std::size_t side, std::size_t i) const noexcept {
        return corners_[3 * side + i % 3];
    }
    bool is_repeated(const FeaturePair& f) const noexcept;
    Piece piece_of(const FeaturePair& f) const;
    static ScaledInteger square_of(const Piece& piece);
    static ScaledLongVector across(const Piece& piece, const ScaledLongVector& x);
    Times times_of(const Piece& piece) const;
    Times of_ball(const Piece& piece) const;
    Times of_cylinder(const Piece& piece) const;
    Times of_plate(const Piece& piece) const;

    std::array<ScaledLongVector, 6> corners_;
    ScaledLongVector motion_;
    ScaledInteger p_;
    std::array<std::array<bool, 3>, 2> is_copy_{};  // corners that are equal to an earlier one of their triangle
};

}  // namespace ecods::exact
