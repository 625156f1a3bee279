// PoseTerms represents a posed point R v + t - t0 as a sum of terms m 2^e, which are converted to integers of any
// width. All poses are decoded in this file.
//
// The terms are added in units of a power of two, in integers of two limbs, of several limbs, or of any length. Doubles
// are decoded from their bits, without floating-point instructions, so neither the rounding mode nor flush-to-zero
// matters.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "base/assert.hpp"
#include "ecods/pose.hpp"
#include "exact/number/dyadic.hpp"
#include "exact/number/integer.hpp"
#include "exact/number/limbs.hpp"

namespace ecods::exact {

// An integer needs sum_bits more bits than its terms. A coordinate is a sum of three products and two translations,
// each below 2^high: three more bits. A difference of two coordinates takes one more. A kernel of L limbs takes
// coordinates of 64 L - 3 bits and a sign: three more.
inline constexpr int sum_bits = 3 + 1 + 3;

// limb_count_max limbs hold every coordinate, since products of doubles are multiples of 2^-2148 and below 2^2048.
inline constexpr int limb_count_max = 66;
static_assert(2048 + 2148 + sum_bits <= 64 * limb_count_max);

// Calls use(L) with the least number L of limbs in the list below that is at least `least` and holds `bits` bits. L is
// an integral_constant. Returns the result of the call.
template <int least, class Use>
auto with_limb_count(int bits, Use&& use) {
    ECODS_ASSERT(bits <= 64 * limb_count_max);
    if constexpr (least <= 2) {
        if (bits <= 64 * 2) return use(std::integral_constant<int, 2>{});
    }
    if (bits <= 64 * 4) return use(std::integral_constant<int, 4>{});
    if (bits <= 64 * 8) return use(std::integral_constant<int, 8>{});
    if (bits <= 64 * 20) return use(std::integral_constant<int, 20>{});
    return use(std::integral_constant<int, limb_count_max>{});
}

// Adds m 2^shift, rounded down to an integer, to `sum`. The result must fit.
inline void add_term(Int128& sum, Int128 m, int shift) noexcept {
    sum += shift >= 0 ? m << shift : m >> std::min(-shift, 127);
}
template <std::size_t L>
inline void add_term(std::array<std::uint64_t, L>& sum, Int128 m, int shift) noexcept {
    add_shifted<static_cast<int>(L)>(sum, shift >= 0 ? m : m >> std::min(-shift, 127), std::max(shift, 0));
}
inline void add_term(Integer& sum, Int128 m, int shift) {
    if (m != 0) sum = sum + (shift >= 0 ? Integer(m) << shift : Integer(m >> std::min(-shift, 127)));
}

// DifferenceTerms holds the difference of two vectors. A coordinate is one term, or two terms if its digits are too far
// apart for one. Unused terms have m = 0.
class DifferenceTerms {
  public:
    using Coordinate = std::array<DyadicDifference, 2>;

    void set(const Vec3& to, const Vec3& from) noexcept {
        for (std::size_t row = 0; row < 3; ++row) {
            const auto k = static_cast<Eigen::Index>(row);
            const Dyadic a = decode(to[k]), b = decode(from[k]);
            const auto difference = subtract(a, b);
            terms_[row] = difference ? Coordinate{*difference, {}} : Coordinate{{{a.m, a.e}, {-b.m, b.e}}};
        }
    }

    const Coordinate& operator[](std::size_t row) const noexcept { return terms_[row]; }

    // Returns a range that contains the digits of all terms, and of the sum of the two terms of a coordinate.
    BitRange digits() const noexcept {
        BitRange digits;
        for (const Coordinate& x : terms_) {
            digits.include(x[0].digits());
            if (x[1].m == 0) continue;
            digits.include(x[1].digits());
            digits.include(digits.low, digits.high + 1);
        }
        return digits;
    }

    // Returns the difference in units of 2^unit. Each term is rounded down.
    template <class Number>
    std::array<Number, 3> in(int unit) const {
        std::array<Number, 3> result{};
        for (std::size_t row = 0; row < 3; ++row) {
            for (const DyadicDifference& term : terms_[row]) {
                if (term.m != 0) add_term(result[row], term.m, term.e - unit);
            }
        }
        return result;
    }

  private:
    std::array<Coordinate, 3> terms_{};
};

class PoseTerms {
  public:
    using Columns = std::array<std::array<Dyadic, 3>, 3>;

    void set(const Pose& pose, const Vec3& t0) noexcept {
        set_rotation(pose.R);
        set_offset(pose.t, t0);
    }
    void set_rotation(const Mat3& R) noexcept {
        for (std::size_t column = 0; column < 3; ++column) {
            ranges_[column] = {};
            for (std::size_t row = 0; row < 3; ++row) {
                columns_[column][row] = decode(R.data()[3 * column + row]);
                ranges_[column].include(columns_[column][row]);
            }
        }
    }
    void set_offset(const Vec3& t, const Vec3& t0) noexcept { offset_.set(t, t0); }
    void set_no_offset() noexcept { offset_ = {}; }

    const Columns& columns() const noexcept { return columns_; }  // columns of R
    const DifferenceTerms& offset() const noexcept { return offset_; }

    // Returns the digits of all products R_ij v_j, for vertices whose coordinates have the digits `v`.
    BitRange digits_of_products(const std::array<BitRange, 3>& v) const noexcept {
        BitRange digits;
        for (std::size_t column = 0; column < 3; ++column) digits.include(ranges_[column] * v[column]);
        return digits;
    }
    // Returns the digits of all products R_ij v_j, and of t - t0.
    BitRange digits(const std::array<BitRange, 3>& v) const noexcept {
        BitRange digits = digits_of_products(v);
        digits.include(offset_.digits());
        return digits;
    }

    // Returns R v + t - t0 in units of 2^unit. Each term is rounded down. The point is exact if 2^unit divides all
    // terms, that is, if `unit` is at most the lowest digit of digits(v).
    template <class Number>
    std::array<Number, 3> point_in(int unit, const Vec3& v) const {
        std::array<Number, 3> p = offset_.in<Number>(unit);
        add_products(v, unit, p);
        return p;
    }
    // Adds R v, in units of 2^unit, to p. Each term is rounded down.
    template <class Number>
    void add_products(const Vec3& v, int unit, std::array<Number, 3>& p) const {
        for (std::size_t column = 0; column < 3; ++column) {
            const Dyadic x = decode(v[static_cast<Eigen::Index>(column)]);
            if (x.m == 0) continue;
            for (std::size_t row = 0; row < 3; ++row) {
                const Dyadic& r = columns_[column][row];
                if (r.m != 0) add_term(p[row], Int128{r.m} * x.m, r.e + x.e - unit);
            }
        }
    }

  private:
    Columns columns_{};
    std::array<BitRange, 3> ranges_;  // digits of each column of R
    DifferenceTerms offset_;          // t - t0
};

}  // namespace ecods::exact
