// Are these outlines those of a figure? Decided by CGAL's predicates, which are exact.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "scenes/plane/plane_figure.hpp"

namespace ecods::scenes {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;

Point to_point(const Vec2& v) {
    return {v.x(), v.y()};
}

std::vector<Point> to_points(const Outline& outline) {
    std::vector<Point> points;
    for (const Vec2& v : outline) points.push_back(to_point(v));
    return points;
}

struct Side {
    FigurePlace place;
    Point from, to;
    bool follows(const Side& other, std::size_t side_count) const {
        return place.outline == other.place.outline && place.index == (other.place.index + 1) % side_count;
    }
};

// Of two sides one of which begins where the other ends: whether that corner is all they share.
bool share_more_than_a_corner(const Point& before, const Point& corner, const Point& after) {
    return CGAL::collinear(before, corner, after) && !CGAL::collinear_are_ordered_along_line(before, corner, after);
}

bool meet(const Side& a, const Side& b, const PlaneFigure& figure) {
    const std::size_t count = figure.outline_at(a.place.outline).size();
    const bool b_follows = b.follows(a, count), a_follows = a.follows(b, count);
    if (b_follows && share_more_than_a_corner(a.from, a.to, b.to)) return true;
    if (a_follows && share_more_than_a_corner(b.from, b.to, a.to)) return true;
    if (a_follows || b_follows) return false;
    return CGAL::do_intersect(Kernel::Segment_2(a.from, a.to), Kernel::Segment_2(b.from, b.to));
}

void check_corners(const PlaneFigure& figure) {
    for (std::size_t i = 0; i < figure.outline_count(); ++i) {
        const Outline& outline = figure.outline_at(i);
        for (std::size_t k = 0; k < outline.size(); ++k)
            for (int axis = 0; axis < 2; ++axis)
                if (!std::isfinite(outline[k][axis])) throw CornerNotFinite({i, k}, axis, outline[k][axis]);
    }
    for (std::size_t i = 0; i < figure.outline_count(); ++i)
        if (figure.outline_at(i).size() < 3) throw TooFewCorners(i, figure.outline_at(i).size());
}

std::vector<Side> sides_of(const PlaneFigure& figure) {
    std::vector<Side> sides;
    for (std::size_t i = 0; i < figure.outline_count(); ++i) {
        const Outline& outline = figure.outline_at(i);
        for (std::size_t k = 0; k < outline.size(); ++k) {
            sides.push_back({{i, k}, to_point(outline[k]), to_point(outline[(k + 1) % outline.size()])});
            if (sides.back().from == sides.back().to) throw SideWithoutLength({i, k});
        }
    }
    return sides;
}

// A sweep along x: only sides whose intervals there overlap are looked at.
void check_sides(const PlaneFigure& figure) {
    std::vector<Side> sides = sides_of(figure);
    const auto low = [](const Side& side) { return std::min(side.from.x(), side.to.x()); };
    const auto high = [](const Side& side) { return std::max(side.from.x(), side.to.x()); };
    std::ranges::sort(sides, {}, low);
    std::optional<std::pair<FigurePlace, FigurePlace>> least;
    for (std::size_t i = 0; i < sides.size(); ++i) {
        for (std::size_t k = i + 1; k < sides.size() && low(sides[k]) <= high(sides[i]); ++k) {
            const std::pair<FigurePlace, FigurePlace> places = std::minmax(sides[i].place, sides[k].place);
            if ((!least || places < *least) && meet(sides[i], sides[k], figure)) least = places;
        }
    }
    if (least) throw SidesMeet(least->first, least->second);
}

// Sides do not meet, so one corner says where all of an outline is.
bool is_inside(const Outline& inner, const std::vector<Point>& outer) {
    return CGAL::bounded_side_2(outer.begin(), outer.end(), to_point(inner.front()), Kernel()) == CGAL::ON_BOUNDED_SIDE;
}

void check_holes(const PlaneFigure& figure) {
    std::vector<std::vector<Point>> holes;
    for (const Outline& hole : figure.holes) holes.push_back(to_points(hole));
    const std::vector<Point> outline = to_points(figure.outline);
    for (std::size_t i = 0; i < holes.size(); ++i) {
        if (!is_inside(figure.holes[i], outline)) throw HoleMisplaced(i);
        for (std::size_t k = 0; k < holes.size(); ++k)
            if (k != i && is_inside(figure.holes[i], holes[k])) throw HoleMisplaced(i, k);
    }
}

}  // namespace

void check_figure(const PlaneFigure& figure) {
    check_corners(figure);
    check_sides(figure);
    check_holes(figure);
}

}  // namespace ecods::scenes
