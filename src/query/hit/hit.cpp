#include "ecods/hit.hpp"

#include <ostream>

#include "ecods/error.hpp"

namespace ecods {

std::ostream& operator<<(std::ostream& out, HitKind kind) {
    switch (kind) {
        case HitKind::front:
            return out << "front";
        case HitKind::back:
            return out << "back";
        case HitKind::face:
            return out << "face";
        case HitKind::edge:
            return out << "edge";
        case HitKind::vertex:
            return out << "vertex";
        case HitKind::along:
            return out << "along";
    }
    return out;
}

// TODO(hits)
std::optional<Hit> first_hit(const Segment&, const Posed<MeshShape>&, QueryMemory&) {
    throw NotSupported("hits");
}
std::optional<Hit> first_hit(const Ray&, const Posed<MeshShape>&, QueryMemory&) {
    throw NotSupported("hits");
}
std::optional<Hit> first_hit(const Segment&, const Posed<MeshShape>&, QueryMemory&, PairWitness&) {
    throw NotSupported("hits");
}
std::optional<Hit> first_hit(const Ray&, const Posed<MeshShape>&, QueryMemory&, PairWitness&) {
    throw NotSupported("hits");
}
std::vector<Hit> all_hits(const Segment&, const Posed<MeshShape>&, QueryMemory&) {
    throw NotSupported("hits");
}
std::vector<Hit> all_hits(const Ray&, const Posed<MeshShape>&, QueryMemory&) {
    throw NotSupported("hits");
}

}  // namespace ecods
