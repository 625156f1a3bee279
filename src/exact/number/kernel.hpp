// Integer kernels: the exact determinants of points with integer coordinates, each kernel for one width of coordinates.
//
// A kernel has these types and functions, all of them static:
//
//     Point                    three coordinates, each below 2^coordinate_bits in magnitude
//     Normal                   (b - a) x (c - a), three minors
//     normal(a, b, c)
//     side(normal, a, p)       the sign of normal . (p - a); of normal(a, b, c) that is orient3d(a, b, c, p)
//     orient2d(a, b, c, axis)  the sign of the minor of b - a and c - a that leaves out `axis`
//     compare(a, b, axis)      the sign of a - b on an axis
//     is_zero(minor)
//
// Widths. With |coordinate| < 2^k, differences are below 2^(k+1), 2x2 minors of differences below 2^(2k+3), and a 3x3
// determinant of differences below 3 * 2^(k+1) * 2^(2k+3) < 2^(3k+6). Static assertions hold each kernel to that.
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

// Coordinates of up to 60 bits and a sign.
class OneLimbKernel {
  public:
    static constexpr int coordinate_bits = 60;
    static_assert(difference_bits(coordinate_bits) <= 63, "a difference fits 64 bits with its sign");
    static_assert(minor_bits(coordinate_bits) <= 127, "a minor fits 128 bits with its sign");
    // A determinant is summed as high * 2^64 + low: `low` is three products of a difference and an unsigned limb.
    static_assert(difference_bits(coordinate_bits) + 64 + 2 <= 127, "the low sum fits 128 bits with its sign");
    static_assert(determinant_bits(coordinate_bits) - 64 + 1 <= 127, "so does the high sum, with the low one's carry");

    using Point = std::array<std::int64_t, 3>;
    using Minor = Int128;
    using Normal = std::array<Minor, 3>;

    static Normal normal(const Point& a, const Point& b, const Point& c) noexcept {
        const std::int64_t x1 = difference(a, b, 0), y1 = difference(a, b, 1), z1 = difference(a, b, 2);
        const std::int64_t x2 = difference(a, c, 0), y2 = difference(a, c, 1), z2 = difference(a, c, 2);
        return {minor(y1, z2, z1, y2), minor(z1, x2, x1, z2), minor(x1, y2, y1, x2)};
    }

    static int side(const Normal& normal, const Point& a, const Point& p) noexcept {
        Int128 high = 0;
        Int128 low = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const std::int64_t x = difference(a, p, axis);
            const Minor n = normal[static_cast<std::size_t>(axis)];
            high += Int128{x} * static_cast<std::int64_t>(n >> 64);
            low += times_unsigned(x, static_cast<std::uint64_t>(n));
        }
        high += low >> 64;
        if (high != 0) return high < 0 ? -1 : 1;
        return static_cast<std::uint64_t>(low) != 0;
    }

    static int orient2d(const Point& a, const Point& b, const Point& c, int axis) noexcept {
        const int i = (axis + 1) % 3, j = (axis + 2) % 3;
        return sign(minor(difference(a, b, i), difference(a, c, j), difference(a, b, j), difference(a, c, i)));
    }

    static int compare(const Point& a, const Point& b, int axis) noexcept {
        const std::int64_t x = at(a, axis), y = at(b, axis);
        return (x > y) - (x < y);
    }

    static bool is_zero(const Minor& minor) noexcept { return minor == 0; }

  private:
    static std::int64_t at(const Point& p, int axis) noexcept { return p[static_cast<std::size_t>(axis)]; }
    static std::int64_t difference(const Point& a, const Point& b, int axis) noexcept {
        return at(b, axis) - at(a, axis);
    }
    // x * y by a signed product, which takes y for 2^64 less than it is if its top bit is set.
    static Int128 times_unsigned(std::int64_t x, std::uint64_t y) noexcept {
        const auto top =
            static_cast<std::uint64_t>(static_cast<std::int64_t>(y) >> 63);  // all ones if y's top bit is set
        const std::uint64_t missing = static_cast<std::uint64_t>(x) & top;
        return static_cast<Int128>(static_cast<Uint128>(Int128{x} * static_cast<std::int64_t>(y)) +
                                   (Uint128{missing} << 64));
    }
    static Minor minor(std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d) noexcept {
        return Int128{a} * b - Int128{c} * d;
    }
};

// Coordinates of up to 123 bits and a sign: as the one-limb kernel, with limbs of 128 bits.
class TwoLimbKernel {
  public:
    static constexpr int coordinate_bits = 123;
    static_assert(difference_bits(coordinate_bits) <= 127, "a difference fits 128 bits with its sign");
    static_assert(minor_bits(coordinate_bits) <= 255, "a minor fits 256 bits with its sign");
    static_assert(difference_bits(coordinate_bits) + 128 + 2 <= 255, "the low sum fits 256 bits with its sign");
    static_assert(determinant_bits(coordinate_bits) - 128 + 1 <= 255, "so does the high sum, with the low one's carry");

    using Point = std::array<Int128, 3>;
    using Minor = Int256;
    using Normal = std::array<Minor, 3>;

    static Normal normal(const Point& a, const Point& b, const Point& c) noexcept {
        const Int128 x1 = difference(a, b, 0), y1 = difference(a, b, 1), z1 = difference(a, b, 2);
        const Int128 x2 = difference(a, c, 0), y2 = difference(a, c, 1), z2 = difference(a, c, 2);
        return {minor(y1, z2, z1, y2), minor(z1, x2, x1, z2), minor(x1, y2, y1, x2)};
    }

    static int side(const Normal& normal, const Point& a, const Point& p) noexcept {
        Int256 high{0, 0};
        Int256 low{0, 0};
        for (int axis = 0; axis < 3; ++axis) {
            const Int128 x = difference(a, p, axis);
            const Minor& n = normal[static_cast<std::size_t>(axis)];
            high = high + multiply(x, n.high);
            low = low + multiply_unsigned(x, n.low);
        }
        const Int256 carry{static_cast<Uint128>(low.high), low.high >> 127};
        high = high + carry;
        if (const int s = sign(high)) return s;
        return low.low != 0;
    }

    static int orient2d(const Point& a, const Point& b, const Point& c, int axis) noexcept {
        const int i = (axis + 1) % 3, j = (axis + 2) % 3;
        return sign(minor(difference(a, b, i), difference(a, c, j), difference(a, b, j), difference(a, c, i)));
    }

    static int compare(const Point& a, const Point& b, int axis) noexcept { return sign(at(a, axis) - at(b, axis)); }

    static bool is_zero(const Minor& minor) noexcept { return minor.low == 0 && minor.high == 0; }

  private:
    static Int128 at(const Point& p, int axis) noexcept { return p[static_cast<std::size_t>(axis)]; }
    static Int128 difference(const Point& a, const Point& b, int axis) noexcept { return at(b, axis) - at(a, axis); }
    static Minor minor(Int128 a, Int128 b, Int128 c, Int128 d) noexcept { return multiply(a, b) - multiply(c, d); }
};

// Coordinates of up to 64 L - 3 bits and a sign.
template <int L>
class LimbKernel {
  public:
    static constexpr int limb_count = L;
    static constexpr int coordinate_bits = 64 * L - 3;
    static_assert(difference_bits(coordinate_bits) <= 64 * L - 1);
    static_assert(minor_bits(coordinate_bits) <= 128 * L - 1);
    static_assert(determinant_bits(coordinate_bits) <= 192 * L - 1);

    using Point = std::array<Limbs<L>, 3>;
    using Minor = Magnitude<2 * L>;
    using Normal = std::array<Minor, 3>;

    static Normal normal(const Point& a, const Point& b, const Point& c) noexcept {
        const Difference x1 = difference(a, b, 0), y1 = difference(a, b, 1), z1 = difference(a, b, 2);
        const Difference x2 = difference(a, c, 0), y2 = difference(a, c, 1), z2 = difference(a, c, 2);
        return {minor(y1, z2, z1, y2), minor(z1, x2, x1, z2), minor(x1, y2, y1, x2)};
    }

    static int side(const Normal& normal, const Point& a, const Point& p) noexcept {
        Limbs<3 * L> sum{};
        for (int axis = 0; axis < 3; ++axis) {
            const Difference x = difference(a, p, axis);
            const Minor& n = normal[static_cast<std::size_t>(axis)];
            add_signed<3 * L>(sum, multiply<L, 2 * L>(x.limbs, n.limbs), x.negative ^ n.negative);
        }
        return sign<3 * L>(sum);
    }

    static int orient2d(const Point& a, const Point& b, const Point& c, int axis) noexcept {
        const int i = (axis + 1) % 3, j = (axis + 2) % 3;
        return sign<2 * L>(minor(difference(a, b, i), difference(a, c, j), difference(a, b, j), difference(a, c, i)));
    }

    static int compare(const Point& a, const Point& b, int axis) noexcept {
        return sign<L>(subtract<L>(at(a, axis), at(b, axis)));
    }

    static bool is_zero(const Minor& minor) noexcept { return exact::is_zero<2 * L>(minor.limbs); }

  private:
    using Difference = Magnitude<L>;

    static const Limbs<L>& at(const Point& p, int axis) noexcept { return p[static_cast<std::size_t>(axis)]; }
    static Difference difference(const Point& a, const Point& b, int axis) noexcept {
        return magnitude<L>(subtract<L>(at(b, axis), at(a, axis)));
    }
    // a * b - c * d
    static Minor minor(const Difference& a, const Difference& b, const Difference& c, const Difference& d) noexcept {
        Limbs<2 * L> sum{};
        add_signed<2 * L>(sum, multiply<L, L>(a.limbs, b.limbs), a.negative ^ b.negative);
        add_signed<2 * L>(sum, multiply<L, L>(c.limbs, d.limbs), ~(c.negative ^ d.negative));
        return magnitude<2 * L>(sum);
    }
};

}  // namespace ecods::exact
