#include "scenes/plane/plane_figure.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "ecods/solid.hpp"
#include "mesh_measures.hpp"
#include "scenes/random.hpp"

namespace ecods::scenes {
namespace {

double twice_area(const Vec2& a, const Vec2& b, const Vec2& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

double twice_area(const Outline& outline) {
    double area = 0;
    for (std::size_t i = 0; i + 2 < outline.size(); ++i) area += twice_area(outline[0], outline[i + 1], outline[i + 2]);
    return std::abs(area);
}

double twice_area(const PlaneFigure& figure) {
    double area = twice_area(figure.outline);
    for (const Outline& hole : figure.holes) area -= twice_area(hole);
    return area;
}

Outline rectangle(double x0, double y0, double x1, double y1) {
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

Outline turned(Outline outline) {
    std::ranges::reverse(outline);
    return outline;
}

// Corners in all directions from a middle, at any distances from 100 to 1000, in integers.
Outline star(Random& random, const Vec2& middle, double size) {
    Outline outline;
    const std::size_t count = 8 + random.below(60);
    for (std::size_t i = 0; i < count; ++i) {
        const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(count);
        const double radius = size * random.uniform(100, 1000);
        outline.emplace_back(std::round(middle.x() + radius * std::cos(angle)),
                             std::round(middle.y() + radius * std::sin(angle)));
    }
    return outline;
}

// All that holds of a figure's triangles and meshes. Coordinates are integers, so that areas are exact.
void expect_sound(const PlaneFigure& figure) {
    const FigureTriangles plane = triangulate(figure);
    std::size_t corner = 0;
    for (std::size_t i = 0; i < figure.outline_count(); ++i)
        for (const Vec2& v : figure.outline_at(i)) EXPECT_EQ(plane.vertices.at(corner++), v);
    ASSERT_EQ(plane.vertices.size(), corner);
    ASSERT_EQ(plane.sides.size(), corner);
    EXPECT_TRUE(std::ranges::is_sorted(plane.triangles));
    // Euler: corners + 2 (holes - 1).
    EXPECT_EQ(plane.triangles.size(), corner + 2 * figure.holes.size() - 2);
    double area = 0;
    for (const auto& [a, b, c] : plane.triangles) {
        const double part = twice_area(plane.vertices[a], plane.vertices[b], plane.vertices[c]);
        EXPECT_GT(part, 0);
        area += part;
    }
    EXPECT_EQ(area, twice_area(figure));

    const auto flat = flat_mesh(figure);
    EXPECT_EQ(flat->triangles().size(), plane.triangles.size());
    EXPECT_TRUE(std::ranges::all_of(flat->vertices(), [](const Vec3& v) { return v.z() == 0; }));
    const auto solid = prism(figure, 6);
    EXPECT_EQ(solid->vertices().size(), 2 * corner);
    EXPECT_TRUE(is_closed(*solid));
    EXPECT_NO_THROW(check_solid(*solid));
    EXPECT_NEAR(volume_of(*solid), 3 * area, 1e-12 * area);
}

template <class Error>
Error error_of(const PlaneFigure& figure) {
    EXPECT_THROW(flat_mesh(figure), Error);
    EXPECT_THROW(prism(figure, 1), Error);
    try {
        check_figure(figure);
    } catch (const Error& error) {
        return error;
    }
    throw std::logic_error("no such error");
}

void expect_meet(const PlaneFigure& figure, const FigurePlace& a, const FigurePlace& b) {
    const auto error = error_of<SidesMeet>(figure);
    EXPECT_EQ(error.a, a) << error.what();
    EXPECT_EQ(error.b, b) << error.what();
}

TEST(PlaneFigure, RectanglesWithHoles) {
    const PlaneFigure plain{rectangle(0, 0, 4, 3), {}};
    expect_sound(plain);
    EXPECT_EQ(twice_area(plain), 24);
    expect_sound({turned(rectangle(0, 0, 4, 3)), {}});
    expect_sound({rectangle(0, 0, 9, 9), {rectangle(1, 1, 2, 2), turned(rectangle(3, 3, 8, 8))}});
    // Corners on straight sides are kept.
    expect_sound({{{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}, {}});
}

TEST(PlaneFigure, StarsInStars) {
    Random random(5);
    int sound_count = 0;
    for (int i = 0; i < 100; ++i) {
        PlaneFigure figure{star(random, {0, 0}, 1000), {}};
        if (i % 2 == 0) figure.holes.push_back(star(random, {0, 0}, 50));  // within the least radius
        if (i % 3 == 0) figure.outline = turned(figure.outline);
        // Near corners may be so far in and out that a side passes the hole.
        try {
            check_figure(figure);
        } catch (const SidesMeet&) {
            continue;
        }
        expect_sound(figure);
        ++sound_count;
    }
    EXPECT_GT(sound_count, 80);
}

TEST(PlaneFigure, ThousandsOfCorners) {
    // Parabolas: exactly convex.
    PlaneFigure figure;
    for (int i = -1000; i <= 1000; ++i) figure.outline.emplace_back(i, i * i);
    expect_sound(figure);
    figure.holes = {{{-1, 9}, {1, 9}, {0, 1000}}};
    expect_sound(figure);
}

TEST(PlaneFigure, SidesThatMeetAreNamed) {
    expect_meet({{{0, 0}, {2, 2}, {2, 0}, {0, 2}}, {}}, {0, 0}, {0, 2});          // crosses itself
    expect_meet({{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}, {}}, {0, 0}, {0, 2});  // a corner on a side
    // A corner at a corner.
    expect_meet({{{0, 0}, {2, 2}, {4, 0}, {4, 4}, {2, 2}, {0, 4}}, {}}, {0, 0}, {0, 3});
    expect_meet({{{0, 0}, {4, 0}, {2, 0}, {2, 3}}, {}}, {0, 0}, {0, 1});  // goes back on itself
    expect_meet({{{0, 0}, {4, 0}, {2, 0}}, {}}, {0, 0}, {0, 1});          // has no area
    expect_meet({{{2, 0}, {0, 0}, {4, 0}}, {}}, {0, 0}, {0, 1});
    expect_meet({{{0, 0}, {2, 0}, {3, 4}, {4, 0}}, {}}, {0, 0}, {0, 3});  // the last side and the first
    const Outline outline = rectangle(0, 0, 4, 4);
    expect_meet({outline, {rectangle(1, 1, 5, 2)}}, {0, 1}, {1, 0});     // a hole through the outline
    expect_meet({outline, {{{4, 2}, {2, 3}, {2, 1}}}}, {0, 1}, {1, 0});  // a hole that touches it
    expect_meet({outline, {outline}}, {0, 0}, {1, 0});                   // both the same
    expect_meet({outline, {rectangle(1, 1, 2, 2), rectangle(2, 2, 3, 3)}}, {1, 1}, {2, 0});  // two holes
    // By an ulp.
    const double x = std::nextafter(4.0, 0.0);
    EXPECT_NO_THROW(check_figure({outline, {{{x, 2}, {2, 3}, {2, 1}}}}));
    const std::ostringstream text = [] {
        std::ostringstream out;
        out << FigurePlace{0, 3} << ", " << FigurePlace{2, 1};
        return out;
    }();
    EXPECT_EQ(text.str(), "side 3 of the outline, side 1 of hole 1");
}

TEST(PlaneFigure, MisplacedHoles) {
    const Outline outline = rectangle(0, 0, 9, 9);
    const auto outside = error_of<HoleMisplaced>({outline, {rectangle(1, 1, 2, 2), rectangle(10, 1, 11, 2)}});
    EXPECT_EQ(outside.hole, 1u);
    EXPECT_FALSE(outside.inside);
    EXPECT_EQ(error_of<HoleMisplaced>({outline, {rectangle(-9, -9, 90, 90)}}).hole, 0u);
    const auto nested = error_of<HoleMisplaced>({outline, {rectangle(2, 2, 3, 3), rectangle(1, 1, 5, 5)}});
    EXPECT_EQ(nested.hole, 0u);
    EXPECT_EQ(nested.inside, 1u);
}

TEST(PlaneFigure, CornersThatMakeNoPolygon) {
    EXPECT_EQ(error_of<TooFewCorners>({{{0, 0}, {1, 0}}, {}}).corner_count, 2u);
    EXPECT_EQ(error_of<TooFewCorners>({{}, {}}).outline, 0u);
    EXPECT_EQ(error_of<TooFewCorners>({rectangle(0, 0, 1, 1), {{}}}).outline, 1u);
    const auto repeated = error_of<SideWithoutLength>({{{0, 0}, {1, 0}, {1, -0.0}, {0, 1}}, {}});
    EXPECT_EQ(repeated.side, (FigurePlace{0, 1}));
    for (const double value :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -HUGE_VAL}) {
        PlaneFigure figure{rectangle(0, 0, 9, 9), {rectangle(1, 1, 2, 2)}};
        figure.holes[0][2].y() = value;
        const auto error = error_of<CornerNotFinite>(figure);
        EXPECT_EQ(error.corner, (FigurePlace{1, 2}));
        EXPECT_EQ(error.axis, 1);
        EXPECT_EQ(std::isnan(error.value), std::isnan(value));
    }
    for (const double height : {0.0, -1.0, HUGE_VAL, std::numeric_limits<double>::quiet_NaN(), 0x1p-1074})
        EXPECT_THROW(prism({rectangle(0, 0, 1, 1), {}}, height), InvalidHeight);
}

TEST(PlaneFigure, AnyExponents) {
    for (const double scale : {0x1p-1000, 0x1p-300, 0x1p300, 0x1p1000}) {
        PlaneFigure figure{rectangle(0, 0, 9 * scale, 9 * scale), {rectangle(scale, scale, 2 * scale, 2 * scale)}};
        EXPECT_EQ(triangulate(figure).triangles.size(), 8u);
        EXPECT_NO_THROW(check_solid(*prism(figure, scale)));
        figure.holes[0][1].x() = 9 * scale;
        expect_meet(figure, {0, 1}, {1, 0});
    }
}

TEST(PlaneFigure, SidesOfPrisms) {
    const PlaneFigure figure{rectangle(0, 0, 9, 9), {{{1, 1}, {2, 1}, {2, 2}}}};
    const auto mesh = prism(figure, 1);
    const std::size_t first = mesh->triangles().size() - 14;
    EXPECT_FALSE(side_of_prism(figure, *mesh, first - 1));
    for (std::size_t i = 0; i < 14; ++i) {
        const FigurePlace place = i < 8 ? FigurePlace{0, i / 2} : FigurePlace{1, i / 2 - 4};
        EXPECT_EQ(side_of_prism(figure, *mesh, first + i), place);
        const Outline& outline = figure.outline_at(place.outline);
        for (const std::uint32_t v : mesh->triangles()[first + i]) {
            const Vec2 corner = mesh->vertices()[v].head<2>();
            EXPECT_TRUE(corner == outline[place.index] || corner == outline[(place.index + 1) % outline.size()]);
        }
    }
}

}  // namespace
}  // namespace ecods::scenes
