// The closest points of two segments are computed in two steps: doubles guess the parameters of the closest points, and
// integers prove error bounds of the guess.
//
// Let x = p0 + S u and y = q0 + T v be points of the segments, S and T given numbers in [0, 1], and z = y - x. The
// squared distance is a convex function of the parameters, whose derivatives by S and T are -2 z.u and 2 z.v. So x and
// y are closest if and only if the following holds for both parameters: the derivative is 0 if the parameter is between
// 0 and 1 ("inside"), at least 0 if the parameter is 0, and at most 0 if the parameter is 1. (A point has no
// parameter.)
//
// Errors of the residuals. Ends are less than 4 units too low, in each coordinate, or exact. x is an average of two
// ends, and cut once more: less than 5 units too low, and so is y; u and v are off by less than 4, and z by less
// than 5. So z.u, for the given S and T, is off by less than 5 |u|_1 + 4 |z|_1 + 60, and z.v likewise. If both
// parameters are 0 or 1 and points are exact, so are the residuals.
//
// Errors of the parameters. The derivatives are linear. If T alone is inside, the true T is off by dT = z.v / v.v. If
// both are inside, dS and dT solve two linear equations, whose determinant is D = (u.u)(v.v) - (u.v)^2: by Cramer's
// rule, |dS| <= (|z.u| v.v + |z.v| |u| |v|) / D, and likewise dT. With u' = two_u, coordinates are read from integers
// with a relative error of less than 2 u', and products have three roundings: they are off by less than 7 u' |u| |v|,
// and D by less than 32 u' (u.u)(v.v). u and v themselves are off by less than 4 units on each axis, and at least 2^60
// units long: the relative errors of their lengths are less than 2^-57, and D is off by less than u' (u.u)(v.v). All
// other roundings and the errors of the lengths of u and v are less than 50 factors of 1 + u', which 1 + 64 u' covers.
//
// A parameter is certainly inside if its distances from 0 and from 1 exceed its error. A parameter at 0 or 1 is right
// if its derivative has the right sign and exceeds its own error plus dT |u| |v|, the effect of the other parameter's
// error. Then the minimum is unique. It is also unique if an exact derivative is 0, unless the segments are parallel:
// the convex function is constant only along a direction in which z does not change.
// Claim: verify/proofs/segment_pairs.py
#include "exact/measure/distance/closest_on_segments.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/arithmetic.hpp"
#include "exact/number/power.hpp"
#include "exact/point/vectors.hpp"

namespace ecods::exact {
namespace {

// A parameter is the sum of two integers, in units of 2^-coarse_digits and 2^-fine_digits. The second integer is a
// correction of less than fine_begin.
constexpr int coarse_digits = 60, fine_digits = 105;
constexpr double fine_begin = 0x1p-43;
constexpr std::int64_t coarse_one = std::int64_t{1} << coarse_digits;

constexpr double above = 1 + 64 * two_u, least_square = 0x1p120;
constexpr double of_determinant = 40 * two_u;

double from_0_to_1(double x) noexcept {
    return std::min(1.0, std::max(0.0, x));  // 0 for NaN
}

// Returns x as a double, with a relative error of less than 2 two_u.
double to_double(const Int256& x) noexcept {
    const Int256 size = size_of(x);
    const int shift = std::max(bit_width(size) - 62, 0);
    const auto top = static_cast<double>(static_cast<std::int64_t>(shifted(size, shift))) * power_of_two(shift);
    return x.high < 0 ? -top : top;
}
double to_double(Int128 x) noexcept {
    const Uint128 size = size_of(x);
    const int shift = std::max(bit_width(size) - 62, 0);
    const auto top = static_cast<double>(static_cast<std::int64_t>(size >> shift)) * power_of_two(shift);
    return x < 0 ? -top : top;
}
Point to_doubles(const IntegerVector& v) noexcept {
    return {to_double(v[0]), to_double(v[1]), to_double(v[2])};
}

// Returns u s 2^-digits, rounded down. |u| must be below 2^123, and |s| at most 2^62.
Int128 times(Int128 u, std::int64_t s, int digits) noexcept {
    const Int128 high = Int128{static_cast<std::int64_t>(u >> 64)} * s;
    const Int128 low = static_cast<Int128>(static_cast<std::uint64_t>(u)) * s;
    return digits > 64 ? (high + (low >> 64)) >> (digits - 64) : (high << (64 - digits)) + (low >> digits);
}

bool is_zero(const IntegerVector& v) noexcept {
    return (v[0] | v[1] | v[2]) == 0;
}

enum class Place : std::uint8_t { begin, end, inside };

// A Side is one of the segments with its parameter. Let u be the segment's vector, and z the vector between the closest
// points. If z.u is positive, the distance grows with the parameter if `outward` is 1, and shrinks if `outward` is -1.
struct Side {
    Side(const std::array<IntegerVector, 2>& ends, bool is_point, int outward_sign) noexcept
        : begin(ends[0]), u(difference(ends[1], ends[0])), has_edge(!is_point), outward(outward_sign) {}

    void set_point() noexcept {
        for (std::size_t k = 0; k < 3; ++k) {
            point[k] = begin[k];
            if (place == Place::end) point[k] += u[k];
            if (place == Place::inside) point[k] += times(u[k], coarse, coarse_digits) + times(u[k], fine, fine_digits);
        }
    }
    void set_parameter(double s) noexcept {
        place = s <= 0 ? Place::begin : s >= 1 ? Place::end : Place::inside;
        coarse = place == Place::inside ? static_cast<std::int64_t>(s * 0x1p60) : 0;
        fine = 0;
    }
    // Moves the parameter by `by`, of magnitude at most 1. The parameter stays in [0, 1], or less than fine_begin
    // beyond.
    void move(double by, bool is_fine) noexcept {
        if (is_fine) {
            fine = static_cast<std::int64_t>(by * 0x1p105);
        } else {
            coarse = std::clamp<std::int64_t>(coarse + static_cast<std::int64_t>(by * 0x1p60), 0, coarse_one);
        }
    }
    // Returns an upper bound of the parameter, which is inside the segment, before it is rounded.
    double parameter_max() const noexcept {
        const Int128 all = (Int128{coarse} << (fine_digits - coarse_digits)) + fine;
        return (to_double(all) * 0x1p-105 + shift) * above;
    }
    // Returns true if the parameter is certainly inside the segment.
    bool is_inside() const noexcept {
        constexpr int up = fine_digits - coarse_digits;
        const Int128 all = (Int128{coarse} << up) + fine, rest = (Int128{coarse_one} << up) - all;
        const double error = shift * 0x1p105 * above;
        return to_double(all) > error && to_double(rest) > error;
    }

    IntegerVector begin, u;
    bool has_edge;
    int outward;
    Place place = Place::begin;
    std::int64_t coarse = 0, fine = 0;  // the parameter
    IntegerVector point{};
    double square = 0;    // u.u
    double sum = 0;       // |u|_1
    double residual = 0;  // z.u
    double off = 0;       // a bound of its error
    double shift = 0;     // a bound of the error of the parameter
};

class SegmentPair {
  public:
    explicit SegmentPair(const SegmentEnds& ends) noexcept
        : a_(ends.at[0], ends.is_point[0], -1), b_(ends.at[1], ends.is_point[1], 1), ends_(ends) {
        if (!ends.is_exact) return;
        a_.has_edge &= !is_zero(a_.u);
        b_.has_edge &= !is_zero(b_.u);
    }

    std::optional<ClosestOnSegments> find() noexcept {
        guess();
        set_points();
        const bool are_certain = are_closest();
        if ((!are_certain || is_tied_) && are_parallel()) return find_parallel();
        return are_certain ? result() : std::nullopt;
    }

  private:
    void guess() noexcept {
        if (!a_.has_edge && !b_.has_edge) return;
        const Point u = to_doubles(a_.u), v = to_doubles(b_.u), w = to_doubles(difference(b_.begin, a_.begin));
        a_.sum = sum_of_magnitudes(u);
        b_.sum = sum_of_magnitudes(v);
        a_.square = dot(u, u);
        b_.square = dot(v, v);
        product_ = dot(u, v);
        const double uw = dot(u, w), vw = dot(v, w);
        double s = 0, t = 0;
        if (a_.has_edge && b_.has_edge) {
            s = from_0_to_1((uw * b_.square - product_ * vw) / (a_.square * b_.square - product_ * product_));
        }
        if (b_.has_edge) t = from_0_to_1((s * product_ - vw) / b_.square);
        if (a_.has_edge) s = from_0_to_1((t * product_ + uw) / a_.square);
        a_.set_parameter(s);
        b_.set_parameter(t);
    }

    // Sets the points at both parameters. Newton's method refines the parameters that are inside: the function is
    // quadratic, so one step is exact except for rounding. A step below fine_begin sets the fine parts and is the last;
    // a larger step moves the coarse parts, and another step follows.
    void set_points() noexcept {
        constexpr int steps_max = 3;
        measure();
        const bool is_a = a_.place == Place::inside, is_b = b_.place == Place::inside;
        bool is_fine = !is_a && !is_b;
        for (int step = 0; step < steps_max && !is_fine; ++step) {
            double by_a = 0, by_b = 0;
            if (is_a && is_b) {
                const double det = a_.square * b_.square - product_ * product_;
                by_a = (a_.residual * b_.square - b_.residual * product_) / det;
                by_b = (a_.residual * product_ - b_.residual * a_.square) / det;
            } else if (is_a) {
                by_a = a_.residual / a_.square;
            } else {
                by_b = -b_.residual / b_.square;
            }
            if (!(std::abs(by_a) <= 1 && std::abs(by_b) <= 1)) return;  // or not a number
            is_fine = std::abs(by_a) < fine_begin && std::abs(by_b) < fine_begin;
            a_.move(by_a, is_fine);
            b_.move(by_b, is_fine);
            measure();
        }
    }

    void measure() noexcept {
        a_.set_point();
        b_.set_point();
        z_ = difference(b_.point, a_.point);
        for (Side* side : {&a_, &b_}) {
            if (side->has_edge) side->residual = to_double(dot_of(z_, side->u));
        }
    }

    // Returns true if the residuals z.u and z.v of the derivation above are exact.
    bool are_exact() const noexcept { return ends_.is_exact && a_.place != Place::inside && b_.place != Place::inside; }

    // Sets the error bounds of residuals and parameters; returns false if the error of a segment's direction is too
    // large.
    bool find_errors() noexcept {
        const double of_z = are_exact() ? 0 : 4 * sum_of_magnitudes(to_doubles(z_)) + 72;
        for (Side* side : {&a_, &b_}) {
            side->off = side->shift = 0;
            if (!side->has_edge || are_exact()) continue;
            if (!(side->square >= least_square)) return false;
            side->off = (6 * side->sum + of_z) * above;
        }
        const bool is_a = a_.place == Place::inside, is_b = b_.place == Place::inside;
        const double of_a = std::abs(a_.residual) + a_.off, of_b = std::abs(b_.residual) + b_.off;
        if (is_a && is_b) {
            const double all = a_.square * b_.square, root = std::sqrt(all);
            const double det = (all - product_ * product_) - of_determinant * all;
            if (!(det > 0)) return false;
            a_.shift = (of_a * b_.square + of_b * root) / det * above;
            b_.shift = (of_b * a_.square + of_a * root) / det * above;
        } else if (is_a) {
            a_.shift = of_a / a_.square * above;
        } else if (is_b) {
            b_.shift = of_b / b_.square * above;
        }
        return true;
    }

    bool are_closest() noexcept { return find_errors() && is_right(a_, b_) && is_right(b_, a_); }

    bool is_right(const Side& side, const Side& other) noexcept {
        if (!side.has_edge) return true;
        if (side.place == Place::inside) return side.is_inside();
        const double growth = side.residual * side.outward * (side.place == Place::begin ? 1 : -1);
        if (are_exact()) {
            is_tied_ |= growth == 0;
            return growth >= 0;
        }
        return growth > (side.off + other.shift * std::sqrt(side.square * other.square)) * above;
    }
    bool are_parallel() const noexcept {
        if (!ends_.is_exact || !a_.has_edge || !b_.has_edge) return false;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
            if (sign(multiply(a_.u[i], b_.u[j]) - multiply(a_.u[j], b_.u[i])) != 0) return false;
        }
        return true;
    }

    // Returns the closest points on the first closest features of parallel segments: two vertices, otherwise a vertex
    // and the segment that has the vertex's foot inside. The distance of a vertex and its foot is the distance of the
    // two lines.
    std::optional<ClosestOnSegments> find_parallel() noexcept {
        is_only_ = false;
        for (const Place of_a : {Place::begin, Place::end}) {
            for (const Place of_b : {Place::begin, Place::end}) {
                a_.place = of_a;
                b_.place = of_b;
                measure();
                if (are_closest()) return result();
            }
        }
        const bool is_any = put_foot(a_, Place::begin, b_) || put_foot(b_, Place::begin, a_) ||
                            put_foot(b_, Place::end, a_) || put_foot(a_, Place::end, b_);
        if (!is_any) return std::nullopt;
        set_points();
        const bool are_right = find_errors() && (a_.place == Place::inside ? a_ : b_).is_inside();
        return are_right ? result() : std::nullopt;
    }
    // Returns true if the foot of the vertex is inside the edge; then sets the edge's parameter to the foot. Points
    // must be exact.
    static bool put_foot(Side& vertex, Place place, Side& edge) noexcept {
        vertex.place = place;
        vertex.set_point();
        const IntegerVector w = difference(vertex.point, edge.begin);
        const Int256 along = dot_of(w, edge.u);
        if (sign(along) <= 0 || sign(square_of(edge.u) - along) <= 0) return false;
        edge.set_parameter(from_0_to_1(to_double(along) / edge.square));
        edge.place = Place::inside;
        return true;
    }

    FeaturePair features() const noexcept {
        const std::size_t a = a_.place == Place::end ? 1 : 0, b = b_.place == Place::end ? 1 : 0;
        const bool is_a = a_.place == Place::inside, is_b = b_.place == Place::inside;
        if (is_a && is_b) return pair_of(FeatureKind::edge_edge, 0, a, b);
        if (is_a) return vertex_and(FeatureKind::vertex_edge, 1, b, a);
        if (is_b) return vertex_and(FeatureKind::vertex_edge, 0, a, b);
        return pair_of(FeatureKind::vertex_vertex, 0, a, b);
    }

    // Returns the closest points; nullopt if a point's error bound is too large. If an edge is parallel to a coordinate
    // axis and its closest point is inside the edge, the vector between the closest points is perpendicular to this
    // axis, so both points have the same coordinate there: an exact coordinate is copied to the other point.
    std::optional<ClosestOnSegments> result() const noexcept {
        ClosestOnSegments result{features(), {a_.point, b_.point}, {}, is_only_};
        for (const std::size_t i : {0, 1}) {
            const Side& side = i == 0 ? a_ : b_;
            const double moved = side.shift * side.sum * above;
            if (!(moved < 0x1p60)) return std::nullopt;
            if (side.place == Place::inside) result.parameter_max[i] = side.parameter_max();
            const std::uint64_t error = 11 + static_cast<std::uint64_t>(moved);
            for (std::size_t k = 0; k < 3; ++k) {
                const bool is_exact = ends_.is_exact && (side.place != Place::inside || side.u[k] == 0);
                result.errors[i][k] = is_exact ? 0 : error;
            }
        }
        for (const std::size_t i : {0, 1}) {
            const Side& side = i == 0 ? a_ : b_;
            if (!ends_.is_exact || side.place != Place::inside) continue;
            for (std::size_t k = 0; k < 3; ++k) {
                const bool is_along = side.u[(k + 1) % 3] == 0 && side.u[(k + 2) % 3] == 0;
                if (!is_along || result.errors[1 - i][k] != 0) continue;
                result.point[i][k] = result.point[1 - i][k];
                result.errors[i][k] = 0;
            }
        }
        return result;
    }

    Side a_, b_;
    const SegmentEnds& ends_;
    IntegerVector z_{};
    double product_ = 0;  // u.v
    bool is_tied_ = false, is_only_ = true;
};

}  // namespace

std::optional<ClosestOnSegments> closest_on_segments(const SegmentEnds& ends) noexcept {
    if (ends.is_point[0] && ends.is_point[1]) {
        const auto error = static_cast<std::uint64_t>(ends.error());
        const ErrorBounds errors{error, error, error};
        return ClosestOnSegments{{}, {ends.at[0][0], ends.at[1][0]}, {errors, errors}};
    }
    return SegmentPair(ends).find();
}

}  // namespace ecods::exact
