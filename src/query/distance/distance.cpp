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

// Compares distances by their keys, in whose order NaN lies beyond the infinities.
bool surface::within(const Posed<MeshShape>& a, const Posed<MeshShape>& b, double max_distance, const Ask& ask) {
    const double d = max_distance;
    require_distance(d);
    const std::int64_t key = key_of(d);
    if (key == infinity_key) return true;
    if (key == 0) return surface::intersects(a, b, ask);
    Asking asking(ask);
    PairWitness& witness = asking.witness();
    DistanceSearch search(a, b, asking.memory());
    search.run({.at_most = d, .stop_at = d}, witness);
    DistanceSieve& sieve = search.sieve();
    const auto is_at_most = [&](const TrianglePair& pair) {
        return search.exact_pair().compare(pair.a, pair.b, d) <= 0;
    };
    const bool is_within = sieve.is_decided() || sieve.is_least_within(d, is_at_most);
    if (sieve.nearest().a != PairWitness::none) witness = sieve.nearest();
    if (is_within) return true;
    witness = apart_witness;
    return false;
}

}  // namespace ecods
