#include "report/povray.hpp"

#include <fmt/core.h>

#include <Eigen/Geometry>

#include <array>
#include <fstream>

#include "process/program.hpp"

namespace ecods::bench {

namespace {

// All numbers with 17 digits: the picture shows the poses that were tested.
std::string number(double x) {
    return fmt::format("{:.17g}", x);
}
std::string vector(const Vec3& v) {
    return fmt::format("<{},{},{}>", number(v.x()), number(v.y()), number(v.z()));
}

// POV-Ray's y is up and its axes are left-handed; `sky` and a negative `right` give z up and right-handed axes.
void write_camera(std::ostream& out, const View& view) {
    out << "#version 3.7;\nglobal_settings { assumed_gamma 1.0 max_trace_level 24 }\n"
        << "background { rgb <0.93,0.94,0.96> }\n"
        << fmt::format("camera {{ location {} sky z up z right -x*image_width/image_height angle {} look_at {} }}\n",
                       vector(view.eye), view.angle, vector(view.target));
    // The lamp stands high on the left of the eye, its shadows fall on the floor; a second one lightens them.
    const Vec3 forward = view.target - view.eye;
    const double distance = forward.norm();
    const Vec3 left = Vec3::UnitZ().cross(forward).normalized();
    const Vec3 lamp = view.target - 0.35 * forward + distance * (0.3 * left + 1.1 * Vec3::UnitZ());
    out << fmt::format("light_source {{ {} rgb 0.7 }}\n", vector(lamp))
        << fmt::format("light_source {{ {} rgb 0.55 shadowless }}\n", vector(view.eye - 0.5 * distance * left));
}

void write_paints(std::ostream& out) {
    out << "#declare Gloss = finish { ambient 0.16 diffuse 0.72 specular 0.25 roughness 0.03 }\n"
        << "#declare Plain = texture { pigment { rgb <0.36,0.42,0.50> } finish { Gloss } }\n"
        << "#declare Casing = texture { pigment { rgb <0.62,0.66,0.70> } finish { Gloss } }\n"
        << "#declare Touching = texture { pigment { rgb <0.10,0.36,0.74> } finish { Gloss } }\n"
        << "#declare Crossing = texture { pigment { rgb <0.93,0.30,0.05> } finish { Gloss } }\n";
}

const char* name_of(Paint paint) {
    switch (paint) {
        case Paint::plain:
            return "Plain";
        case Paint::casing:
            return "Casing";
        case Paint::touching:
            return "Touching";
        case Paint::crossing:
            return "Crossing";
    }
    return "Plain";
}

// A floor, the two walls that face the eye, and all edges but the three of the corner nearest to it.
void write_room(std::ostream& out, const View& view) {
    const double h = view.room_half_side;
    const double thickness = h * 0.004;
    out << "#declare Edge = texture { pigment { rgb <0.25,0.28,0.33> } finish { ambient 0.3 diffuse 0.6 } }\n"
        << fmt::format(
               "#declare Tiles = texture {{ pigment {{ checker rgb <0.80,0.81,0.83>, rgb <0.88,0.89,0.90> "
               "scale {} }} finish {{ ambient 0.15 diffuse 0.8 }} }}\n",
               number(h / 4))
        << "#declare Wall = texture { pigment { rgb <0.80,0.84,0.90> } finish { ambient 0.25 diffuse 0.6 } }\n";
    const auto corner = [&](int i) { return Vec3(i & 1 ? h : -h, i & 2 ? h : -h, i & 4 ? h : -h); };
    const int near_corner = (view.eye.x() > 0 ? 1 : 0) | (view.eye.y() > 0 ? 2 : 0) | (view.eye.z() > 0 ? 4 : 0);
    out << "union {\n";
    for (int i = 0; i < 8; ++i) {
        for (const int bit : {1, 2, 4}) {
            if ((i & bit) == 0 && i != near_corner && (i | bit) != near_corner)
                out << fmt::format("  cylinder {{ {}, {}, {} }}\n", vector(corner(i)), vector(corner(i | bit)),
                                   number(thickness));
        }
        if (i != near_corner) out << fmt::format("  sphere {{ {}, {} }}\n", vector(corner(i)), number(thickness));
    }
    out << "  texture { Edge } no_shadow }\n";
    const auto wall = [&](int axis, double side, const char* texture) {
        Vec3 low = Vec3::Constant(-h), high = Vec3::Constant(h);
        low[axis] = side * h;
        high[axis] = side * (h + thickness);
        if (side < 0) std::swap(low, high);
        out << fmt::format("box {{ {}, {} texture {{ {} }} no_shadow }}\n", vector(low.cwiseMin(high)),
                           vector(low.cwiseMax(high)), texture);
    };
    wall(2, -1, "Tiles");
    for (const int axis : {0, 1}) wall(axis, view.eye[axis] > 0 ? -1 : 1, "Wall");
}

void write_vertices(std::ostream& out, const Mesh& mesh) {
    out << fmt::format("mesh2 {{ vertex_vectors {{ {}", mesh.vertices().size());
    for (const Vec3& v : mesh.vertices()) out << ",\n" << vector(v);
    out << " }\n";
}

// Bodies that are painted in one colour share this.
void write_mesh(std::ostream& out, std::size_t mesh_index, const Mesh& mesh) {
    out << fmt::format("#declare Mesh{} = ", mesh_index);
    write_vertices(out, mesh);
    out << fmt::format("face_indices {{ {}", mesh.triangles().size());
    for (const Triangle& t : mesh.triangles()) out << fmt::format(",\n<{},{},{}>", t[0], t[1], t[2]);
    out << " } }\n";
}

void write_painted_mesh(std::ostream& out, const Mesh& mesh, const PaintedBody& body) {
    write_vertices(out, mesh);
    constexpr std::array<Paint, 4> paints = {Paint::plain, Paint::casing, Paint::touching, Paint::crossing};
    out << "texture_list { 4";
    for (const Paint paint : paints) out << fmt::format(", texture {{ {} }}", name_of(paint));
    out << fmt::format(" }}\nface_indices {{ {}", mesh.triangles().size());
    for (std::size_t i = 0; i < mesh.triangles().size(); ++i) {
        const Triangle& t = mesh.triangles()[i];
        const auto painted = body.triangles.find(static_cast<std::uint32_t>(i));
        const Paint paint = painted == body.triangles.end() ? body.paint : painted->second;
        out << fmt::format(",\n<{},{},{}>,{}", t[0], t[1], t[2], static_cast<int>(paint));
    }
    out << " }";
}

void write_body(std::ostream& out, const scenes::Scene& scene, std::size_t index, const PaintedBody& body) {
    const std::size_t mesh_index = scene.bodies[index].mesh_index;
    if (body.triangles.empty()) {
        out << fmt::format("object {{ Mesh{} texture {{ {} }}", mesh_index, name_of(body.paint));
    } else {
        write_painted_mesh(out, *scene.meshes[mesh_index].mesh, body);
    }
    out << " matrix <";
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) out << number(body.pose.R(row, column)) << ",";
    out << fmt::format("{},{},{}>{} }}\n", number(body.pose.t.x()), number(body.pose.t.y()), number(body.pose.t.z()),
                       body.paint == Paint::casing ? " clipped_by { plane { y, 0 } }" : "");
}

}  // namespace

std::vector<PaintedBody> bodies_at(const scenes::Scene& scene, std::size_t frame) {
    std::vector<PaintedBody> bodies;
    for (const scenes::SceneBody& body : scene.bodies) bodies.push_back({body.pose, Paint::plain, {}});
    for (std::size_t f = 0; f < frame; ++f)
        for (const scenes::Move& move : scene.frames[f].moves) bodies[move.body_index].pose = move.pose;
    return bodies;
}

Picture draw(const scenes::Scene& scene, const std::vector<PaintedBody>& bodies, const View& view,
             const std::filesystem::path& folder, const std::string& caption) {
    const std::filesystem::path script = folder / (view.name + ".pov");
    const std::filesystem::path picture = folder / (view.name + ".png");
    std::ofstream out(script);
    write_camera(out, view);
    write_paints(out);
    if (view.room_half_side > 0) write_room(out, view);
    for (std::size_t m = 0; m < scene.meshes.size(); ++m) write_mesh(out, m, *scene.meshes[m].mesh);
    for (std::size_t i = 0; i < bodies.size(); ++i) write_body(out, scene, i, bodies[i]);
    out.close();
    if (!out) return {picture, caption, "cannot write " + script.string()};

    std::filesystem::remove(picture);
    const process::ProgramResult result = process::run_program(
        {"povray", "+I" + script.string(), "+O" + picture.string(), "+FN", fmt::format("+W{}", view.width),
         fmt::format("+H{}", view.height), "+A0.2", "+R2", "-D", "-GA"});
    const bool is_made = result.status == 0 && std::filesystem::exists(picture);
    return {picture, caption, is_made ? "" : "POV-Ray failed: " + result.text()};
}

}  // namespace ecods::bench
