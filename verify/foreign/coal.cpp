// Boxes: distances, closest points and security margins (Coal, test/box_box_distance.cpp and security_margin.cpp).
#include <cmath>
#include <numbers>
#include <optional>

#include "foreign/shapes.hpp"
#include "foreign/sources.hpp"

namespace ecods::foreign::coal {
namespace {

constexpr double root_2 = std::numbers::sqrt2;

Pose quaternion(double w, double x, double y, double z, const Vec3& t) {
    return Pose::from_quaternion(Eigen::Quaterniond(w, x, y, z), t);
}

Pose product(const Pose& a, const Pose& b) {
    return {a.R * b.R, a.R * b.t + a.t};
}

// Distance and points, with the relative error of 1e-6 that the source allows.
void check(Expectations& expect, const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, double distance,
           const Vec3& point_a, const Vec3& point_b) {
    const auto closest = closest_apart(a, b);
    expect.is(closest.has_value(), true);
    if (!closest) return;
    expect.near(closest->distance, distance, 1e-6 * distance);
    for (int k = 0; k < 3; ++k) {
        expect.near(closest->point_a[k], point_a[k], 1e-6 * std::abs(point_a[k]));
        expect.near(closest->point_b[k], point_b[k], 1e-6 * std::abs(point_b[k]));
    }
}

void ask_distances(Expectations& expect) {
    const ConvexSolid large = box({3, 5, 1}), middle = box({1, 1, 1}), unit = box({0.5, 0.5, 0.5});
    expect.from("distance_box_box_1");
    check(expect, {large, Pose{}}, {middle, at(25, 20, 5)}, std::sqrt(21. * 21 + 14 * 14 + 3 * 3), {3, 5, 1},
          {24, 19, 4});

    expect.from("distance_box_box_2");
    const double s = std::sin(pi / 8) / std::sqrt(3), z = -1.62123444 + 10;
    check(expect, {large, Pose{}}, {middle, quaternion(std::cos(pi / 8), s, s, s, {0, 0, 10})}, z - 1,
          {0.60947571, 0.01175873, 1}, {0.60947571, 0.01175873, z});

    expect.from("distance_box_box_3");
    const double c8 = std::cos(pi / 8), s8 = std::sin(pi / 8);
    const Pose a = quaternion(c8, 0, 0, s8, {-2, 1, .5}), b = quaternion(c8, 0, s8, 0, {2, .5, .5});
    const Vec3 p(root_2 / 2 - 2, 1, .5), q(2 - root_2 / 2, 1, .5);
    check(expect, {unit, a}, {unit, b}, 4 - root_2, p, q);
    const Pose moved = quaternion(0.435952844074, -0.718287018243, 0.310622451066, 0.444435113443, {4, 5, 6});
    check(expect, {unit, product(moved, a)}, {unit, product(moved, b)}, 4 - root_2, moved.R * p + moved.t,
          moved.R * q + moved.t);

    // Differences of neighbors like these are exact in doubles.
    expect.from("distance_box_box_4");
    for (const double x : {2.0, 1.01, 0.99, 0.0}) {
        expect.is(signed_number({unit, at(x, 0, 0)}, {unit, Pose{}}), x - 1);
        expect.is(signed_number({unit, Pose{}}, {unit, at(x, 0, 0)}), x - 1);
    }
}

// Whether the boxes count as colliding when their distance may be as large as the margin, or must be below it.
bool collide(const ConvexSolid& unit, double y, double z, double margin) {
    const Posed<ConvexSolid> a{unit, Pose{}}, b{unit, at(0, y, z)};
    if (margin >= 0) return within(a, b, margin);
    const auto how_deep = depth(a, b);
    return how_deep && how_deep->depth >= -margin;
}

struct Margin {
    double y, z, margin;
    bool collide;
};
constexpr Margin margins[] = {
    {1, 1, 0, true},
    {1, 1 + 0.01, 0, false},
    {1, 1, 0.01, true},
    // The source expects these to collide. 1 + 0.01 is 1.0100000000000000088..., and 0.01 is 0.01000000000000000020...:
    // the distance is above the margin by 8.6e-18.
    {1, 1 + 0.01, 0.01, false},
    {1, 1, -0.01, false},
    // 1 - 0.01 is 0.98999999999999999111..., so the boxes are deeper than 0.01.
    {1 - 0.01, 1 - 0.01, -0.01, true},
};

void ask_margins(Expectations& expect) {
    expect.from("security_margin, box_box and aabb_aabb");
    const ConvexSolid unit = box({0.5, 0.5, 0.5});
    for (const Margin& m : margins) {
        expect.is(collide(unit, m.y, m.z, m.margin), m.collide);
        expect.is(collide(unit, -m.y, m.z, m.margin), m.collide);
        expect.is(collide(unit, m.z, m.y, m.margin), m.collide);
    }
    expect.is(signed_number({unit, Pose{}}, {unit, at(0, 1, 1)}), -0.0);
    expect.is(signed_number({unit, Pose{}}, {unit, at(0, 1, 1 + 0.01)}), (1 + 0.01) - 1);
    expect.is(signed_number({unit, Pose{}}, {unit, at(0, 1 - 0.01, 1 - 0.01)}), (1 - 0.01) - 1);
}

// A depth parts, and a distance joins: moved by a millionth more or less, what was said is so
// (normal_and_nearest_points).
void ask_moves(Expectations& expect) {
    expect.from("normal_and_nearest_points, boxes");
    const ConvexSolid a = box({0.5, 0.3, 0.2}), b = box({0.2, 0.4, 0.6});
    for (int i = 0; i < 200; ++i) {
        const Pose pose{turn(0.37 * i, Vec3(std::sin(i), std::cos(2 * i), 1)),
                        Vec3(std::cos(0.7 * i), std::sin(0.9 * i), std::sin(1.3 * i))};
        const auto how_deep = depth({a, Pose{}}, {b, pose});
        const auto closest = closest_apart({a, Pose{}}, {b, pose});
        expect.is(how_deep.has_value() != closest.has_value(), true);
        const Vec3 way =
            how_deep ? Vec3(how_deep->depth * how_deep->direction) : Vec3(closest->point_a - closest->point_b);
        const Vec3 step = 1e-6 * way.normalized();
        const Pose more{pose.R, pose.t + (way + step)}, less{pose.R, pose.t + (way - step)};
        expect.is(distance({a, Pose{}}, {b, more}) > 0, how_deep.has_value());
        expect.is(distance({a, Pose{}}, {b, less}) > 0, !how_deep.has_value());
    }
}

}  // namespace

void ask(Expectations& expect) {
    ask_distances(expect);
    ask_margins(expect);
    ask_moves(expect);
}

}  // namespace ecods::foreign::coal
