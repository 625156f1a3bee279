// bvh/masks/ray_mask.cpp includes this source once for each instruction set.

struct RayKernel {
    static constexpr std::size_t width = float_width;
    using Floats = Vec<float, width>;
    using Ints = Vec<std::int32_t, width>;

    ECODS_ALWAYS_INLINE static Floats load(const FloatLanes& lanes, std::size_t first) noexcept {
        return ECODS_SET::load<Floats>(&lanes[first]);
    }
    ECODS_ALWAYS_INLINE static Floats value(const RayRow& row, const std::array<FloatLanes, 3>& at,
                                            std::size_t first) noexcept {
        return ((row.shift + row.g[0] * load(at[0], first)) + row.g[1] * load(at[1], first)) +
               row.g[2] * load(at[2], first);
    }
    ECODS_ALWAYS_INLINE static std::uint32_t bits_of(Ints apart, std::size_t first) noexcept {
        return static_cast<std::uint32_t>(any_bits(~apart & lane_bits<Ints>(static_cast<int>(first))));
    }

    // Returns a mask of the lanes whose boxes the ray may meet. Comparisons with NaN are false, so NaN proves nothing.
    [[gnu::noinline]] static std::uint32_t node_mask(const TreeRay& ray, const BvhNode& node) noexcept {
        std::uint32_t lanes = 0;
        for (std::size_t first = 0; first < tree_width; first += width) {
            const auto reach = [&](const RayRow& row) -> Floats {
                return ((row.margin + row.size[0] * load(node.half[0], first)) +
                        row.size[1] * load(node.half[1], first)) +
                       row.size[2] * load(node.half[2], first);
            };
            Ints apart = value(ray.along, node.center, first) < -reach(ray.along);
            for (const RayRow& row : ray.across) {
                apart |= absolute(value(row, node.center, first)) > reach(row);
            }
            lanes |= bits_of(apart, first);
        }
        return lanes & node.lanes();
    }
    // Returns a mask of the lanes whose triangles the ray may meet. No NaN arises with bounded rows: all their numbers
    // are finite, and so are the corners.
    [[gnu::noinline]] static std::uint32_t leaf_mask(const TreeRay& ray, const TreeLeaf& leaf) noexcept {
        std::uint32_t lanes = 0;
        for (std::size_t first = 0; first < tree_width; first += width) {
            Ints apart{};
            const auto include = [&](const RayRow& row, bool is_across) {
                const Floats a = value(row, leaf.corner[0], first), b = value(row, leaf.corner[1], first),
                             c = value(row, leaf.corner[2], first);
                apart |= max(max(a, b), c) < Floats{} - row.margin;
                if (is_across) apart |= min(min(a, b), c) > Floats{} + row.margin;
            };
            include(ray.along, false);
            for (const RayRow& row : ray.across) include(row, true);
            lanes |= bits_of(apart, first);
        }
        return lanes & leaf.lanes();
    }
};
