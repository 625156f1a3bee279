// IntegerPoints are N posed points as integers, for the narrowest kernel that is wide enough. For finite coordinates,
// at least one kernel is wide enough.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "exact/number/dyadic.hpp"
#include "exact/number/kernel.hpp"
#include "exact/point/pose_terms.hpp"
#include "exact/point/posed_points.hpp"

namespace ecods::exact {

// IntegerPoints holds points for an integer kernel, in units of 2^unit and translated by a common vector, which changes
// no sign.
template <class Kernel, std::size_t N>
struct IntegerPoints {
    std::array<typename Kernel::Point, N> at;
    int unit = 0;  // coordinates are in units of 2^unit
};

// WidePoints computes points relative to the first point, in as many limbs as the terms of all points need. All queries
// share this code. Only the code that uses the points is compiled for each kind of query and each kernel.
class WidePoints {
  public:
    // Computes the points. `terms` must have an element for each point, and `limbs` 3 limb_count_max elements for each
    // point. Both are overwritten, and must outlive this object.
    WidePoints(std::span<const PointRef> points, std::span<PoseTerms> terms, std::span<std::uint64_t> limbs) noexcept;

    // All coordinates are below 2^width() in magnitude, in units of 2^unit(). The unit is as large as possible: zero
    // bits at the low end of all coordinates are removed.
    int width() const noexcept { return digits_.width(); }
    int unit() const noexcept { return unit_ + zeros(); }
    // Sets `points` to the points, in units of 2^unit(). They must fit into the kernel.
    template <class Kernel>
    void copy_to(std::span<typename Kernel::Point> points) const noexcept;

  private:
    template <int L>
    void set(std::span<const PointRef> points, std::span<const PoseTerms> terms) noexcept;
    int zeros() const noexcept { return digits_.empty() ? 0 : digits_.low; }

    std::span<std::uint64_t> limbs_;
    std::size_t limb_count_ = 0;
    int unit_ = 0;     // exponent of the unit of limbs_
    BitRange digits_;  // digits of all coordinates in that unit
};

// Calls use(kernel) with the narrowest kernel whose coordinates have at least `width` bits, and returns its result.
template <class Use>
auto with_kernel(int width, Use&& use) {
    if (width <= OneLimbKernel::coordinate_bits) return use(OneLimbKernel{});
    if (width <= TwoLimbKernel::coordinate_bits) return use(TwoLimbKernel{});
    if (width <= LimbKernel<4>::coordinate_bits) return use(LimbKernel<4>{});
    if (width <= LimbKernel<8>::coordinate_bits) return use(LimbKernel<8>{});
    if (width <= LimbKernel<20>::coordinate_bits) return use(LimbKernel<20>{});
    return use(LimbKernel<limb_count_max>{});
}

// Calls use(integers) and returns its result; `integers` are the points relative to the first one, in the narrowest
// kernel that is wide enough. Zero bits at the low end of all differences are removed first. Differences must have at
// most TwoLimbKernel::coordinate_bits.
template <std::size_t N, class Use>
auto use_narrowest(const IntegerPoints<TwoLimbKernel, N>& points, Use&& use) {
    IntegerPoints<TwoLimbKernel, N> two;
    two.unit = points.unit;
    Uint128 leading = 0;   // as many bits as the largest magnitude; one bit less if that is -2^k
    Uint128 trailing = 0;  // as many zero bits at the low end as all coordinates have
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

// Calls use(integers) and returns its result; `integers` are the points as IntegerPoints<Kernel, N>, for the narrowest
// kernel that is wide enough. `use` must accept every kernel. The unit is chosen for these points alone. Far from the
// origin, differences of translations are much shorter than the translations.
template <std::size_t N, class Use>
auto with_integers(const PosedPoints<N>& points, Use&& use) {
    std::array<PoseTerms, N> terms;
    std::array<std::uint64_t, 3 * limb_count_max * N> limbs;
    const WidePoints wide(points, terms, limbs);
    return with_kernel(wide.width(), [&]<class Kernel>(Kernel) {
        IntegerPoints<Kernel, N> integers;
        integers.unit = wide.unit();
        wide.copy_to<Kernel>(integers.at);
        return use(integers);
    });
}

}  // namespace ecods::exact
