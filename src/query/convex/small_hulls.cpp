// This file bounds the distance of two small convex sets in doubles. Let u' = two_u. Vertices are off by at most d_a
// and d_b on each axis (SmallHull::delta), and M bounds the magnitudes of all coordinates as computed. n is any vector,
// |n|_1 the sum of its magnitudes, E = `error`.
//
// Upper bound. z = p + r u + s v + t w is a point of the Minkowski difference, where p is one vertex of a simplex and
// u, v, w are the differences from it to the others, r, s, t >= 0, and r + s + t <= 1 but for two roundings: a point of
// the simplex is less than 16 u' M away on each axis. A vertex of the difference has one rounding, of 2 M; u, v, w have
// one more, of 4 M; their products one more; three sums are below 2.2 M each. All of this is below 34 u' M, and the
// vertices themselves are off by d_a + d_b: E = 1.01 (d_a + d_b) + 40 u' M bounds the error of a coordinate of z, and
// sqrt(3) E that of |z|. |z| as computed is off by less than 4 u' of itself.
//
// Lower bound. The distance is at least (min n.q - max n.p) / |n|, over the vertices p of the first set and q of the
// second (weak duality). A product as computed is off by less than 3.1 u' M |n|_1. The vertices that the search takes
// for extreme may be less so than others by twice that. With the products of these vertices, and their difference, that
// is less than 22 u' M |n|_1; E |n|_1 covers it, and d_a + d_b. Factors of 1 +- 8 u' cover the roundings of |n|_1, |n|
// and the quotients.
//
// Vertices behind a feature. Let n be the true direction within e on each axis. A vertex is behind a corner of the
// feature along the true direction if it is along n by more than e times the sum of the magnitudes of their difference,
// at most 6 M e, and 2 (d + 3.1 u' M) |n|_1; its height and that of the corner are then different. The margin is larger
// by some percent, which covers its own roundings.
//
// Underflow: sizes are at most 2^400; what is compared is at least 2^-400, and numbers below 2^-900 are lost beside
// others of at least 2^-500. 2^-700 is added to delta, since an entry of R times a power of two may underflow.
// Claim: verify/proofs/small_hulls.py
#include "query/convex/small_hulls.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/arithmetic.hpp"
#include "exact/number/power.hpp"
#include "query/convex/convex_parts.hpp"
#include "query/convex/furthest.hpp"
#include "query/convex/hull_features.hpp"
#include "simd/dispatch.hpp"

namespace ecods::convex {

using exact::dot;
using exact::Point;

namespace {

constexpr std::size_t group = 3 * SupportPoints::lanes;

}  // namespace

ECODS_ALWAYS_INLINE void SmallHull::pose_vertices() noexcept {
    if (unposed_ == nullptr) return;
    constexpr std::size_t lanes = SupportPoints::lanes;
    for (std::uint32_t i = 0; i < number_count_; i += group) {
        const auto x = load_anywhere<FourDoubles>(unposed_ + i), y = load_anywhere<FourDoubles>(unposed_ + i + lanes),
                   z = load_anywhere<FourDoubles>(unposed_ + i + 2 * lanes);
        for (std::size_t k = 0; k < 3; ++k) {
            store_anywhere(&groups_[i + k * lanes],
                           ((rows_[k][0] * x + rows_[k][1] * y) + rows_[k][2] * z) + offset_[k]);
        }
    }
}

ECODS_ALWAYS_INLINE std::uint32_t SmallHull::support(const Point& along) const noexcept {
    if (vertex_count_ == 1) return 0;
    if (vertex_count_ == 2) return dot(along, at(1)) > dot(along, at(0)) ? 1 : 0;
    return std::min(vertex_count_ - 1, furthest(groups_.data(), number_count_, along));
}

// Returns the number of vertices whose dot product is at least `least` or NaN. Copies of the last vertex pad the last
// groups, and are counted if the last vertex is.
ECODS_ALWAYS_INLINE std::size_t SmallHull::count_not_below(const Point& along, double least) const noexcept {
    if (vertex_count_ < 3) {
        std::size_t count = 0;
        for (std::uint32_t v = 0; v < vertex_count_; ++v) count += dot(along, at(v)) < least ? 0 : 1;
        return count;
    }
    const std::size_t count = convex::count_not_below(groups_.data(), number_count_, along, least);
    const bool is_last = !(dot(along, at(vertex_count_ - 1)) < least);
    return is_last ? count - (number_count_ / 3 - vertex_count_) : count;
}

namespace {

using exact::minus;
using exact::negated;
using exact::sum_of_magnitudes;

constexpr double least_compared = 0x1p-400, most_compared = 0x1p400, root_of_three = 1.7320509;

ECODS_ALWAYS_INLINE double from_0_to(double most, double x) noexcept {
    return std::min(most, std::max(0.0, x));  // 0 for NaN
}

// Returns a point of the simplex, about the nearest to the origin: its weights are cut to what a simplex allows.
Point feasible(const Simplex& simplex) noexcept {
    const auto& p = simplex.points;
    const auto count = static_cast<std::size_t>(simplex.count);
    Point z = p[0];
    std::array<Point, 3> u{};
    for (std::size_t i = 1; i < count; ++i) u[i - 1] = minus(p[i], p[0]);
    std::array<double, 3> weights{};
    if (count == 2) weights[0] = -dot(u[0], p[0]) / dot(u[0], u[0]);
    if (count == 3) {
        const double uu = dot(u[0], u[0]), vv = dot(u[1], u[1]), uv = dot(u[0], u[1]);
        const double uw = -dot(u[0], p[0]), vw = -dot(u[1], p[0]), det = uu * vv - uv * uv;
        weights = {(uw * vv - vw * uv) / det, (vw * uu - uw * uv) / det, 0};
    }
    if (count == 4) {
        const Point vw = exact::cross(u[1], u[2]);
        const double det = -dot(u[0], vw);
        weights = {dot(p[0], vw) / det, dot(exact::cross(p[0], u[2]), u[0]) / det,
                   -dot(exact::cross(p[0], u[1]), u[0]) / det};
    }
    double rest = 1;
    for (std::size_t i = 0; i + 1 < count; ++i) {
        const double weight = from_0_to(rest, weights[i]);
        rest -= weight;
        for (std::size_t k = 0; k < 3; ++k) z[k] += weight * u[i][k];
    }
    return z;
}

// Compares the distance of two sets with a sum, from bounds of the distance.
struct Comparison {
    double sum;    // at least least_compared
    double error;  // E

    bool is_below(const Simplex& simplex) const noexcept {
        const Point z = feasible(simplex);
        const double length = std::sqrt(dot(z, z));
        return (length * (1 + 8 * two_u) + root_of_three * error) * (1 + 8 * two_u) < sum * (1 - 8 * two_u);
    }
    // Returns true if the distance is certainly above the sum. `gap` is min n.q - max n.p, as computed, and `square` is
    // |n|^2.
    ECODS_ALWAYS_INLINE bool is_above(double gap, const Point& n, double square) const noexcept {
        const double length = std::sqrt(square);
        const double certain = gap - error * sum_of_magnitudes(n) * (1 + 8 * two_u);
        return certain * (1 - 8 * two_u) > sum * (length * (1 + 8 * two_u)) * (1 + 8 * two_u) &&
               length >= least_compared;
    }
};

struct Supports {
    const std::array<SmallHull, 2>& hulls;

    ECODS_ALWAYS_INLINE std::uint32_t operator()(std::size_t side, const Point& along, std::uint32_t) const noexcept {
        return hulls[side].support(along);
    }
};

}  // namespace

const Vec3& SmallHull::vertex(std::uint32_t v) const noexcept {
    const Mesh& mesh = posed_->what->mesh();
    return mesh.vertices()[hull_ != nullptr ? hull_->mesh_vertices[v] : mesh.triangles()[0][v]];
}

bool SmallHull::set(const Posed<MeshShape>& posed, const Vec3& origin) noexcept {
    const MeshShape& shape = *posed.what;
    const bool is_solid = shape.form() == MeshForm::convex;
    if (!is_solid && shape.mesh().triangles().size() != 1) return false;
    posed_ = &posed;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto row = static_cast<Eigen::Index>(k);
        offset_[k] = posed.pose.t[row] - origin[row];
    }
    if (!is_solid) return shape.form() == MeshForm::surface && set_triangle();
    const auto& solid = static_cast<const ConvexSolid&>(shape);
    hull_ = &ConvexSolidAccess::hull(solid);
    return set_solid(ConvexSolidAccess::points(solid));
}

bool SmallHull::set_solid(const SupportPoints& points) noexcept {
    constexpr int exponent_max = 300;
    if (points.vertex_count > vertices_max || !points.has_all_digits || std::abs(points.exponent) > exponent_max) {
        return false;
    }
    const double power = exact::power_of_two(points.exponent);
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t k = 0; k < 3; ++k) {
            rows_[row][k] = posed_->pose.R(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(k)) * power;
        }
    }
    vertex_count_ = points.vertex_count;
    number_count_ = static_cast<std::uint32_t>(points.groups.size());
    unposed_ = points.groups.data();
    center_ = pose(points.center);
    set_bounds(points.reach, 1);
    return true;
}

bool SmallHull::set_triangle() noexcept {
    const Triangle& corners = posed_->what->mesh().triangles()[0];
    const bool is_point = corners[0] == corners[1] && corners[1] == corners[2];
    const bool is_segment = corners[1] == corners[2];
    const bool is_triangle = corners[0] != corners[1] && corners[0] != corners[2];
    if (!is_segment && !is_triangle) return false;
    vertex_count_ = is_point ? 1 : is_segment ? 2 : 3;
    number_count_ = 2 * group;
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t k = 0; k < 3; ++k) {
            rows_[row][k] = posed_->pose.R(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(k));
        }
    }
    Point reach{}, sum{};
    double factor_max = 0;
    const std::uint32_t place_count = vertex_count_ == 3 ? 2 * SupportPoints::lanes : vertex_count_;
    for (std::uint32_t i = 0; i < place_count; ++i) {
        const std::uint32_t at = std::min(i, vertex_count_ - 1);
        const Vec3& v = vertex(at);
        const Point x = pose({v[0], v[1], v[2]});
        for (std::size_t k = 0; k < 3; ++k) {
            groups_[i / SupportPoints::lanes * group + k * SupportPoints::lanes + i % SupportPoints::lanes] = x[k];
            if (i >= vertex_count_) continue;
            sum[k] += x[k];
            reach[k] = std::max(reach[k], std::abs(v[static_cast<Eigen::Index>(k)]));
            factor_max = std::max(factor_max, reach[k]);
        }
    }
    center_ = exact::times(sum, vertex_count_ == 1 ? 1 : vertex_count_ == 2 ? 0.5 : 1.0 / 3);
    set_bounds(reach, factor_max);
    return true;
}

Point SmallHull::pose(const Point& v) const noexcept {
    Point p;
    for (std::size_t k = 0; k < 3; ++k) {
        p[k] = ((rows_[k][0] * v[0] + rows_[k][1] * v[1]) + rows_[k][2] * v[2]) + offset_[k];
    }
    return p;
}

// Sets the error bound of the posed vertices, as derived in exact/point/point.hpp.
void SmallHull::set_bounds(const Point& reach, double factor_max) noexcept {
    double sum_max = 0;
    for (std::size_t row = 0; row < 3; ++row) {
        const Point& r = rows_[row];
        const double sum = ((std::abs(r[0]) * reach[0] + std::abs(r[1]) * reach[1]) + std::abs(r[2]) * reach[2]) +
                           std::abs(offset_[row]);
        sum_max = std::max(sum_max, sum);
        factor_max = std::max(factor_max, exact::largest(r));
    }
    delta_ = exact::point_error_bound(sum_max, factor_max) + 0x1p-700;
    size_ = sum_max * (1 + 12 * two_u) + 0x1p-700;
}

SmallHulls::SmallHulls(const Posed<MeshShape>& a, const Posed<MeshShape>& b) noexcept
    : are_small_(hulls_[0].set(a, a.pose.t) && hulls_[1].set(b, a.pose.t)) {
    if (!are_small_) return;
    are_small_ = hulls_[0].size() <= most_compared && hulls_[1].size() <= most_compared;
    dispatch<&SmallHulls::prepare>(*this);
}

// Sets the first simplex to the support vertices along the direction between the centers.
ECODS_ALWAYS_INLINE void SmallHulls::prepare() noexcept {
    hulls_[0].pose_vertices();
    hulls_[1].pose_vertices();
    const Point between = minus(hulls_[1].center(), hulls_[0].center());
    gjk::add(simplex_, *this, {hulls_[0].support(between), hulls_[1].support(negated(between))});
}

ECODS_ALWAYS_INLINE int SmallHulls::find_sign(double sum) noexcept {
    const double size = std::max(hulls_[0].size(), hulls_[1].size());
    const Comparison comparison{sum, 1.01 * (hulls_[0].delta() + hulls_[1].delta()) + 40 * two_u * size};
    int sign = 0;
    Simplex simplex = simplex_;
    gjk::descend(simplex, *this, Supports{hulls_},
                 [&](const Simplex& at, const gjk::Nearest& nearest,
                     const std::array<std::uint32_t, 2>& pair) ECODS_INLINE_LAMBDA {
                     const double gap = dot(nearest.v, hulls_[1].at(pair[1])) - dot(nearest.v, hulls_[0].at(pair[0]));
                     if (comparison.is_above(gap, nearest.v, nearest.square)) {
                         sign = 1;
                     } else if (nearest.square < sum * sum && comparison.is_below(at)) {
                         sign = -1;
                     }
                     return sign != 0;
                 });
    if (sign == 0 && simplex.count > 0 && comparison.is_below(simplex)) sign = -1;
    simplex_ = simplex;
    return sign;
}

std::optional<int> SmallHulls::compare(double sum) noexcept {
    if (!(sum >= least_compared && sum <= most_compared)) return std::nullopt;
    const int sign = dispatch<&SmallHulls::find_sign>(*this, sum);
    return sign != 0 ? std::optional(sign) : std::nullopt;
}

ECODS_ALWAYS_INLINE void SmallHulls::find_nearest() noexcept {
    gjk::descend(simplex_, *this, Supports{hulls_});
}

// Returns the features that the simplex's vertices span. The features are known only if the simplex has one pair more
// than their dimensions add up to; otherwise returns nullopt.
std::optional<SmallFeatures> SmallHulls::guess_closest() noexcept {
    dispatch<&SmallHulls::find_nearest>(*this);
    const Simplex& simplex = simplex_;
    if (simplex.count < 1 || simplex.count > 3) return std::nullopt;
    SmallFeatures result;
    for (std::size_t i = 0; i < static_cast<std::size_t>(simplex.count); ++i) {
        for (const std::size_t side : {0, 1}) {
            auto& corners = result.corners[side];
            std::size_t& count = result.count[side];
            const auto end = corners.begin() + static_cast<std::ptrdiff_t>(count);
            if (std::find(corners.begin(), end, simplex.pairs[i][side]) == end) {
                corners[count++] = simplex.pairs[i][side];
            }
        }
    }
    if (result.count[0] + result.count[1] != static_cast<std::size_t>(simplex.count) + 1) return std::nullopt;
    return result;
}

bool SmallHulls::are_others_behind(std::size_t side, const SmallFeatures& features, const Point& n,
                                   double error) const noexcept {
    const SmallHull& hull = hulls_[side];
    const Point along = side == 0 ? n : negated(n);
    std::size_t level_count = features.count[side];
    if (level_count == 3 && hull.hull() != nullptr) {
        const std::uint32_t face = face_of(*hull.hull(), features.corners[side]);
        if (face == Hull::no_face) return false;
        level_count = hull.hull()->faces[face].count;
    }
    const double of_points = 2.1 * (hull.delta() + 4 * two_u * hull.size()) * sum_of_magnitudes(n);
    const double margin = of_points + 6.1 * (hull.size() * error);
    const double least = dot(along, hull.at(features.corners[side][0])) - margin;
    return dispatch<&SmallHull::count_not_below>(hull, along, least) == level_count;
}

}  // namespace ecods::convex
