#include "bvh/slabs.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include "base/outward.hpp"

namespace ecods {
namespace {

Vec3 corner_of(const TreeLeaf& leaf, std::size_t lane, std::size_t corner) {
    const auto& c = leaf.corner[corner];
    return {static_cast<double>(c[0][lane]), static_cast<double>(c[1][lane]), static_cast<double>(c[2][lane])};
}

void set_vertices(TreeLeaf& leaf, const Mesh& mesh, const LocalFrame& frame) {
    for (std::size_t lane = 0; lane < tree_width; ++lane) {
        leaf.vertices[lane] = mesh.triangles()[leaf.triangle[lane]];
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const Vec3& v = mesh.vertices()[leaf.vertices[lane][corner]];
            // A frame without bounds has no coordinates, and none is read.
            const Vec3 y = frame.is_bounded ? frame.coordinates(v) : Vec3(0, 0, 0);
            for (std::size_t k = 0; k < 3; ++k) {
                leaf.corner[corner][k][lane] = round_to_nearest(y[static_cast<Eigen::Index>(k)]);
            }
        }
    }
}

// Twice the area of the leaf's triangles along their normals.
Vec3 area_of(const TreeLeaf& leaf) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t lane = 0; lane < leaf.count; ++lane) {
        const Vec3 a = corner_of(leaf, lane, 0);
        sum += (corner_of(leaf, lane, 1) - a).cross(corner_of(leaf, lane, 2) - a);
    }
    return sum;
}

// A slab along `area` that contains the triangles of the leaves; any normal is sound. Its products with corners are off
// by 3.01 u' sum |normal| |y| <= 3.01 u' sqrt(3) (1 + 2^-22), and by corner_error sum |normal| for the corners
// themselves: below 2 corner_error.
Slab slab_of(std::span<const TreeLeaf> leaves, const Vec3& area) {
    const double length = area.norm();
    Slab slab{};
    if (length > 0) {
        for (std::size_t k = 0; k < 3; ++k) {
            slab.normal[k] = round_to_nearest(area[static_cast<Eigen::Index>(k)] / length);
        }
    }
    const auto& n = slab.normal;
    const double x = static_cast<double>(n[0]), y = static_cast<double>(n[1]), z = static_cast<double>(n[2]);
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const TreeLeaf& leaf : leaves) {
        for (const auto& c : leaf.corner) {
            for (std::size_t lane = 0; lane < tree_width; ++lane) {
                const double at = (x * static_cast<double>(c[0][lane]) + y * static_cast<double>(c[1][lane])) +
                                  z * static_cast<double>(c[2][lane]);
                low = std::min(low, at);
                high = std::max(high, at);
            }
        }
    }
    slab.low = round_down(low - 2 * corner_error);
    slab.high = round_up(high + 2 * corner_error);
    return slab;
}

// The leaves below a node, which are neighbours in the tree's list, and the sum of their areas.
struct LeafRange {
    std::size_t begin, end;
    Vec3 area;
};

}  // namespace

void set_corners_and_slabs(MeshBvh& tree, const Mesh& mesh) {
    const std::span<const TreeLeaf> leaves = tree.leaves;
    std::vector<Vec3> areas;
    areas.reserve(leaves.size());
    for (TreeLeaf& leaf : tree.leaves) {
        set_vertices(leaf, mesh, tree.frame);
        areas.push_back(area_of(leaf));
        leaf.slab = slab_of({&leaf, 1}, areas.back());
    }
    std::vector<LeafRange> ranges(tree.nodes.size());
    for (std::size_t i = tree.nodes.size(); i-- > 0;) {
        BvhNode& node = tree.nodes[i];
        const auto range_of = [&](TreeRef ref) {
            const std::size_t index = ref.index();
            return ref.is_leaf() ? LeafRange{index, index + 1, areas[index]} : ranges[index];
        };
        ranges[i] = range_of(node.child[0]);
        for (std::size_t lane = 1; lane < node.count; ++lane) {
            const LeafRange more = range_of(node.child[lane]);
            ranges[i].end = more.end;
            ranges[i].area += more.area;
        }
        node.slab = slab_of(leaves.subspan(ranges[i].begin, ranges[i].end - ranges[i].begin), ranges[i].area);
    }
}

}  // namespace ecods
