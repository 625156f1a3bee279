// walk_line walks one tree along a line and visits the nearest nodes first.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "bvh/axes/line_axes.hpp"
#include "bvh/masks/projected_lanes.hpp"
#include "bvh/walks/node_stack.hpp"
#include "simd/dispatch.hpp"
#include "simd/vec.hpp"

namespace ecods {

// Holds sets of triangles of a leaf, as masks of lanes.
struct FoundInLeaf {
    std::uint32_t may_meet;  // triangles that may share a point with the line
    std::uint32_t cross;     // triangles in may_meet whose planes are certainly not parallel to the line
    std::uint32_t inside;    // triangles in `cross` whose faces the line certainly crosses, at r in [low, high]
    alignas(32) FloatLanes low, high;
};

template <std::size_t width>
struct LineLanes : ProjectedLanes<width> {
    using Lanes = ProjectedLanes<width>;
    using Lanes::bits_of, Lanes::load, Lanes::part_count;
    using typename Lanes::Floats, typename Lanes::Ints;

    // Returns a mask of the lanes whose boxes the line may meet at a parameter r <= limit (LinePart). Sets `from` to
    // lower bounds of the parameters at which the line meets these boxes.
    ECODS_ALWAYS_INLINE static std::uint32_t find_lanes(const LinePart& line, const BvhNode& node, float limit,
                                                        FloatLanes& from) noexcept {
        Ints lanes[part_count];
        for (std::size_t part = 0; part < part_count; ++part) {
            Floats low{}, high = broadcast<Floats>(limit);
            for (std::size_t k = 0; k < 3; ++k) {
                Floats center, half;
                if (line.is_unit) {
                    center = load(node.center[k], part);
                    half = load(node.half[k], part);
                } else {
                    center = (line.p[0][k] * load(node.center[0], part) + line.p[1][k] * load(node.center[1], part)) +
                             line.p[2][k] * load(node.center[2], part);
                    half = (line.size[0][k] * load(node.half[0], part) + line.size[1][k] * load(node.half[1], part)) +
                           line.size[2][k] * load(node.half[2], part);
                }
                const Floats middle = (center - line.origin[k]) * line.inverse[k];
                const Floats reach = (half + line.margin[k]) * line.inverse_size[k];
                low = max(middle - reach, low);
                high = min(middle + reach, high);
            }
            Lanes::store(from, part, low);
            lanes[part] = (low <= high) & lane_bits<Ints>(static_cast<int>(part * width));
        }
        return bits_of(lanes) & node.lanes();
    }

    // Holds the corners of a leaf's triangles relative to the line's point `start`: x and y in the projection along the
    // line, and z as a difference of parameters along the line.
    struct CornersFromLine {
        Floats x[3], y[3], z[3];

        ECODS_ALWAYS_INLINE CornersFromLine(const LinePart& line, const TreeLeaf& leaf,
                                            const std::array<float, 3>& start, std::size_t part) noexcept {
            const std::array<std::size_t, 3> axes{line.x, line.y, line.z};
            for (std::size_t c = 0; c < 3; ++c) {
                const auto& corner = leaf.corner[c];
                Floats at[3];
                for (std::size_t i = 0; i < 3; ++i) {
                    const std::size_t k = axes[i];
                    if (line.is_unit) {
                        at[i] = load(corner[k], part) - start[k];
                    } else {
                        at[i] = ((line.p[0][k] * load(corner[0], part) + line.p[1][k] * load(corner[1], part)) +
                                 line.p[2][k] * load(corner[2], part)) -
                                start[k];
                    }
                }
                x[c] = at[0] - line.slope_x * at[2];
                y[c] = at[1] - line.slope_y * at[2];
                z[c] = at[2] * line.inverse[line.z];
            }
        }
    };

    // Sets `found` to the triangles of a leaf that the line may meet at a parameter r <= limit (LinePart). The line
    // must not meet any triangle of the leaf at r < from.
    ECODS_ALWAYS_INLINE static void find_lanes(const LinePart& line, const TreeLeaf& leaf, float from, float limit,
                                               FoundInLeaf& found) noexcept {
        std::array<float, 3> start;
        for (std::size_t k = 0; k < 3; ++k) start[k] = line.origin[k] + from * line.direction[k];
        const float ahead = limit - from;
        Ints lanes[part_count], crossed[part_count], inside[part_count];
        for (std::size_t part = 0; part < part_count; ++part) {
            const Ints bits = lane_bits<Ints>(static_cast<int>(part * width));
            const CornersFromLine corners(line, leaf, start, part);
            const Floats(&x)[3] = corners.x;
            const Floats(&y)[3] = corners.y;
            const Floats(&z)[3] = corners.z;
            const Floats x_low = min(x[0], min(x[1], x[2])), x_high = max(x[0], max(x[1], x[2]));
            const Floats y_low = min(y[0], min(y[1], y[2])), y_high = max(y[0], max(y[1], y[2]));
            const Floats z_low = min(z[0], min(z[1], z[2])), z_high = max(z[0], max(z[1], z[2]));
            const Floats size = max(max(absolute(x_low), absolute(x_high)), max(absolute(y_low), absolute(y_high)));
            const Floats bound =
                ((4 * line.side) * size + (4 * 0x1p-23f) * (size * size) + 2 * line.side * line.side) * (1 + 0x1p-10f);
            const Floats a = x[1] * y[2] - y[1] * x[2], b = x[2] * y[0] - y[2] * x[0], c = x[0] * y[1] - y[0] * x[1];
            const Ints is_beside = (max(a, max(b, c)) > bound) & (min(a, min(b, c)) < -bound);
            const Ints is_outside =
                (x_low > line.side) | (x_high < -line.side) | (y_low > line.side) | (y_high < -line.side);
            const Ints is_apart = (z_low > (ahead + line.depth)) | (z_high < -(from + line.depth));
            // Excludes triangles whose plane the line crosses beyond the limit or before its beginning. The crossing is
            // computed from the weights of the corners.
            const Floats sizes = (absolute(a) + absolute(b)) + absolute(c), all = (a + b) + c;
            const Floats reach = max(absolute(z_low), absolute(z_high)) + (ahead + from);
            const Floats error =
                (3.01f * bound) * (reach + line.depth) + sizes * (1.01f * line.depth + (8 * 0x1p-23f) * reach);
            const Floats after = (a * (z[0] - ahead) + b * (z[1] - ahead)) + c * (z[2] - ahead);
            const Floats before = (a * (z[0] + from) + b * (z[1] + from)) + c * (z[2] + from);
            const Floats doubt = 3.01f * bound + (4 * 0x1p-23f) * sizes;
            const Ints is_front = all > doubt, is_back = all < -doubt;
            const Ints is_beyond =
                (is_front & ((after > error) | (before < -error))) | (is_back & ((after < -error) | (before > error)));
            lanes[part] = ~(is_beside | is_outside | is_apart | is_beyond) & bits;
            crossed[part] = (is_front | is_back) & bits;
            // If the line crosses the face, the parameter of the crossing is the weighted mean of the corners'
            // parameters, and lies between the least and the greatest of these.
            const Floats far = max(absolute(z_low), absolute(z_high));
            const Floats all_size = absolute(all), at_plane = ((a * z[0] + b * z[1]) + c * z[2]) / all;
            const Floats doubt_of_it =
                (((6.02f * bound) * (far + line.depth) + sizes * (1.01f * line.depth + (16 * 0x1p-23f) * far)) /
                     all_size +
                 (from + far) * 0x1p-20f) *
                (1 + 0x1p-10f);
            inside[part] = ((min(a, min(b, c)) > bound) | (max(a, max(b, c)) < -bound)) & crossed[part];
            Lanes::store(found.low, part, (at_plane - doubt_of_it) + from);
            Lanes::store(found.high, part, (at_plane + doubt_of_it) + from);
        }
        found.may_meet = bits_of(lanes) & leaf.lanes();
        found.cross = line.has_slopes ? bits_of(crossed) & found.may_meet : 0;
        found.inside = bits_of(inside) & found.cross;
    }

    template <class Result>
    ECODS_ALWAYS_INLINE static void walk(const MeshBvh& tree, const LinePart& line, std::vector<OrderedNode>& stack,
                                         Result& result) {
        alignas(32) FloatLanes from;
        FoundInLeaf found;
        if (stack.size() < 2 * tree_width) stack.resize(2 * tree_width);
        std::size_t depth = 0;
        OrderedNode at{0, tree.root};
        for (;;) {
            if (at.ref.is_leaf()) {
                const TreeLeaf& leaf = tree.leaves[at.ref.index()];
                find_lanes(line, leaf, at.from, result.limit(), found);
                result.visit(leaf, found);
            } else {
                const BvhNode& node = tree.nodes[at.ref.index()];
                const std::uint32_t lanes = find_lanes(line, node, result.limit(), from);
                result.visit_node();
                if (std::has_single_bit(lanes)) {
                    const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
                    at = {from[lane], node.child[lane]};
                    continue;
                }
                if (depth + tree_width > stack.size()) stack.resize(2 * stack.size());
                OrderedNode* const first = stack.data();
                depth = static_cast<std::size_t>(push_nearest_last(tree, node, lanes, from, first + depth) - first);
            }
            do {
                if (depth == 0) return;
                at = stack[--depth];
            } while (at.from > result.limit());
        }
    }
};

// Visits the leaves that the line may meet, nearly in the order of the parameters at which the line meets the leaves.
//
// `result.limit()` returns the current upper bound of the parameter r of the line's part, at most 1. Nodes that the
// line meets only beyond this bound are skipped. `result.visit(leaf, found)` is called for each visited leaf, with the
// triangles that the line may meet; it may lower the limit. `result.visit_node()` is called for each visited inner
// node. `stack` is scratch.
template <class Result>
void walk_line(const MeshBvh& tree, const LinePart& line, std::vector<OrderedNode>& stack, Result& result) {
    dispatch_by_width<LineLanes<4>::template walk<Result>, LineLanes<8>::template walk<Result>>(tree, line, stack,
                                                                                                result);
}

}  // namespace ecods
