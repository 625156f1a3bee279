#include "bounds/segment_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/arithmetic.hpp"
#include "base/assert.hpp"
#include "base/double_key.hpp"
#include "ecods/primitives.hpp"
#include "geometry/find_invalid.hpp"

namespace ecods {
namespace {

constexpr double extent_max = 0x1p500;

int compare(double a, double b) noexcept {
    return (key_of(a) > key_of(b)) - (key_of(a) < key_of(b));
}
double lesser(double a, double b) noexcept {
    return compare(a, b) < 0 ? a : b;
}
double greater(double a, double b) noexcept {
    return compare(a, b) > 0 ? a : b;
}

}  // namespace

SegmentBounds::SegmentBounds(const Segment& segment) noexcept : segment_(segment), direction_(segment.b - segment.a) {
    double extent = 0;
    for (int k = 0; k < 3; ++k) {
        ECODS_ASSERT(is_finite(segment.a[k]) && is_finite(segment.b[k]));
        box_.min[k] = lesser(segment.a[k], segment.b[k]);
        box_.max[k] = greater(segment.a[k], segment.b[k]);
        sign_[static_cast<std::size_t>(k)] = compare(segment.b[k], segment.a[k]);
        extent = std::max(extent, std::abs(direction_[k]));
    }
    for (int x = 0; x < 3; ++x) {
        const double size_y = std::abs(direction_[(x + 1) % 3]), size_z = std::abs(direction_[(x + 2) % 3]);
        bound_[static_cast<std::size_t>(x)] = extent < extent_max
                                                  ? 16 * two_u * size_y * size_z + (0x1p-1000 * extent + 0x1p-1010)
                                                  : std::numeric_limits<double>::infinity();
    }
}

// Chooses each end of the part by a sign of the direction d: s = d_y (z - a_z) - d_z (y - a_y) grows with z if d_y > 0,
// and with y if d_z < 0.
inline std::array<double, 2> SegmentBounds::corner(const Aabb& box, int y, int z, int side) const noexcept {
    const bool is_upper_z = sign_[static_cast<std::size_t>(y)] == side;
    const bool is_upper_y = sign_[static_cast<std::size_t>(z)] != side;
    return {is_upper_y ? lesser(box.max[y], box_.max[y]) : greater(box.min[y], box_.min[y]),
            is_upper_z ? lesser(box.max[z], box_.max[z]) : greater(box.min[z], box_.min[z])};
}

BoxVerdict SegmentBounds::judge(const Aabb& box) const noexcept {
    bool is_certain = true;
    for (int x = 0; x < 3; ++x) {
        const int y = (x + 1) % 3, z = (x + 2) % 3;
        // If d_y or d_z is zero, the cross product is zero or along a coordinate axis. Coordinate axes do not separate
        // the segment and the box, since box() overlaps the box.
        if (sign_[static_cast<std::size_t>(y)] == 0 || sign_[static_cast<std::size_t>(z)] == 0) continue;
        const auto side_of = [&](const std::array<double, 2>& p) {
            return direction_[y] * (p[1] - segment_.a[z]) - direction_[z] * (p[0] - segment_.a[y]);
        };
        const double most = side_of(corner(box, y, z, 1)), least = side_of(corner(box, y, z, -1));
        const double bound = bound_[static_cast<std::size_t>(x)];
        if (most < -bound || least > bound) return BoxVerdict::apart;
        is_certain = is_certain && most > bound && least < -bound;
    }
    return is_certain ? BoxVerdict::meeting : BoxVerdict::unknown;
}

bool SegmentBounds::meets(const Aabb& box) const noexcept {
    if (!ecods::overlap(box_, box)) return false;
    const BoxVerdict verdict = judge(box);
    if (verdict != BoxVerdict::unknown) return verdict == BoxVerdict::meeting;
    for (int x = 0; x < 3; ++x) {
        const int y = (x + 1) % 3, z = (x + 2) % 3;
        if (sign_[static_cast<std::size_t>(y)] == 0 || sign_[static_cast<std::size_t>(z)] == 0) continue;
        const Vec2 a(segment_.a[y], segment_.a[z]), b(segment_.b[y], segment_.b[z]);
        const auto most = corner(box, y, z, 1), least = corner(box, y, z, -1);
        if (orient2d(a, b, Vec2(most[0], most[1])) == Sign::negative) return false;
        if (orient2d(a, b, Vec2(least[0], least[1])) == Sign::positive) return false;
    }
    return true;
}

bool overlap(const Segment& segment, const Aabb& box) noexcept {
    return SegmentBounds(segment).meets(box);
}

}  // namespace ecods
