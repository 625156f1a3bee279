#include "exact/number/integer.hpp"

#include <bit>
#include <utility>

#include "base/assert.hpp"

namespace ecods::exact {
namespace {

// Sets `to` to a + b, which has a.size() + 1 limbs. a must have at least as many limbs as b.
void add(NaturalSpan a, NaturalSpan b, std::uint64_t* to) noexcept {
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Uint128 s = Uint128{a[i]} + (i < b.size() ? b[i] : 0) + carry;
        to[i] = static_cast<std::uint64_t>(s);
        carry = static_cast<std::uint64_t>(s >> 64);
    }
    to[a.size()] = carry;
}

// Sets `to` to a - b, which has a.size() limbs. a must be at least b.
void subtract(NaturalSpan a, NaturalSpan b, std::uint64_t* to) noexcept {
    std::uint64_t borrow = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Uint128 difference = Uint128{a[i]} - (i < b.size() ? b[i] : 0) - borrow;
        to[i] = static_cast<std::uint64_t>(difference);
        borrow = static_cast<std::uint64_t>(difference >> 64) & 1;
    }
}

}  // namespace

int Integer::trailing_zeros() const noexcept {
    ECODS_ASSERT(size_ > 0);
    const std::uint64_t* limb = data();
    int zeros = 0;
    for (; *limb == 0; ++limb) zeros += 64;
    return zeros + std::countr_zero(*limb);
}

Integer Integer::operator-() const& {
    Integer result = *this;
    result.is_negative_ = !is_negative_;
    return result;
}

Integer Integer::sum(const Integer& a, const Integer& b, bool negates_b) {
    const bool b_is_negative = b.is_negative_ != negates_b;
    const bool a_is_less = compare_shifted(a.limbs(), 0, b.limbs()) < 0;
    const Integer& more = a_is_less ? b : a;
    const Integer& less = a_is_less ? a : b;
    Integer result;
    result.is_negative_ = a_is_less ? b_is_negative : a.is_negative_;
    if (a.is_negative_ == b_is_negative) {
        result.reserve(more.size_ + 1);
        add(more.limbs(), less.limbs(), result.data());
        result.set_size(more.size_ + 1);
    } else {
        result.reserve(more.size_);
        subtract(more.limbs(), less.limbs(), result.data());
        result.set_size(more.size_);
    }
    return result;
}

Integer operator*(const Integer& a, const Integer& b) {
    Integer result;
    if (a.size_ == 0 || b.size_ == 0) return result;
    const std::size_t size = a.size_ + b.size_;
    result.reserve(size);
    multiply(a.limbs(), b.limbs(), result.data());
    result.set_size(size);
    result.is_negative_ = a.is_negative_ != b.is_negative_;
    return result;
}

Integer operator<<(const Integer& a, int bits) {
    ECODS_ASSERT(bits >= 0);
    Integer result;
    if (a.size_ == 0) return result;
    const std::size_t size = a.size_ + static_cast<std::size_t>(bits) / 64 + 1;
    result.reserve(size);
    std::uint64_t* to = result.data();
    for (std::size_t i = 0; i < size; ++i) to[i] = limb_of_shifted(a.limbs(), bits, i);
    result.set_size(size);
    result.is_negative_ = a.is_negative_;
    return result;
}

Integer operator>>(const Integer& a, int bits) {
    ECODS_ASSERT(bits >= 0);
    Integer result;
    const std::size_t skip = static_cast<std::size_t>(bits) / 64;
    if (a.size_ <= skip) return result;
    const std::size_t size = a.size_ - skip;
    const int rest = bits % 64;
    result.reserve(size);
    std::uint64_t* to = result.data();
    const NaturalSpan from = a.limbs().subspan(skip);
    for (std::size_t i = 0; i < size; ++i) {
        const std::uint64_t high = rest != 0 && i + 1 < size ? from[i + 1] << (64 - rest) : 0;
        to[i] = from[i] >> rest | high;
    }
    result.set_size(size);
    result.is_negative_ = a.is_negative_;
    return result;
}

int compare(const Integer& a, const Integer& b) noexcept {
    const int sign_a = a.sign(), sign_b = b.sign();
    if (sign_a != sign_b) return sign_a < sign_b ? -1 : 1;
    return sign_a * compare_shifted(a.limbs(), 0, b.limbs());
}

}  // namespace ecods::exact
