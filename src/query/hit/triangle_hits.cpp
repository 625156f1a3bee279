#include "query/hit/triangle_hits.hpp"

#include <algorithm>
#include <cmath>

#include "exact/measure/measure_pair.hpp"
#include "exact/point/integer_points.hpp"
#include "simd/inline.hpp"

namespace ecods {

using namespace exact;

void TriangleHits::prepare(const BodyRef& body) noexcept {
    const Mat3& R = body.pose->R;
    sum_ = R.cwiseAbs() * body.extent->magnitude;
    factor_ = std::max(R.cwiseAbs().maxCoeff(), body.extent->magnitude.maxCoeff());
    points_.bind(body);
}

void TriangleHits::bind(const Line& line, const ScaledLine& scaled, const BodyRef& body) noexcept {
    line_ = &line;
    scaled_ = &scaled;
    body_ = body;
    offset_ = body.pose->t - line.a;
    delta_ = point_error_bound((sum_ + offset_.cwiseAbs()).maxCoeff(), factor_);
    kind_ = Points::unknown;
}

// ---- doubles

namespace {

// Products of magnitudes stay far from overflow, and what they lose by underflow is far below the bounds.
constexpr double size_max = 0x1p200;
constexpr double bound_min = 0x1p-780;

struct Vector {
    double x, y, z;
};
ECODS_ALWAYS_INLINE Vector vector(const Point& p) noexcept {
    return {p[0], p[1], p[2]};
}
ECODS_ALWAYS_INLINE Vector minus(const Vector& a, const Vector& b) noexcept {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
ECODS_ALWAYS_INLINE Vector cross(const Vector& a, const Vector& b) noexcept {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
ECODS_ALWAYS_INLINE double dot(const Vector& a, const Vector& b) noexcept {
    return (a.x * b.x + a.y * b.y) + a.z * b.z;
}
ECODS_ALWAYS_INLINE Vector absolute(const Vector& a) noexcept {
    return {std::abs(a.x), std::abs(a.y), std::abs(a.z)};
}
ECODS_ALWAYS_INLINE Vector largest(const Vector& a, const Vector& b) noexcept {
    return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}
// The largest that a component of the cross product of two vectors of these sizes can be, but for a factor of 2.
ECODS_ALWAYS_INLINE Vector products(const Vector& a) noexcept {
    return {a.y * a.z, a.z * a.x, a.x * a.y};
}
ECODS_ALWAYS_INLINE Vector sums(const Vector& a) noexcept {
    return {a.y + a.z, a.z + a.x, a.x + a.y};
}
// f a + g b
ECODS_ALWAYS_INLINE Vector combine(double f, const Vector& a, double g, const Vector& b) noexcept {
    return {f * a.x + g * b.x, f * a.y + g * b.y, f * a.z + g * b.z};
}

}  // namespace

// With the line's beginning at 0, corners p, q and r, and d as in exact/measure/line_hit.hpp.
//
// Bound; u' = 2^-52 bounds one operation in any rounding mode, delta the error of a corner's coordinate, E the largest
// coordinate of a corner by axis, D that of d, whose error is `d_error`. 1 + 2^-20 covers the evaluation.
//
// Weights: a component of c = p x q, two products of at most E_i E_j, is off by 4 u' E_i E_j for rounding and 2 delta
// (E_i + E_j) + 2 delta^2 for its factors; c . d by another 3.01 u' 2 E_i E_j |d| and 2 E_i E_j d_error: in all below
//     sum over k of (11 u' E_i E_j + 2.01 delta (E_i + E_j) + 2 delta^2) |d_k| + 2.01 E_i E_j d_error_k.
// The normal n: differences are off by e = u' S + 2 delta, S being the largest by axis; a component by 4 u' S_i S_j + 2
// (e_i S_j + S_i e_j) + 2 e_i e_j < B = 8.1 u' S_i S_j + 4.01 delta (S_i + S_j) + 8.1 delta^2. Then n . d is off by
// the sum of (B + 3.01 u' |n|) (|d| + d_error) + |n| d_error, and n . p by that of (B + 3.01 u' |n|) (|p| + delta) +
// |n| delta.
HitEnclosure TriangleHits::enclose(std::uint32_t triangle) const noexcept {
    using Verdict = HitEnclosure::Verdict;
    HitEnclosure result;
    const ScaledLine& line = *scaled_;
    result.upper = line.end_high;
    if (!line.is_known) return result;
    const Triangle& corners = body_.mesh->triangles()[triangle];
    const auto posed = [&](std::size_t k) {
        return vector(pose_point(body_.pose->R, body_.mesh->vertices()[corners[k]], offset_));
    };
    const Vector p = posed(0), q = posed(1), r = posed(2), d{line.d[0], line.d[1], line.d[2]};
    const Vector d_size = absolute(d), d_error{line.d_error[0], line.d_error[1], line.d_error[2]};
    const Vector E = largest(absolute(p), largest(absolute(q), absolute(r))), EE = products(E);
    constexpr double slack = 1 + 0x1p-20;
    const double beside = (dot(combine(11 * two_u, EE, 2.01 * delta_, sums(E)), d_size) + 2.01 * dot(EE, d_error) +
                           2 * delta_ * delta_ * (d_size.x + d_size.y + d_size.z)) *
                          slack;
    // In this form a NaN leaves all open.
    if (!(std::max({E.x, E.y, E.z, delta_}) < size_max && beside > bound_min)) return result;

    const Vector dp = cross(p, q), dq = cross(q, r), dr = cross(r, p);
    const double wr = dot(dp, d), wp = dot(dq, d), wq = dot(dr, d);
    const double most = std::max({wp, wq, wr}), least = std::min({wp, wq, wr});
    if (most > beside && least < -beside) {
        result.verdict = Verdict::none;
        return result;
    }

    const Vector u = minus(q, p), v = minus(r, p), n = cross(u, v), n_size = absolute(n);
    const Vector S = largest(absolute(u), absolute(v));
    Vector B = combine(8.1 * two_u, products(S), 4.01 * delta_, sums(S));
    const double delta_square = 8.1 * delta_ * delta_;
    B = {B.x + delta_square, B.y + delta_square, B.z + delta_square};
    const Vector of_n = combine(1, B, 3.01 * two_u, n_size);
    const double den = dot(n, d), num = dot(n, p);
    const double den_error =
        (dot(of_n, {d_size.x + d_error.x, d_size.y + d_error.y, d_size.z + d_error.z}) + dot(n_size, d_error)) * slack +
        bound_min;
    const Vector p_size = absolute(p);
    const double num_error = (dot(of_n, {p_size.x + delta_, p_size.y + delta_, p_size.z + delta_}) +
                              delta_ * (n_size.x + n_size.y + n_size.z)) *
                                 slack +
                             bound_min;
    const double size = std::abs(den);
    if (!(size > den_error)) return result;
    result.is_crossing = true;
    const double forward = den < 0 ? -num : num;
    constexpr double down = 1 - 0x1p-49, up = 1 + 0x1p-49;
    if (forward + num_error < 0) {
        result.verdict = Verdict::none;
        return result;
    }
    const bool begins_before = forward > num_error;
    result.lower = begins_before ? (forward - num_error) / (size + den_error) * down : 0;
    result.upper = (forward + num_error) / (size - den_error) * up + 0x1p-1020;
    if (result.lower > line.end_high) {
        result.verdict = Verdict::none;
        return result;
    }
    const bool is_inside = least > beside || most < -beside;
    if (is_inside && begins_before && result.upper <= line.end_low) {
        result.verdict = Verdict::face;
        result.is_back = den > 0;
    }
    result.upper = std::min(result.upper, line.end_high);
    return result;
}

// ---- integers

namespace {

Magnitude<1> to_magnitude_of_one(Int128 x) noexcept {
    const auto narrow = static_cast<std::int64_t>(x);
    return magnitude<1>({static_cast<std::uint64_t>(narrow)});
}
Magnitude<2> to_magnitude_of_two(Int128 x) noexcept {
    return magnitude<2>(to_limbs(x));
}
template <int L>
LimbVector<L> to_vector(const LinePoints::Point& p) noexcept {
    if constexpr (L == 1) {
        return {to_magnitude_of_one(p[0]), to_magnitude_of_one(p[1]), to_magnitude_of_one(p[2])};
    } else {
        return {to_magnitude_of_two(p[0]), to_magnitude_of_two(p[1]), to_magnitude_of_two(p[2])};
    }
}

}  // namespace

// Calls use(direction, corners) with vectors of limbs from the line's beginning.
template <class Use>
auto TriangleHits::with_limbs(std::uint32_t triangle, Use&& use) {
    const Triangle& corners = body_.mesh->triangles()[triangle];
    const auto vertices = body_.mesh->vertices();
    if (kind_ == Points::unknown) kind_ = points_.bind(*line_) ? Points::short_ones : Points::long_ones;
    if (kind_ == Points::short_ones) {
        const std::array<LinePoints::Point, 3> at{points_.at(vertices[corners[0]]), points_.at(vertices[corners[1]]),
                                                  points_.at(vertices[corners[2]])};
        const auto in_limbs = [&]<int L>(std::integral_constant<int, L>) {
            return use(to_vector<L>(points_.direction()),
                       std::array{to_vector<L>(at[0]), to_vector<L>(at[1]), to_vector<L>(at[2])});
        };
        if (points_.is_one_limb()) return in_limbs(std::integral_constant<int, 1>{});
        return in_limbs(std::integral_constant<int, 2>{});
    }
    static const Vec3 origin(0, 0, 0);
    line_pose_.t = line_->is_ray ? line_->a : origin;
    PosedPoints<5> posed;
    posed[0] = {&line_pose_, line_->is_ray ? &origin : &line_->a};
    posed[1] = {&line_pose_, &line_->b};
    for (std::size_t k = 0; k < 3; ++k) posed[2 + k] = {body_.pose, &vertices[corners[k]]};
    return with_integers(posed, [&]<class Kernel>(const IntegerPoints<Kernel, 5>& points) {
        constexpr int L = limbs_of<Kernel>;
        const auto limbs = to_limbs(points);
        const auto vector = [&](std::size_t i) { return difference<L>(limbs[i], limbs[0]); };
        return use(vector(1), std::array<LimbVector<L>, 3>{vector(2), vector(3), vector(4)});
    });
}

bool TriangleHits::find(std::uint32_t triangle, LineHit& hit) {
    return with_limbs(triangle, [&]<int L>(const LimbVector<L>& d, const std::array<LimbVector<L>, 3>& corners) {
        return LineTriangle<L>(d, corners, line_->end).find(hit);
    });
}

void TriangleHits::find_crossing(std::uint32_t triangle, bool is_back, LineHit& hit) {
    with_limbs(triangle, [&]<int L>(const LimbVector<L>& d, const std::array<LimbVector<L>, 3>& corners) {
        LineTriangle<L>(d, corners, line_->end).find_crossing(hit.enter);
    });
    hit.leave = hit.enter;
    hit.is_along = false;
    hit.feature = Feature::Kind::face;
    hit.corner = 0;
    hit.facing = is_back ? 1 : -1;
}

}  // namespace ecods
