#include "base/limits.hpp"
#include "query/distance/distance_search.hpp"
#include "query/distance/surface_distance.hpp"
#include "query/intersection/asking.hpp"
#include "query/intersection/surface_intersection.hpp"

namespace ecods {

double surface::distance(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const Ask& ask) {
    Asking asking(ask);
    DistanceSearch search(a, b, asking.memory());
    const double result = search.find_distance(asking.witness());
    asking.witness() = search.sieve().nearest();
    return result;
}

// The order of D less the margin is that of D. It is that of the real distances: under cancellation, D less the margin
// has digits that the rounded D has not. So pairs with the least real distance are found, as in closest().
double surface::distance_beyond(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const exact::ExactSum& margin,
                                const Ask& ask) {
    Asking asking(ask);
    DistanceSearch search(a, b, asking.memory());
    search.run({.stop_at = margin.lower()}, asking.witness());
    DistanceSieve& sieve = search.sieve();
    if (sieve.nearest().a != PairWitness::none) asking.witness() = sieve.nearest();
    if (sieve.is_decided()) return 0;
    const auto& open = sieve.keep_least(
        [&](const TrianglePair& x, const TrianglePair& y) { return search.exact_pair().compare(x, y); });
    const TrianglePair nearest = open.front().triangles;
    asking.witness() = {nearest.a, nearest.b};
    return search.exact_pair().distance_beyond(nearest, margin);
}

bool surface::within(const Posed<MeshShape>& a, const Posed<MeshShape>& b, double max_distance, const Ask& ask) {
    require_distance(max_distance);
    if (key_of(max_distance) == infinity_key) return true;
    return within(a, b, exact::Limit{max_distance}, ask);
}

bool surface::within(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const exact::Limit& limit, const Ask& ask) {
    if (limit.sum.sign() == 0) return !limit.is_strict && surface::intersects(a, b, ask);
    Asking asking(ask);
    PairWitness& witness = asking.witness();
    DistanceSearch search(a, b, asking.memory());
    const double d = limit.greatest();
    search.run({.at_most = limit.sum.upper(), .stop_at = d}, witness);
    DistanceSieve& sieve = search.sieve();
    const auto is_at_most = [&](const TrianglePair& pair) {
        return limit.holds(search.exact_pair().compare(pair, limit.sum));
    };
    const bool is_within = sieve.is_decided() || sieve.is_least_within(d, is_at_most);
    if (sieve.nearest().a != PairWitness::none) witness = sieve.nearest();
    if (is_within) return true;
    witness = apart_witness;
    return false;
}

}  // namespace ecods
