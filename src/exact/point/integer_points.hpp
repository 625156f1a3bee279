// IntegerPoints are N posed points as integers, in the narrowest kernel that holds them: complete for every finite
// double.
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

// Holds points for an integer kernel, in units of one power of two and moved by one vector, so signs are unchanged.
template <class Kernel, std::size_t N>
struct IntegerPoints {
    std::array<typename Kernel::Point, N> at;
    int unit = 0;  // counted in 2^unit
};

// The points in limbs, as many as all of their terms take, relative to the first one. They are the same for all
// questions, so that these are compiled with the narrowest kernels alone.
class WidePoints {
  public:
    // Works in `terms`, which has an element for each point, and keeps all in `limbs`, which has 3 limb_count_max
    // for each; both must outlive the rest.
    WidePoints(std::span<const PointRef> points, std::span<PoseTerms> terms, std::span<std::uint64_t> limbs) noexcept;

    // All coordinates are below 2^width() units of 2^unit() in magnitude: zeros that all of them end in are stripped.
    int width() const noexcept { return digits_.width(); }
    int unit() const noexcept { return unit_ + zeros(); }
    // Hands the points to a kernel that must hold them.
    template <class Kernel>
    void copy_to(std::span<typename Kernel::Point> points) const noexcept;

  private:
    template <int L>
    void set(std::span<const PointRef> points, std::span<const PoseTerms> terms) noexcept;
    int zeros() const noexcept { return digits_.empty() ? 0 : digits_.low; }

    std::span<std::uint64_t> limbs_;
    std::size_t limb_count_ = 0;
    int unit_ = 0;     // of the limbs
    BitRange digits_;  // in that unit
};

// Calls use(kernel) with the narrowest kernel that holds coordinates of so many bits.
template <class Use>
auto with_kernel(int width, Use&& use) {
    if (width <= OneLimbKernel::coordinate_bits) return use(OneLimbKernel{});
    if (width <= TwoLimbKernel::coordinate_bits) return use(TwoLimbKernel{});
    if (width <= LimbKernel<4>::coordinate_bits) return use(LimbKernel<4>{});
    if (width <= LimbKernel<8>::coordinate_bits) return use(LimbKernel<8>{});
    if (width <= LimbKernel<20>::coordinate_bits) return use(LimbKernel<20>{});
    return use(LimbKernel<limb_count_max>{});
}

// Calls `use` with the points in the narrowest kernel that holds them: zeros that all differences end in are stripped.
// Differences have at most TwoLimbKernel::coordinate_bits.
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
