// bvh/masks/pair_kernel.hpp includes this source once for each instruction set.

// A Measure has a type Value, which holds its result for pairs, with one lane for each lane of y. It has the functions
//     put(set, tree, node, placed)              projects a node to the axes of a set
//     load(i, part), store(i, part, value)      read and write the values of row i
//     is_near(value)                            returns a mask of the lanes whose pairs are not excluded
//     narrow<set>(value, x, y, i, part)         narrows the values of row i of x and a part of y by a set of axes
// and, if slabs are used, axes(set) and
//     start(over_x, over_y, i, part)            combines the values from both slabs for row i; lanes of over_x are rows
//     of_slab(set, axis, slab, shift, low, high)  returns the values, by one slab, of lanes from `low` to `high` on its
//     axis
// It may also have look_first(), called before all other functions, and look_beside_slabs(), called after the slabs.
//
// Rows are lanes of x. Nodes are projected to the second set only if the first one does not exclude all pairs.
template <class Measure>
struct PairKernel : ProjectedLanes<float_width> {
    using Value = typename Measure::Value;
    using Placed = typename Measure::Placed;

    template <class X, class Y>
    ECODS_ALWAYS_INLINE static std::uint64_t find(const Measure& measure, const X& x, const Y& y) noexcept {
        Ints near[part_count];
        Placed on_first[2];
        return find_lanes(measure, x, y, on_first, near) ? pairs_of(near, y) : 0;
    }

    // Returns the pairs as a mask of 64 bits: bit i of lane j becomes bit 8 j + i.
    template <class Y>
    ECODS_ALWAYS_INLINE static std::uint64_t pairs_of(const Ints (&lanes)[part_count], const Y& y) noexcept {
        std::uint64_t pairs = 0;
        for (std::size_t part = 0; part < part_count; ++part) collect(lanes[part], part, pairs);
        return pairs & ~std::uint64_t{0} >> (64 - tree_width * y.count);
    }

    // Sets bit i in lane j of `near` if the pair of lanes i of x and j of y is not excluded, and returns true if there
    // is any such pair. Then `on_first` holds both nodes on the axes of the first set.
    template <class X, class Y>
    ECODS_ALWAYS_INLINE static bool find_lanes(const Measure& measure, const X& x, const Y& y, Placed (&on_first)[2],
                                               Ints (&near)[part_count]) noexcept {
        Value over_x[part_count], over_y[part_count];
        std::uint32_t rows = x.lanes();
        for (Ints& all : near) all = ~Ints{};
        if constexpr (requires { measure.look_first(x, y, near); }) {
            measure.look_first(x, y, near);
            rows &= bits_of(near);
            if (rows == 0) return false;
        }
        if constexpr (requires { measure.axes(0); }) {
            if (!look_at_slabs(measure, x, y, over_x, over_y, near, rows)) return false;
        }
        measure.put(0, &AxisSet::a, x, on_first[0]);
        measure.put(0, &AxisSet::b, y, on_first[1]);
        narrow_rows<0>(measure, on_first, rows, near, [&](std::size_t i, std::size_t part) -> Value {
            if constexpr (requires { measure.look_first(x, y, near); }) {
                return measure.join(measure.start(over_x, over_y, i, part), measure.load(i, part));
            } else {
                return measure.start(over_x, over_y, i, part);
            }
        });
        rows = bits_of(near);
        if (rows == 0) return false;
        Placed on_second[2];
        measure.put(1, &AxisSet::a, x, on_second[0]);
        measure.put(1, &AxisSet::b, y, on_second[1]);
        narrow_rows<1>(measure, on_second, rows, near,
                       [&](std::size_t i, std::size_t part) -> Value { return measure.load(i, part); });
        return bits_of(near) != 0;
    }

  private:
    // Clears in `near` the bits of pairs that a set of axes excludes. value_of(i, part) returns the values of row i
    // before this set.
    template <std::size_t set, class ValueOf>
    ECODS_ALWAYS_INLINE static void narrow_rows(const Measure& measure, const Placed (&nodes)[2],
                                                const std::uint32_t rows, Ints (&near)[part_count],
                                                const ValueOf& value_of) noexcept {
        for (std::size_t part = 0; part < part_count; ++part) {
            Ints lanes{};
            for (std::uint32_t rest = rows; rest != 0; rest &= rest - 1) {
                const auto i = static_cast<std::size_t>(std::countr_zero(rest));
                Value value = value_of(i, part);
                measure.template narrow<set>(value, nodes[0], nodes[1], i, part);
                measure.store(i, part, value);
                lanes |= measure.is_near(value) & (1 << i);
            }
            near[part] &= lanes;
        }
    }

    // Sets over_y to the values of the lanes of y by the slab of x, and over_x to the values of the lanes of x by the
    // slab of y. Clears the bits of `near` and `rows` that the slabs exclude. Returns false if no pair remains.
    template <class X, class Y>
    ECODS_ALWAYS_INLINE static bool look_at_slabs(const Measure& measure, const X& x, const Y& y,
                                                  Value (&over_x)[part_count], Value (&over_y)[part_count],
                                                  Ints (&near)[part_count], std::uint32_t& rows) noexcept {
        for (std::size_t part = 0; part < part_count; ++part) over_x[part] = over_y[part] = measure.unknown();
        const AxisSet &first = measure.axes(0), &second = measure.axes(1);
        if (first.a.is_unit) {
            for (std::size_t part = 0; part < part_count; ++part) {
                over_y[part] = beside_slab(measure, 0, SlabAxis(first, x.slab, first.b, 1), x.slab, y, 1, part);
                near[part] &= measure.is_near(over_y[part]);
            }
            if (bits_of(near) == 0) return false;
        }
        if (second.b.is_unit) {
            Ints lanes[part_count];
            for (std::size_t part = 0; part < part_count; ++part) {
                over_x[part] = beside_slab(measure, 1, SlabAxis(second, y.slab, second.a, -1), y.slab, x, -1, part);
                lanes[part] = measure.is_near(over_x[part]);
            }
            rows &= lanes_of(lanes);
            if (rows == 0) return false;
        }
        if constexpr (requires { measure.look_beside_slabs(x, y, near, rows); }) {
            return measure.look_beside_slabs(x, y, near, rows);
        }
        return true;
    }

    // Returns the values of the lanes of `other` by a slab of the other tree. `shift` is as for SlabAxis.
    template <class Other>
    ECODS_ALWAYS_INLINE static Value beside_slab(const Measure& measure, std::size_t set, const SlabAxis& axis,
                                                 const Slab& slab, const Other& other, float shift,
                                                 std::size_t part) noexcept {
        Floats low, high;
        find_ends(other, axis.m, part, low, high);
        return measure.of_slab(set, axis, slab, shift, low, high);
    }
};
