// The true first contact of two meshes of which one turns. The oracle is asked about each pair of triangles that may
// meet by then: it would take hours about all pairs of large meshes.
#pragma once

#include <optional>

#include "ecods/turn.hpp"

namespace ecods::bench {

// `claimed` is a time up to which pairs are looked for first, or none. The answer does not depend on it.
std::optional<FirstContact> true_contact(const Turning<MeshShape>& a, const Posed<MeshShape>& b,
                                         std::optional<double> claimed);

}  // namespace ecods::bench
