#include "exact/point/segment_ends.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <span>

#include "base/outward.hpp"
#include "exact/number/dyadic.hpp"
#include "exact/number/power.hpp"
#include "exact/point/pose_terms.hpp"
#include "exact/point/short_matrix.hpp"
#include "geometry/find_invalid.hpp"

namespace ecods::exact {
namespace {

using Point = SegmentEnds::Point;

// EndProducts computes the products R v for up to three points v of one body.
class EndProducts {
  public:
    EndProducts(const Pose& pose, std::span<const Vec3* const> points) noexcept : R_(pose.R), points_(points) {
        if (std::ranges::all_of(points, [](const Vec3* v) { return ecods::is_zero(*v); })) return;
        form_ = bind_short() ? Form::numbers : Form::terms;
        if (form_ == Form::terms) bind_terms();
    }

    // All products and their sums are below 2^high().
    int high() const noexcept { return high_; }

    // Adds the product R v of point `end` to `to`, in units of 2^unit, rounded down. Clears is_exact if digits are
    // lost. A short product has 126 digits below 2^high(), and unit >= high() - 120, so at least 6 digits are dropped.
    void add(std::size_t end, int unit, Point& to, bool& is_exact) const noexcept {
        if (form_ == Form::zero) return;
        if (form_ == Form::terms) {
            is_exact &= low_ >= unit;
            terms_->add_products(*points_[end], unit, to);
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
        for (const Vec3* v : points_) {
            for (int k = 0; k < 3; ++k) {
                const std::uint64_t size = magnitude_of((*v)[k]);
                most = std::max(most, size);
                are_ordinary &= size == 0 || size >= least;
            }
        }
        const int up = short_bits - (static_cast<int>(most >> 52) - 1022);
        if (!are_ordinary || std::abs(up) > short_power_max || !matrix_.bind(R_)) return false;
        const double power = power_of_two(up);
        bool are_short = true;
        for (std::size_t i = 0; i < points_.size(); ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                are_short &= to_short((*points_[i])[static_cast<Eigen::Index>(k)], power, short_[i][k]);
            }
        }
        low_ = matrix_.unit() - up;
        high_ = low_ + 126;
        return are_short;
    }

    // Sets terms_ and the range of the products. The sum of three products is below 2^(digits.high + 2).
    void bind_terms() noexcept {
        terms_.emplace().set_rotation(R_);
        std::array<BitRange, 3> v;
        for (std::size_t k = 0; k < 3; ++k) {
            for (const Vec3* x : points_) v[k].include(decode((*x)[static_cast<Eigen::Index>(k)]));
        }
        const BitRange digits = terms_->digits_of_products(v);
        low_ = digits.low;
        high_ = digits.empty() ? exponent_of_zero : digits.high + 2;
    }

    const Mat3& R_;
    std::span<const Vec3* const> points_;
    Form form_ = Form::zero;
    int low_ = 0, high_ = exponent_of_zero;  // the products are multiples of 2^low_
    ShortMatrix matrix_;
    std::array<std::array<std::int64_t, 3>, 3> short_{};
    std::optional<PoseTerms> terms_;  // set only if digits do not fit
};

// Adds the translation t to `to`, in units of 2^unit, rounded down. Clears is_exact if digits are lost.
void add_translation(const std::array<Dyadic, 3>& t, int unit, Point& to, bool& is_exact) noexcept {
    for (std::size_t k = 0; k < 3; ++k) {
        const Dyadic& x = t[k];
        if (x.m == 0) continue;
        is_exact &= x.e >= unit;
        add_term(to[k], x.m, x.e - unit);
    }
}

// TwoBodies computes points of two bodies in world coordinates.
class TwoBodies {
  public:
    // Chooses the unit: a product and a translation are below 2^high, and their sum below 2^(high + 1), which is
    // 2^(unit + digits).
    TwoBodies(const std::array<const Pose*, 2>& poses, const std::array<std::span<const Vec3* const>, 2>& points,
              int high, int digits) noexcept
        : products_{EndProducts(*poses[0], points[0]), EndProducts(*poses[1], points[1])} {
        BitRange range;
        for (std::size_t body = 0; body < 2; ++body) {
            for (std::size_t k = 0; k < 3; ++k) {
                t_[body][k] = decode(poses[body]->t[static_cast<Eigen::Index>(k)]);
                range.include(t_[body][k]);
            }
        }
        high =
            std::max({high, products_[0].high(), products_[1].high(), range.empty() ? exponent_of_zero : range.high});
        unit_ = high + 1 - digits;
        for (std::size_t body = 0; body < 2; ++body) add_translation(t_[body], unit_, origins_[body], is_exact_);
    }

    Point at(std::size_t body, std::size_t i) noexcept {
        Point point = origins_[body];
        products_[body].add(i, unit_, point, is_exact_);
        return point;
    }
    int unit() const noexcept { return unit_; }
    bool is_exact() const noexcept { return is_exact_; }

  private:
    std::array<EndProducts, 2> products_;
    std::array<std::array<Dyadic, 3>, 2> t_;
    std::array<Point, 2> origins_{};
    int unit_ = 0;
    bool is_exact_ = true;
};

std::span<const Vec3* const> points_of(const std::array<const Vec3*, 2>& ends) noexcept {
    return std::span(ends).first(ends[0] == ends[1] ? 1 : 2);
}

}  // namespace

SegmentEnds::SegmentEnds(const SegmentRef& a, const SegmentRef& b, int high) noexcept
    : is_point{a.is_point(), b.is_point()} {
    const std::array<const Vec3*, 2> ends_of_a{a.p, a.q}, ends_of_b{b.p, b.q};
    TwoBodies bodies({a.pose, b.pose}, {points_of(ends_of_a), points_of(ends_of_b)}, high, 121);
    for (std::size_t body = 0; body < 2; ++body) {
        at[body][0] = bodies.at(body, 0);
        at[body][1] = is_point[body] ? at[body][0] : bodies.at(body, 1);
    }
    unit = bodies.unit();
    is_exact = bodies.is_exact();
}

// Points are below 2^119, and x - (r - p) below 3 * 2^119. If points are not exact, each is less than 4 units too low,
// so that x - (r - p) - 4 is less than 12 units too low. Three digits are dropped: then all are less than 12 / 8 + 1
// units too low.
// Claim: verify/proofs/segment_pairs.py
SegmentEnds::SegmentEnds(const PointAndTriangle& refs, std::size_t of_triangle, int high) noexcept : is_point{} {
    constexpr int dropped = 3;
    TwoBodies bodies({refs.pose_of_point, refs.pose}, {std::span(&refs.point, 1), std::span(refs.corners)}, high, 119);
    const Point x = bodies.at(0, 0), p = bodies.at(1, 0), q = bodies.at(1, 1), r = bodies.at(1, 2);
    is_exact = bodies.is_exact();
    const int drop = is_exact ? 0 : dropped;
    unit = bodies.unit() + drop;
    for (std::size_t k = 0; k < 3; ++k) {
        at[of_triangle][0][k] = p[k] >> drop;
        at[of_triangle][1][k] = q[k] >> drop;
        at[1 - of_triangle][0][k] = x[k] >> drop;
        at[1 - of_triangle][1][k] = (x[k] - (r[k] - p[k]) - (is_exact ? 0 : error_units)) >> drop;
    }
}

}  // namespace ecods::exact
