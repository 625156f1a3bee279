#include "query/hit/triangle_hits.hpp"

#include <algorithm>
#include <cmath>

#include "bounds/double4.hpp"
#include "exact/measure/distance/measure_pair.hpp"
#include "exact/point/integer_points.hpp"
#include "simd/dispatch.hpp"

namespace ecods {

using namespace exact;

namespace {

std::array<double, 4> lanes(const Vec3& v) noexcept {
    return {v[0], v[1], v[2], 0};
}

}  // namespace

void TriangleHits::prepare(const BodyRef& body) noexcept {
    const Mat3& R = body.pose->R;
    sum_ = R.cwiseAbs() * body.extent->magnitude;
    factor_ = std::max(R.cwiseAbs().maxCoeff(), body.extent->magnitude.maxCoeff());
    for (int k = 0; k < 3; ++k) in_doubles_.R[static_cast<std::size_t>(k)] = lanes(R.col(k));
    points_.bind(body);
}

void TriangleHits::bind(const Line& line, const ScaledLine& scaled, const BodyRef& body) noexcept {
    line_ = &line;
    body_ = body;
    const Vec3 offset = body.pose->t - line.a;
    InDoubles& s = in_doubles_;
    s.offset = lanes(offset);
    s.delta = point_error_bound((sum_ + offset.cwiseAbs()).maxCoeff(), factor_);
    s.d = lanes(scaled.d);
    s.d_error = lanes(scaled.d_error);
    s.end_low = scaled.end_low;
    s.end_high = scaled.end_high;
    s.is_known = scaled.is_known;
    kind_ = Points::unknown;
}

// ---- doubles

namespace {

// Below size_max, products of magnitudes stay far from overflow. Above bound_min, error bounds are far greater than the
// errors of products that underflow.
constexpr double size_max = 0x1p200;
constexpr double bound_min = 0x1p-780;
constexpr double slack = 1 + 0x1p-20;

ECODS_ALWAYS_INLINE Double4 load4(const std::array<double, 4>& v) noexcept {
    return load<Double4>(v.data());
}
// Return, for each axis, the product or the sum of the components on the two other axes.
ECODS_ALWAYS_INLINE Double4 products(Double4 a) noexcept {
    return shuffle<1, 2, 0, 3>(a) * shuffle<2, 0, 1, 3>(a);
}
ECODS_ALWAYS_INLINE Double4 sums(Double4 a) noexcept {
    return shuffle<1, 2, 0, 3>(a) + shuffle<2, 0, 1, 3>(a);
}
// Returns the sum of the first three components of each of the four vectors. Fourth lanes are ignored.
ECODS_ALWAYS_INLINE Double4 sums_of(Double4 a, Double4 b, Double4 c, Double4 d) noexcept {
    const Double4 ab_low = shuffle<0, 4, 2, 6>(a, b), ab_high = shuffle<1, 5, 3, 7>(a, b);
    const Double4 cd_low = shuffle<0, 4, 2, 6>(c, d), cd_high = shuffle<1, 5, 3, 7>(c, d);
    return (shuffle<0, 1, 4, 5>(ab_low, cd_low) + shuffle<0, 1, 4, 5>(ab_high, cd_high)) +
           shuffle<2, 3, 6, 7>(ab_low, cd_low);
}

}  // namespace

// Sets `result` to what doubles prove about the points that the line shares with the triangle. The line begins at 0;
// the corners p, q and r, the direction d and the normal n are as in exact/measure/line/line_hit.hpp.
//
// Bound. u' = 2^-52 bounds the relative error of one operation in any rounding mode, and delta the error of a corner's
// coordinate. E_i is the largest coordinate of a corner on axis i. The error of d is `d_error`. The factor `slack`, 1 +
// 2^-20, covers the evaluation of the bounds.
//
// Weights: a component of c = p x q is two products of at most E_i E_j. It is off by 4 u' E_i E_j for rounding, and by
// 2 delta (E_i + E_j) + 2 delta^2 for the errors of its factors. c . d is off by another 3.01 u' 2 E_i E_j |d| and 2
// E_i E_j d_error. Together these are less than
//     sum over k of (11 u' E_i E_j + 2.01 delta (E_i + E_j) + 2 delta^2) |d_k| + 2.01 E_i E_j d_error_k.
// The normal n: differences of corners are off by e = u' S + 2 delta, where S is the largest difference by axis. A
// component of n is off by 4 u' S_i S_j + 2 (e_i S_j + S_i e_j) + 2 e_i e_j < B = 8.1 u' S_i S_j + 4.01 delta (S_i +
// S_j) + 8.1 delta^2. Then n . d is off by the sum of (B + 3.01 u' |n|) (|d| + d_error) + |n| d_error, and n . p by the
// sum of (B + 3.01 u' |n|) (|p| + delta) + |n| delta.
//
// No number is infinite or a NaN: a sum S of magnitudes at which posing could overflow makes delta at least 4 u' S, and
// then delta exceeds size_max. In a mode that rounds down, an upper end that overflows becomes the largest double. No
// hit is beyond this end, since a point of the triangle is at most sqrt(3) size_max from 0.
// Claim: verify/proofs/triangle_hits.py
ECODS_ALWAYS_INLINE void TriangleHits::enclose_in(const InDoubles& s, const std::array<const Vec3*, 3>& corners,
                                                  HitEnclosure& result) noexcept {
    using Verdict = HitEnclosure::Verdict;
    const auto posed = [&](const Vec3& v) ECODS_INLINE_LAMBDA {
        return ((load4(s.R[0]) * v[0] + load4(s.R[1]) * v[1]) + load4(s.R[2]) * v[2]) + load4(s.offset);
    };
    const Double4 p = posed(*corners[0]), q = posed(*corners[1]), r = posed(*corners[2]), d = load4(s.d);
    const Double4 d_size = absolute(d), d_error = load4(s.d_error);
    const Double4 p_size = absolute(p), E = max(p_size, max(absolute(q), absolute(r))), EE = products(E);
    const double delta = s.delta, delta_square = delta * delta;
    const Double4 each = (11 * two_u * EE + (2.01 * delta) * sums(E)) + 2 * delta_square;
    // The four lanes are the weights of r, p and q, and the error bound of the weights.
    const Double4 weights =
        sums_of(cross(p, q) * d, cross(q, r) * d, cross(r, p) * d, each * d_size + 2.01 * EE * d_error);
    const double beside = weights[3] * slack;
    if (!(largest(E) < size_max && delta < size_max && beside > bound_min)) return;
    const double most = largest(weights), least = -largest(-weights);
    if (most > beside && least < -beside) {
        result.verdict = Verdict::none;
        return;
    }

    const Double4 u = q - p, v = r - p, n = cross(u, v), n_size = absolute(n);
    const Double4 S = max(absolute(u), absolute(v));
    const Double4 B = (8.1 * two_u * products(S) + (4.01 * delta) * sums(S)) + 8.1 * delta_square;
    const Double4 of_n = B + 3.01 * two_u * n_size;
    result.has_area = largest(n_size - slack * B) > bound_min;
    const Double4 both =
        sums_of(n * d, n * p, of_n * (d_size + d_error) + n_size * d_error, of_n * (p_size + delta) + n_size * delta);
    const double den = both[0], num = both[1];
    const double den_error = both[2] * slack + bound_min, num_error = both[3] * slack + bound_min;
    const double size = std::abs(den);
    if (!(size > den_error)) return;
    result.is_crossing = true;
    const double forward = den < 0 ? -num : num;
    constexpr double down = 1 - 0x1p-49, up = 1 + 0x1p-49;
    if (forward + num_error < 0) {
        result.verdict = Verdict::none;
        return;
    }
    const bool begins_before = forward > num_error;
    result.lower = begins_before ? (forward - num_error) / (size + den_error) * down : 0;
    result.upper = (forward + num_error) / (size - den_error) * up + 0x1p-1020;
    if (result.lower > s.end_high) {
        result.verdict = Verdict::none;
        return;
    }
    const bool is_inside = least > beside || most < -beside;
    if (is_inside && begins_before && result.upper <= s.end_low) {
        result.verdict = Verdict::face;
    }
    result.upper = std::min(result.upper, s.end_high);
}

HitEnclosure TriangleHits::enclose(const Triangle& corners) const noexcept {
    HitEnclosure result;
    result.upper = in_doubles_.end_high;
    if (!in_doubles_.is_known) return result;
    const auto vertices = body_.mesh->vertices();
    const std::array<const Vec3*, 3> at{&vertices[corners[0]], &vertices[corners[1]], &vertices[corners[2]]};
    dispatch<&TriangleHits::enclose_in>(in_doubles_, at, result);
    return result;
}

// ---- integers

namespace {

template <int L>
LimbVector<L> to_vector(const LinePoints::Point& p) noexcept {
    const auto coordinate = [](Int128 x) {
        const Limbs<2> limbs = to_limbs(x);
        if constexpr (L == 1) return magnitude<1>({limbs[0]});
        if constexpr (L == 2) return magnitude<2>(limbs);
    };
    return {coordinate(p[0]), coordinate(p[1]), coordinate(p[2])};
}

}  // namespace

bool TriangleHits::has_short_points() {
    if (kind_ == Points::unknown) kind_ = points_.bind(*line_) ? Points::short_ones : Points::long_ones;
    return kind_ == Points::short_ones;
}

std::array<LinePoints::Point, 3> TriangleHits::short_points(const Triangle& corners) const {
    const auto vertices = body_.mesh->vertices();
    return {points_.at(vertices[corners[0]]), points_.at(vertices[corners[1]]), points_.at(vertices[corners[2]])};
}

bool TriangleHits::round_crossing(const Triangle& corners, RoundedCrossing& crossing) {
    if (!has_short_points()) return false;
    return exact::round_crossing({line_->a, points_.direction(), points_.unit()}, short_points(corners), crossing);
}

// Calls use(direction, corners) with the line's direction and the corners as vectors of limbs. The corners are relative
// to the line's beginning.
template <class Use>
auto TriangleHits::with_limbs(const Triangle& corners, Use&& use) {
    if (has_short_points()) {
        const std::array<LinePoints::Point, 3> at = short_points(corners);
        const auto in_limbs = [&]<int L>(std::integral_constant<int, L>) {
            return use(to_vector<L>(points_.direction()),
                       std::array{to_vector<L>(at[0]), to_vector<L>(at[1]), to_vector<L>(at[2])});
        };
        if (points_.is_one_limb()) return in_limbs(std::integral_constant<int, 1>{});
        return in_limbs(std::integral_constant<int, 2>{});
    }
    static const Vec3 origin(0, 0, 0);
    const auto vertices = body_.mesh->vertices();
    line_pose_.t = line_->is_ray ? line_->a : origin;
    PosedPoints<5> posed;
    posed[0] = {&line_pose_, line_->is_ray ? &origin : &line_->a};
    posed[1] = {&line_pose_, &line_->b};
    for (std::size_t k = 0; k < 3; ++k) posed[2 + k] = {body_.pose, &vertices[corners[k]]};
    return with_integers(posed, [&]<class Kernel>(const IntegerPoints<Kernel, 5>& points) {
        constexpr int L = Kernel::limb_count;
        const auto limbs = to_limbs(points);
        const auto vector = [&](std::size_t i) { return difference<L>(limbs[i], limbs[0]); };
        return use(vector(1), std::array<LimbVector<L>, 3>{vector(2), vector(3), vector(4)});
    });
}

bool TriangleHits::find(const Triangle& corners, LineHit& hit) {
    return with_limbs(corners, [&]<int L>(const LimbVector<L>& d, const std::array<LimbVector<L>, 3>& at) {
        return LineTriangle<L>(d, at, line_->end).find(hit);
    });
}

void TriangleHits::find_crossing(const Triangle& corners, LineHit& hit) {
    with_limbs(corners, [&]<int L>(const LimbVector<L>& d, const std::array<LimbVector<L>, 3>& at) {
        hit.facing = LineTriangle<L>(d, at, line_->end).find_crossing(hit.enter);
    });
    hit.leave = hit.enter;
    hit.is_along = false;
    hit.feature = Feature::Kind::face;
    hit.corner = 0;
}

}  // namespace ecods
