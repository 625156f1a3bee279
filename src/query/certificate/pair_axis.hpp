// An axis on which the parts of two posed trees are compared, eight with eight, in floats.
//
// In floats a test takes a third of the time of one in doubles, and proves the same but where a gap is less than some
// 2^-19 of the bodies' size beyond what it needs.
//
// With p, q and the errors of both trees (proof_axes.hpp), a part of a reaches to p_a . y, one of b from
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

#include "bvh/tree/mesh_bvh.hpp"
#include "query/certificate/proof_axes.hpp"

namespace ecods {

struct PairAxis {
    std::array<float, 3> a{}, b{};
    // What is added to where parts of b begin, and to where they end. As they are, nothing is apart.
    float below = -std::numeric_limits<float>::infinity();
    float above = std::numeric_limits<float>::infinity();
    double scale = 0;  // by which a and b are multiplied
};

// Parts are apart if there is more than `need` between them, which is finite.
PairAxis pair_axis(const BodyAxis& a, const BodyAxis& b, double need) noexcept;

// The slab of a node on an axis that is about the slab's: p . y = slope (normal . y) + rest . y.
struct SlabEnds {
    std::array<float, 3> rest{};
    // slope (normal . y) is between these.
    float low = -std::numeric_limits<float>::infinity();
    float high = std::numeric_limits<float>::infinity();
};

// `p` is that of the slab's tree, of which the axis was made.
SlabEnds slab_ends(const PairAxis& axis, const BodyAxis& of_tree, const Slab& slab) noexcept;

// Bit 8 i + j: parts i of x and j of y are certainly apart, on either side. Of all lanes i, and of those j that
// `columns` has. A leaf beside a node is one part, 0, of all of its triangles. A slab is that of x or of y.
std::uint64_t apart_mask(const PairAxis& axis, const BvhNode& x, const BvhNode& y, std::uint32_t columns,
                         const SlabEnds* of_x = nullptr, const SlabEnds* of_y = nullptr) noexcept;
std::uint64_t apart_mask(const PairAxis& axis, const BvhNode& x, const TreeLeaf& y, std::uint32_t columns,
                         const SlabEnds* of_x = nullptr, const SlabEnds* of_y = nullptr) noexcept;
std::uint64_t apart_mask(const PairAxis& axis, const TreeLeaf& x, const BvhNode& y, std::uint32_t columns,
                         const SlabEnds* of_x = nullptr, const SlabEnds* of_y = nullptr) noexcept;
std::uint64_t apart_mask(const PairAxis& axis, const TreeLeaf& x, const TreeLeaf& y, std::uint32_t columns,
                         const SlabEnds* of_x = nullptr, const SlabEnds* of_y = nullptr) noexcept;

}  // namespace ecods
