#include "ecods/distance.hpp"

#include <ostream>

#include "base/limits.hpp"
#include "query/distance/distance_search.hpp"
#include "query/distance/least_distance.hpp"

namespace ecods {

std::ostream& operator<<(std::ostream& out, ClosestKind kind) {
    switch (kind) {
        case ClosestKind::vertex_vertex:
            return out << "vertex and vertex";
        case ClosestKind::vertex_edge:
            return out << "vertex and edge";
        case ClosestKind::vertex_face:
            return out << "vertex and face";
        case ClosestKind::edge_edge:
            return out << "edge and edge";
        case ClosestKind::intersecting:
            return out << "intersecting";
    }
    return out << "ClosestKind " << static_cast<int>(kind);
}

double distance(const Posed<MeshShape>& a, const Posed<MeshShape>& b, QueryMemory& memory, PairWitness& witness) {
    DistanceSearch search(a, b, memory);
    if (search.can_refer()) {
        const double result = search.find_distance(witness);
        witness = search.witness();
        return result;
    }
    search.run({}, witness);
    witness = search.witness();
    return search.is_zero() ? 0 : round_least(search, witness);
}

double distance(const Posed<MeshShape>& a, const Posed<MeshShape>& b, QueryMemory& memory) {
    PairWitness witness;
    return distance(a, b, memory, witness);
}

// By keys, in whose order a NaN lies beyond the infinities.
bool within(const Posed<MeshShape>& a, const Posed<MeshShape>& b, double d, QueryMemory& memory, PairWitness& witness) {
    require_distance(d);
    const std::int64_t key = key_of(d);
    if (key == infinity_key) return true;
    if (key == 0) return intersects(a, b, memory, witness);
    DistanceSearch search(a, b, memory);
    search.run({.at_most = d, .stop_at = d}, witness);
    if (search.witness().a != PairWitness::none) witness = search.witness();
    if (search.is_zero() || key_of(search.upper()) <= key) return true;
    if (is_least_within(search, d, witness)) return true;
    witness = apart_witness;
    return false;
}

bool within(const Posed<MeshShape>& a, const Posed<MeshShape>& b, double d, QueryMemory& memory) {
    PairWitness witness;
    return within(a, b, d, memory, witness);
}

}  // namespace ecods
