#include "exact/number/exact_sum.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <utility>

#include "base/assert.hpp"
#include "base/double_key.hpp"
#include "base/next.hpp"
#include "exact/number/dyadic.hpp"

namespace ecods::exact {
namespace {

// Returns the greatest double that is at most m 2^e, where m is not zero and e >= -1074, and sets is_exact to true if
// the result equals m 2^e. Beyond the largest double, returns the largest double.
double round_down(NaturalSpan m, int e, bool& is_exact) noexcept {
    const int width = bit_width(m), drop = std::max(width - mantissa_bits, 0);
    std::uint64_t kept = 0;
    is_exact = true;
    for (int bit = 0; bit < drop; bit += 64) {
        const std::uint64_t limb = m[static_cast<std::size_t>(bit) / 64];
        is_exact &= (drop - bit >= 64 ? limb : limb << (64 - (drop - bit))) == 0;
    }
    const std::size_t at = static_cast<std::size_t>(drop) / 64;
    const int shift = drop % 64;
    kept = m[at] >> shift;
    if (shift != 0 && at + 1 < m.size()) kept |= m[at + 1] << (64 - shift);
    const int digits = static_cast<int>(std::bit_width(kept)), top = e + drop + digits;  // below 2^top
    if (top > 1024) {
        is_exact = false;
        return std::numeric_limits<double>::max();
    }
    // A double below 2^-1022 is subnormal. Its bits count units of 2^-1074.
    if (top <= -1022) return std::bit_cast<double>(kept << (e + drop + 1074));
    const std::uint64_t fraction = kept << (mantissa_bits - digits);
    return std::bit_cast<double>(fraction + (static_cast<std::uint64_t>(top + 1021) << 52));
}

}  // namespace

ExactSum::ExactSum(double x) {
    const std::int64_t key = key_of(x);
    if (key == 0) return;
    terms_[0] = lower_ = upper_ = x;
    count_ = 1;
    sign_ = key < 0 ? -1 : 1;
}

ExactSum ExactSum::plus(double x) const {
    if (key_of(x) == 0) return *this;
    if (count_ == 0) return ExactSum(x);
    ECODS_ASSERT(count_ < terms_.size());
    ExactSum result = *this;
    result.terms_[result.count_++] = x;
    result.find_bounds();
    return result;
}

ExactSum ExactSum::operator-() const {
    ExactSum result = *this;
    for (double& term : result.terms_) term = -term;
    result.lower_ = -upper_;
    result.upper_ = -lower_;
    result.sign_ = -sign_;
    return result;
}

ScaledInteger ExactSum::scaled() const {
    BitRange range;
    for (std::size_t i = 0; i < count_; ++i) range.include(decode(terms_[i]));
    if (range.empty()) return {};
    if (range.width() + 4 <= 127) {
        Int128 sum = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            const Dyadic x = decode(terms_[i]);
            sum += Int128{x.m} * (Int128{1} << (x.e - range.low));
        }
        return {Integer(sum), range.low};
    }
    Integer sum;
    for (std::size_t i = 0; i < count_; ++i) {
        const Dyadic x = decode(terms_[i]);
        sum = sum + (Integer(x.m) << (x.e - range.low));
    }
    return {std::move(sum), range.low};
}

void ExactSum::find_bounds() {
    const ScaledInteger sum = scaled();
    sign_ = sum.sign();
    lower_ = upper_ = 0;
    is_double_ = true;
    if (sign_ == 0) return;
    const double below = round_down(sum.m().limbs(), sum.e(), is_double_);
    const double above = is_double_ ? below : next_up(below);
    lower_ = sign_ > 0 ? below : -above;
    upper_ = sign_ > 0 ? above : -below;
}

}  // namespace ecods::exact
