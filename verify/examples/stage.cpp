#include "examples/stage.hpp"

#include <fmt/core.h>

#include <fstream>
#include <stdexcept>

namespace ecods::examples {
namespace {

std::string text(const Vec3& v) {
    return fmt::format("<{:.9g},{:.9g},{:.9g}>", v.x(), v.y(), v.z());
}

std::string text(const Paint& paint) {
    return fmt::format(
        "texture {{ pigment {{ rgbt <{:.3g},{:.3g},{:.3g},{:.3g}> }} "
        "finish {{ ambient 0.2 diffuse 0.7 specular 0.2 roughness 0.03 }} }}",
        paint.red, paint.green, paint.blue, paint.transparency);
}

}  // namespace

Stage::Stage(const Vec3& eye, const Vec3& target, double angle) {
    // POV-Ray's axes are left-handed; a negative `right` makes them right-handed.
    text_ = fmt::format(
        "#version 3.7;\nglobal_settings {{ assumed_gamma 1.0 max_trace_level 32 }}\nbackground {{ rgb 0.95 }}\n"
        "camera {{ location {0} sky z up z right -x*image_width/image_height angle {1} look_at {2} }}\n",
        text(eye), angle, text(target));
    const Vec3 forward = target - eye;
    const Vec3 left = Vec3::UnitZ().cross(forward).normalized();
    const Vec3 lamp = eye + forward.norm() * (0.6 * left + 0.8 * Vec3::UnitZ());
    text_ += fmt::format("light_source {{ {} rgb 0.8 }}\nlight_source {{ {} rgb 0.4 shadowless }}\n", text(lamp),
                         text(eye - forward.norm() * left));
}

void Stage::add(const Mesh& mesh, const Pose& pose, const Paint& paint) {
    const auto [place, is_new] = meshes_.try_emplace(&mesh, meshes_.size());
    if (is_new) {
        text_ += fmt::format("#declare Mesh{} = mesh2 {{ vertex_vectors {{ {}", place->second, mesh.vertices().size());
        for (const Vec3& v : mesh.vertices()) text_ += fmt::format(",{}", text(v));
        text_ += fmt::format(" }}\nface_indices {{ {}", mesh.triangles().size());
        for (const Triangle& t : mesh.triangles()) text_ += fmt::format(",<{},{},{}>", t[0], t[1], t[2]);
        text_ += " } }\n";
    }
    text_ += fmt::format("object {{ Mesh{} {} matrix <", place->second, text(paint));
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) text_ += fmt::format("{:.9g},", pose.R(row, column));
    text_ += fmt::format("{:.9g},{:.9g},{:.9g}> }}\n", pose.t.x(), pose.t.y(), pose.t.z());
}

void Stage::add_segment(const Vec3& from, const Vec3& to, double radius, const Paint& paint) {
    if (from == to) return;
    text_ += fmt::format("cylinder {{ {}, {}, {:.9g} {} no_shadow }}\n", text(from), text(to), radius, text(paint));
}

void Stage::add_ball(const Vec3& center, double radius, const Paint& paint) {
    text_ += fmt::format("sphere {{ {}, {:.9g} {} }}\n", text(center), radius, text(paint));
}

void Stage::write(const std::string& file) const {
    std::ofstream out(file);
    out << text_;
    if (!out.flush()) throw std::runtime_error("cannot write " + file);
}

}  // namespace ecods::examples
