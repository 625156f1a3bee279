#include "ecods/distance.hpp"

#include "base/limits.hpp"
#include "base/write_name.hpp"
#include "query/distance/distance_search.hpp"

namespace ecods {

std::ostream& operator<<(std::ostream& out, ClosestKind kind) {
    constexpr std::array names{"vertex and vertex", "vertex and edge", "vertex and face", "edge and edge",
                               "intersecting"};
    return write_name(out, kind, names);
}

double distance(const Posed<MeshShape>& a, const Posed<MeshShape>& b, QueryMemory& memory, PairWitness& witness) {
    DistanceSearch search(a, b, memory);
    const double result = search.find_distance(witness);
    witness = search.sieve().nearest();
    return result;
}

double distance(const Posed<MeshShape>& a, const Posed<MeshShape>& b, QueryMemory& memory) {
    PairWitness witness;
    return distance(a, b, memory, witness);
}

// Compares keys, in whose order NaN lies beyond the infinities.
bool within(const Posed<MeshShape>& a, const Posed<MeshShape>& b, double d, QueryMemory& memory, PairWitness& witness) {
    require_distance(d);
    const std::int64_t key = key_of(d);
    if (key == infinity_key) return true;
    if (key == 0) return intersects(a, b, memory, witness);
    DistanceSearch search(a, b, memory);
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

bool within(const Posed<MeshShape>& a, const Posed<MeshShape>& b, double d, QueryMemory& memory) {
    PairWitness witness;
    return within(a, b, d, memory, witness);
}

}  // namespace ecods
