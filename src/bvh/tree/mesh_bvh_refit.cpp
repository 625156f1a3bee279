#include "bvh/tree/frame_box.hpp"
#include "bvh/tree/mesh_bvh.hpp"
#include "bvh/tree/moving_tree.hpp"
#include "bvh/tree/slabs.hpp"

namespace ecods {
namespace {

// If the cost grows by more than this factor, the tree is rebuilt. Rebuilding costs several times as much as refitting,
// and is worth it if many queries follow.
constexpr double cost_growth_max = 1.5;

double surface_of(double x, double y, double z) noexcept {
    return x * y + y * z + z * x;
}

}  // namespace

double tree_cost(const MeshBvh& tree) noexcept {
    double sum = 0;
    for (const BvhNode& node : tree.nodes) {
        for (std::size_t lane = 0; lane < node.count; ++lane) {
            sum += surface_of(static_cast<double>(node.half[0][lane]), static_cast<double>(node.half[1][lane]),
                              static_cast<double>(node.half[2][lane]));
        }
    }
    const auto& half = tree.root_half;
    return sum / surface_of(static_cast<double>(half[0]), static_cast<double>(half[1]), static_cast<double>(half[2]));
}

// Computes boxes from the last node to the first. Parents come before their children, so each box is computed before it
// is read.
MeshBvh with_other_vertices(const MeshBvh& tree, const Mesh& mesh) {
    MeshBvh result = tree;
    result.frame = refit_frame(tree.frame, mesh);
    std::vector<FrameBox> node_boxes(result.nodes.size()), leaf_boxes(result.leaves.size());
    for (std::size_t i = 0; i < result.leaves.size(); ++i) {
        for (const std::uint32_t triangle : result.leaves[i].triangle) {
            leaf_boxes[i].include(box_of(mesh, mesh.triangles()[triangle], result.frame));
        }
    }
    const auto box_at = [&](TreeRef ref) -> const FrameBox& {
        return (ref.is_leaf() ? leaf_boxes : node_boxes)[ref.index()];
    };
    for (std::size_t i = result.nodes.size(); i-- > 0;) {
        BvhNode& node = result.nodes[i];
        for (std::size_t lane = 0; lane < tree_width; ++lane) {
            const FrameBox& box = box_at(node.child[std::min<std::size_t>(lane, node.count - 1)]);
            set_lane(node, lane, box);
            node_boxes[i].include(box);
        }
    }
    set_corners_and_slabs(result, mesh);
    set_root(result, box_at(result.root));
    return result;
}

MeshBvh refit_mesh_bvh(const MeshBvh& tree, const Mesh& mesh) {
    MeshBvh result = with_other_vertices(tree, mesh);
    // If boxes are infinite, the cost is NaN and the comparison false: then the tree is kept.
    if (tree_cost(result) > cost_growth_max * result.built_cost) return build_mesh_bvh(mesh, fit_frame(mesh));
    return result;
}

}  // namespace ecods
