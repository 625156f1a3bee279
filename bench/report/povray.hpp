// Pictures of scenes, drawn by POV-Ray from the exact poses.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "ecods/pose.hpp"
#include "report/page.hpp"
#include "scenes/scene.hpp"

namespace ecods::bench {

// Casing: cut open along the plane y = 0, so that what is inside can be seen.
enum class Paint { plain, casing, touching, crossing };

struct PaintedBody {
    Pose pose;
    Paint paint = Paint::plain;
    std::map<std::uint32_t, Paint> triangles;  // those that are painted otherwise
};

struct View {
    std::string name;  // of the files
    Vec3 eye;
    Vec3 target;
    double angle = 40;          // degrees, across
    double room_half_side = 0;  // when positive, a room with open front walls is drawn about the origin
    int width = 1200;
    int height = 800;
};

// Writes NAME.pov and NAME.png into the folder. `bodies` are those of the scene, in its order.
Picture draw(const scenes::Scene& scene, const std::vector<PaintedBody>& bodies, const View& view,
             const std::filesystem::path& folder, const std::string& caption);

// All bodies as they are after so many frames, plain.
std::vector<PaintedBody> bodies_at(const scenes::Scene& scene, std::size_t frame);

}  // namespace ecods::bench
