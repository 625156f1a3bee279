// Which meshes are worth to be made convex solids, which costs more than to be made solids.
#pragma once

#include <cstddef>
#include <vector>

#include "scenes/scene.hpp"

namespace ecods::clash {

// By mesh, not 0 where it may be convex and has a body in the scene that may share inner points with another such body:
// only then will its depth be asked. A mesh with a vertex that is beyond a plane by rounding alone may be left out.
std::vector<char> find_convex_candidates(const scenes::Scene& scene, std::size_t jobs);

}  // namespace ecods::clash
