// What a program asks about two figures of a plane: do they collide, in what, how far are they apart, how deep in each
// other, where do they touch and which way do they push? Every coordinate, distance and depth is the true one of the
// figures as given, rounded once.
//
// usage: ecods_plane_figures [PICTURE.svg]
#include <fmt/core.h>

#include <cmath>
#include <exception>
#include <fstream>

#include "examples/plane_figures/picture.hpp"
#include "examples/plane_figures/placed_figure.hpp"

namespace {

using namespace ecods::examples;
using ecods::Vec2;
using ecods::scenes::Outline;
using ecods::scenes::PlaneFigure;

constexpr const char* blue = "#1565c0";
constexpr const char* green = "#2e7d32";

// On the terminal and in the picture.
template <class... Arguments>
void say(Picture& picture, fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    const std::string text = fmt::format(format, std::forward<Arguments>(arguments)...);
    fmt::print("  {}\n", text);
    picture.add_line(text);
}

std::string text(const Vec2& v) {
    return fmt::format("({}, {})", v.x(), v.y());
}

void begin(Picture& picture, const std::string& title, const Vec2& middle) {
    fmt::print("{}\n", title);
    picture.begin_field(title, middle);
}

bool collide(const PlacedFigure& a, const PlacedFigure& b) {
    return intersects(a.flat(), b.flat());
}

void show_intersection(Picture& picture, const PlacedFigure& a, const PlacedFigure& b) {
    double twice_area = 0;
    for (const std::vector<Vec2>& piece : intersection(a, b)) {
        for (std::size_t i = 0; i + 2 < piece.size(); ++i) {
            const Vec2 p = piece[i + 1] - piece[0], q = piece[i + 2] - piece[0];
            twice_area += std::abs(p.x() * q.y() - p.y() * q.x());
        }
        picture.add_region(piece);
    }
    const std::vector<Vec2> points = crossings(a, b);
    say(picture, "they collide, in an area of {:.9f}; sides cross at {} points", twice_area / 2, points.size());
    for (const Vec2& point : points) {
        fmt::print("    {}\n", text(point));
        picture.add_point(point);
    }
}

void show_convex(Picture& picture) {
    const PlacedFigure a("a", {{{2, 0}, {1, 1.75}, {-1, 1.75}, {-2, 0}, {-1, -1.75}, {1, -1.75}}, {}}, {1, 0}, {0, 0});
    const PlacedFigure b("b", {{{-1.5, -1}, {2, -0.5}, {-0.5, 2}}, {}}, {0.8, 0.6}, {2.25, 0.5});
    begin(picture, "Convex figures: how deep?", {1, 0.5});
    picture.add_figure(a, blue);
    picture.add_figure(b, green);
    show_intersection(picture, a, b);
    const PlaneDepth depth = convex_depth(a, b).value();
    const Vec2 way = depth.depth * depth.direction;
    say(picture, "depth {}, by the normal of {}:", depth.depth, depth.side);
    say(picture, "b moves along {}", text(depth.direction));
    picture.add_ghost(b, way, green);
    const Vec2 from = b.to_plane({0, 0.2});
    picture.add_arrow(from, from + way);
}

void show_hole(Picture& picture) {
    PlaneFigure gear;
    constexpr double pi = 3.14159265358979324;
    for (int i = 0; i < 48; ++i) {
        const double radius = i % 4 < 2 ? 3.5 : 3;
        gear.outline.emplace_back(std::round(1024 * radius * std::cos(i * pi / 24)) / 1024,
                                  std::round(1024 * radius * std::sin(i * pi / 24)) / 1024);
    }
    gear.holes = {
        {{-1.75, -1.5}, {1.75, -1.5}, {1.75, 1.5}, {0.5, 1.5}, {0.5, 2}, {-0.5, 2}, {-0.5, 1.5}, {-1.75, 1.5}}};
    const PlacedFigure a("a", gear, {0.96, 0.28}, {0, 0});
    const PlacedFigure b("b", {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}, {{{0.5, 0}, {0, -0.5}, {-0.5, 0}, {0, 0.5}}}},
                         {1, 0}, {0.25, -0.125});
    begin(picture, "A figure in another's hole: how far?", {0, 0});
    picture.add_figure(a, blue);
    picture.add_figure(b, green);
    const ecods::ClosestPoints points = closest(a.flat(), b.flat());
    say(picture, "they {}; distance {}", collide(a, b) ? "collide" : "do not collide", points.distance);
    const Vec2 on_a = points.point_a.head<2>(), on_b = points.point_b.head<2>();
    say(picture, "from {}", text(on_a));
    say(picture, "to {}", text(on_b));
    picture.add_segment(on_a, on_b);
}

void show_contacts(Picture& picture) {
    const PlacedFigure a("a", {{{-4, -2}, {3.5, -2}, {3.5, 2.5}, {2.5, 2.5}, {2.5, -1}, {-4, -1}}, {}}, {1, 0}, {0, 0});
    const PlacedFigure b("b", {{{-1.75, 0}, {1.25, 0}, {1.25, 1.5}, {0, 3}, {-1.75, 1.5}}, {}}, {1, 0}, {1.1875, -1});
    begin(picture, "At rest by a wall: where do they touch?", {0, 0.5});
    picture.add_figure(a, blue);
    picture.add_figure(b, green);
    say(picture, "they {}; within 0.1 of each other:", collide(a, b) ? "collide" : "do not collide");
    for (const PlaneContact& contact : contacts(a, b, 0.1)) {
        say(picture, "gap {} at {}, {}: {}", contact.gap, text(contact.on_a),
            contact.normal ? "normal " + text(*contact.normal) : "no normal", contact.what);
        picture.add_point(contact.on_a);
        if (contact.normal) picture.add_arrow(contact.on_b, contact.on_b + 0.75 * *contact.normal);
    }
}

void show_bounds(Picture& picture) {
    const PlacedFigure a("a", {{{-3, -2}, {3, -2}, {3, 2}, {2, 2}, {2, -1}, {-2, -1}, {-2, 2}, {-3, 2}}, {}}, {1, 0},
                         {0, 0});
    const PlacedFigure b("b",
                         {{{-2, 0}, {-0.5, 0.5}, {0, 2.5}, {0.5, 0.5}, {2, 0}, {0.5, -0.5}, {0, -2}, {-0.5, -0.5}}, {}},
                         {0.936, 0.352}, {-0.875, 0.875});
    begin(picture, "Not convex: between what bounds is the depth?", {-0.5, 1});
    picture.add_figure(a, blue);
    picture.add_figure(b, green);
    show_intersection(picture, a, b);
    const PlaneDepthBounds bounds = depth_bounds(a, b).value();
    const Vec2 way = bounds.parted - b.pose.t.head<2>();
    say(picture, "depth from {:.3f} to {:.3f}: parted at {}", bounds.lower, bounds.upper, text(bounds.parted));
    picture.add_ghost(b, way, green);
    const Vec2 from = b.to_plane({0, 0});
    picture.add_arrow(from, from + way);
}

void show_error() {
    fmt::print("No figure\n");
    try {
        ecods::scenes::check_figure({{{0, 0}, {2, 2}, {2, 0}, {0, 2}}, {}});
    } catch (const ecods::scenes::FigureError& error) {
        fmt::print("  {}\n", error.what());
    }
}

}  // namespace

int main(int argc, char** argv) {
    try {
        Picture picture;
        show_convex(picture);
        show_hole(picture);
        show_contacts(picture);
        show_bounds(picture);
        show_error();
        if (argc > 1) {
            std::ofstream out(argv[1]);
            picture.write(out);
            if (!out.flush()) throw std::runtime_error(std::string("cannot write ") + argv[1]);
        }
    } catch (const std::exception& error) {
        fmt::print(stderr, "ecods_plane_figures: {}\n", error.what());
        return 1;
    }
}
