// This header gives the library access to a deforming mesh at both ends of its motion.
#pragma once

#include "ecods/cast.hpp"
#include "query/cast/mesh_at_ends.hpp"

namespace ecods {

struct DeformingAccess {
    // Return the surface at time 0, and the surface at times 0 and 1. The mesh must outlive the results.
    static const Posed<MeshShape>& at_start(const Deforming& mesh);
    static MeshAtEnds at_ends(const Deforming& mesh);
};

}  // namespace ecods
