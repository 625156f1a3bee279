#include "scenes/building/pipe_contact.hpp"

#include <limits>
#include <stdexcept>

namespace ecods::scenes {
namespace {

using Point = std::array<Length, 2>;
using Polygon = std::vector<Point>;  // convex, counterclockwise

Polygon polygon_of(const Element& pipe) {
    const auto corners = pipe_corners(pipe);
    return {corners.begin(), corners.end()};
}

// What is seen of a block along an axis.
Polygon polygon_of(const Block& block, std::size_t axis) {
    const std::size_t u = (axis + 1) % 3;
    const std::size_t v = (axis + 2) % 3;
    return {{block.min[u], block.min[v]},
            {block.max[u], block.min[v]},
            {block.max[u], block.max[v]},
            {block.min[u], block.max[v]}};
}

enum class Meeting2d { apart, touching, overlapping };

// How far `b` reaches beyond the sides of `a`: apart if it is beyond one of them, touching if it begins at one.
Meeting2d beyond_sides(const Polygon& a, const Polygon& b) {
    Meeting2d meeting = Meeting2d::overlapping;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Point& from = a[i];
        const Point& to = a[(i + 1) % a.size()];
        Length most = std::numeric_limits<Length>::min();  // how far inwards of this side
        for (const Point& p : b)
            most = std::max(most, (to[0] - from[0]) * (p[1] - from[1]) - (to[1] - from[1]) * (p[0] - from[0]));
        if (most < 0) return Meeting2d::apart;
        if (most == 0) meeting = Meeting2d::touching;
    }
    return meeting;
}

Meeting2d meet(const Polygon& a, const Polygon& b) {
    return std::min(beyond_sides(a, b), beyond_sides(b, a));
}

Meeting2d meet(Length a_min, Length a_max, Length b_min, Length b_max) {
    const Length shared = std::min(a_max, b_max) - std::max(a_min, b_min);
    if (shared < 0) return Meeting2d::apart;
    return shared == 0 ? Meeting2d::touching : Meeting2d::overlapping;
}

bool holds(const Block& block, const std::array<Length, 3>& point) {
    return !is_empty(common(block, {point, point}));
}

// The middle of the pipe at one of its ends.
std::array<Length, 3> middle_at(const Element& pipe, Length end) {
    const auto w = static_cast<std::size_t>(pipe.axis);
    std::array<Length, 3> point{};
    point[w] = end;
    point[(w + 1) % 3] = pipe.u;
    point[(w + 2) % 3] = pipe.v;
    return point;
}

bool is_in(const std::array<Length, 3>& point, const Blocks& solid) {
    return std::any_of(solid.begin(), solid.end(), [&](const Block& block) { return holds(block, point); });
}

// A box in the pipe: its figure has half the width on each side, and more.
Block inner_block(const Element& pipe) {
    Block block = bounds_of(pipe);
    const auto w = static_cast<std::size_t>(pipe.axis);
    for (const std::size_t axis : {(w + 1) % 3, (w + 2) % 3}) {
        block.min[axis] += pipe.radius / 2;
        block.max[axis] -= pipe.radius / 2;
    }
    return block;
}

}  // namespace

Contact contact_of_pipe(const Element& pipe, const Blocks& solid) {
    const auto w = static_cast<std::size_t>(pipe.axis);
    Meeting2d strongest = Meeting2d::apart;
    for (const Block& block : solid) {
        const Meeting2d meeting =
            std::min(meet(polygon_of(pipe), polygon_of(block, w)), meet(pipe.lo, pipe.hi, block.min[w], block.max[w]));
        strongest = std::max(strongest, meeting);
    }
    if (strongest == Meeting2d::apart) return Contact::apart;
    if (strongest == Meeting2d::touching) return Contact::touching;
    const Block bounds = bounds_of(pipe);
    Length inside = 0;
    for (const Block& block : solid) inside += measure(common(bounds, block), bounds);
    if (inside == measure(bounds, bounds)) return Contact::inside;
    const bool ends_inside = is_in(middle_at(pipe, pipe.lo), solid) && is_in(middle_at(pipe, pipe.hi), solid);
    const bool holds_solid = std::all_of(solid.begin(), solid.end(), [&](const Block& block) {
        return !is_empty(block) && measure(common(block, bounds), block) == measure(block, block);
    });
    if (ends_inside || holds_solid) throw std::logic_error("how a pipe is to a solid is not known");
    return Contact::overlapping;
}

Contact contact_of_pipes(const Element& a, const Element& b) {
    if (a.axis == b.axis) {
        const Meeting2d meeting = std::min(meet(polygon_of(a), polygon_of(b)), meet(a.lo, a.hi, b.lo, b.hi));
        if (meeting == Meeting2d::apart) return Contact::apart;
        if (meeting == Meeting2d::touching) return Contact::touching;
        throw std::logic_error("pipes along one axis share inner points");
    }
    const Block inner = common(inner_block(a), inner_block(b));
    const bool share_inner_points =
        inner.min[0] < inner.max[0] && inner.min[1] < inner.max[1] && inner.min[2] < inner.max[2];
    const auto sticks_out = [](const Element& pipe, const Element& other) {
        const Block bounds = bounds_of(other);
        return !holds(bounds, middle_at(pipe, pipe.lo)) || !holds(bounds, middle_at(pipe, pipe.hi));
    };
    if (!share_inner_points || !sticks_out(a, b) || !sticks_out(b, a))
        throw std::logic_error("how two pipes are to each other is not known");
    return Contact::overlapping;
}

void require_extreme_at(const Element& pipe, const Block& block) {
    const Block bounds = bounds_of(pipe);
    const auto w = static_cast<std::size_t>(pipe.axis);
    for (const std::size_t axis : {(w + 1) % 3, (w + 2) % 3}) {
        const Length center = axis == (w + 1) % 3 ? pipe.u : pipe.v;
        const bool is_apart = bounds.max[axis] < block.min[axis] || block.max[axis] < bounds.min[axis];
        if (!is_apart && (center < block.min[axis] || center > block.max[axis]))
            throw std::logic_error("the distance of a pipe is not known");
    }
}

}  // namespace ecods::scenes
