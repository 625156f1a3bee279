#include "query/convex/solid_pair.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "base/arithmetic.hpp"
#include "base/double_key.hpp"
#include "exact/measure/round/distance_beyond.hpp"
#include "exact/point/vectors.hpp"
#include "geometry/find_invalid.hpp"
#include "query/convex/closest_hulls.hpp"
#include "query/convex/posed_hulls.hpp"

namespace ecods::convex {
namespace {

using exact::dot;
using exact::largest;
using exact::minus;
using exact::sum_of_magnitudes;

// Returns true if is_beyond() may prove anything about the hulls. A vertex found in a hull that is not scanned may not
// be the nearest one.
bool are_scanned(const PosedHulls& hulls) noexcept {
    return hulls.exponent() == 0 && hulls.is_scanned(0) && hulls.is_scanned(1);
}

// Returns true if the direction n, taken as a separating axis, proves that the solids are further apart than the limit.
// `gap` must be the difference of the nearest pair of vertices along n. Returns false unless are_scanned(), and if n is
// not a number or almost zero. n must be below 2^400.
//
// Derivation. Let u' = two_u and D = delta(), which is at least 4.25 u' sum (find_bounds), where
// `sum` bounds the magnitudes added up for any coordinate of a point, and |n|_1 the sum of the magnitudes of n. A
// vertex's height along n, in the mesh's coordinates, is off by at most (1 + u')^6 - 1 < 6.1 u' of sum |n|_1: less than
// 1.5 D |n|_1. So the vertex found is lower than the highest one by less than 3 D |n|_1, and its rounded point is off
// by D |n|_1 along n: for both solids together by less than 8 D |n|_1. The product of n and the difference of the two
// points is off by less than 5 u' of its terms' magnitudes S. 9 D and 8 u' also cover the rounding of the sums and of
// both products below; the root is off by less than 4 u'. Underflow in a product is below 2^-1022, and all of it below
// 2^-900. n is so large that underflow has no other effect, and a limit that is flushed to zero is below what 2^-900 /
// |n| leaves.
// Claim: verify/proofs/lines_and_times.py
bool is_beyond(const PosedHulls& hulls, const Point& n, const Point& gap, double limit) noexcept {
    if (!are_scanned(hulls) || !(largest(n) >= 0x1p-400)) return false;
    const double magnitudes = sum_of_magnitudes({n[0] * gap[0], n[1] * gap[1], n[2] * gap[2]});
    const double least = ((dot(n, gap) - 8 * two_u * magnitudes) - 9 * hulls.delta() * sum_of_magnitudes(n)) - 0x1p-900;
    return least > limit * (std::sqrt(dot(n, n)) * (1 + 8 * two_u));
}

// Returns true if the direction between the centers proves that the solids are further apart than the limit. `start`
// must be between_centers().
bool is_beyond(const PosedHulls& hulls, const Simplex& start, double limit) noexcept {
    return is_beyond(hulls, minus(hulls.center(1), hulls.center(0)), start.points[0], limit);
}

bool is_beyond_along(const PosedHulls& hulls, const Vec3& axis, double limit) noexcept {
    if (!are_scanned(hulls)) return false;
    const Point n{axis[0], axis[1], axis[2]};
    if (is_zero(axis)) return is_beyond(hulls, between_centers(hulls), limit);
    const Point p = hulls.rounded(0, hulls.support(0, n)), q = hulls.rounded(1, hulls.support(1, exact::negated(n)));
    return is_beyond(hulls, n, minus(q, p), limit);
}

// Returns the distance if it is at most the limit; otherwise nullopt. If the rounded distance equals the limit, the
// real distance may still exceed the limit; only then, the two are compared exactly.
std::optional<double> distance_within(PosedHulls& hulls, const std::optional<ClosestHulls>& closest, double limit) {
    if (!closest) return 0;
    const double distance = round_distance(hulls, closest->found);
    const std::int64_t key = key_of(distance), limit_key = key_of(limit);
    if (key > limit_key || (key == limit_key && compare_distance(hulls, closest->found, limit) > 0))
        return std::nullopt;
    return distance;
}

}  // namespace

bool is_regular(const Pose& pose) {
    return orientation(rows_of(pose, [](double r) { return r; }), pose) != Sign::zero;
}

SolidInMemory::SolidInMemory(const ConvexSolid& solid) noexcept
    : parts(&ConvexSolidAccess::points(solid)),
      points(ConvexSolidAccess::points(solid).groups.data()),
      point_count(ConvexSolidAccess::points(solid).groups.size()) {}

void SolidInMemory::prefetch_solid(const ConvexSolid* solid) noexcept {
    if (solid == nullptr) return;
    __builtin_prefetch(solid);
    __builtin_prefetch(reinterpret_cast<const char*>(solid + 1) - 1);
}
void SolidInMemory::prefetch_parts(const ConvexSolid& solid) noexcept {
    __builtin_prefetch(&ConvexSolidAccess::points(solid));
}

void SolidInMemory::prefetch() const noexcept {
    constexpr std::size_t line = 64, most = PosedHulls::scanned_max * 3 * sizeof(double);
    const char* const first = static_cast<const char*>(parts);
    for (std::size_t at = 0; at < sizeof(SupportPoints); at += line) __builtin_prefetch(first + at);
    const char* const numbers = reinterpret_cast<const char*>(points);
    for (std::size_t at = 0; at < std::min(most, point_count * sizeof(double)); at += line)
        __builtin_prefetch(numbers + at);
}

std::optional<double> distance_within(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, double limit,
                                      QueryMemory& memory) {
    PosedHulls hulls(a, b, memory);
    const Simplex start = between_centers(hulls);
    if (is_beyond(hulls, start, limit)) return std::nullopt;
    return distance_within(hulls, find_closest(hulls, start), limit);
}

double distance(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, QueryMemory& memory, PairWitness& witness) {
    PosedHulls hulls(a, b, memory);
    const auto closest = find_closest(hulls, &witness);
    return closest ? round_distance(hulls, closest->found) : 0;
}

double distance_beyond(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, const exact::ExactSum& margin,
                       QueryMemory& memory, PairWitness& witness) {
    PosedHulls hulls(a, b, memory);
    const auto closest = find_closest(hulls, &witness);
    return closest ? exact::round_beyond(square_of(hulls, closest->found), margin) : 0;
}

bool within(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, const exact::Limit& limit, QueryMemory& memory,
            PairWitness& witness) {
    PosedHulls hulls(a, b, memory);
    if (!is_known(witness) && is_beyond(hulls, between_centers(hulls), limit.sum.upper())) return false;
    const auto closest = find_closest(hulls, &witness);
    if (!closest) return true;
    if (!limit.is_strict && limit.sum.is_double())
        return distance_within(hulls, closest, limit.sum.lower()).has_value();
    return limit.holds(exact::compare(square_of(hulls, closest->found), limit.sum));
}

bool within(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, double limit, QueryMemory& memory,
            PairWitness& witness, Vec3& axis) {
    PosedHulls hulls(a, b, memory);
    if (is_beyond_along(hulls, axis, limit)) return false;
    const auto closest = find_closest(hulls, &witness);
    if (distance_within(hulls, closest, limit)) return true;
    axis = round_direction(hulls, closest->found);
    return false;
}

std::optional<ClosestPoints> closest(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, QueryMemory& memory,
                                     PairWitness& witness, const exact::Radii& radii) {
    PosedHulls hulls(a, b, memory);
    const auto closest = find_closest(hulls, &witness);
    if (!closest) return std::nullopt;
    return name_closest(hulls, *closest, radii);
}

bool do_meet(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, QueryMemory& memory) {
    PosedHulls hulls(a, b, memory);
    const Simplex start = between_centers(hulls);
    return !is_beyond(hulls, start, 0) && !find_closest(hulls, start);
}

}  // namespace ecods::convex
