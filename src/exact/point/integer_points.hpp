// IntegerPoints are N posed points as integers, in the narrowest kernel that holds them: complete for every finite
// double.
#pragma once

#include <array>
#include <bit>
#include <type_traits>

#include "ecods/pose.hpp"
#include "exact/number/dyadic.hpp"
#include "exact/number/kernel.hpp"
#include "exact/point/pose_terms.hpp"
#include "exact/point/posed_points.hpp"

namespace ecods::exact {

// Holds points for an integer kernel, in units of one power of two and moved by one vector, so signs are unchanged.
template <class Kernel, std::size_t N>
struct IntegerPoints {
    std::array<typename Kernel::Point, N> at;
    int unit = 0;  // counted in 2^unit
};

static_assert(64 * 4 - sum_bits + 4 <= LimbKernel<4>::coordinate_bits);

// Replaces points by their differences from the first one, and returns the range of the digits of the differences.
template <int L, std::size_t N>
BitRange relate_to_first(IntegerPoints<LimbKernel<L>, N>& points) noexcept {
    const std::array<Limbs<L>, 3> first = points.at[0];
    Limbs<L> any{};
    for (auto& point : points.at) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            point[axis] = subtract<L>(point[axis], first[axis]);
            const Magnitude<L> m = magnitude<L>(point[axis]);
            for (std::size_t i = 0; i < L; ++i) any[i] |= m.limbs[i];
        }
    }
    BitRange range;
    for (int i = 0; i < L; ++i) {
        const std::uint64_t limb = any[static_cast<std::size_t>(i)];
        if (limb == 0) continue;
        range.include(64 * i + std::countr_zero(limb), 64 * i + static_cast<int>(std::bit_width(limb)));
    }
    return range;
}

// Converts one coordinate, divided by 2^shift, for another kernel. The value must fit.
template <int L>
void assign(std::int64_t& to, const Limbs<L>& from, int shift) noexcept {
    to = static_cast<std::int64_t>(shift_right<1, L>(from, shift)[0]);
}
template <int L>
void assign(Int128& to, const Limbs<L>& from, int shift) noexcept {
    const Limbs<2> x = shift_right<2, L>(from, shift);
    to = static_cast<Int128>(Uint128{x[1]} << 64 | x[0]);
}
template <int L, std::size_t M>
void assign(std::array<std::uint64_t, M>& to, const Limbs<L>& from, int shift) noexcept {
    to = shift_right<static_cast<int>(M), L>(from, shift);
}

// Returns the points divided by 2^shift, which must divide them, for a kernel that must hold the quotients.
template <class Kernel, int L, std::size_t N>
IntegerPoints<Kernel, N> narrow(const IntegerPoints<LimbKernel<L>, N>& points, int shift) noexcept {
    IntegerPoints<Kernel, N> result;
    result.unit = points.unit + shift;
    for (std::size_t i = 0; i < N; ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) assign<L>(result.at[i][axis], points.at[i][axis], shift);
    }
    return result;
}

// Calls `use` with the points in the narrowest kernel that holds them, without the zeros that all differences end in.
template <int L, std::size_t N, class Use>
auto use_narrowest(IntegerPoints<LimbKernel<L>, N>& points, Use&& use) {
    const BitRange range = relate_to_first<L>(points);
    const int shift = range.empty() ? 0 : range.low;
    const int width = range.width();
    if (width <= OneLimbKernel::coordinate_bits) return use(narrow<OneLimbKernel, L>(points, shift));
    if (width <= TwoLimbKernel::coordinate_bits) return use(narrow<TwoLimbKernel, L>(points, shift));
    if (width <= LimbKernel<4>::coordinate_bits) return use(narrow<LimbKernel<4>, L>(points, shift));
    if constexpr (L > 4) {
        if (width <= LimbKernel<8>::coordinate_bits) return use(narrow<LimbKernel<8>, L>(points, shift));
    }
    if constexpr (L > 8) {
        if (width <= LimbKernel<20>::coordinate_bits) return use(narrow<LimbKernel<20>, L>(points, shift));
    }
    // The points keep their limbs: `sum_bits` has left the bits that a kernel's determinants need.
    return use(narrow<LimbKernel<L>, L>(points, shift));
}

// Overload for points whose differences have at most TwoLimbKernel::coordinate_bits.
template <std::size_t N, class Use>
auto use_narrowest(const IntegerPoints<TwoLimbKernel, N>& points, Use&& use) {
    IntegerPoints<TwoLimbKernel, N> two;
    two.unit = points.unit;
    Uint128 leading = 0;   // has as many bits as the largest magnitude; -2^k may count as 2^k - 1
    Uint128 trailing = 0;  // ends in as many zeros as all coordinates do
    for (std::size_t i = 0; i < N; ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Int128 x = points.at[i][axis] - points.at[0][axis];
            two.at[i][axis] = x;
            leading |= static_cast<Uint128>(x ^ (x >> 127));
            trailing |= static_cast<Uint128>(x);
        }
    }
    const int shift = trailing == 0 ? 0 : trailing_zeros(trailing);
    if (bit_width(leading) + 1 - shift > OneLimbKernel::coordinate_bits) return use(two);
    IntegerPoints<OneLimbKernel, N> one;
    one.unit = points.unit + shift;
    for (std::size_t i = 0; i < N; ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            one.at[i][axis] = static_cast<std::int64_t>(two.at[i][axis] >> shift);
        }
    }
    return use(one);
}

// Calls `use` with the points as IntegerPoints<Kernel, N> of the narrowest kernel that holds them, and returns its
// result. `use` must take every kernel. The unit is chosen for these points alone. Far from the origin, differences of
// translations are much shorter than the translations.
template <std::size_t N, class Use>
auto with_integers(const PosedPoints<N>& points, Use&& use) {
    std::array<PoseTerms, N> terms;
    BitRange digits;
    for (std::size_t i = 0; i < N; ++i) {
        if (i > 0 && points[i].pose == points[i - 1].pose) {
            terms[i] = terms[i - 1];
        } else {
            terms[i].set(*points[i].pose, points[0].pose->t);
        }
        std::array<BitRange, 3> v;
        for (std::size_t k = 0; k < 3; ++k) v[k].include(decode((*points[i].v)[static_cast<Eigen::Index>(k)]));
        digits.include(terms[i].digits(v));
    }
    const int unit = digits.empty() ? 0 : digits.low, bits = digits.width() + sum_bits;
    return with_limb_count<4>(bits, [&]<int L>(std::integral_constant<int, L>) {
        IntegerPoints<LimbKernel<L>, N> integers;
        integers.unit = unit;
        for (std::size_t i = 0; i < N; ++i) integers.at[i] = terms[i].template point_in<Limbs<L>>(unit, *points[i].v);
        return use_narrowest<L>(integers, use);
    });
}

}  // namespace ecods::exact
