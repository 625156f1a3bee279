#include "ecods/cast.hpp"
#include "ecods/error.hpp"

namespace ecods {

// TODO(moving)
std::optional<FirstContact> cast(const Moving<MeshShape>&, const Moving<MeshShape>&, QueryMemory&) {
    throw NotSupported("cast");
}
std::optional<FirstContact> cast(const Moving<MeshShape>&, const Moving<MeshShape>&, QueryMemory&, PairWitness&) {
    throw NotSupported("cast");
}

}  // namespace ecods
