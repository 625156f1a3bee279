// The support function is computed from a SupportTable for several directions at once, and boxes for several poses at
// once.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "bounds/double4.hpp"
#include "bounds/scaled_pose.hpp"
#include "bounds/support_table.hpp"
#include "exact/point/point.hpp"
#include "simd/dispatch.hpp"

namespace ecods::support {

inline constexpr double double_u = 0x1p-52;  // relative error of one operation, in any rounding mode
inline constexpr int cell_count = SupportTableGrid::cell_count, side_count = SupportTableGrid::side_count;
inline constexpr int middle = cell_count / 2;
inline constexpr double tiny = 0x1p-1000;              // shorter directions count as zero
inline constexpr double table_error = 512 * double_u;  // added to values of the table; derived at reaches()
using Row = std::array<float, SupportTableGrid::direction_count>;

// Refers to the members of a SupportTable.
struct TableView {
    const LocalFrame& frame;
    const Vec3& v_max;
    double v_max_of_all;
    const Row& support;
};

// Below these limits nothing overflows: the reach is at most 3 size_max in units of the scale, and below 1.5 sum_max. A
// rounding mode that rounds down turns infinities into large numbers, which exceed the limits, too.
inline constexpr double sum_limit = 0x1p1020, size_limit = 0x1p1000;

}  // namespace ecods::support

#define ECODS_TEXT "bounds/support_lanes_text.hpp"
#include "simd/each_set.hpp"
