// Meshes and skins of glTF; for gltf_*.cpp only.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "ecods/pose.hpp"
#include "scenes/io/gltf_accessor.hpp"
#include "scenes/io/gltf_model.hpp"
#include "scenes/io/mesh_soup.hpp"

namespace ecods::scenes {

// The poses that the joints of a skin give to the mesh, by joint: of its node, behind the inverse bind matrix. Throws
// ReadError for a joint that is not in the scene.
std::vector<Pose> joint_poses(GltfModel& model, const JsonPlace& skin, std::span<const std::optional<Pose>> nodes);

// Vertices of a primitive as the joints of a skin place them.
class GltfSkinning {
  public:
    GltfSkinning(GltfModel& model, const JsonPlace& attributes, std::span<const Pose> joints);

    // With x_j the image of the vertex under joint j and w_j its weight, over the joints of weight not 0 and in the
    // file's order: x_1 + (sum of w_j (x_j - x_1)) / (sum of w_j), in double precision. So a vertex is exactly
    // where its joints say if these agree, whatever rounding did to the weights.
    Vec3 operator()(std::size_t vertex, const Vec3& position) const;

    std::size_t set_count() const noexcept { return sets_.size(); }

  private:
    struct Set {  // of four joints and weights
        JsonPlace joints_place, weights_place;
        GltfElements joints, weights;
    };
    JsonPlace attributes_;
    std::span<const Pose> joints_;
    std::vector<Set> sets_;
};

// The triangles of a mesh and the vertices that they use: in the order of the file, each once where primitives name the
// same accessor. Primitives of points and lines are passed over. With joints, vertices are placed by them.
MeshSoup read_primitives(GltfModel& model, const JsonPlace& mesh, const std::vector<Pose>* joints);

// True if the primitive is points or lines. Throws ReadError for a mode that does not exist.
bool is_points_or_lines(const JsonPlace& primitive);

// A geometry holds the numbers that the primitives of a mesh name: meshes of one geometry have equal triangles and
// vertices where there is no skin.
using GltfGeometry = std::vector<std::uint32_t>;
GltfGeometry geometry_of(const JsonPlace& mesh);

}  // namespace ecods::scenes
