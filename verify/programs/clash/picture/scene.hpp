// What a picture of a clash shows, in the coordinates of the report.
#pragma once

#include <span>
#include <vector>

#include "programs/clash/picture/camera.hpp"
#include "programs/clash/picture/fragments.hpp"
#include "programs/clash/report.hpp"

namespace ecods::clash {

// A part's mesh at its pose, relative to the scene's origin. Numbers are rounded: pictures are of pixels.
struct PosedMesh {
    std::vector<Vec3> points;
    std::span<const Triangle> triangles;
    bool is_solid = false;
};

// A polygon of contact: where a face of one part lies on a face of the other.
using Patch = std::vector<Vec3>;

// All points are relative to `origin`, which is near the contact: so far from the origin of the scene nothing is lost.
struct ClashScene {
    Vec3 origin = Vec3::Zero();
    PosedMesh first;
    PosedMesh second;
    std::vector<PosedMesh> context;
    std::vector<Patch> patches;
    std::vector<Line> lines;
    std::vector<Vec3> points;
    std::array<Vec3, 8> contact_box{};  // corners
    Kind kind = Kind::touching;
    bool is_first_within = false;  // the first part is a subset of the second
    bool is_second_within = false;
    Vec3 vertical = Vec3::UnitZ();  // what is upright: y in glTF files, elsewhere z
};

// The boxes of a report's parts, made once for all pictures.
std::vector<Aabb> part_boxes(const ClashReport& report);

// The scene without other parts.
ClashScene scene_of(const ClashReport& report, const Clash& clash);

// The same of the parts' boxes, without triangles: enough for a camera.
ClashScene boxes_scene_of(const ClashReport& report, const Clash& clash);

// Adds the other parts whose boxes come within `reach` of the middle of the contact: the nearest ones, as many as a
// picture has use for.
void add_context(ClashScene& scene, const ClashReport& report, const Clash& clash, std::span<const Aabb> boxes,
                 double reach);

// The meshes as the camera, whose target is relative to the origin, too, sees them.
ScreenMesh on_screen(const PosedMesh& mesh, Layer layer, const Camera& camera, std::size_t width, std::size_t height);

}  // namespace ecods::clash
