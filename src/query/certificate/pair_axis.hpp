// Compares the parts of two posed trees along an axis, eight with eight: in floats, and in doubles where floats fail.
//
// A test in floats takes a third of the time of one in doubles. It proves the same unless a gap exceeds what it needs
// by less than about 2^-19 of the bodies' size.
//
// With p, q and the errors of both trees (body_axis.hpp), a part of a reaches to p_a . y, and one of b from
// p_b . y + q, where q = q_b - q_a. Bound, in floats, with v = 2^-23 for one operation in any rounding mode: let
// S = |p| 1 for either tree, and |y| <= 1 + 2^-22. Converting p, and products and sums, take 4.01 v S for the middle of
// a box, as much for its reach, and 2 v S for its end: 10.1 v S. A triangle's corners take less. Adding q and the
// margin takes v (2 S + |q| + margin) more. Together this is below 13 v (S_a + S_b + |q| + need), with the margin below
// twice that sum. 16 v times the sum is added to what the gap needs, to the errors in doubles, and to the error of the
// leaves' corners. q minus (and plus) the margin is rounded outwards.
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
    double margin = std::numeric_limits<double>::infinity();  // gap in doubles above which parts are apart

    // The projection in floats. The initial values prove nothing apart.
    std::array<float, 3> p_a{}, p_b{};
    float below = -std::numeric_limits<float>::infinity();  // added to the lower ends of parts of b
    float above = std::numeric_limits<float>::infinity();   // added to the upper ends of parts of b
    double scale = 0;                                       // factor of p_a and p_b

    Proof::Word named = Proof::no_axis;
};

// The axis n, on which parts are apart if their gap exceeds `distance`.
PairAxis pair_axis(const BodyFrame& a, const BodyFrame& b, const Vec3& n, double distance);

// The slab of a node, on an axis nearly parallel to the slab's normal: p . y = slope (normal . y) + rest . y.
struct SlabEnds {
    std::array<float, 3> rest{};
    // The interval of slope (normal . y).
    float low = -std::numeric_limits<float>::infinity();
    float high = std::numeric_limits<float>::infinity();
};

// `of_tree` is the axis of the tree that has the slab.
SlabEnds slab_ends(const PairAxis& axis, const BodyAxis& of_tree, const Slab& slab) noexcept;

// Bit 8 i + j of the result: parts i of x and j of y are certainly apart. It tests all lanes i, and each lane j that
// occurs in `pairs`. A leaf beside a node is one part, 0, of all its triangles. `of_x` and `of_y` are slabs of x and y,
// or null. If `is_fine`, doubles decide where floats fail.
template <class X, class Y>
std::uint64_t apart_mask(const PairAxis& axis, const X& x, const Y& y, std::uint64_t pairs, bool is_fine,
                         const SlabEnds* of_x = nullptr, const SlabEnds* of_y = nullptr) noexcept;

}  // namespace ecods
