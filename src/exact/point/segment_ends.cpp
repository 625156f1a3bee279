#include "exact/point/segment_ends.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <optional>

#include "base/outward.hpp"
#include "exact/number/dyadic.hpp"
#include "exact/number/power.hpp"
#include "exact/point/pose_terms.hpp"
#include "exact/point/short_matrix.hpp"

namespace ecods::exact {
namespace {

using Point = SegmentEnds::Point;

bool is_zero(const Vec3& v) noexcept {
    return (magnitude_of(v[0]) | magnitude_of(v[1]) | magnitude_of(v[2])) == 0;
}

// Computes the products R p and R q of one segment.
class EndProducts {
  public:
    explicit EndProducts(const SegmentRef& segment) noexcept : segment_(segment) {
        const Vec3 &p = *segment.p, &q = *segment.q;
        if (is_zero(p) && (segment.is_point() || is_zero(q))) return;
        form_ = bind_short() ? Form::numbers : Form::terms;
        if (form_ == Form::terms) bind_terms();
    }

    // All products and their sums are below 2^high().
    int high() const noexcept { return high_; }

    // Adds a product in units of 2^unit, rounded down. Clears is_exact if digits are lost. A short product has 126
    // digits below 2^high(), and unit >= high() - 120, so at least 6 digits are dropped.
    void add(std::size_t end, int unit, Point& to, bool& is_exact) const noexcept {
        if (form_ == Form::zero) return;
        if (form_ == Form::terms) {
            is_exact &= low_ >= unit;
            terms_->add_products(end == 0 ? *segment_.p : *segment_.q, unit, to);
            return;
        }
        const int drop = std::min(unit - low_, 127);
        const Point product = matrix_.times(short_[end]);
        for (std::size_t k = 0; k < 3; ++k) {
            const Int128 kept = product[k] >> drop;
            is_exact &= kept << drop == product[k];
            to[k] += kept;
        }
    }

  private:
    enum class Form : std::uint8_t { zero, numbers, terms };

    // Sets short_ and matrix_, and returns true if all digits fit. Short numbers are below 2^62, so that the sums of
    // three products are below 2^126 units.
    bool bind_short() noexcept {
        constexpr std::uint64_t least = magnitude_of(0x1p-500);
        std::uint64_t most = 0;
        bool are_ordinary = true;
        const auto include = [&](const Vec3& v) {
            for (int k = 0; k < 3; ++k) {
                const std::uint64_t size = magnitude_of(v[k]);
                most = std::max(most, size);
                are_ordinary &= size == 0 || size >= least;
            }
        };
        include(*segment_.p);
        if (!segment_.is_point()) include(*segment_.q);
        const int up = short_bits - (static_cast<int>(most >> 52) - 1022);
        if (!are_ordinary || std::abs(up) > short_power_max || !matrix_.bind(segment_.pose->R)) return false;
        const double power = power_of_two(up);
        bool are_short = true;
        const auto convert = [&](const Vec3& v, std::array<std::int64_t, 3>& to) {
            for (std::size_t k = 0; k < 3; ++k) are_short &= to_short(v[static_cast<Eigen::Index>(k)], power, to[k]);
        };
        convert(*segment_.p, short_[0]);
        if (!segment_.is_point()) convert(*segment_.q, short_[1]);
        low_ = matrix_.unit() - up;
        high_ = low_ + 126;
        return are_short;
    }

    // Sets terms_ and the range of the products. The sum of three products is below 2^(digits.high + 2).
    void bind_terms() noexcept {
        terms_.emplace().set_rotation(segment_.pose->R);
        std::array<BitRange, 3> v;
        for (std::size_t k = 0; k < 3; ++k) {
            v[k].include(decode((*segment_.p)[static_cast<Eigen::Index>(k)]));
            v[k].include(decode((*segment_.q)[static_cast<Eigen::Index>(k)]));
        }
        const BitRange digits = terms_->digits_of_products(v);
        low_ = digits.low;
        high_ = digits.empty() ? exponent_of_zero : digits.high + 2;
    }

    SegmentRef segment_;
    Form form_ = Form::zero;
    int low_ = 0, high_ = exponent_of_zero;  // the products are multiples of 2^low_
    ShortMatrix matrix_;
    std::array<std::array<std::int64_t, 3>, 2> short_{};
    std::optional<PoseTerms> terms_;  // set only if digits do not fit
};

// Adds t in units of 2^unit, rounded down.
void add_translation(const std::array<Dyadic, 3>& t, int unit, Point& to, bool& is_exact) noexcept {
    for (std::size_t k = 0; k < 3; ++k) {
        const Dyadic& x = t[k];
        if (x.m == 0) continue;
        is_exact &= x.e >= unit;
        add_term(to[k], x.m, x.e - unit);
    }
}

}  // namespace

// Chooses the unit from `high`, the largest exponent in use. A product and a translation are below 2^high, and their
// sum below 2^(high + 1) = 2^(unit + 121).
SegmentEnds::SegmentEnds(const SegmentRef& a, const SegmentRef& b, int high) noexcept
    : is_point{a.is_point(), b.is_point()} {
    const std::array<const SegmentRef*, 2> segments{&a, &b};
    const EndProducts of_a(a), of_b(b);
    std::array<std::array<Dyadic, 3>, 2> t;
    BitRange digits;
    for (std::size_t body = 0; body < 2; ++body) {
        for (std::size_t k = 0; k < 3; ++k) {
            t[body][k] = decode(segments[body]->pose->t[static_cast<Eigen::Index>(k)]);
            digits.include(t[body][k]);
        }
    }
    high = std::max({high, of_a.high(), of_b.high(), digits.empty() ? exponent_of_zero : digits.high});
    unit = high - 120;
    for (std::size_t body = 0; body < 2; ++body) {
        const EndProducts& products = body == 0 ? of_a : of_b;
        Point origin{};
        add_translation(t[body], unit, origin, is_exact);
        at[body] = {origin, origin};
        products.add(0, unit, at[body][0], is_exact);
        products.add(is_point[body] ? 0 : 1, unit, at[body][1], is_exact);
    }
}

}  // namespace ecods::exact
