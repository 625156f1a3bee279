// A PairAxis compares boxes or triangles of two posed trees along an axis, eight with eight: in floats, and in doubles
// if floats do not prove a pair apart.
//
// A test in floats takes a third of the time of a test in doubles. It proves the same pairs apart, except pairs whose
// gap exceeds the required one by less than about 2^-19 of the bodies' size.
//
// With p, q and the errors of both trees (body_axis.hpp), a point of a has the coordinate p_a . y, and a point of b has
// p_b . y + q, where q = q_b - q_a. Bound, in floats, with v = 2^-23 for one operation in any rounding mode: let S =
// |p| 1 for either tree, and |y| <= 1 + 2^-22. Converting p, and products and sums, take 4.01 v S for the middle of a
// box, as much for its half width, and 2 v S for its end: 10.1 v S. A triangle's corners take less. Adding q and the
// margin takes v (2 S + |q| + margin) more. Together this is below 13 v (S_a + S_b + |q| + need), since the margin is
// below twice that sum. The margin is the sum of the required gap, the errors in doubles, the errors of the leaves'
// corners, and 16 v (S_a + S_b + |q| + need). q minus (and plus) the margin is rounded outwards.
//
// Underflow: numbers are scaled so that the sum is between 1 and 2. Twenty operations lose 2^-126 each, also if
// subnormals count as zero: 2^-100 is added.
// Claim: verify/proofs/float_axes.py
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "query/certificate/body_axis.hpp"
#include "query/certificate/proof.hpp"

namespace ecods {

struct PairAxis {
    Vec3 n = Vec3::Zero();
    BodyAxis a, b;
    double margin = std::numeric_limits<double>::infinity();  // boxes are apart if their gap in doubles exceeds this

    // The members down to `scale` are for tests in floats. Their initial values prove no pair apart.
    std::array<float, 3> p_a{}, p_b{};
    float below = -std::numeric_limits<float>::infinity();  // added to the lower ends of intervals of b
    float above = std::numeric_limits<float>::infinity();   // added to the upper ends of intervals of b
    double scale = 0;                                       // factor of p_a and p_b

    Proof::Word named = Proof::no_axis;
};

// Returns the PairAxis along n, which proves two boxes apart if their gap exceeds `distance`.
PairAxis pair_axis(const BodyFrame& a, const BodyFrame& b, const Vec3& n, double distance);

// Bounds p . y on a node's slab, for an axis p that is nearly parallel to the slab's normal: p . y = slope (normal . y)
// + rest . y, whose first term is in [low, high].
struct SlabEnds {
    std::array<float, 3> rest{};
    // [low, high] is the interval of slope (normal . y) in the slab.
    float low = -std::numeric_limits<float>::infinity();
    float high = std::numeric_limits<float>::infinity();
};

// Returns the ends of a node's slab on the axis. `of_tree` must be axis.a or axis.b, whichever belongs to the slab's
// tree.
SlabEnds slab_ends(const PairAxis& axis, const BodyAxis& of_tree, const Slab& slab) noexcept;

// Returns the pairs that are certainly apart: bit 8 i + j stands for lane i of x and lane j of y. Only pairs whose j
// occurs in `pairs` are tested. If one of x and y is a leaf and the other a node, the leaf counts as one box, lane 0.
// `of_x` and `of_y` are the slabs of x and y, or null. If `is_fine`, doubles test the pairs that floats leave open.
template <class X, class Y>
std::uint64_t apart_mask(const PairAxis& axis, const X& x, const Y& y, std::uint64_t pairs, bool is_fine,
                         const SlabEnds* of_x = nullptr, const SlabEnds* of_y = nullptr) noexcept;

}  // namespace ecods
