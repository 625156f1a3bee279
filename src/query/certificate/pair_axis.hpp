// An axis on which the parts of two posed trees are compared, eight with eight, in floats, and in doubles where those
// fail.
//
// In floats a test takes a third of the time of one in doubles, and proves the same but where a gap is less than some
// 2^-19 of the bodies' size beyond what it needs.
//
// With p, q and the errors of both trees (body_axis.hpp), a part of a reaches to p_a . y, one of b from
// p_b . y + q, where q = q_b - q_a. Bound, in floats, v = 2^-23 for one operation in any rounding mode: let S = |p| 1
// for either tree, and |y| <= 1 + 2^-22. Converting p, and products and sums, take 4.01 v S for the middle of a box, as
// much for its reach, and 2 v S for its end: 10.1 v S. A triangle's corners take less. Adding q and the margin takes
// v (2 S + |q| + margin) more. Together below 13 v (S_a + S_b + |q| + need), with the margin below twice that sum: 16 v
// are added to what the gap needs, to the errors in doubles, and to what the corners of leaves may be off. q less (and
// plus) the margin is rounded outwards. Underflow: numbers are scaled so that the sum is between 1 and 2; twenty
// operations lose 2^-126 each, subnormals taken for zero included: 2^-100 is added.
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
    double margin = std::numeric_limits<double>::infinity();  // by how much more than nothing parts must be apart

    // In floats; as they are, nothing is apart.
    std::array<float, 3> p_a{}, p_b{};
    float below = -std::numeric_limits<float>::infinity();  // added to where parts of b begin,
    float above = std::numeric_limits<float>::infinity();   // and to where they end
    double scale = 0;                                       // by which p_a and p_b are multiplied

    Proof::Word named = Proof::no_axis;
};

// Parts are apart if there is more than `distance` between them.
PairAxis pair_axis(const BodyFrame& a, const BodyFrame& b, const Vec3& n, double distance);

// The slab of a node on an axis that is about the slab's: p . y = slope (normal . y) + rest . y.
struct SlabEnds {
    std::array<float, 3> rest{};
    // slope (normal . y) is between these.
    float low = -std::numeric_limits<float>::infinity();
    float high = std::numeric_limits<float>::infinity();
};

// `of_tree` is that of the slab's tree.
SlabEnds slab_ends(const PairAxis& axis, const BodyAxis& of_tree, const Slab& slab) noexcept;

// Bit 8 i + j: parts i of x and j of y are certainly apart, on either side. Of all lanes i, and of those j that any of
// `pairs` has. A leaf beside a node is one part, 0, of all of its triangles. A slab is that of x or of y. Doubles are
// asked where floats fail, if `is_fine`.
template <class X, class Y>
std::uint64_t apart_mask(const PairAxis& axis, const X& x, const Y& y, std::uint64_t pairs, bool is_fine,
                         const SlabEnds* of_x = nullptr, const SlabEnds* of_y = nullptr) noexcept;

}  // namespace ecods
