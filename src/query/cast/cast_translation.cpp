#include "ecods/cast.hpp"
#include "ecods/error.hpp"

namespace ecods {

// TODO(slide)
std::optional<FirstContact> cast(const Posed<MeshShape>&, const Vec3&, const Posed<MeshShape>&, QueryMemory&) {
    throw NotSupported("cast");
}
std::optional<FirstContact> cast(const Posed<MeshShape>&, const Vec3&, const Posed<MeshShape>&, QueryMemory&,
                                 PairWitness&) {
    throw NotSupported("cast");
}

}  // namespace ecods
