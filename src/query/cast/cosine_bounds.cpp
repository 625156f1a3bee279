#include "query/cast/cosine_bounds.hpp"

#include <utility>

namespace ecods {

using exact::Integer;

// Sums Taylor's series by Horner's scheme in integers. Let t = m / 2^bits and N = degree. The scheme sums c_n t^n / n!
// for n from 0 to N, times N! 2^(bits N); c_n is 1, 0, -1, 0, ... for the cosine and 0, 1, 0, -1, ... for the sine. By
// Taylor's theorem both sums are off by at most t^(N + 1) / (N + 1)!, which times the scale is m^(N + 1) / (2^bits (N +
// 1)).
CosineBounds bound_cosine(const exact::BinaryFraction& t, int degree) {
    CosineBounds result;
    Integer factor(std::int64_t{1});  // N! / n! 2^(bits (N - n))
    Integer power(std::int64_t{1});   // m^(N + 1)
    for (int n = degree;; --n) {
        const Integer signed_factor = n % 4 < 2 ? factor : -factor;
        result.cos = result.cos * t.m;
        result.sin = result.sin * t.m;
        Integer& sum = n % 2 == 0 ? result.cos : result.sin;
        sum = sum + signed_factor;
        power = power * t.m;
        if (n == 0) break;
        factor = (factor * Integer(std::int64_t{n})) << t.bits;
    }
    result.off = (power >> t.bits) + Integer(std::int64_t{1});
    result.scale = std::move(factor);
    return result;
}

}  // namespace ecods
