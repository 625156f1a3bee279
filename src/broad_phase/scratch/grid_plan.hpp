// Plans a search for all pairs from scratch (grid_sweep.hpp): the axis of the sweep, and the number of cells on the
// other two axes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "broad_phase/boxes/packed_box.hpp"

namespace ecods {

using Doubles = Vec<double, 4>;
using Ranks = Vec<std::int32_t, 4>;

// Maps coordinates from low to low + width linearly to integers, the ranks 0 .. rank_end - 1; coordinates outside get
// the first or the last rank. Indices and lanes are axes.
//
// Ranks are monotonic in the coordinates, in any rounding mode and also if subnormals are taken for zero, since each
// step is monotonic: a difference from a constant, a product with a constant, a clamp and a truncation. So a lower rank
// means a lower coordinate; for equal ranks the order is unknown. How evenly ranks are distributed affects only the
// speed.
struct alignas(32) RankMap {
    static constexpr std::int32_t rank_bits = 22;
    static constexpr std::int32_t rank_end = std::int32_t{1} << rank_bits;

    std::array<double, 4> low{};
    std::array<double, 4> width{};  // length that the ranks cover; finite, not negative
    std::array<double, 4> ranks_per_unit{};

    void set(std::size_t axis, double from, double to) noexcept;

    ECODS_ALWAYS_INLINE Ranks at(KeyLanes keys) const noexcept {
        const Doubles from_low = max(doubles_of(keys) - load<Doubles>(low.data()), Doubles{});
        return convert<Ranks>(min(from_low, load<Doubles>(width.data())) * load<Doubles>(ranks_per_unit.data()));
    }
};

// Returns the cell of a rank. Ranks 0 .. rank_end - 1 are divided evenly among the cells.
inline std::uint32_t cell_of(std::int32_t rank, std::uint32_t cell_count) noexcept {
    return static_cast<std::uint32_t>(std::uint64_t{static_cast<std::uint32_t>(rank)} * cell_count >>
                                      RankMap::rank_bits);
}

struct GridPlan {
    static constexpr std::uint32_t cells_max = 256;  // per axis

    std::array<std::size_t, 3> axes = {0, 1, 2};  // axis of the sweep, then the axes of the cells
    std::array<std::uint32_t, 2> cells = {1, 1};
    RankMap map = {};

    std::size_t cell_count() const noexcept { return std::size_t{cells[0]} * cells[1]; }
};

// Plans the search from a sample of the boxes `lines`; boxes may be empty. Cost: reads about a thousand lines at most.
GridPlan plan_grid(std::span<const PackedBox> lines);

}  // namespace ecods
