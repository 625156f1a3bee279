#include "query/solid/fan.hpp"

#include <algorithm>
#include <array>

#include "base/assert.hpp"
#include "exact/sign/frame_signs.hpp"

namespace ecods {

int PointSigns::orient3d(Point a, Point b, Point c, Point d) {
    return exact::with_signs(frame_, std::array{a, b, c, d}, [](auto& signs) { return signs.orient3d(0, 1, 2, 3); });
}

int PointSigns::orient2d(Point a, Point b, Point c, int axis) {
    return exact::with_signs(frame_, std::array{a, b, c}, [&](auto& signs) { return signs.orient2d(0, 1, 2, axis); });
}

int PointSigns::compare(Point a, Point b, int axis) {
    return exact::with_signs(frame_, std::array{a, b}, [&](auto& signs) { return signs.compare(0, 1, axis); });
}

int PointSigns::normal_axis(Point a, Point b, Point c) {
    return exact::with_signs(frame_, std::array{a, b, c}, [](auto& signs) { return signs.normal_axis(0); });
}

bool PointSigns::are_in_order(Point p, Point q, Point a, Point b) {
    int axis = 0, direction = 0;
    while (direction == 0 && axis < 3) direction = compare(p, q, axis++);
    return compare(a, b, axis - 1) == direction;
}

void sort_fan(PointSigns& signs, PointSigns::Point p, PointSigns::Point q, std::vector<Wing>& wings) {
    enum : std::uint32_t { along, first_half, opposite, second_half };
    const PointSigns::Point first = wings[0].apex;
    const int axis = signs.normal_axis(p, q, first);
    ECODS_ASSERT(axis >= 0);
    const int turn = signs.orient2d(p, q, first, axis);
    for (Wing& wing : wings) {
        const int side = signs.orient3d(p, q, first, wing.apex);
        wing.group = side > 0                                        ? first_half
                     : side < 0                                      ? second_half
                     : signs.orient2d(p, q, wing.apex, axis) == turn ? along
                                                                     : opposite;
    }
    const auto is_before = [&](const Wing& x, const Wing& y) {
        if (x.group != y.group) return x.group < y.group;
        if (x.group == along || x.group == opposite) return false;
        return signs.orient3d(p, q, x.apex, y.apex) > 0;
    };
    std::sort(wings.begin(), wings.end(), is_before);
    // Replaces the half-turn in `group` of each wing by the number of the wing's direction. `half` is the half-turn of
    // the previous wing, whose `group` has already been overwritten.
    std::uint32_t group = 0, half = wings[0].group;
    for (std::size_t i = 1; i < wings.size(); ++i) {
        const bool is_next = wings[i].group != half || ((half == first_half || half == second_half) &&
                                                        signs.orient3d(p, q, wings[i - 1].apex, wings[i].apex) != 0);
        half = wings[i].group;
        group += is_next;
        wings[i].group = group;
    }
    wings[0].group = 0;
}

}  // namespace ecods
