// bvh/masks/projected_lanes.hpp includes this source once for each instruction set.

// Projects the eight boxes or triangles of a node onto three axes, in registers of `width` floats. `width` is 4, which
// every x86-64 processor has, or 8. Operations and their order are the same in every lane, so the bits of results do
// not depend on the width.
template <std::size_t width>
struct ProjectedLanes {
    using Floats = Vec<float, width>;
    using Ints = Vec<std::int32_t, width>;
    static constexpr std::size_t part_count = tree_width / width;

    ECODS_ALWAYS_INLINE static Floats load(const FloatLanes& lanes, std::size_t part) noexcept {
        return ECODS_SET::load<Floats>(&lanes[part * width]);
    }
    ECODS_ALWAYS_INLINE static void store(FloatLanes& lanes, std::size_t part, Floats v) noexcept {
        ECODS_SET::store(&lanes[part * width], v);
    }

    // Holds the intervals to which eight boxes or triangles are projected, on three axes.
    struct Spans {
        alignas(32) std::array<FloatLanes, 3> low;
        alignas(32) std::array<FloatLanes, 3> high;
    };
    // Holds the corners of eight triangles, in coordinates on three axes.
    struct Corners {
        alignas(32) std::array<std::array<FloatLanes, 3>, 3> at;  // [corner][axis][lane]
    };

    // Holds a node on three axes. `corners` is set only for leaves.
    struct Placed {
        Corners corners;
        Spans spans;
    };

    ECODS_ALWAYS_INLINE static void project(const Projection& p, const BvhNode& node, Spans& spans) noexcept {
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t part = 0; part < part_count; ++part) {
                Floats middle, reach;
                if (p.is_unit) {
                    middle = load(node.center[k], part);
                    reach = load(node.half[k], part);
                } else {
                    middle = (p.p[0][k] * load(node.center[0], part) + p.p[1][k] * load(node.center[1], part)) +
                             p.p[2][k] * load(node.center[2], part);
                    reach = (p.size[0][k] * load(node.half[0], part) + p.size[1][k] * load(node.half[1], part)) +
                            p.size[2][k] * load(node.half[2], part);
                }
                middle = middle + p.shift[k];
                reach = reach + p.margin[k];
                store(spans.low[k], part, middle - reach);
                store(spans.high[k], part, middle + reach);
            }
        }
    }

    ECODS_ALWAYS_INLINE static void pose(const Projection& p, const TreeLeaf& leaf, Corners& corners) noexcept {
        for (std::size_t c = 0; c < 3; ++c) {
            const auto& y = leaf.corner[c];
            for (std::size_t k = 0; k < 3; ++k) {
                for (std::size_t part = 0; part < part_count; ++part) {
                    const Floats z = p.is_unit ? load(y[k], part)
                                               : (p.p[0][k] * load(y[0], part) + p.p[1][k] * load(y[1], part)) +
                                                     p.p[2][k] * load(y[2], part);
                    store(corners.at[c][k], part, z + p.shift[k]);
                }
            }
        }
    }

    ECODS_ALWAYS_INLINE static void span(const Projection& p, const Corners& corners, Spans& spans) noexcept {
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t part = 0; part < part_count; ++part) {
                const Floats a = load(corners.at[0][k], part), b = load(corners.at[1][k], part),
                             c = load(corners.at[2][k], part);
                store(spans.low[k], part, min(a, min(b, c)) - p.margin[k]);
                store(spans.high[k], part, max(a, max(b, c)) + p.margin[k]);
            }
        }
    }

    ECODS_ALWAYS_INLINE static void place(const Projection& p, const BvhNode& node, Placed& placed) noexcept {
        project(p, node, placed.spans);
    }
    ECODS_ALWAYS_INLINE static void place(const Projection& p, const TreeLeaf& leaf, Placed& placed) noexcept {
        pose(p, leaf, placed.corners);
        span(p, placed.corners, placed.spans);
    }

    // Returns the bitwise or of all lanes.
    ECODS_ALWAYS_INLINE static std::uint32_t bits_of(const Ints (&lanes)[part_count]) noexcept {
        Ints any = lanes[0];
        for (std::size_t part = 1; part < part_count; ++part) any |= lanes[part];
        return static_cast<std::uint32_t>(any_bits(any));
    }

    // Returns a mask whose bit i is set if lane i of `masks` is all ones. Each lane must be all ones or zero.
    ECODS_ALWAYS_INLINE static std::uint32_t lanes_of(const Ints (&masks)[part_count]) noexcept {
        Ints lanes[part_count];
        for (std::size_t part = 0; part < part_count; ++part) {
            lanes[part] = masks[part] & lane_bits<Ints>(static_cast<int>(part * width));
        }
        return bits_of(lanes);
    }

    // Sets bit 8 j + i of `pairs` for each bit i of lane j of `near`, a part of the lanes.
    ECODS_ALWAYS_INLINE static void collect(const Ints& near, std::size_t part, std::uint64_t& pairs) noexcept {
        pairs |= low_bytes(near) << (8 * part * width);
    }

    // SlabAxis is the axis of a slab in the coordinates of the other tree, which `p` projects. A box or triangle of the
    // other tree is certainly beyond the slab if m . y > `high` for all its points y, or m . y < `low` for all of them.
    // The gap is exact up to the rounding of the difference. `set` must have the axes of the slab's tree. `shift` is 1
    // if the other tree is the one with a shift, and -1 if the slab's tree is.
    //
    // Bound: the slab's normal n is a vector in the coordinates N x. The other's projection on it is n . (P y + q),
    // computed as (P^T n) . y + n . q. For a corner there are the errors of converting P and q, of y, and 3.01 v s for
    // each of three products of vectors, 3 v s for sums: below 14 v s + 13 u' w + e, summed as |n_k| (...)_k. A box
    // adds a reach with two products, and the ends: below 23 v s + 20 u' w + 2 e. Three times point_error is 24 v s +
    // 48 u' w + 3 e.
    // Claim: verify/proofs/float_axes.py
    struct SlabAxis {
        std::array<float, 3> m;
        float low, high;
        float margin;  // the margin by which the slab is enlarged

        ECODS_ALWAYS_INLINE SlabAxis(const AxisSet& set, const Slab& slab, const Projection& p, float shift) noexcept {
            const auto& n = slab.normal;
            // The fourth lane of the sum is n . q, which is not used here.
            const auto row = [](const std::array<float, 4>& r) { return Vec<float, 4>{r[0], r[1], r[2], r[3]}; };
            const auto& rows = set.b.row;  // the fourth number of each row is q
            const Vec<float, 4> m4 = (n[0] * row(p.row[0]) + n[1] * row(p.row[1])) + n[2] * row(p.row[2]);
            m = {m4[0], m4[1], m4[2]};
            const float q = shift * ((n[0] * rows[0][3] + n[1] * rows[1][3]) + n[2] * rows[2][3]);
            margin = 3 * ((std::abs(n[0]) * set.point_error[0] + std::abs(n[1]) * set.point_error[1]) +
                          std::abs(n[2]) * set.point_error[2]);
            low = (slab.low - margin) - q;
            high = (slab.high + margin) - q;
        }
    };

    // Sets `low` and `high` to the least and the greatest m . y of each lane's box or triangle.
    ECODS_ALWAYS_INLINE static void find_ends(const BvhNode& node, const std::array<float, 3>& m, std::size_t part,
                                              Floats& low, Floats& high) noexcept {
        const Floats middle =
            (m[0] * load(node.center[0], part) + m[1] * load(node.center[1], part)) + m[2] * load(node.center[2], part);
        const Floats reach = (std::abs(m[0]) * load(node.half[0], part) + std::abs(m[1]) * load(node.half[1], part)) +
                             std::abs(m[2]) * load(node.half[2], part);
        low = middle - reach;
        high = middle + reach;
    }
    ECODS_ALWAYS_INLINE static void find_ends(const TreeLeaf& leaf, const std::array<float, 3>& m, std::size_t part,
                                              Floats& low, Floats& high) noexcept {
        const auto at = [&](std::size_t c) ECODS_INLINE_LAMBDA {
            const auto& y = leaf.corner[c];
            return (m[0] * load(y[0], part) + m[1] * load(y[1], part)) + m[2] * load(y[2], part);
        };
        const Floats a = at(0), b = at(1), c = at(2);
        low = min(a, min(b, c));
        high = max(a, max(b, c));
    }

    // ThinAxis is the axis m of a slab, for a node of the other tree that has a slab of its own, with the normal n. For
    // the points y of the node's triangles, m . y = slope (n . y) + rest . y. If n is nearly parallel to m, rest is
    // small and the node's slab bounds n . y well. On a smooth surface this bounds m . y much better than the node's
    // boxes do.
    //
    // Bound: m is taken as computed, for which a corner's error is 14 v s + 13 u' w + e. Let M = sum |m_k|, at most the
    // sum of |n_i| s_i of the axis, and |n| < 1.001, so that sum |n_k| and the ends of slabs are below 1.74. Any slope
    // is sound; as computed here it is below 1.002 M. Then sum |slope n_k| < 1.75 M, sum |rest_k| < 2.75 M, and, as all
    // |y| are at most 1 + 2^-22, rounding rest costs (1.75 + 2.75) v M. Middle and reach of a box on rest have errors
    // of 3.01 v 2.75 M each, their sum 5.6 v M, ends of slope (n . y) 1.75 v M, with the margin as much again, and the
    // last sum 7.3 v M: 38 v M. All are below 52 v s + 13 u' w + e. Three times the margin of the axis is 72 v s + 144
    // u' w + 9 e.
    struct ThinAxis {
        std::array<float, 3> rest;
        float low, high;  // bounds of slope (n . y), with the margin

        ECODS_ALWAYS_INLINE ThinAxis(const SlabAxis& axis, const Slab& slab) noexcept {
            const auto &m = axis.m, &n = slab.normal;
            const float slope = (m[0] * n[0] + m[1] * n[1]) + m[2] * n[2];
            rest = {m[0] - slope * n[0], m[1] - slope * n[1], m[2] - slope * n[2]};
            const float one = slope * slab.low, other = slope * slab.high;
            low = std::min(one, other) - 2 * axis.margin;
            high = std::max(one, other) + 2 * axis.margin;
        }
    };

    // Sets `low` and `high` to bounds of m . y for each box of a node, from the node's slab and the box.
    ECODS_ALWAYS_INLINE static void find_thin_ends(const BvhNode& node, const ThinAxis& axis, std::size_t part,
                                                   Floats& low, Floats& high) noexcept {
        find_ends(node, axis.rest, part, low, high);
        low = low + axis.low;
        high = high + axis.high;
    }
};
