#include "query/certificate/pair_axis.hpp"

#include <bit>
#include <cmath>
#include <type_traits>

#include "base/outward.hpp"
#include "bvh/masks/projected_lanes.hpp"
#include "simd/dispatch.hpp"

namespace ecods {
namespace {

// Sets the members for tests in floats, which must prove boxes apart if their gap exceeds `need`. `need` must be
// finite.
void set_floats(PairAxis& axis, double need) noexcept {
    constexpr double v = 0x1p-23;
    const BodyAxis &a = axis.a, &b = axis.b;
    double sum = std::abs(b.q - a.q) + need;
    for (std::size_t k = 0; k < 3; ++k) sum += std::abs(a.p[k]) + std::abs(b.p[k]);
    if (!(sum > 0x1p-900 && sum < 0x1p900)) return;
    const std::uint64_t exponent = std::bit_cast<std::uint64_t>(sum) >> 52;
    const double scale = std::bit_cast<double>((2 * 1023 - exponent) << 52);
    axis.scale = scale;
    for (std::size_t k = 0; k < 3; ++k) {
        axis.p_a[k] = static_cast<float>(a.p[k] * scale);
        axis.p_b[k] = static_cast<float>(b.p[k] * scale);
    }
    // The factor 1 + 2^-20 covers the rounding of the difference of q and of this sum.
    const double errors = (a.error + b.error) + (a.corner_reach + b.corner_reach) + 16 * v * sum;
    const double margin = (need + errors * (1 + 0x1p-20)) * (scale * (1 + 0x1p-48)) + 0x1p-100;
    const double q = (b.q - a.q) * scale;
    axis.below = round_down(q - margin);
    axis.above = round_up(q + margin);
}

}  // namespace

PairAxis pair_axis(const BodyFrame& a, const BodyFrame& b, const Vec3& n, double distance) {
    PairAxis axis;
    axis.n = n;
    axis.a = put_on_axis(a, n);
    axis.b = put_on_axis(b, n);
    const double need = distance * n.norm() * (1 + 0x1p-40);
    // The factor 1 + 2^-20 covers the roundings: seven in a product of positive numbers, and two sums.
    const double margin = (axis.a.error + axis.b.error) * (1 + 0x1p-20) + need;
    if (!axis.a.is_bounded || !axis.b.is_bounded || !(margin < 0x1p600)) return axis;
    axis.margin = margin;
    set_floats(axis, need);
    return axis;
}

SlabEnds slab_ends(const PairAxis& axis, const BodyAxis& of_tree, const Slab& slab) noexcept {
    SlabEnds ends;
    double along = 0, square = 0, size = 0, rest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double m = static_cast<double>(slab.normal[k]);
        along += of_tree.p[k] * m;
        square += m * m;
        size += std::abs(of_tree.p[k]);
    }
    const double slope = along / square;
    for (std::size_t k = 0; k < 3; ++k) {
        const double part = of_tree.p[k] - slope * static_cast<double>(slab.normal[k]);
        rest += std::abs(part);
        ends.rest[k] = static_cast<float>(part * axis.scale);
    }
    if (!(rest <= size / 8)) return {};
    const double low = slope * axis.scale * static_cast<double>(slope > 0 ? slab.low : slab.high),
                 high = slope * axis.scale * static_cast<double>(slope > 0 ? slab.high : slab.low);
    ends.low = round_down(low);
    ends.high = round_up(high);
    return ends;
}

namespace {

// If one of x and y is a leaf and the other a node, joins the intervals of the leaf, so that the leaf is tested as one
// box.
template <class X, class Y, class Number>
ECODS_ALWAYS_INLINE void join_leaf(Reaches<Number>& of_x, Reaches<Number>& of_y) noexcept {
    if constexpr (std::is_same_v<X, Y>) return;
    std::is_same_v<X, TreeLeaf> ? of_x.join_lanes() : of_y.join_lanes();
}

template <std::size_t width>
struct InFloats : ProjectedLanes<width> {
    using Lanes = ProjectedLanes<width>;
    using Lanes::find_ends, Lanes::part_count, Lanes::store;
    using typename Lanes::Floats;

    // Sets `reaches` to the intervals of the boxes or triangles of x, with `below` and `above` added to their ends.
    template <class X>
    ECODS_ALWAYS_INLINE static void project(const std::array<float, 3>& p, const X& x, const SlabEnds* slab,
                                            float below, float above, Reaches<float>& reaches) noexcept {
        for (std::size_t part = 0; part < part_count; ++part) {
            Floats low, high;
            find_ends(x, p, part, low, high);
            if (std::is_same_v<X, BvhNode> && slab != nullptr) {
                Floats low_rest, high_rest;
                find_ends(x, slab->rest, part, low_rest, high_rest);
                low = max(low, low_rest + slab->low);
                high = min(high, high_rest + slab->high);
            }
            store(reaches.low, part, low + below);
            store(reaches.high, part, high + above);
        }
    }

    template <class X, class Y>
    ECODS_ALWAYS_INLINE static std::uint64_t apart(const PairAxis& axis, const X& x, const Y& y, std::uint32_t columns,
                                                   const SlabEnds* slab_x, const SlabEnds* slab_y) noexcept {
        Reaches<float> of_x, of_y;
        project(axis.p_a, x, slab_x, 0, 0, of_x);
        project(axis.p_b, y, slab_y, axis.below, axis.above, of_y);
        join_leaf<X, Y>(of_x, of_y);
        return apart_lanes<width>(of_x, of_y, columns);
    }
};

template <class X, class Y>
ECODS_ALWAYS_INLINE std::uint64_t apart_in_doubles(const PairAxis& axis, const X& x, const Y& y,
                                                   std::uint32_t columns) noexcept {
    Reaches<double> of_x, of_y;
    InDoubles::find_reaches(axis.a, axis.margin, x, of_x);
    InDoubles::find_reaches(axis.b, 0, y, of_y);
    join_leaf<X, Y>(of_x, of_y);
    return apart_lanes<4>(of_x, of_y, columns);
}

// Returns the set of columns that occur in `pairs`: bit j is set if bit 8 i + j of `pairs` is set for some i.
std::uint32_t columns_of(std::uint64_t pairs) {
    pairs |= pairs >> 32;
    pairs |= pairs >> 16;
    return static_cast<std::uint32_t>((pairs | pairs >> 8) & 0xff);
}

}  // namespace

template <class X, class Y>
std::uint64_t apart_mask(const PairAxis& axis, const X& x, const Y& y, std::uint64_t pairs, bool is_fine,
                         const SlabEnds* of_x, const SlabEnds* of_y) noexcept {
    std::uint64_t mask = dispatch_by_width<InFloats<4>::template apart<X, Y>, InFloats<8>::template apart<X, Y>>(
        axis, x, y, columns_of(pairs), of_x, of_y);
    pairs &= ~mask;
    if (is_fine && pairs != 0) mask |= dispatch<apart_in_doubles<X, Y>>(axis, x, y, columns_of(pairs));
    return mask;
}

template std::uint64_t apart_mask(const PairAxis&, const BvhNode&, const BvhNode&, std::uint64_t, bool, const SlabEnds*,
                                  const SlabEnds*) noexcept;
template std::uint64_t apart_mask(const PairAxis&, const BvhNode&, const TreeLeaf&, std::uint64_t, bool,
                                  const SlabEnds*, const SlabEnds*) noexcept;
template std::uint64_t apart_mask(const PairAxis&, const TreeLeaf&, const BvhNode&, std::uint64_t, bool,
                                  const SlabEnds*, const SlabEnds*) noexcept;
template std::uint64_t apart_mask(const PairAxis&, const TreeLeaf&, const TreeLeaf&, std::uint64_t, bool,
                                  const SlabEnds*, const SlabEnds*) noexcept;

}  // namespace ecods
