// Where a sweep from scratch goes along, and into how many cells it divides the other two axes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "broad_phase/boxes/packed_box.hpp"

namespace ecods {

using Doubles = Vec<double, 4>;
using Ranks = Vec<std::int32_t, 4>;

// Maps coordinates to ranks 0 .. rank_end - 1, evenly from `low` on; what lies beyond has the first or the last one. By
// lanes: one for each axis.
//
// Ranks never descend where coordinates ascend, whatever the rounding mode, and with subnormals taken for zero: a
// difference from a constant, a product with one, a clamp and cutting off do not. So a lower rank is a lower
// coordinate, and only of equal ones nothing is known. How even they are is a matter of speed.
struct alignas(32) RankMap {
    static constexpr std::int32_t rank_bits = 22;
    static constexpr std::int32_t rank_end = std::int32_t{1} << rank_bits;

    std::array<double, 4> low{};
    std::array<double, 4> width{};  // of all ranks together; finite, not negative
    std::array<double, 4> ranks_per_unit{};

    void set(std::size_t axis, double from, double to) noexcept;

    ECODS_ALWAYS_INLINE Ranks at(KeyLanes keys) const noexcept {
        const Doubles from_low = max(doubles_of(keys) - load<Doubles>(low.data()), Doubles{});
        return convert<Ranks>(min(from_low, load<Doubles>(width.data())) * load<Doubles>(ranks_per_unit.data()));
    }
};

// Cells are runs of ranks of the same length.
inline std::uint32_t cell_of(std::int32_t rank, std::uint32_t cell_count) noexcept {
    return static_cast<std::uint32_t>(std::uint64_t{static_cast<std::uint32_t>(rank)} * cell_count >>
                                      RankMap::rank_bits);
}

struct GridPlan {
    static constexpr std::uint32_t cells_max = 256;  // on an axis

    std::array<std::size_t, 3> axes = {0, 1, 2};  // that of the sweep, then those of the cells
    std::array<std::uint32_t, 2> cells = {1, 1};
    RankMap map = {};

    std::size_t cell_count() const noexcept { return std::size_t{cells[0]} * cells[1]; }
};

// A plan from a sample of the lines, some of which may be empty. Cost: a thousand are looked at, at most.
GridPlan plan_grid(std::span<const PackedBox> lines);

}  // namespace ecods
