// Boxes past each other, and how deep they are (libccd, src/testsuites: boxbox.c, mpr_boxbox.c, and what they print,
// regressions/TSBoxBox.out and TSMPRBoxBox.out, to six digits).
#include <cmath>
#include <numbers>

#include "foreign/shapes.hpp"
#include "foreign/sources.hpp"

namespace ecods::foreign::libccd {
namespace {

// A box goes along an axis by 100 steps. It meets the other in the steps from `first` to `last`; in these two it
// touches, or does so but for the rounding of the sum of steps, and the source expects nothing.
struct Way {
    Vec3 sides, start;
    int axis;
    double step;
    Vec3 other_sides;
    double angle;  // about y
    int first, last;
};
const Way ways[] = {
    {{1, 2, 1}, {-5, 0, 0}, 0, 0.1, {2, 1, 2}, 0, 35, 65},
    {{0.1, 0.2, 0.1}, {-0.5, 0, 0}, 0, 0.01, {0.2, 0.1, 0.2}, 0, 35, 65},
    {{1, 2, 1}, {-5, -0.1, 0}, 0, 0.1, {2, 1, 2}, 0, 35, 65},
    {{1, 2, 1}, {0, -5, 0}, 1, 0.1, {2, 1, 2}, 0, 35, 65},
    {{1, 2, 1}, {0, 0, -5}, 2, 0.1, {2, 1, 2}, 0, 35, 65},
    {{1, 2, 1}, {-5, 0.5, 0}, 0, 0.1, {2, 1, 2}, pi / 4, 33, 67},
};

void ask_ways(Expectations& expect) {
    expect.from("boxbox, steps of a box");
    for (const Way& way : ways) {
        const ConvexSolid a = box(way.sides / 2), b = box(way.other_sides / 2);
        Pose pose{turn(way.angle, Vec3::UnitY()), way.start};
        for (int i = 0; i < 100; ++i, pose.t[way.axis] += way.step) {
            if (i == way.first || i == way.last) continue;
            const bool meet = way.first < i && i < way.last;
            expect.is(distance({a, pose}, {b, Pose{}}) == 0, meet);
            expect.is(distance({b, Pose{}}, {a, pose}) == 0, meet);
        }
    }
}

// Two unit boxes at a distance of 1.01; the one turns on, and reaches the other but where it is straight.
void ask_turns(Expectations& expect) {
    expect.from("boxboxRot, a box that turns");
    const ConvexSolid cube = box(Vec3(0.5, 0.5, 0.5));
    double angle = 0;
    for (int i = 0; i < 30; ++i, angle += pi / 20) {
        const Pose pose{turn(angle, Vec3::UnitY()), Vec3(-1.01, 0, 0)};
        expect.is(distance({cube, pose}, {cube, Pose{}}) == 0, i % 10 != 0);
    }
}

// A turned box and one at rest, with the depth. `other` are sides.
struct Pen {
    Mat3 R;
    Vec3 at, other, other_at;
    double depth;
    Vec3 direction;  // of the second; zero if the source says none, or not the only one
};

Mat3 about(const Vec3& axis) {
    return turn(pi / 4, axis);
}

void ask_depths(Expectations& expect) {
    expect.from("boxboxPenetration, boxboxSeparate");
    const Mat3 I = Mat3::Identity(), z = about({0, 0, 1}), yz = about({0, 1, 1});
    const Vec3 plate(0.5, 1, 1.5), cube(1, 1, 1), small(0.5, 0.5, 0.5), none = Vec3::Zero();
    const double root = std::numbers::sqrt2 / 2;
    const Pen pens[] = {
        {I, none, plate, {0.1, 0, 0}, 0.65, {1, 0, 0}},
        {I, {-0.3, 0.5, 1}, plate, {0.1, 0, 0}, 0.25, {0, 0, -1}},
        {z, {0.1, 0, 0.1}, cube, {0.1, 0, 0}, 0.9, {0, 0, -1}},
        {z, {-0.5, 0, 0}, cube, {0.1, 0, 0}, 0.607107, {1, 0, 0}},
        {z, {-0.5, 0.5, 0}, cube, {0.1, 0, 0}, 0.429289, {root, -root, 0}},
        {yz, {-0.5, 0.1, 0.4}, cube, {0.1, 0, 0}, 0.648412, {0.862856, 0, -0.505449}},
        // TSMPRBoxBox.out has 0.622928 along (0.999509, 0.028016, -0.014008), which is not the least: 0.622622 along
        // (1, 0, 0) parts them, as TSBoxBox.out has it.
        {yz * about({1, 1, 1}), {-0.5, 0.1, 0.4}, cube, {0.1, 0, 0}, 0.622622, {1, 0, 0}},
        {z * about({1, 0, 0}), {-1.3, 0, 0}, cube, none, 0.053553, {1, 0, 0}},
        {I, none, small, {0, 0.73, 0}, 0.02, {0, 1, 0}},
        {I, none, small, {0.3, 0.738, 0}, 0.012, {0, 1, 0}},
        {I, {-0.5, 0.5, 0.2}, plate, none, 0.25, {1, 0, 0}},
        {I, {-0.3, 0.5, 1}, plate, none, 0.25, {0, 0, -1}},
        {z, none, cube, none, 1, none},
        {z, {-0.5, 0, 0}, cube, none, 0.707107, {1, 0, 0}},
        {yz, {-0.5, 0.1, 0.4}, cube, none, Vec3(0.633939, 0, -0.371353).norm(), {0.862856, 0, -0.505449}},
    };
    const ConvexSolid a = box(Vec3(0.5, 0.5, 0.5));
    for (const Pen& pen : pens) {
        const ConvexSolid b = box(pen.other / 2);
        const auto found = depth({a, {pen.R, pen.at}}, {b, {Mat3::Identity(), pen.other_at}});
        expect.is(found.has_value(), true);
        if (!found) continue;
        expect.near(found->depth, pen.depth, 1e-6);
        for (int k = 0; k < 3 && pen.direction != none; ++k) expect.near(found->direction[k], pen.direction[k], 1e-6);
    }
    // Moved by what the first of boxboxSeparate says, the two touch: -0.5 - 0.25 and half of 1 and 0.5 are exact.
    const ConvexSolid b = box(plate / 2);
    const auto moved = depth({a, at(-0.75, 0.5, 0.2)}, {b, Pose{}});
    expect.is(moved.has_value() && moved->depth == 0, true);
}

}  // namespace

void ask(Expectations& expect) {
    ask_ways(expect);
    ask_turns(expect);
    ask_depths(expect);
}

}  // namespace ecods::foreign::libccd
