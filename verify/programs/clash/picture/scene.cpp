#include "programs/clash/picture/scene.hpp"

#include <algorithm>
#include <string_view>

#include "ecods/distance.hpp"
#include "ecods/intersection.hpp"
#include "programs/clash/place.hpp"

namespace ecods::clash {
namespace {

constexpr std::size_t line_limit = 4000;  // more than a picture has use for
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

// Where the parts' faces lie on each other.
void add_patches(ClashScene& scene, const Part& a, const Part& b, QueryMemory& memory) {
    for (const TriangleIntersection& each : intersections(surface_of(a), surface_of(b), memory)) {
        if (each.shared.corner_count < 3) continue;
        Patch& patch = scene.patches.emplace_back();
        for (const Vec3& corner : each.shared.corners()) patch.push_back(corner - scene.origin);
    }
}

void add_contact(ClashScene& scene, const Part& a, const Part& b, const Clash& clash) {
    QueryMemory memory;
    const Place place = place_with_lines(a, b, {clash.kind, clash.relation, clash.distance}, line_limit, memory);
    scene.contact_box = corners_of({place.box.min - scene.origin, place.box.max - scene.origin});
    for (const Line& line : place.lines) scene.lines.push_back({line[0] - scene.origin, line[1] - scene.origin});
    for (const Vec3& point : place.points) scene.points.push_back(point - scene.origin);
    if (clash.kind == Kind::clearance && scene.points.size() == 2)
        scene.lines.push_back({scene.points[0], scene.points[1]});
    // What both solids fill is painted itself. Where there are more lines, so are patches.
    const bool is_filled = a.is_solid && b.is_solid && clash.kind != Kind::touching;
    if (!is_filled && place.line_count <= line_limit) add_patches(scene, a, b, memory);
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
    add_contact(scene, a, b, clash);
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
