#include "query/convex/posed_hulls.hpp"

#include <algorithm>
#include <cmath>

#include "base/arithmetic.hpp"
#include "base/outward.hpp"
#include "ecods/error.hpp"
#include "ecods/primitives.hpp"
#include "exact/measure/round/scaled_vector.hpp"
#include "exact/point/vectors.hpp"
#include "query/convex/furthest.hpp"
#include "query/convex/short_points.hpp"
#include "query/shape/mesh_body.hpp"
#include "simd/dispatch.hpp"

namespace ecods::convex {
namespace {

using exact::power_of_two;

double largest_magnitude(const Mat3& R) noexcept {
    return R.cwiseAbs().maxCoeff();
}

// A ScaledDifference represents a difference t - t0 as x 2^exponent, with x rounded once and below 2 in magnitude.
struct ScaledDifference {
    double x = 0;
    int exponent = -exact::BitRange::none;
};

ScaledDifference subtract(double t, double t0) noexcept {
    const auto difference = exact::subtract(exact::decode(t), exact::decode(t0));
    if (!difference) {  // one is more than 2^60 times as large as the other
        const int exponent = std::max(exponent_above(t), exponent_above(t0));
        return {times_power(t, -exponent) - times_power(t0, -exponent), exponent};
    }
    if (difference->m == 0) return {};
    const exact::Uint128 size =
        difference->m < 0 ? -static_cast<exact::Uint128>(difference->m) : static_cast<exact::Uint128>(difference->m);
    const int shift = std::max(0, exact::bit_width(size) - 62);
    // The digits that are shifted out are less than 2^-61 of the other digits.
    const auto digits = static_cast<std::int64_t>(size >> shift);
    const double x = static_cast<double>(digits) * 0x1p-62;
    return {difference->m < 0 ? -x : x, difference->e + shift + 62};
}

}  // namespace

PosedHulls::PosedHulls(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, QueryMemory& memory)
    : memory_(ConvexMemory::of(memory)) {
    for (const std::size_t side : {0, 1}) {
        const Posed<ConvexSolid>& posed = side == 0 ? a : b;
        Body& body = bodies_[side];
        body.solid = posed.what;
        body.at = &posed.pose;
        body.hull = &ConvexSolidAccess::hull(*posed.what);
        body.points = &ConvexSolidAccess::points(*posed.what);
        body.offset = {};
    }
    if (!scale_plainly()) scale_any();
    find_bounds();
    find_orientation(0);
    find_orientation(1);
}

// Leaves points in their own unit, and returns true, if sizes are ordinary; otherwise returns false. The mesh's points
// were divided by a power of two, so the entries of R are multiplied by this power. A solid that is only the origin has
// size 0.
bool PosedHulls::scale_plainly() noexcept {
    double largest = 0;
    for (Body& body : bodies_) {
        const bool is_zero = body.points->exponent == -exact::BitRange::none;
        const int e = is_zero ? 0 : body.points->exponent;
        if (e < -300 || e > 300) return false;
        const double power = power_of_two(e);
        const double size = largest_magnitude(body.at->R) * power;
        if (!(size <= 0x1p100)) return false;
        if (!is_zero) largest = std::max(largest, size);
        body.rows = rows_of(*body.at, [&](double r) { return r * power; });
    }
    if (!(largest >= 0x1p-100)) return false;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto row = static_cast<Eigen::Index>(k);
        bodies_[1].offset[k] = bodies_[1].at->t[row] - bodies_[0].at->t[row];
        if (!(std::abs(bodies_[1].offset[k]) <= 0x1p100)) return false;
    }
    exponent_ = 0;
    return true;
}

// Scales points of any size: decodes all numbers from their bits, and divides them by a power of two that makes the
// largest number less than 2.
void PosedHulls::scale_any() noexcept {
    std::array<ScaledDifference, 3> difference;
    int exponent = -exact::BitRange::none;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto row = static_cast<Eigen::Index>(k);
        difference[k] = subtract(bodies_[1].at->t[row], bodies_[0].at->t[row]);
        exponent = std::max(exponent, difference[k].exponent);
    }
    for (const Body& body : bodies_) {
        for (int i = 0; i < 9; ++i) {
            exponent = std::max(exponent, exponent_above(body.at->R.data()[i]) + body.points->exponent);
        }
    }
    exponent_ = exponent;
    for (Body& body : bodies_) {
        body.rows = rows_of(*body.at, [&](double r) { return times_power(r, body.points->exponent - exponent); });
    }
    for (std::size_t k = 0; k < 3; ++k) {
        bodies_[1].offset[k] = times_power(difference[k].x, difference[k].exponent - exponent);
    }
}

// Bounds errors as in exact/point/point.hpp. Here each factor is a product of an entry of R, or of a coordinate, and a
// power of two. Such a product may underflow: for an entry by less than 2^-1022 times 2^300, for others by less than
// 2^-900 (times_power). The other factor is at most 2^100. All of this together is below 2^-700.
void PosedHulls::find_bounds() noexcept {
    delta_ = 0;
    for (Body& body : bodies_) {
        double sum_max = 0, extent_max = 0;
        for (std::size_t row = 0; row < 3; ++row) {
            const Point &r = body.rows[row], &reach = body.points->reach, &extent = body.points->extent;
            const double x = std::abs(r[0]), y = std::abs(r[1]), z = std::abs(r[2]);
            sum_max = std::max(sum_max, ((x * reach[0] + y * reach[1]) + z * reach[2]) + std::abs(body.offset[row]));
            extent_max = std::max(extent_max, (x * extent[0] + y * extent[1]) + z * extent[2]);
        }
        delta_ = std::max(delta_, 4.25 * two_u * sum_max + 0x1p-700);
        body.size = extent_max * (1 + 16 * two_u);
    }
    for (Body& body : bodies_) body.size += 4 * delta_;
}

// Computes the sign in doubles. It is certain if the determinant exceeds 6 u' times the sum of the products' magnitudes
// (exact/sign/difference_signs.hpp, for three vectors instead of three differences). Another u' covers underflow, which
// is below 2^-500 with factors of at most 2^100. If the sign is not certain, computes it exactly.
Sign orientation(const std::array<Point, 3>& rows, const Pose& pose) {
    const auto& [r, s, t] = rows;
    const auto minor = [&](std::size_t i, std::size_t j) { return s[i] * t[j] - s[j] * t[i]; };
    const auto permanent = [&](std::size_t i, std::size_t j) { return std::abs(s[i] * t[j]) + std::abs(s[j] * t[i]); };
    const double det = (r[0] * minor(1, 2) + r[1] * minor(2, 0)) + r[2] * minor(0, 1);
    const double sum =
        (std::abs(r[0]) * permanent(1, 2) + std::abs(r[1]) * permanent(2, 0)) + std::abs(r[2]) * permanent(0, 1);
    const bool is_ordinary =
        exact::largest(r) <= 0x1p100 && exact::largest(s) <= 0x1p100 && exact::largest(t) <= 0x1p100;
    if (is_ordinary && sum > 0x1p-400 && std::abs(det) > 7 * two_u * sum)
        return det < 0 ? Sign::negative : Sign::positive;
    const auto at = [&](int axis) -> PosedPoint {
        return {pose, axis < 0 ? Vec3(Vec3::Zero()) : Vec3(Vec3::Unit(axis))};
    };
    return orient3d(at(-1), at(0), at(1), at(2));
}

void PosedHulls::find_orientation(std::size_t side) {
    Body& body = bodies_[side];
    const Sign sign = orientation(body.rows, *body.at);
    if (sign == Sign::zero) throw SingularPose(static_cast<int>(side));
    body.is_mirrored = sign == Sign::negative;
}

std::uint32_t PosedHulls::support(std::size_t side, const Point& direction, std::uint32_t start) const noexcept {
    const Body& body = bodies_[side];
    const Point along = in_mesh(body, direction);
    if (!is_scanned(side)) return climb(body, along, start);
    const std::vector<double>& groups = body.points->groups;
    return std::min(last_vertex(body), dispatch<furthest>(groups.data(), groups.size(), along));
}

std::uint32_t PosedHulls::support(std::size_t side, const Point& direction) const noexcept {
    if (is_scanned(side)) return support(side, direction, 0);
    const Body& body = bodies_[side];
    const Point along = in_mesh(body, direction);
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k) {
        if (std::abs(along[k]) > std::abs(along[axis])) axis = k;
    }
    return climb(body, along, body.points->extremes[2 * axis + (along[axis] > 0)]);
}

// Returns the heights of the vertices along n, with the margin derived here. Let u' = two_u and D = delta(), which is
// at least 4.25 u' sum (find_bounds), where `sum` bounds the magnitudes added up for any coordinate of a point. Let
// |n|_1 be the sum of the magnitudes of n. A height has six roundings, and is off by at most 6.1 u' sum |n|_1. Two
// heights, and the rounding of the number with which they are compared, are off by less than 13.4 u' sum |n|_1 < 3.2 D
// |n|_1. The error of n changes the difference of two heights by 3 error size(side). The factor 3.6 also covers the
// roundings of the margin, and underflow. Underflow loses less than 2^-900, whereas D must be at least 2^-200, so that
// the margin is 2^-600 or more.
// Claim: verify/proofs/difference_signs.py
// Claim: verify/proofs/hull_signs.py
auto PosedHulls::heights(std::size_t side, const Point& n, double error) const noexcept -> Heights {
    const Body& body = bodies_[side];
    const double margin = 3.6 * (error * body.size + delta_ * exact::sum_of_magnitudes(n));
    return {body.points, in_mesh(body, n), margin};
}

void PosedHulls::list_furthest(const Heights& heights, std::vector<std::uint32_t>& list) {
    dispatch<convex::list_furthest>(*heights.points, heights.along, heights.margin, list);
}

bool PosedHulls::are_others_behind(std::size_t side, const Point& n, double error,
                                   std::span<const std::uint32_t> corners) const noexcept {
    if (!is_scanned(side)) return false;
    const Heights heights = this->heights(side, n, error);
    const std::vector<double>& groups = heights.points->groups;
    // Expects the corners, which are level with each other. If the last vertex is one of them, its copies in the groups
    // are level, too, and are expected as well.
    std::size_t expected = corners.size();
    for (const std::uint32_t vertex : corners) {
        if (vertex == last_vertex(bodies_[side])) expected += groups.size() / 3 - heights.points->vertex_count;
    }
    const double least = heights.of(corners[0]) - heights.margin;
    return dispatch<count_not_below>(groups.data(), groups.size(), heights.along, least) == expected;
}

// Climbs from vertex to vertex while the dot product increases. The computed product of a vertex is always the same, so
// the climb ends.
std::uint32_t PosedHulls::climb(const Body& body, const Point& along, std::uint32_t start) noexcept {
    std::uint32_t at = start;
    double most = exact::dot(along, body.points->at(at));
    for (bool has_moved = true; has_moved;) {
        has_moved = false;
        for (const Hull::Neighbor& n : body.hull->neighbors_of(at)) {
            const double h = exact::dot(along, body.points->at(n.vertex));
            if (h > most) {
                most = h;
                at = n.vertex;
                has_moved = true;
            }
        }
    }
    return at;
}

std::array<std::uint32_t, 3> PosedHulls::vertices_near(std::size_t side, std::uint32_t triangle) const noexcept {
    const auto triangles = mesh(side).triangles();
    std::array<std::uint32_t, 3> result{};
    if (triangle >= triangles.size()) return result;
    std::uint32_t last = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t v = bodies_[side].points->hull_index[triangles[triangle][i]];
        result[i] = v != SupportPoints::none ? v : last;
        last = result[i];
    }
    return result;
}

bool PosedHulls::has_fixed_points() {
    if (!is_bound_) bind_exact();
    return memory_.points.is_exact();
}

PosedHulls::Integers PosedHulls::integers(const std::array<std::span<const std::uint32_t>, 2>& vertices) {
    Integers result;
    if (find_short(vertices, result)) return result;
    result.are_exact = has_fixed_points();
    result.unit = fixed_unit();
    for (const std::size_t side : {0, 1}) {
        for (std::size_t i = 0; i < vertices[side].size(); ++i) result.at[side][i] = fixed({side, vertices[side][i]});
    }
    return result;
}

// Computes the points as short integers, and returns true, if they fit. Otherwise returns false. Points must be in
// their own unit (exponent_ is 0), so that the offset is t - t0.
bool PosedHulls::find_short(const std::array<std::span<const std::uint32_t>, 2>& vertices,
                            Integers& result) const noexcept {
    if (exponent_ != 0) return false;
    ShortPoints points;
    if (!points.bind(*bodies_[0].at, *bodies_[0].points, *bodies_[1].at, *bodies_[1].points,
                     exact::largest(bodies_[1].offset)))
        return false;
    for (const std::size_t side : {0, 1}) {
        for (std::size_t i = 0; i < vertices[side].size(); ++i) {
            if (!points.find(side, vertices[side][i], result.at[side][i])) return false;
        }
    }
    result.unit = points.unit();
    result.are_exact = points.is_exact();
    return true;
}

exact::BodyRef PosedHulls::body(std::size_t side) const {
    return MeshBody(*bodies_[side].solid, *bodies_[side].at).ref();
}

void PosedHulls::bind_exact() {
    memory_.points.bind_pair(body(0), body(1));
    is_bound_ = true;
}

}  // namespace ecods::convex
