// find_closest() finds features that contain the closest points of two triangles, whose corners are integer points.
#pragma once

#include <algorithm>
#include <array>
#include <type_traits>

#include "base/assert.hpp"
#include "exact/measure/distance/exact_features.hpp"
#include "exact/measure/distance/feature_pair.hpp"
#include "exact/measure/round/squared_distance.hpp"
#include "exact/point/integer_points.hpp"
#include "exact/sign/exact_signs.hpp"
#include "exact/simplex/triangle_pair.hpp"

namespace ecods::exact {

static_assert(OneLimbKernel::coordinate_bits <= ExactFeatures<1>::coordinate_bits);
static_assert(TwoLimbKernel::coordinate_bits <= ExactFeatures<2>::coordinate_bits);

inline Limbs<1> to_limbs(std::int64_t x) noexcept {
    return {static_cast<std::uint64_t>(x)};
}
inline Limbs<2> to_limbs(Int128 x) noexcept {
    return {static_cast<std::uint64_t>(x), static_cast<std::uint64_t>(x >> 64)};
}
template <std::size_t L>
const std::array<std::uint64_t, L>& to_limbs(const std::array<std::uint64_t, L>& x) noexcept {
    return x;
}

template <class Kernel, std::size_t N>
auto to_limbs(const IntegerPoints<Kernel, N>& points) noexcept {
    std::array<std::array<Limbs<Kernel::limb_count>, 3>, N> result;
    for (std::size_t i = 0; i < N; ++i) {
        for (std::size_t k = 0; k < 3; ++k) result[i][k] = to_limbs(points.at[i][k]);
    }
    return result;
}

// ClosestFeatures holds a pair of features that contain closest points, and the pair's standing. The standing is `none`
// if the triangles share a point that is not in both features of the guess.
struct ClosestFeatures {
    FeaturePair features;
    Standing standing = Standing::none;
};

// Returns a pair of features that contain closest points. If the standing of `guess` is `only`, returns the guess
// without a test; otherwise tests the guess first.
template <class Kernel, int L>
ClosestFeatures find_closest(const IntegerPoints<Kernel, 6>& points, const ExactFeatures<L>& features,
                             const ClosestFeatures& guess) noexcept {
    if (guess.standing == Standing::only) return guess;
    const Standing of_guess = features.standing(guess.features);
    if (of_guess != Standing::none) return {guess.features, of_guess};
    const ExactSigns signs(points);
    if (triangle_pair(signs) != Relation::apart) return {};
    for (const FeaturePair& pair : feature_pairs) {
        if (const Standing standing = features.standing(pair); standing != Standing::none) return {pair, standing};
    }
    ECODS_ASSERT(false);  // disjoint triangles have closest points
    return {};
}

// The functions for all kernels are compiled in measure_pair.cpp, and so is triangle_pair(), which they call.
extern template ClosestFeatures find_closest(const IntegerPoints<OneLimbKernel, 6>&, const ExactFeatures<1>&,
                                             const ClosestFeatures&) noexcept;
extern template ClosestFeatures find_closest(const IntegerPoints<TwoLimbKernel, 6>&, const ExactFeatures<2>&,
                                             const ClosestFeatures&) noexcept;
extern template ClosestFeatures find_closest(const IntegerPoints<LimbKernel<4>, 6>&, const ExactFeatures<4>&,
                                             const ClosestFeatures&) noexcept;
extern template ClosestFeatures find_closest(const IntegerPoints<LimbKernel<8>, 6>&, const ExactFeatures<8>&,
                                             const ClosestFeatures&) noexcept;
extern template ClosestFeatures find_closest(const IntegerPoints<LimbKernel<20>, 6>&, const ExactFeatures<20>&,
                                             const ClosestFeatures&) noexcept;
extern template ClosestFeatures find_closest(const IntegerPoints<LimbKernel<limb_count_max>, 6>&,
                                             const ExactFeatures<limb_count_max>&, const ClosestFeatures&) noexcept;
extern template Relation triangle_pair(const ExactSigns<OneLimbKernel, 6>&);
extern template Relation triangle_pair(const ExactSigns<TwoLimbKernel, 6>&);
extern template Relation triangle_pair(const ExactSigns<LimbKernel<4>, 6>&);
extern template Relation triangle_pair(const ExactSigns<LimbKernel<8>, 6>&);
extern template Relation triangle_pair(const ExactSigns<LimbKernel<20>, 6>&);
extern template Relation triangle_pair(const ExactSigns<LimbKernel<limb_count_max>, 6>&);

// Returns the first pair, in the order of feature_pairs, with closest points in both relative interiors. The triangles
// must be disjoint; `found` is the result of find_closest().
template <int L>
FeaturePair first_closest(const ExactFeatures<L>& features, const ClosestFeatures& found) noexcept {
    if (found.standing == Standing::only) return found.features;
    return *std::ranges::find_if(feature_pairs,
                                 [&](const FeaturePair& pair) { return features.standing(pair) >= Standing::inside; });
}

}  // namespace ecods::exact
