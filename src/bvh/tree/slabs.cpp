#include "bvh/tree/slabs.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
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
            // An unbounded frame has no coordinates. These zeros are never read.
            const Vec3 y = frame.is_bounded ? frame.coordinates(v) : Vec3(0, 0, 0);
            for (std::size_t k = 0; k < 3; ++k) {
                leaf.corner[corner][k][lane] = round_to_nearest(y[static_cast<Eigen::Index>(k)]);
            }
        }
    }
}

// Returns twice the vector area of the leaf's triangles: the sum of the cross products of their edges.
Vec3 area_of(const TreeLeaf& leaf) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t lane = 0; lane < leaf.count; ++lane) {
        const Vec3 a = corner_of(leaf, lane, 0);
        sum += (corner_of(leaf, lane, 1) - a).cross(corner_of(leaf, lane, 2) - a);
    }
    return sum;
}

// Returns the axis on which the extent of the mesh is at most 2^-20 of its greatest extent; -1 if there is none.
int flat_axis_of(const LocalFrame& frame) {
    for (int axis = 0; axis < 3; ++axis) {
        if (frame.is_bounded && frame.half[axis] <= 0x1p-20 * frame.half.maxCoeff()) return axis;
    }
    return -1;
}

// Returns the direction in the plane of a flat mesh along which the corners of the leaves spread least. Boxes bound the
// flat axis well already, but in the plane the boxes of slender triangles are much too large. If all corners are at one
// point, any direction may result.
Vec3 thinnest(std::span<const TreeLeaf> leaves, int flat_axis) {
    const auto k = static_cast<Eigen::Index>(flat_axis + 1) % 3, l = static_cast<Eigen::Index>(flat_axis + 2) % 3;
    const Vec3 middle = corner_of(leaves.front(), 0, 0);
    double count = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
    for (const TreeLeaf& leaf : leaves) {
        for (std::size_t lane = 0; lane < leaf.count; ++lane) {
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const Vec3 d = corner_of(leaf, lane, corner) - middle;
                count += 1;
                x += d[k];
                y += d[l];
                xx += d[k] * d[k];
                xy += d[k] * d[l];
                yy += d[l] * d[l];
            }
        }
    }
    const double longest = 0.5 * std::atan2(2 * (xy - x * y / count), (xx - x * x / count) - (yy - y * y / count));
    Vec3 direction = Vec3::Zero();
    direction[k] = -std::sin(longest);
    direction[l] = std::cos(longest);
    return direction;
}

// Returns a slab along `area` that contains the triangles of the leaves; any normal is sound. The products of the
// normal with corners are off by 3.01 u' sum |normal| |y| <= 3.01 u' sqrt(3) (1 + 2^-22), and by corner_error sum
// |normal| for the corners themselves: together below 2 corner_error.
// Claim: verify/proofs/small_bounds.py
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

// Returns true if the thickness of the node's slab is less than a quarter of the average extent, along the slab's
// normal, of the children's boxes.
bool is_thin(const BvhNode& node) {
    double thickness = 0;
    for (std::size_t lane = 0; lane < node.count; ++lane) {
        for (std::size_t k = 0; k < 3; ++k)
            thickness += std::abs(static_cast<double>(node.slab.normal[k])) * static_cast<double>(node.half[k][lane]);
    }
    const double of_slab = static_cast<double>(node.slab.high) - static_cast<double>(node.slab.low);
    return of_slab * node.count < 0.25 * (2 * thickness);
}

// Holds the range of the leaves below a node, which are consecutive in the tree's list, and the sum of their vector
// areas.
struct LeafRange {
    std::size_t begin, end;
    Vec3 area;
};

}  // namespace

void set_corners_and_slabs(MeshBvh& tree, const Mesh& mesh) {
    const std::span<const TreeLeaf> leaves = tree.leaves;
    const int flat_axis = flat_axis_of(tree.frame);
    const auto slab_along = [&](std::span<const TreeLeaf> part, const Vec3& area) {
        return slab_of(part, flat_axis < 0 ? area : thinnest(part, flat_axis));
    };
    std::vector<Vec3> areas;
    areas.reserve(leaves.size());
    for (TreeLeaf& leaf : tree.leaves) {
        set_vertices(leaf, mesh, tree.frame);
        areas.push_back(area_of(leaf));
        leaf.slab = slab_along({&leaf, 1}, areas.back());
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
        node.slab = slab_along(leaves.subspan(ranges[i].begin, ranges[i].end - ranges[i].begin), ranges[i].area);
        node.is_thin = is_thin(node);
    }
}

}  // namespace ecods
