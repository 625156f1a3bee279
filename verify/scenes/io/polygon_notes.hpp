// Notes tell of the polygons of a scene's files.
#pragma once

#include <filesystem>

#include "scenes/polygon/polygon_counts.hpp"
#include "scenes/scene.hpp"

namespace ecods::scenes {

// Keeps the counts if some polygon was not cut into a fan, or is in no plane. There is a note if one was not cut into a
// fan: corners that rounding moved out of a plane are too common for one.
void add_polygon_counts(const std::filesystem::path& file, const PolygonCounts& counts, Scene& scene);

}  // namespace ecods::scenes
