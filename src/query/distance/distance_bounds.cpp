#include <algorithm>
#include <limits>

#include "base/limits.hpp"
#include "base/next.hpp"
#include "query/distance/distance_search.hpp"
#include "query/distance/surface_distance.hpp"
#include "query/intersection/asking.hpp"

namespace ecods {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double double_max = std::numeric_limits<double>::max();

double least(double x, double y) {
    return key_of(x) < key_of(y) ? x : y;
}

// Returns the adjacent doubles around the least distance, or the distance twice if it is a double. Unrounded distances
// of several pairs may lie on both sides of the double to which they round. So each open pair is compared with this
// double, unless the pair's lower bound suffices.
DistanceBounds adjacent_bounds(DistanceSearch& search, PairWitness& witness) {
    const double rounded = search.round_least();
    witness = search.sieve().nearest();
    if (rounded == infinity) return {double_max, infinity};
    int sign = search.exact_pair().compare(witness.a, witness.b, rounded);
    for (const DistanceSieve::Open& open : search.sieve().open()) {
        if (sign < 0) break;
        if (key_of(open.interval.lower) >= key_of(rounded)) continue;
        sign = std::min(sign, search.exact_pair().compare(open.triangles.a, open.triangles.b, rounded));
    }
    if (sign == 0) return {rounded, rounded};
    return sign > 0 ? DistanceBounds{rounded, next_up(rounded)} : DistanceBounds{next_down(rounded), rounded};
}

// Returns the bounds that follow from the intervals. Pairs that the search dropped have distances above the floor or
// above at_most.
DistanceBounds enclosed_bounds(DistanceSearch& search, double at_most) {
    double lower = least(search.sieve().floor(), at_most);
    for (const DistanceSieve::Open& open : search.sieve().open()) lower = least(lower, open.interval.lower);
    return {lower, search.sieve().upper()};
}

}  // namespace

// The difference and each product have a relative error of at most u' = 2^-52.
// Claim: verify/proofs/small_bounds.py
bool surface::is_narrow(const DistanceBounds& bounds, const DistanceTolerance& tolerance) {
    if (key_of(bounds.upper) - key_of(bounds.lower) <= 1) return true;
    if (key_of(bounds.upper) == key_of(infinity)) return false;
    const double width = (bounds.upper - bounds.lower) * (1 + 4 * 0x1p-52);
    if (!(width >= std::numeric_limits<double>::min())) return false;  // the difference may have been flushed to zero
    return width <= std::max(tolerance.absolute, tolerance.relative * bounds.lower);
}

DistanceBounds surface::distance_bounds(const Posed<MeshShape>& a, const Posed<MeshShape>& b,
                                        const DistanceTolerance& tolerance, const Ask& ask) {
    require_valid(tolerance);
    Asking asking(ask);
    QueryMemory& memory = asking.memory();
    PairWitness& witness = asking.witness();
    // The search may drop pairs whose distances exceed `limit`. If all pairs are dropped, the lower bound is above
    // max_distance, because `limit` is.
    const double limit = next_up(tolerance.max_distance);
    {
        DistanceSearch search(a, b, memory);
        search.run({.at_most = limit,
                    .relative = least(tolerance.relative, double_max),
                    .absolute = least(tolerance.absolute, double_max)},
                   witness);
        if (search.sieve().nearest().a != PairWitness::none) witness = search.sieve().nearest();
        if (search.sieve().is_zero()) return {0, 0};
        const DistanceBounds bounds = enclosed_bounds(search, limit);
        if (key_of(bounds.lower) > key_of(tolerance.max_distance)) return bounds;
        if (is_narrow(bounds, tolerance)) return bounds;
    }
    DistanceSearch search(a, b, memory);
    search.run({.at_most = limit}, witness);
    if (search.sieve().is_zero()) return {0, 0};
    if (search.sieve().open().empty()) return {limit, infinity};
    const DistanceBounds bounds = adjacent_bounds(search, witness);
    // A pair that was dropped may be nearer than the nearest open pair. If the nearest open pair is beyond the limit,
    // so is the dropped pair.
    if (key_of(bounds.lower) > key_of(limit)) return {limit, infinity};
    return bounds;
}

}  // namespace ecods
