#include "exact/point/line_points.hpp"

#include <bit>

namespace ecods::exact {
namespace {

// Two of them and the sum of three such products fit into 128 bits with a sign.
constexpr int short_bits = 62;

// x / 2^unit, of which x must be a multiple. By bits: nothing is decoded.
std::int64_t in_units(double x, int unit) noexcept {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const int biased = static_cast<int>(bits >> 52 & 0x7ff);
    std::uint64_t m = bits & ((std::uint64_t{1} << 52) - 1);
    if (m == 0 && biased == 0) return 0;
    if (biased != 0) m |= std::uint64_t{1} << 52;
    const int shift = (biased == 0 ? 1 : biased) - 1075 - unit;
    const auto size = static_cast<std::int64_t>(shift >= 0 ? m << shift : m >> -shift);
    return bits >> 63 != 0 ? -size : size;
}

}  // namespace

void LinePoints::bind(const BodyRef& body) noexcept {
    digits_ = {};
    BitRange all_R, all_v;
    for (int column = 0; column < 3; ++column) {
        const BitRange& v = body.extent->digits[static_cast<std::size_t>(column)];
        BitRange r;
        for (int row = 0; row < 3; ++row) {
            const Dyadic x = decode(body.pose->R(row, column));
            columns_[static_cast<std::size_t>(column)][static_cast<std::size_t>(row)] = x;
            r.include(x);
        }
        digits_.include(r * v);
        all_R.include(r);
        all_v.include(v);
    }
    digits_of_t_ = {};
    for (int row = 0; row < 3; ++row) {
        t_[static_cast<std::size_t>(row)] = decode(body.pose->t[row]);
        digits_of_t_.include(t_[static_cast<std::size_t>(row)]);
    }
    is_short_ = !digits_.empty() && all_R.width() <= short_bits && all_v.width() <= short_bits;
    if (!is_short_) return;
    unit_of_v_ = all_v.low;
    unit_of_products_ = all_R.low + all_v.low;
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) {
            integers_[static_cast<std::size_t>(column)][static_cast<std::size_t>(row)] =
                in_units(body.pose->R(row, column), all_R.low);
        }
    }
}

// A coordinate is a sum of three products and a difference, each below 2^high: two more bits. Differences of corners
// are taken by the kernel.
bool LinePoints::bind(const Line& line) noexcept {
    std::array<Dyadic, 3> a, b;
    BitRange terms = digits_;
    terms.include(digits_of_t_);
    for (std::size_t row = 0; row < 3; ++row) {
        const auto k = static_cast<Eigen::Index>(row);
        a[row] = decode(line.a[k]);
        b[row] = decode(line.b[k]);
        terms.include(a[row]);
        terms.include(b[row]);
    }
    // A difference is below 2^(high + 1).
    if (terms.width() + 3 > TwoLimbKernel::coordinate_bits) return bind_differences(a, b, line.is_ray);
    set_unit(terms.low, terms.width() + 3);
    const auto in_unit = [&](const Dyadic& x) { return x.m == 0 ? Int128{0} : Int128{x.m} << (x.e - unit_); };
    for (std::size_t row = 0; row < 3; ++row) {
        offset_[row] = in_unit(t_[row]) - in_unit(a[row]);
        direction_[row] = in_unit(b[row]) - (line.is_ray ? Int128{0} : in_unit(a[row]));
    }
    return true;
}

// Differences may be shorter than what they are differences of, far from the origin.
bool LinePoints::bind_differences(const std::array<Dyadic, 3>& a, const std::array<Dyadic, 3>& b,
                                  bool is_ray) noexcept {
    BitRange digits = digits_;
    std::array<DyadicDifference, 3> offset, direction;
    for (std::size_t row = 0; row < 3; ++row) {
        const auto from_a = subtract(t_[row], a[row]), along = subtract(b[row], is_ray ? Dyadic{} : a[row]);
        if (!from_a || !along) return false;
        offset[row] = *from_a;
        direction[row] = *along;
        digits.include(from_a->digits());
        digits.include(along->digits());
    }
    if (digits.width() + 2 > TwoLimbKernel::coordinate_bits) return false;
    set_unit(digits.low, digits.width() + 2);
    for (std::size_t row = 0; row < 3; ++row) {
        offset_[row] = offset[row].at(unit_);
        direction_[row] = direction[row].at(unit_);
    }
    return true;
}

void LinePoints::set_unit(int low, int width) noexcept {
    unit_ = low == BitRange::none ? 0 : low;
    is_one_limb_ = width <= OneLimbKernel::coordinate_bits;
}

// The products may be counted in a smaller unit than the points, of which their sum is a multiple, too: smaller by at
// most 2^124, since in each column of R and each coordinate of v digits are short_bits from those of the others at
// most.
LinePoints::Point LinePoints::short_at(const Vec3& v) const noexcept {
    const std::int64_t x = in_units(v[0], unit_of_v_), y = in_units(v[1], unit_of_v_), z = in_units(v[2], unit_of_v_);
    const int shift = unit_of_products_ - unit_;
    Point p;
    for (std::size_t row = 0; row < 3; ++row) {
        const Int128 sum =
            Int128{integers_[0][row]} * x + Int128{integers_[1][row]} * y + Int128{integers_[2][row]} * z;
        p[row] = offset_[row] + (shift >= 0 ? sum << shift : sum >> -shift);
    }
    return p;
}

LinePoints::Point LinePoints::long_at(const Vec3& v) const noexcept {
    Point p = offset_;
    for (std::size_t column = 0; column < 3; ++column) {
        const Dyadic x = decode(v[static_cast<Eigen::Index>(column)]);
        if (x.m == 0) continue;
        for (std::size_t row = 0; row < 3; ++row) {
            const Dyadic& r = columns_[column][row];
            if (r.m != 0) p[row] += (Int128{r.m} * x.m) << (r.e + x.e - unit_);
        }
    }
    return p;
}

}  // namespace ecods::exact
