#include "programs/clash/picture/scene.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "ecods/contact.hpp"
#include "ecods/intersection.hpp"

namespace ecods::clash {
namespace {

constexpr std::size_t context_parts = 150;
constexpr std::size_t context_triangles = 100'000;

PosedMesh posed(const Part& part, const Vec3& origin) {
    const Mesh& mesh = part.shape->mesh();
    PosedMesh result;
    result.points.reserve(mesh.vertices().size());
    const Vec3 shift = part.pose.t - origin;
    for (const Vec3& vertex : mesh.vertices()) result.points.push_back(part.pose.R * vertex + shift);
    result.triangles = mesh.triangles();
    result.is_solid = part.is_solid;
    return result;
}

bool is_gltf(std::string_view file) {
    return file.ends_with(".gltf") || file.ends_with(".glb") || file.ends_with(".GLTF") || file.ends_with(".GLB");
}

bool comes_before(const Line& a, const Line& b) {
    return std::lexicographical_compare(a[0].begin(), a[0].end(), b[0].begin(), b[0].end()) ||
           (a[0] == b[0] && std::lexicographical_compare(a[1].begin(), a[1].end(), b[1].begin(), b[1].end()));
}

// Where the parts' faces lie on each other: in the report's coordinates.
std::vector<Patch> patches_of(const Part& a, const Part& b) {
    QueryMemory memory;
    std::vector<Patch> patches;
    const Posed<MeshShape> posed_a(*a.shape, a.pose);
    const Posed<MeshShape> posed_b(*b.shape, b.pose);
    for (const TriangleIntersection& each : intersections(posed_a, posed_b, memory)) {
        if (each.shared.corner_count < 3) continue;
        patches.emplace_back(each.shared.corners().begin(), each.shared.corners().end());
    }
    return patches;
}

// The sides of patches, as Place has lines, ascending. A picture does without them: most are sides of triangles inside
// a larger face, and areas have their own contours in it.
std::vector<Line> sides_of(const std::vector<Patch>& patches) {
    std::vector<Line> sides;
    for (const Patch& patch : patches) {
        for (std::size_t i = 0; i < patch.size(); ++i) {
            const Line side{patch[i], patch[(i + 1) % patch.size()]};
            const Line reversed{side[1], side[0]};
            sides.push_back(comes_before(side, reversed) ? side : reversed);
        }
    }
    std::sort(sides.begin(), sides.end(), comes_before);
    return sides;
}

void add_contact(ClashScene& scene, const Clash& clash, const std::vector<Patch>& patches) {
    const std::vector<Line> sides = sides_of(patches);
    for (const Line& line : clash.place.lines) {
        if (!std::binary_search(sides.begin(), sides.end(), line, comes_before))
            scene.lines.push_back({line[0] - scene.origin, line[1] - scene.origin});
    }
    for (const Vec3& point : clash.place.points) scene.points.push_back(point - scene.origin);
    if (clash.kind == Kind::clearance && scene.points.size() == 2)
        scene.lines.push_back({scene.points[0], scene.points[1]});
    // What both solids fill is painted itself.
    if (scene.first.is_solid && scene.second.is_solid && clash.kind != Kind::touching) return;
    for (const Patch& patch : patches) {
        Patch& moved = scene.patches.emplace_back();
        for (const Vec3& corner : patch) moved.push_back(corner - scene.origin);
    }
}

// What a scene has beside its parts and their contact.
ClashScene empty_scene(const ClashReport& report, const Clash& clash) {
    ClashScene scene;
    scene.origin = clash.place.box.min / 2 + clash.place.box.max / 2;
    scene.kind = clash.kind;
    scene.is_first_within = clash.relation == "inside" || clash.kind == Kind::equal;
    scene.is_second_within = clash.relation == "contains" || clash.kind == Kind::equal;
    if (is_gltf(report.parts[clash.a].file) && is_gltf(report.parts[clash.b].file)) scene.vertical = Vec3::UnitY();
    scene.contact_box = corners_of({clash.place.box.min - scene.origin, clash.place.box.max - scene.origin});
    return scene;
}

double distance_to_box(const Aabb& box, const Vec3& point) {
    return (box.min - point).cwiseMax(point - box.max).cwiseMax(0.0).norm();
}

}  // namespace

std::vector<Aabb> part_boxes(const ClashReport& report) {
    std::vector<Aabb> boxes;
    boxes.reserve(report.parts.size());
    for (const Part& part : report.parts) boxes.push_back(part.shape->box(part.pose));
    return boxes;
}

ClashScene scene_of(const ClashReport& report, const Clash& clash) {
    const Part& a = report.parts[clash.a];
    const Part& b = report.parts[clash.b];
    ClashScene scene = empty_scene(report, clash);
    scene.first = posed(a, scene.origin);
    scene.second = posed(b, scene.origin);
    // Where more lines were found than are kept, there are more patches than a picture has use for.
    const bool has_all_lines = clash.place.line_count <= clash.place.lines.size();
    add_contact(scene, clash, has_all_lines ? patches_of(a, b) : std::vector<Patch>{});
    return scene;
}

ClashScene boxes_scene_of(const ClashReport& report, const Clash& clash) {
    ClashScene scene = empty_scene(report, clash);
    for (const auto& [part, mesh] : {std::pair(clash.a, &scene.first), std::pair(clash.b, &scene.second)}) {
        const Aabb box = report.parts[part].shape->box(report.parts[part].pose);
        const auto corners = corners_of({box.min - scene.origin, box.max - scene.origin});
        mesh->points.assign(corners.begin(), corners.end());
    }
    return scene;
}

void add_context(ClashScene& scene, const ClashReport& report, const Clash& clash, std::span<const Aabb> boxes,
                 double reach) {
    std::vector<std::pair<double, std::size_t>> near;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (i == clash.a || i == clash.b) continue;
        const double distance = distance_to_box(boxes[i], scene.origin);
        if (distance <= reach) near.emplace_back(distance, i);
    }
    std::sort(near.begin(), near.end());
    std::size_t triangles = 0;
    for (const auto& [distance, i] : near) {
        triangles += report.parts[i].shape->mesh().triangles().size();
        if (scene.context.size() == context_parts || triangles > context_triangles) return;
        scene.context.push_back(posed(report.parts[i], scene.origin));
    }
}

ScreenMesh on_screen(const PosedMesh& mesh, Layer layer, const Camera& camera, std::size_t width, std::size_t height) {
    ScreenMesh result;
    result.layer = layer;
    result.triangles = mesh.triangles;
    result.points.reserve(mesh.points.size());
    for (const Vec3& point : mesh.points) result.points.push_back(on_screen(point, camera, width, height));
    return result;
}

}  // namespace ecods::clash
