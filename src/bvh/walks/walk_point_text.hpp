// bvh/walks/walk_point.cpp includes this source once for each instruction set.

// PointLanes bounds the distances of a point, the origin of the axes, from the boxes of a node or the triangles of a
// leaf.
//
// Bound. Ends of boxes have the margins of separating_axes.hpp, and squared gaps have the bounds of distance_axes.hpp.
//
// Triangles: let E = `error`, an error bound of a corner, v = 2^-23. Upper bound: a point of an edge is z + t e with 0
// <= t <= 1, a point of a face z + (t e - u e'), and triangle_bounds_text.hpp derives that each is off by less than 4.5
// E on each axis, and its length by 8 E. Lower bound: for any vector n of floats, all points y of a triangle have n . y
// >= min n . c over the corners c, so the distance is at least this minimum divided by |n|. A corner is off by E, and
// the product n . c as computed by 3.01 v sum |n_k| M, where M is the largest coordinate of a corner as computed:
// together sum |n_k| (E + 3.01 v M). The sum of magnitudes and the margin have five roundings: 2 E + 9 v M is enough.
// The quotients, the squares and the factor are below 10 v, relative, and 2^-18 of `square` covers them.
// Claim: verify/proofs/point_triangles.py
struct PointLanes : BoundsKernel {
    // Sets `squares` to lower bounds of the squared distances of the boxes, and returns the lanes up to the limit.
    ECODS_ALWAYS_INLINE static std::uint32_t find_near(const DistanceSet& set, const BvhNode& node, float limit,
                                                       FloatLanes& squares) noexcept {
        Spans spans;
        project(set.axes.b, node, spans);
        Ints near[part_count];
        for (std::size_t part = 0; part < part_count; ++part) {
            // A gap that is negative or NaN becomes 0.
            const auto gap = [&](std::size_t k) ECODS_INLINE_LAMBDA -> Floats {
                return max(max(load(spans.low[k], part), Floats{} - load(spans.high[k], part)), Floats{});
            };
            const Floats x = gap(0), y = gap(1), z = gap(2);
            const Floats square = ((x * x + y * y) + z * z) * set.square;
            store(squares, part, square);
            near[part] = square <= limit;
        }
        return lanes_of(near) & node.lanes();
    }

    // Holds the point of each triangle that is nearest to the origin, as computed, and its squared length.
    struct Nearest {
        Floats square;
        Vector n;

        ECODS_ALWAYS_INLINE void take(const Vector& p, Ints valid) noexcept {
            const Floats d = dot(p, p);
            const Ints closer = (d < square) & valid;
            square = ECODS_SET::select(closer, d, square);
            n = select(closer, p, n);
        }
    };

    ECODS_ALWAYS_INLINE static Nearest nearest_of(const Triangles& t) noexcept {
        Nearest nearest{broadcast<Floats>(std::numeric_limits<float>::infinity()), {}};
        for (int i = 0; i < 3; ++i) {
            const Floats s = clamp((Floats{} - dot(t.v[i], t.e[i])) * t.inverse[i]);
            nearest.take(along(t.v[i], s, t.e[i]), ~Ints{});
        }
        Ints inside;
        const Vector on_face = foot(t, Vector{}, inside);
        nearest.take(on_face, inside);
        return nearest;
    }

    ECODS_ALWAYS_INLINE static Floats lower_square(const Triangles& t, const Nearest& nearest, float error,
                                                   float square) noexcept {
        const Vector& n = nearest.n;
        Floats low{}, size{};
        for (int i = 0; i < 3; ++i) {
            const Floats at = dot(n, t.v[i]);
            low = i == 0 ? at : min(low, at);
            size = max(size, largest(t.v[i]));
        }
        const Floats sum = (absolute(n.x) + absolute(n.y)) + absolute(n.z);
        const Floats gap = max(low - sum * (2 * error + 9 * 0x1p-23f * size), Floats{});
        // If n is shorter than this, its square loses digits to underflow, and the bound is 0. The order of operations
        // avoids the square of the gap, which may overflow.
        const Ints is_long = nearest.square > 0x1p-80f;
        return ECODS_SET::select(is_long, gap * (gap / nearest.square) * square, Floats{});
    }

    // Sets `lower` to lower bounds of the squared distances of a leaf's triangles, and `upper` to the squared distances
    // of their nearest points on the axes, as computed. Returns the triangles up to the limit.
    ECODS_ALWAYS_INLINE static std::uint32_t find_near(const DistanceSet& set, const TreeLeaf& leaf, float limit,
                                                       FloatLanes& lower, FloatLanes& upper) noexcept {
        const auto& errors = set.axes.point_error;
        const float error = std::max(std::max(errors[0], errors[1]), errors[2]);
        Corners corners;
        pose(set.axes.b, leaf, corners);
        Ints near[part_count];
        for (std::size_t part = 0; part < part_count; ++part) {
            Triangles t;
            gather(t, corners.at, part);
            const Nearest nearest = nearest_of(t);
            const Floats square = lower_square(t, nearest, error, set.square);
            store(lower, part, square);
            store(upper, part, nearest.square);
            near[part] = square <= limit;
        }
        return lanes_of(near) & leaf.lanes();
    }

    ECODS_ALWAYS_INLINE static void visit(const PointAxes& axes, const TreeLeaf& leaf, float& least, PointWalk& walk) {
        alignas(32) FloatLanes lower, upper;
        std::uint32_t lanes = find_near(axes.set(), leaf, walk.limit, lower, upper);
        walk.triangle_count += leaf.count;
        for (; lanes != 0; lanes &= lanes - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
            if (upper[lane] < least) {
                least = upper[lane];
                walk.limit = std::min(walk.limit, axes.limit_of(least));
            }
            if (lower[lane] <= walk.limit) walk.found.push_back({lower[lane], leaf.triangle[lane]});
        }
    }

    [[gnu::noinline]] static void run(const MeshBvh& tree, const PointAxes& axes, PointWalk& walk) {
        alignas(32) FloatLanes squares;
        float least = std::numeric_limits<float>::infinity();
        std::vector<OrderedNode>& stack = walk.stack;
        if (stack.size() < 2 * tree_width) stack.resize(2 * tree_width);
        std::size_t depth = 0;
        OrderedNode at{0, tree.root};
        for (;;) {
            if (at.ref.is_leaf()) {
                visit(axes, tree.leaves[at.ref.index()], least, walk);
            } else {
                const BvhNode& node = tree.nodes[at.ref.index()];
                const std::uint32_t lanes = find_near(axes.set(), node, walk.limit, squares);
                ++walk.node_count;
                if (depth + tree_width > stack.size()) stack.resize(2 * stack.size());
                OrderedNode* const first = stack.data();
                OrderedNode* const top = push_nearest_last(tree, node, lanes, squares, first + depth);
                depth = static_cast<std::size_t>(top - first);
            }
            do {
                if (depth == 0) return;
                at = stack[--depth];
            } while (at.from > walk.limit);
        }
    }
};
