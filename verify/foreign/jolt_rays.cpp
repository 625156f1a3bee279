// Rays through boxes, hulls, scaled hulls and pairs of hulls (Jolt, UnitTests/Physics/RayShapeTests.cpp and
// UnitTests/Geometry/RayAABoxTests.cpp).
#include <array>
#include <optional>

#include "foreign/shapes.hpp"
#include "foreign/sources.hpp"

namespace ecods::foreign::jolt_rays {
namespace {

// The source's numbers are floats, which it allows this error in.
constexpr double within_floats = 2.5e-5;

// A ray from `from` to `to`, in lengths from A (0) to B (1), which are where the line through both meets the surface:
// where it does so, in lengths of the ray, and whether it begins inside.
struct Part {
    double from, to;
    std::array<double, 2> hits;
    std::size_t hit_count;
    bool is_inside;
};
constexpr Part parts[] = {
    {-2, -0.1, {}, 0, false},     {-0.1, -0.1, {}, 0, false},
    {-0.1, 0.1, {0.5}, 1, false}, {-0.1, 1.1, {0.1 / 1.2, 1.1 / 1.2}, 2, false},
    {0.9, 0.9, {}, 0, true},      {0.9, 1.1, {0.5}, 1, true},
    {1.1, 5.2, {}, 0, false},
};

class Rays {
  public:
    Rays(Expectations& expect, const Solid& solid) : expect_(expect), solid_(solid) {}

    // By itself, and in a world where it stands turned, from both sides.
    void ask(const Vec3& a, const Vec3& b, const Pose& own = {}) const {
        const Pose world{turn(pi / 4, Vec3::UnitX()), Vec3(2, 3, 4)};
        for (const Pose& by : {Pose{}, world}) {
            const auto moved = [&](const Vec3& p) { return Vec3(by.R * p + by.t); };
            const Pose pose{by.R * own.R, by.R * own.t + by.t};
            ask_parts(moved(a), moved(b), pose);
            ask_parts(moved(b), moved(a), pose);
        }
    }
    // Along three axes through the origin of the hull, at a pose of its own.
    void ask_axes(const Vec3& low, const Vec3& high, const Pose& at = {}, const Pose& own = {}) const {
        for (int k = 0; k < 3; ++k) {
            const Vec3 a = low[k] * Vec3::Unit(k), b = high[k] * Vec3::Unit(k);
            ask(at.R * a + at.t, at.R * b + at.t, own);
        }
    }
    void ask_miss(const Vec3& origin, const Vec3& direction) const {
        expect_.is(first_hit(Ray{origin, direction}, {surface_of(solid_), Pose{}}).has_value(), false);
    }

  private:
    void ask_parts(const Vec3& a, const Vec3& b, const Pose& pose) const {
        for (const Part& part : parts) {
            const Vec3 from = a + part.from * (b - a), to = a + part.to * (b - a);
            const auto hits = all_hits(Segment{from, to}, {surface_of(solid_), pose});
            expect_.is(hits.empty() ? std::size_t{0} : hits.back().rank + std::size_t{1}, part.hit_count);
            for (const Hit& hit : hits) {
                if (hit.rank < part.hit_count) expect_.near(hit.parameter, part.hits[hit.rank], within_floats);
            }
            expect_.is(locate(from, {solid_, pose}).side == Side::inside, part.is_inside);
        }
    }

    Expectations& expect_;
    const Solid& solid_;
};

void ask_shapes(Expectations& expect) {
    expect.from("TestBoxShapeRay");
    const ConvexSolid plain = box({2, 3, 4});
    Rays(expect, plain).ask_axes({-2, -3, -4}, {2, 3, 4});

    expect.from("TestConvexHullShapeRay");
    const Vec3 low(-2, -4, -6), high(3, 5, 7);
    const ConvexSolid hull = hull_of(box_corners(low, high));
    const Rays rays(expect, hull);
    rays.ask_axes(low, high);
    for (const double y : {-5.0, 0.0, 6.0}) rays.ask_miss({-3, y, 0}, Vec3::UnitY());

    expect.from("TestScaledShapeRay");
    for (const double x : {2.0, -2.0}) {
        Pose scaled;
        scaled.R = Vec3(x, 3, 4).asDiagonal();
        for (int k = 0; k < 3; ++k) {
            const Vec3 axis = Vec3::Unit(k);
            rays.ask(scaled.R * (low[k] * axis), scaled.R * (high[k] * axis), scaled);
        }
    }

    expect.from("TestStaticCompoundShapeRay");
    const Pose first{turn(0.1 * pi, Vec3::UnitX()) * turn(0.2 * pi, Vec3::UnitY()), Vec3(10, 20, 30)};
    const Pose second{turn(0.3 * pi, Vec3::UnitZ()), Vec3(40, 50, 60)};
    const Solid compound(both(hull.mesh(), first, second));
    const Rays of_both(expect, compound);
    of_both.ask_axes(low, high, first);
    of_both.ask_axes(low, high, second);
}

// The box from -1 to 1: a ray from the center has no first side there (the source says -1: it is behind); from where it
// leads to, back, it has.
void ask_box(Expectations& expect) {
    expect.from("TestRayAABox");
    const ConvexSolid unit = box({1, 1, 1});
    const auto first = [&](const Vec3& origin, const Vec3& direction) {
        const auto hit = first_hit(Ray{origin, direction}, {surface_of(unit), Pose{}});
        return hit ? hit->parameter : -1;
    };
    for (int axis = 0; axis < 3; ++axis) {
        for (const double sign : {1.0, -1.0}) {
            const Vec3 along = sign * Vec3::Unit(axis);
            expect.is(first(Vec3::Zero(), along), 1.0);
            expect.is(first(-2 * along, along), 1.0);
            expect.near(first(1.1 * along, -along), 0.1, 1e-6);
            expect.is(first(1.1 * along, along), -1.0);
        }
    }
    const Vec3 direction(4, -4, 0);
    expect.near(first(Vec3(0, 1, 0) - 0.123 * direction, direction), 0.123, 1e-6);
}

}  // namespace

void ask(Expectations& expect) {
    ask_shapes(expect);
    ask_box(expect);
}

}  // namespace ecods::foreign::jolt_rays
