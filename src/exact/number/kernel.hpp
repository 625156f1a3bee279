// An integer kernel computes exact determinants of points with integer coordinates of a limited width.
//
// A kernel is a class with these types and static functions:
//
//     limb_count               number of 64-bit limbs of a coordinate
//     Point                    three coordinates, each below 2^coordinate_bits in magnitude
//     Normal                   (b - a) x (c - a), three minors
//     normal(a, b, c)
//     side(normal, a, p)       the sign of normal . (p - a), which is orient3d(a, b, c, p) for normal(a, b, c)
//     orient2d(a, b, c, axis)  the sign of the minor of b - a and c - a that leaves out `axis`
//     compare(a, b, axis)      the sign of a - b on an axis
//     is_zero(minor)
//
// Widths. With |coordinate| < 2^k, differences are below 2^(k+1), 2x2 minors of differences below 2^(2k+3), and a 3x3
// determinant of differences below 3 * 2^(k+1) * 2^(2k+3) < 2^(3k+6). Static assertions check this for each kernel.
#pragma once

#include <array>
#include <cstdint>

#include "exact/number/limbs.hpp"

namespace ecods::exact {

constexpr int difference_bits(int k) {
    return k + 1;
}
constexpr int minor_bits(int k) {
    return 2 * k + 3;
}
constexpr int determinant_bits(int k) {
    return 3 * k + 6;
}

// DeterminantKernel computes determinants with the types of Arithmetic: Number (a coordinate), Difference (of two
// Numbers), Minor (a product of Differences minus another one), and Sum (of products of a Difference and a Minor).
template <class Arithmetic>
class DeterminantKernel {
  public:
    static constexpr int limb_count = Arithmetic::limb_count;
    static constexpr int coordinate_bits = Arithmetic::coordinate_bits;

    using Point = std::array<typename Arithmetic::Number, 3>;
    using Minor = typename Arithmetic::Minor;
    using Normal = std::array<Minor, 3>;

    static Normal normal(const Point& a, const Point& b, const Point& c) noexcept {
        const Difference x1 = difference(a, b, 0), y1 = difference(a, b, 1), z1 = difference(a, b, 2);
        const Difference x2 = difference(a, c, 0), y2 = difference(a, c, 1), z2 = difference(a, c, 2);
        return {Arithmetic::minor(y1, z2, z1, y2), Arithmetic::minor(z1, x2, x1, z2),
                Arithmetic::minor(x1, y2, y1, x2)};
    }

    static int side(const Normal& normal, const Point& a, const Point& p) noexcept {
        typename Arithmetic::Sum sum{};
        for (std::size_t axis = 0; axis < 3; ++axis) sum.add(Arithmetic::difference(p[axis], a[axis]), normal[axis]);
        return sum.sign();
    }

    static int orient2d(const Point& a, const Point& b, const Point& c, int axis) noexcept {
        const int i = (axis + 1) % 3, j = (axis + 2) % 3;
        return sign(
            Arithmetic::minor(difference(a, b, i), difference(a, c, j), difference(a, b, j), difference(a, c, i)));
    }

    static int compare(const Point& a, const Point& b, int axis) noexcept {
        const auto k = static_cast<std::size_t>(axis);
        return Arithmetic::compare(a[k], b[k]);
    }

    static bool is_zero(const Minor& minor) noexcept { return Arithmetic::is_zero(minor); }

  private:
    using Difference = typename Arithmetic::Difference;

    static Difference difference(const Point& a, const Point& b, int axis) noexcept {
        const auto k = static_cast<std::size_t>(axis);
        return Arithmetic::difference(b[k], a[k]);
    }
};

// WordArithmetic has words of `word_bits` bits for coordinates and their differences, and two words for minors.
template <class Word, class TwoWords, int word_bits, int bits>
struct WordArithmetic {
    static constexpr int limb_count = word_bits / 64;
    static constexpr int coordinate_bits = bits;
    static_assert(difference_bits(bits) < word_bits, "a difference fits a word with its sign");
    static_assert(minor_bits(bits) < 2 * word_bits, "a minor fits two words with its sign");
    // The determinant is the sum of three products of a difference x and a minor n. It is computed as high *
    // 2^word_bits + low: `high` sums x times the high word of n, and `low` sums x times the low word, which is
    // unsigned.
    static_assert(difference_bits(bits) + word_bits + 2 < 2 * word_bits, "the low sum fits two words with its sign");
    static_assert(determinant_bits(bits) - word_bits + 1 < 2 * word_bits, "so does the high sum, with the low's carry");

    using Number = Word;
    using Difference = Word;
    using Minor = TwoWords;

    struct Sum {
        TwoWords high{}, low{};

        void add(Word x, const Minor& n) noexcept {
            high = high + multiply(x, high_word(n));
            low = low + multiply_unsigned(x, low_word(n));
        }
        int sign() const noexcept {
            const TwoWords carried = high + widened(high_word(low));
            if (const int s = exact::sign(carried)) return s;
            return low_word(low) != 0;
        }
    };

    static Word difference(Word to, Word from) noexcept { return to - from; }
    static Minor minor(Word a, Word b, Word c, Word d) noexcept { return multiply(a, b) - multiply(c, d); }
    static int compare(Word a, Word b) noexcept { return (a > b) - (a < b); }
    static bool is_zero(const Minor& minor) noexcept { return exact::sign(minor) == 0; }
};

// OneLimbKernel has coordinates of up to 60 bits and a sign, and TwoLimbKernel coordinates of up to 123 bits and a
// sign.
using OneLimbKernel = DeterminantKernel<WordArithmetic<std::int64_t, Int128, 64, 60>>;
using TwoLimbKernel = DeterminantKernel<WordArithmetic<Int128, Int256, 128, 123>>;

// LimbArithmetic has integers of L limbs for coordinates, which have up to 64 L - 3 bits and a sign.
template <int L>
struct LimbArithmetic {
    static constexpr int limb_count = L;
    static constexpr int coordinate_bits = 64 * L - 3;
    static_assert(difference_bits(coordinate_bits) <= 64 * L - 1);
    static_assert(minor_bits(coordinate_bits) <= 128 * L - 1);
    static_assert(determinant_bits(coordinate_bits) <= 192 * L - 1);

    using Number = Limbs<L>;
    using Difference = Magnitude<L>;
    using Minor = Magnitude<2 * L>;

    struct Sum {
        Limbs<3 * L> sum{};

        void add(const Difference& x, const Minor& n) noexcept {
            add_signed<3 * L>(sum, multiply<L, 2 * L>(x.limbs, n.limbs), x.negative ^ n.negative);
        }
        int sign() const noexcept { return exact::sign<3 * L>(sum); }
    };

    static Difference difference(const Number& to, const Number& from) noexcept {
        return magnitude<L>(subtract<L>(to, from));
    }
    // Returns a * b - c * d.
    static Minor minor(const Difference& a, const Difference& b, const Difference& c, const Difference& d) noexcept {
        Limbs<2 * L> sum{};
        add_signed<2 * L>(sum, multiply<L, L>(a.limbs, b.limbs), a.negative ^ b.negative);
        add_signed<2 * L>(sum, multiply<L, L>(c.limbs, d.limbs), ~(c.negative ^ d.negative));
        return magnitude<2 * L>(sum);
    }
    static int compare(const Number& a, const Number& b) noexcept { return sign<L>(subtract<L>(a, b)); }
    static bool is_zero(const Minor& minor) noexcept { return exact::is_zero<2 * L>(minor.limbs); }
};
template <int L>
using LimbKernel = DeterminantKernel<LimbArithmetic<L>>;

}  // namespace ecods::exact
