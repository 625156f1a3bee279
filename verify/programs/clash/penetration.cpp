#include "programs/clash/penetration.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "ecods/distance.hpp"
#include "ecods/shape.hpp"
#include "ecods/solid.hpp"
#include "programs/clash/place.hpp"
#include "programs/clash/verdict.hpp"

namespace ecods::clash {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Null if the part is not known to be convex.
const ConvexSolid* convex_of(const Part& part) {
    return dynamic_cast<const ConvexSolid*>(part.shape.get());
}

std::optional<Interval> convex_depth(const Part& a, const Part& b, QueryMemory& memory) {
    if (!are_convex(a, b)) return std::nullopt;
    const double depth = ecods::depth({*convex_of(a), a.pose}, {*convex_of(b), b.pose}, memory).value().depth;
    return Interval{depth, depth};
}

// Not less than a - b. The rounded difference is off by less than the way to its neighbor; it is exact if a and b are
// within a factor of two (Sterbenz).
double difference_above(double a, double b) {
    const double difference = a - b;
    const bool is_exact = (b / 2 <= a && a <= 2 * b) || (2 * b <= a && a <= b / 2) || b == 0 || a == 0;
    return is_exact ? difference : std::nextafter(difference, infinity);
}

double bound_above(const Aabb& a, const Aabb& b) {
    double least = infinity;
    for (int axis = 0; axis < 3; ++axis) {
        least = std::min(least, difference_above(a.max[axis], b.min[axis]));
        least = std::min(least, difference_above(b.max[axis], a.min[axis]));
    }
    return least;
}

// A radius of a ball around the point that is inside the solid; 0 if the point is not. The distance is rounded once, so
// the double below it is not above the real one.
double radius_in(const Part& part, const Vec3& point, QueryMemory& memory) {
    if (locate(point, solid_of(part), memory).side != Side::inside) return 0;
    const MeshShape ball_center(Mesh::create({point}, {{0, 0, 0}}));
    return std::nextafter(distance(surface_of(part), {ball_center, Pose{}}, memory), 0.0);
}

}  // namespace

bool are_convex(const Part& a, const Part& b) {
    return convex_of(a) != nullptr && convex_of(b) != nullptr;
}

Interval depth_of(const Part& a, const Part& b, const Aabb& common, QueryMemory& memory) {
    if (const auto depth = convex_depth(a, b, memory)) return *depth;
    const Vec3 middle = common.min / 2 + common.max / 2;
    const double radius_a = radius_in(a, middle, memory);
    const double radius = radius_a == 0 ? 0 : std::min(radius_a, radius_in(b, middle, memory));
    const double above = bound_above(bounds_of(a), bounds_of(b));
    return {std::min(2 * radius, above), above};
}

Interval narrow_depth_of(const Part& a, const Part& b, QueryMemory& memory) {
    if (const auto depth = convex_depth(a, b, memory)) return *depth;
    const DepthBounds bounds = depth_bounds(solid_of(a), solid_of(b), memory).value();
    return {bounds.lower, bounds.upper};
}

}  // namespace ecods::clash
