#include "base/limits.hpp"
#include "exact/measure/round/distance_beyond.hpp"
#include "query/distance/distance_search.hpp"
#include "query/distance/surface_distance.hpp"
#include "query/intersection/asking.hpp"
#include "query/intersection/surface_intersection.hpp"

namespace ecods {
namespace {

// Returns a pair of triangles with the least real distance, as closest() finds it. Comparing rounded distances does not
// suffice here: if the difference D - margin of a distance D cancels, it has digits that the rounded D has not.
TrianglePair find_nearest(DistanceSearch& search, PairWitness& witness) {
    const auto& open = search.sieve().keep_least(
        [&](const TrianglePair& x, const TrianglePair& y) { return search.exact_pair().compare(x, y); });
    const TrianglePair nearest = open.front().triangles;
    witness = {nearest.a, nearest.b};
    return nearest;
}

}  // namespace

double surface::distance(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const Ask& ask) {
    Asking asking(ask);
    DistanceSearch search(a, b, asking.memory());
    const double result = search.find_distance(asking.witness());
    asking.witness() = search.sieve().nearest();
    return result;
}

double surface::distance_beyond(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const exact::ExactSum& margin,
                                const Ask& ask) {
    Asking asking(ask);
    DistanceSearch search(a, b, asking.memory());
    search.run({.stop_at = margin.lower()}, asking.witness());
    const DistanceSieve& sieve = search.sieve();
    if (sieve.nearest().a != PairWitness::none) asking.witness() = sieve.nearest();
    if (sieve.is_decided()) return 0;
    return search.exact_pair().distance_beyond(find_nearest(search, asking.witness()), margin);
}

double surface::signed_beyond(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const exact::ExactSum& margin,
                              const Ask& ask) {
    Asking asking(ask);
    DistanceSearch search(a, b, asking.memory());
    search.run({}, asking.witness());
    const DistanceSieve& sieve = search.sieve();
    if (sieve.is_zero()) {
        if (sieve.nearest().a != PairWitness::none) asking.witness() = sieve.nearest();
        return exact::round_signed_beyond({}, margin);
    }
    return search.exact_pair().signed_beyond(find_nearest(search, asking.witness()), margin);
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
