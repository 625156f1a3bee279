// round_direction computes unit vectors of integer vectors. Each coordinate is rounded once.
#pragma once

#include "ecods/pose.hpp"
#include "exact/measure/round/limb_vectors.hpp"
#include "exact/measure/round/squared_distance.hpp"
#include "exact/number/natural.hpp"

namespace ecods::exact {

// Returns v / |v|, or -v / |v| if is_turned. Each coordinate is rounded once to the nearest double, ties to even; a
// zero is +0. v must not be zero.
template <int M>
Vec3 round_direction(const LimbVector<M>& v, bool is_turned = false) noexcept {
    static_assert(2 * M <= static_cast<int>(divisor_limbs));
    const Limbs<2 * M> all = dot<M, M>(v, v).limbs;
    Vec3 result;
    for (std::size_t k = 0; k < 3; ++k) {
        const Limbs<2 * M> one = multiply<M, M>(v[k].limbs, v[k].limbs);
        result[static_cast<Eigen::Index>(k)] =
            round_cosine(without_leading_zeros(one), without_leading_zeros(all), (v[k].negative != 0) != is_turned);
    }
    return result;
}

}  // namespace ecods::exact
