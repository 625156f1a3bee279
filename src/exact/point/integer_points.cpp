#include "exact/point/integer_points.hpp"

#include <algorithm>
#include <bit>

namespace ecods::exact {
namespace {

// Sets `to`, a coordinate of a kernel, to from >> shift, which must fit.
void assign(std::int64_t& to, std::span<const std::uint64_t> from, int shift) noexcept {
    to = static_cast<std::int64_t>(shift_right<1>(from, shift)[0]);
}
void assign(Int128& to, std::span<const std::uint64_t> from, int shift) noexcept {
    const Limbs<2> x = shift_right<2>(from, shift);
    to = static_cast<Int128>(Uint128{x[1]} << 64 | x[0]);
}
template <std::size_t M>
void assign(std::array<std::uint64_t, M>& to, std::span<const std::uint64_t> from, int shift) noexcept {
    to = shift_right<static_cast<int>(M)>(from, shift);
}

// Returns the digits of several numbers, from `any`, the bitwise or of their magnitudes.
template <int L>
BitRange digits_of(const Limbs<L>& any) noexcept {
    BitRange range;
    for (int i = 0; i < L; ++i) {
        const std::uint64_t limb = any[static_cast<std::size_t>(i)];
        if (limb == 0) continue;
        range.include(64 * i + std::countr_zero(limb), 64 * i + static_cast<int>(std::bit_width(limb)));
    }
    return range;
}

// A difference of two points has one bit more than a point. `sum_bits` leaves the bits that a kernel with the same
// number of limbs needs for its determinants.
static_assert(64 * 4 - sum_bits + 4 <= LimbKernel<4>::coordinate_bits);

}  // namespace

template <int L>
void WidePoints::set(std::span<const PointRef> points, std::span<const PoseTerms> terms) noexcept {
    limb_count_ = L;
    std::array<Limbs<L>, 3> first;
    Limbs<L> any{};
    std::uint64_t* to = limbs_.data();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::array<Limbs<L>, 3> point = terms[i].point_in<Limbs<L>>(unit_, *points[i].v);
        if (i == 0) first = point;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Limbs<L> x = subtract<L>(point[axis], first[axis]);
            const Magnitude<L> m = magnitude<L>(x);
            for (std::size_t k = 0; k < L; ++k) any[k] |= m.limbs[k];
            to = std::copy(x.begin(), x.end(), to);
        }
    }
    digits_ = digits_of<L>(any);
}

WidePoints::WidePoints(std::span<const PointRef> points, std::span<PoseTerms> terms,
                       std::span<std::uint64_t> limbs) noexcept
    : limbs_(limbs) {
    BitRange digits;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i > 0 && points[i].pose == points[i - 1].pose) {
            terms[i] = terms[i - 1];
        } else {
            terms[i].set(*points[i].pose, points[0].pose->t);
        }
        std::array<BitRange, 3> v;
        for (std::size_t k = 0; k < 3; ++k) v[k].include(decode((*points[i].v)[static_cast<Eigen::Index>(k)]));
        digits.include(terms[i].digits(v));
    }
    unit_ = digits.empty() ? 0 : digits.low;
    with_limb_count<4>(digits.width() + sum_bits,
                       [&]<int L>(std::integral_constant<int, L>) { set<L>(points, terms); });
}

template <class Kernel>
void WidePoints::copy_to(std::span<typename Kernel::Point> points) const noexcept {
    std::span<const std::uint64_t> from = limbs_;
    for (typename Kernel::Point& point : points) {
        for (auto& x : point) {
            assign(x, from.first(limb_count_), zeros());
            from = from.subspan(limb_count_);
        }
    }
}

template void WidePoints::copy_to<OneLimbKernel>(std::span<OneLimbKernel::Point>) const noexcept;
template void WidePoints::copy_to<TwoLimbKernel>(std::span<TwoLimbKernel::Point>) const noexcept;
template void WidePoints::copy_to<LimbKernel<4>>(std::span<LimbKernel<4>::Point>) const noexcept;
template void WidePoints::copy_to<LimbKernel<8>>(std::span<LimbKernel<8>::Point>) const noexcept;
template void WidePoints::copy_to<LimbKernel<20>>(std::span<LimbKernel<20>::Point>) const noexcept;
template void WidePoints::copy_to<LimbKernel<limb_count_max>>(
    std::span<LimbKernel<limb_count_max>::Point>) const noexcept;

}  // namespace ecods::exact
