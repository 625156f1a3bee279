#include "query/depth/rounded_hulls.hpp"

#include <algorithm>

#include "simd/dispatch.hpp"

namespace ecods::depths {
namespace {

struct Range {
    std::array<double, 3> low, high;
};

// R v + d for the points v of a side, as convex::PosedHulls has it.
ECODS_ALWAYS_INLINE void pose_all(RoundedHulls::Side& side, const convex::PosedHulls& hulls, std::size_t which,
                                  Range& range) noexcept {
    const double* group = hulls.points(which).groups.data();
    const auto& rows = hulls.rows(which);
    const auto& offset = hulls.offset(which);
    std::array<Double4, 3> low, high;
    for (std::uint32_t i = 0; i < side.count; i += 4) {
        const Double4 x = load_anywhere<Double4>(group), y = load_anywhere<Double4>(group + 4),
                      z = load_anywhere<Double4>(group + 8);
        group += 12;
        std::array<Double4, 3> p;
        for (std::size_t k = 0; k < 3; ++k) p[k] = ((rows[k][0] * x + rows[k][1] * y) + rows[k][2] * z) + offset[k];
        std::memcpy(side.x.data() + i, &p[0], sizeof p[0]);
        std::memcpy(side.y.data() + i, &p[1], sizeof p[0]);
        std::memcpy(side.z.data() + i, &p[2], sizeof p[0]);
        for (std::size_t k = 0; k < 3; ++k) {
            low[k] = i == 0 ? p[k] : min(low[k], p[k]);
            high[k] = i == 0 ? p[k] : max(high[k], p[k]);
        }
    }
    for (std::size_t k = 0; k < 3; ++k) {
        range.low[k] = std::min(std::min(low[k][0], low[k][1]), std::min(low[k][2], low[k][3]));
        range.high[k] = std::max(std::max(high[k][0], high[k][1]), std::max(high[k][2], high[k][3]));
    }
}

static_assert(convex::SupportPoints::lanes == 4);

}  // namespace

// The box of the vertices that are furthest along the axes of the mesh: not of all.
auto RoundedHulls::box_of_extremes(std::size_t i) const noexcept -> Box {
    Box box;
    bool is_first = true;
    for (const std::uint32_t v : posed_->points(i).extremes) {
        const std::array<double, 3> p = posed_->rounded(i, v);
        for (std::size_t k = 0; k < 3; ++k) {
            box.low[k] = is_first ? p[k] : std::min(box.low[k], p[k]);
            box.high[k] = is_first ? p[k] : std::max(box.high[k], p[k]);
        }
        is_first = false;
    }
    return box;
}

bool RoundedHulls::bind(const convex::PosedHulls& hulls) {
    posed_ = &hulls;
    std::array<Range, 2> ranges;
    bool is_scanned = true;
    for (std::size_t i = 0; i < 2; ++i) {
        Side& side = sides_[i];
        side.count = static_cast<std::uint32_t>(hulls.hull(i).vertex_count());
        is_scanned_[i] = side.count <= convex::PosedHulls::scanned_max;
        is_scanned = is_scanned && is_scanned_[i];
        if (!is_scanned_[i]) {
            const Box box = box_of_extremes(i);
            ranges[i] = {box.low, box.high};
            continue;
        }
        for (auto* list : {&side.x, &side.y, &side.z}) {
            if (list->size() < side.padded_count()) list->resize(side.padded_count());
        }
        dispatch<pose_all>(side, hulls, i, ranges[i]);
    }
    bounds_ = {};
    bounds_.delta = hulls.delta();
    // delta is at least 17/4 u' times the largest sum of magnitudes.
    bounds_.V = bounds_.delta * (1 / (4.25 * two_u));
    for (std::size_t k = 0; k < 3; ++k) {
        const double high = ranges[0].high[k] - ranges[1].low[k], low = ranges[0].low[k] - ranges[1].high[k];
        bounds_.E = std::max({bounds_.E, high, -low});
        middle_[k] = 0.5 * high + 0.5 * low;
    }
    // Other differences than those of boxes of some vertices are further away by as much as solids extend.
    if (!is_scanned) bounds_.E += hulls.size(0) + hulls.size(1);
    bounds_.V *= RoundedBounds::slack;
    bounds_.E *= RoundedBounds::slack;
    const double E = bounds_.E, delta = bounds_.delta;
    bounds_.e_x = RoundedBounds::slack * (4 * delta + 4 * two_u * E);
    // Comparisons with a NaN are false.
    return E >= 0x1p-200 && E <= 0x1p200 && delta <= E;
}

}  // namespace ecods::depths
