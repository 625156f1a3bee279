#include "exact/measure/round/fixed_digits.hpp"

#include <cmath>

namespace ecods::exact {

// Returns 2^252 / sqrt(s) with a relative error of at most 2^-94. Let x be the leading digits of s, 2^124 <= x < 2^128.
// A root in doubles gives g = 2^84 / sqrt(x / 2^64) with a relative error of 2^-49: three roundings of 2^-52, one of
// which the root halves, and digits that are cut off. One Newton step leaves 3/8 of the square of twice that error,
// which is below 2^-95, and again an error for digits that are cut off.
// Claim: verify/proofs/fixed_digits.py
Uint128 inverse_root(const Int256& s) noexcept {
    const auto x = static_cast<Uint128>(s.high) << 2 | s.low >> 126;
    const double top = static_cast<double>(static_cast<std::uint64_t>(x >> 64));
    const auto g = static_cast<std::uint64_t>(1 / std::sqrt(top) * 0x1p84);
    // rest = (1 - x g^2 / 2^232) 2^108
    const Int256 one{0, Int128{1} << (232 - 128)};
    const Int128 rest = shifted(one - multiply_halves(x, Uint128{g} * g), 124);
    return (Uint128{g} << 73) + static_cast<Uint128>((Int128{static_cast<std::int64_t>(g)} * rest) >> 36);
}

}  // namespace ecods::exact
