// From six posed points to the kernel of the width that they need: complete for every finite double.
#pragma once

#include <array>
#include <bit>
#include <type_traits>

#include "ecods/pose.hpp"
#include "exact/number/dyadic.hpp"
#include "exact/number/kernel.hpp"

namespace ecods::exact {

// A point of a body, R v + t, by reference.
struct PointRef {
    const Pose* pose;
    const Vec3* v;
};

using SixPoints = std::array<PointRef, 6>;

// Six points relative to the translation of the first one's pose: P - t_0 = R v + t - t_0. The differences of points,
// of which all signs are made, are those of the points; far from the origin the numbers are much shorter.
template <int L>
using SixWide = std::array<std::array<Limbs<L>, 3>, 6>;

// The digits that the coordinates of R v + t - t_0 are made of, before they are added up.
inline BitRange digits_of(const SixPoints& points) noexcept {
    BitRange range;
    for (const PointRef& p : points) {
        for (int column = 0; column < 3; ++column) {
            BitRange r;
            for (int row = 0; row < 3; ++row) r.include(decode(p.pose->R(row, column)));
            BitRange v;
            v.include(decode((*p.v)[column]));
            range.include(r * v);
        }
        for (int row = 0; row < 3; ++row) range.include(decode(p.pose->t[row]));
    }
    return range;
}

// A coordinate is a sum of three products and two translations, each below 2^high: three more bits. A difference of two
// coordinates needs one more. A kernel of L limbs takes coordinates of 64 L - 3 bits and a sign.
constexpr int sum_bits = 3 + 1 + 3;
static_assert(64 * 4 - sum_bits + 4 <= LimbKernel<4>::coordinate_bits);

// Products of doubles are multiples of 2^-2148 and below 2^2048.
constexpr int limb_count_max = 66;
static_assert(2048 + 2148 + sum_bits <= 64 * limb_count_max);

template <int L>
SixWide<L> evaluate(const SixPoints& points, int low) noexcept {
    SixWide<L> result{};
    const Pose& base = *points[0].pose;
    for (std::size_t i = 0; i < 6; ++i) {
        const Pose& pose = *points[i].pose;
        for (int row = 0; row < 3; ++row) {
            Limbs<L>& sum = result[i][static_cast<std::size_t>(row)];
            for (int column = 0; column < 3; ++column) {
                const Dyadic r = decode(pose.R(row, column));
                const Dyadic v = decode((*points[i].v)[column]);
                if (r.m != 0 && v.m != 0) add_shifted<L>(sum, Int128{r.m} * v.m, r.e + v.e - low);
            }
            if (&pose == &base) continue;
            const Dyadic t = decode(pose.t[row]);
            const Dyadic t0 = decode(base.t[row]);
            if (t.m != 0) add_shifted<L>(sum, t.m, t.e - low);
            if (t0.m != 0) add_shifted<L>(sum, -t0.m, t0.e - low);
        }
    }
    return result;
}

// Makes the differences to the first point in place, and returns the range of their digits.
template <int L>
BitRange relate_to_first(SixWide<L>& points) noexcept {
    const std::array<Limbs<L>, 3> first = points[0];
    Limbs<L> any{};
    for (auto& point : points) {
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

template <int M, int L>
LimbKernel<M> narrow(const SixWide<L>& points, int shift) noexcept {
    LimbKernel<M> kernel;
    for (std::size_t i = 0; i < 6; ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) kernel.points[i][axis] = shift_right<M, L>(points[i][axis], shift);
    }
    return kernel;
}

template <int L>
TwoLimbKernel narrow_to_two(const SixWide<L>& points, int shift) noexcept {
    TwoLimbKernel kernel;
    for (std::size_t i = 0; i < 6; ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Limbs<2> x = shift_right<2, L>(points[i][axis], shift);
            kernel.points[i][axis] = static_cast<Int128>(Uint128{x[1]} << 64 | x[0]);
        }
    }
    return kernel;
}

template <int L>
OneLimbKernel narrow_to_one(const SixWide<L>& points, int shift) noexcept {
    OneLimbKernel kernel;
    for (std::size_t i = 0; i < 6; ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            kernel.points[i][axis] = static_cast<std::int64_t>(shift_right<1, L>(points[i][axis], shift)[0]);
        }
    }
    return kernel;
}

// Calls `use` with the narrowest kernel that holds the points: zeros that all differences end in are stripped.
template <int L, class Use>
auto use_narrowest(SixWide<L>& points, Use&& use) {
    const BitRange range = relate_to_first<L>(points);
    const int shift = range.empty() ? 0 : range.low;
    const int width = range.width();
    if (width <= OneLimbKernel::coordinate_bits) return use(narrow_to_one<L>(points, shift));
    if (width <= TwoLimbKernel::coordinate_bits) return use(narrow_to_two<L>(points, shift));
    if (width <= LimbKernel<4>::coordinate_bits) return use(narrow<4, L>(points, shift));
    if constexpr (L > 4) {
        if (width <= LimbKernel<8>::coordinate_bits) return use(narrow<8, L>(points, shift));
    }
    if constexpr (L > 8) {
        if (width <= LimbKernel<20>::coordinate_bits) return use(narrow<20, L>(points, shift));
    }
    // As wide as the numbers came: `sum_bits` has left room for what a kernel's determinants need.
    return use(narrow<L, L>(points, shift));
}

// Six points of 128-bit coordinates.
using SixInt128 = std::array<std::array<Int128, 3>, 6>;

// The same for points whose differences have at most TwoLimbKernel::coordinate_bits.
template <class Use>
auto use_narrowest(const SixInt128& points, Use&& use) {
    TwoLimbKernel two;
    Uint128 leading = 0;   // as wide as the widest magnitude; that of -2^k may count as 2^k - 1
    Uint128 trailing = 0;  // ends in as many zeros as all of them
    for (std::size_t i = 0; i < 6; ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Int128 x = points[i][axis] - points[0][axis];
            two.points[i][axis] = x;
            leading |= static_cast<Uint128>(x ^ (x >> 127));
            trailing |= static_cast<Uint128>(x);
        }
    }
    const int shift = trailing == 0 ? 0 : trailing_zeros(trailing);
    if (bit_width(leading) + 1 - shift > OneLimbKernel::coordinate_bits) return use(two);
    OneLimbKernel one;
    for (std::size_t i = 0; i < 6; ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            one.points[i][axis] = static_cast<std::int64_t>(two.points[i][axis] >> shift);
        }
    }
    return use(one);
}

template <class Use>
auto with_kernel(const SixPoints& points, Use&& use) {
    const BitRange range = digits_of(points);
    const int low = range.empty() ? 0 : range.low;
    const int bits = range.width() + sum_bits;
    const auto at_width = [&]<int L>(std::integral_constant<int, L>) {
        SixWide<L> wide = evaluate<L>(points, low);
        return use_narrowest<L>(wide, use);
    };
    if (bits <= 64 * 4) return at_width(std::integral_constant<int, 4>{});
    if (bits <= 64 * 8) return at_width(std::integral_constant<int, 8>{});
    if (bits <= 64 * 20) return at_width(std::integral_constant<int, 20>{});
    return at_width(std::integral_constant<int, limb_count_max>{});
}

}  // namespace ecods::exact
