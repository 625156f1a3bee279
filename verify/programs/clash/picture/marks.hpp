// What a picture has beside the parts: the places where they meet.
#pragma once

#include <vector>

#include "programs/clash/picture/scene.hpp"

namespace ecods::clash {

// Meshes with triangles of their own.
struct Marks {
    std::vector<Triangle> area_triangles;
    std::vector<Triangle> line_triangles;
    std::vector<Vec3> area_points;
    std::vector<Vec3> line_points;
};

// Patches, and lines and points that are `thickness` samples wide, as the camera sees them. All are a little nearer to
// the eye than the surfaces that they lie on.
Marks marks_of(const ClashScene& scene, const Camera& camera, std::size_t width, std::size_t height, double thickness);

}  // namespace ecods::clash
