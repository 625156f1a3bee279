// A LimbVector is a vector of integers, each stored as sign and magnitude. Callers must make sure that products fit, by
// assertions about widths.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "exact/number/limbs.hpp"

namespace ecods::exact {

template <int L>
using LimbVector = std::array<Magnitude<L>, 3>;

template <int L>
Magnitude<L> negated(Magnitude<L> a) noexcept {
    a.negative = ~a.negative;
    return a;
}

// Returns x with M limbs instead of L.
template <int M, int L>
Magnitude<M> widened(const Magnitude<L>& x) noexcept {
    static_assert(M >= L);
    Magnitude<M> result{{}, x.negative};
    for (std::size_t i = 0; i < L; ++i) result.limbs[i] = x.limbs[i];
    return result;
}

// Adds a * b to `sum`, or subtracts it if `negative` is all_ones.
template <int A, int B>
inline void add_product(Limbs<A + B>& sum, const Magnitude<A>& a, const Magnitude<B>& b,
                        std::uint64_t negative = 0) noexcept {
    add_signed<A + B>(sum, multiply<A, B>(a.limbs, b.limbs), a.negative ^ b.negative ^ negative);
}

template <int A, int B>
Magnitude<A + B> dot(const LimbVector<A>& a, const LimbVector<B>& b) noexcept {
    Limbs<A + B> sum{};
    for (std::size_t k = 0; k < 3; ++k) add_product<A, B>(sum, a[k], b[k]);
    return magnitude<A + B>(sum);
}

template <int L>
LimbVector<2 * L> cross(const LimbVector<L>& a, const LimbVector<L>& b) noexcept {
    LimbVector<2 * L> result;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
        Limbs<2 * L> sum{};
        add_product<L, L>(sum, a[i], b[j]);
        add_product<L, L>(sum, a[j], b[i], all_ones);
        result[k] = magnitude<2 * L>(sum);
    }
    return result;
}

template <int L>
Magnitude<L> minus(const Magnitude<L>& a, const Magnitude<L>& b) noexcept {
    Limbs<L> sum{};
    add_signed<L>(sum, a.limbs, a.negative);
    add_signed<L>(sum, b.limbs, ~b.negative);
    return magnitude<L>(sum);
}

template <int L>
LimbVector<L> difference(const std::array<Limbs<L>, 3>& to, const std::array<Limbs<L>, 3>& from) noexcept {
    LimbVector<L> result;
    for (std::size_t k = 0; k < 3; ++k) result[k] = magnitude<L>(subtract<L>(to[k], from[k]));
    return result;
}

template <int L>
bool is_zero_vector(const LimbVector<L>& a) noexcept {
    return is_zero<L>(a[0].limbs) && is_zero<L>(a[1].limbs) && is_zero<L>(a[2].limbs);
}

// Returns true if a and b are parallel, or at least one of them is zero.
template <int L>
bool is_parallel(const LimbVector<L>& a, const LimbVector<L>& b) noexcept {
    return is_zero_vector<2 * L>(cross<L>(a, b));
}

// Returns the cross product of u and the first axis that is not parallel to u; if u is zero, the x axis.
template <int L>
LimbVector<2 * L> across(const LimbVector<L>& u) noexcept {
    LimbVector<2 * L> x_axis{};
    x_axis[0].limbs[0] = 1;
    if (is_zero_vector<L>(u)) return x_axis;
    LimbVector<L> axis{};
    axis[0].limbs[0] = 1;
    if (is_parallel<L>(u, axis)) std::swap(axis[0], axis[1]);
    return cross<L>(u, axis);
}

}  // namespace ecods::exact
