#include "bvh/masks/ray_mask.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/arithmetic.hpp"
#include "simd/dispatch.hpp"
#include "simd/vec.hpp"

#define ECODS_TEXT "bvh/masks/ray_text.hpp"
#include "simd/each_set.hpp"

namespace ecods {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double float_u = 0x1p-23;

// Holds a tree's local frame at its pose R, t, in a unit in which the entries of R map are at most about one.
struct PosedRoot {
    Mat3 edges;      // R map
    Vec3 from;       // R center - (p - t)
    Mat3 edge_size;  // |R| |map|
    Vec3 from_size;  // |R| |center| + |p - t|
    double error;    // error bound of the ray's origin, by axis
    bool is_bounded;

    PosedRoot(const MeshBvh& tree, const Mat3& R, const RayOrigin& origin) {
        const LocalFrame& frame = tree.frame;
        const Mat3 R_size = R.cwiseAbs();
        edges = R * frame.map;
        edge_size = R_size * frame.map.cwiseAbs();
        from = R * frame.center - origin.offset;
        from_size = R_size * frame.center.cwiseAbs() + origin.offset.cwiseAbs();
        error = origin.error;
        const double largest = std::max(edge_size.maxCoeff(), 0x1p-60 * from_size.maxCoeff());
        const double factor = std::max({R_size.maxCoeff(), frame.size_max, origin.offset.cwiseAbs().maxCoeff()});
        // If a number is NaN, its comparison is false, and the tree counts as unbounded.
        is_bounded = frame.is_bounded && largest > 0x1p-400 && from_size.maxCoeff() < 0x1p500 && factor < 0x1p500;
        if (!is_bounded) return;
        const double unit = std::ldexp(1.0, -std::ilogb(largest));
        edges *= unit;
        edge_size *= unit;
        from *= unit;
        from_size *= unit;
        error *= unit;
    }

    struct DoubleRow {
        Vec3 g;
        double shift;
        double margin;
    };
    DoubleRow row(const Vec3& n) const {
        const Vec3 size = n.cwiseAbs();
        const double sum = size.dot(from_size) + (size.transpose() * edge_size).sum();
        const double margin = 16 * two_u * sum + 2 * error * size.sum();
        return {edges.transpose() * n, n.dot(from), margin};
    }
};

void set_row(RayRow& row, const PosedRoot& root, const Vec3& n) {
    const PosedRoot::DoubleRow exact = root.row(n);
    for (std::size_t k = 0; k < 3; ++k) {
        row.g[k] = static_cast<float>(exact.g[static_cast<Eigen::Index>(k)]);
        row.size[k] = std::abs(row.g[k]);
    }
    row.shift = static_cast<float>(exact.shift);
    const double in_floats = 16 * float_u * (std::abs(exact.shift) + exact.g.cwiseAbs().sum());
    // 1 + 2^-20 covers the rounding of the margin.
    const double margin = ((in_floats + exact.margin) + 0x1p-100) * (1 + 0x1p-20);
    row.margin = static_cast<float>(root.is_bounded ? margin : infinite);
}

// Holds the interval of a row's values on the root's box, enlarged by the row's margin.
struct RootSpan {
    double low, high;

    RootSpan(const MeshBvh& tree, const PosedRoot::DoubleRow& row) {
        double middle = row.shift, reach = row.margin;
        double sum = std::abs(row.shift);
        for (std::size_t k = 0; k < 3; ++k) {
            const double g = row.g[static_cast<Eigen::Index>(k)];
            middle += g * static_cast<double>(tree.root_center[k]);
            reach += std::abs(g) * static_cast<double>(tree.root_half[k]);
            sum += std::abs(g);
        }
        reach += 16 * two_u * sum + 0x1p-100;
        low = middle - reach;
        high = middle + reach;
    }
    bool excludes_zero() const noexcept { return low > 0 || high < 0; }
};

Vec3 unit_vector(int axis, double sign = 1) {
    Vec3 n = Vec3::Zero();
    n[axis] = sign;
    return n;
}

// Returns the cross product of the ray's direction, which is along `axis`, and an edge of the boxes.
Vec3 across_edge(const Vec3& edge, int axis) {
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    Vec3 n = Vec3::Zero();
    n[i] = -edge[j];
    n[j] = edge[i];
    return n;
}

}  // namespace

bool set_ray(TreeRay& ray, const MeshBvh& tree, const Mat3& R, const RayOrigin& origin, std::uint32_t axes) {
    const PosedRoot root(tree, R, origin);
    double least = infinite;
    ray.axis = -1;
    for (int axis = 0; axis < 3; ++axis) {
        const RootSpan span(tree, root.row(unit_vector(axis)));
        if (root.is_bounded && span.excludes_zero()) return false;
        if ((axes >> axis & 1) == 0) continue;
        const double up = span.high / (span.high - span.low);
        const double way = std::min(up, 1 - up);
        if (ray.axis >= 0 && !(way < least)) continue;
        least = way;
        ray.axis = axis;
        ray.sign = up <= 0.5 ? 1 : -1;
    }
    set_row(ray.along, root, unit_vector(ray.axis, ray.sign));
    for (int k = 0; k < 3; ++k) {
        set_row(ray.across[static_cast<std::size_t>(k)], root, across_edge(root.edges.col(k), ray.axis));
    }
    return true;
}

bool set_point(TreeRay& point, const MeshBvh& tree, const Mat3& R, const RayOrigin& origin) {
    const PosedRoot root(tree, R, origin);
    for (int axis = 0; axis < 3; ++axis) {
        const RootSpan span(tree, root.row(unit_vector(axis)));
        if (root.is_bounded && span.excludes_zero()) return false;
        set_row(point.across[static_cast<std::size_t>(axis)], root, unit_vector(axis));
    }
    point.along = point.across[0];
    point.along.margin = std::numeric_limits<float>::infinity();
    return true;
}

std::uint32_t ray_mask(const TreeRay& ray, const BvhNode& node) noexcept {
    return call_widest<ECODS_OF_EACH_SET(RayKernel::node_mask)>(ray, node);
}
std::uint32_t ray_mask(const TreeRay& ray, const TreeLeaf& leaf) noexcept {
    return call_widest<ECODS_OF_EACH_SET(RayKernel::leaf_mask)>(ray, leaf);
}

}  // namespace ecods
