// A block above, on and in a slab: each question about two bodies once.
#include <fmt/core.h>
#include <fmt/ostream.h>
#include <ecods/ecods.hpp>

#include <limits>
#include <string>
#include <vector>

namespace {

using ecods::Vec3;

std::string text(const Vec3& v) {
    return fmt::format("({}, {}, {})", v.x(), v.y(), v.z());
}

// A solid is the shape of a closed mesh; a convex one is the hull of points, here of the corners of a box.
ecods::ConvexSolid box(const Vec3& least, const Vec3& greatest) {
    std::vector<Vec3> corners;
    for (const double x : {least.x(), greatest.x()})
        for (const double y : {least.y(), greatest.y()})
            for (const double z : {least.z(), greatest.z()}) corners.emplace_back(x, y, z);
    return ecods::ConvexSolid(corners);
}

}  // namespace

int main() {
    const ecods::ConvexSolid block = box({0, 0, 0}, {1, 1, 1});
    const ecods::ConvexSolid slab = box({-2, -2, -1}, {3, 3, 0});
    for (const double height : {0.1, 0.0, -0.3}) {
        // A body is a shape at a pose: the real points R v + t.
        const ecods::Posed<ecods::ConvexSolid> a(block, {.t = {0, 0, height}}), b(slab, {});
        fmt::print("The block is at {}.\n", height);
        fmt::print("  {}, distance {}\n", fmt::streamed(relation(a, b)), distance(a, b));
        const ecods::ClosestPoints points = closest(a, b);
        fmt::print("  closest: {}, {} and {}\n", fmt::streamed(points.kind), text(points.point_a),
                   text(points.point_b));
        if (const auto out = depth(a, b))
            fmt::print("  depth {}: the slab would move out along {}\n", out->depth, text(out->direction));
        fmt::print("  pairs of triangles that share a point: {}\n", intersections(a, b).size());
        const Vec3 down(0, 0, -1);
        if (const auto contact = cast(a, down, b))
            fmt::print("  falling, it meets the slab at time {}\n", contact->time);
        if (const auto hit = first_hit(ecods::Ray{.origin = {0.25, 0.5, 2}, .direction = down}, a))
            fmt::print("  a ray from above hits triangle {} at {}\n", hit->triangle(), text(hit->point));
    }

    // What is wrong is said by a typed error, and changes nothing.
    try {
        box({0, 0, 0}, {1, 1, std::numeric_limits<double>::infinity()});
    } catch (const ecods::InvalidMesh& error) {
        fmt::print("A box without end: {}\n", error.what());
    }
}
