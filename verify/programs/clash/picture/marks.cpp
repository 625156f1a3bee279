#include "programs/clash/picture/marks.hpp"

#include <array>

namespace ecods::clash {
namespace {

// The points of a regular polygon of twelve corners, as doubles: no function of the C library that may differ.
constexpr std::array<std::array<double, 2>, 12> circle{{{1, 0},
                                                        {0.8660254, 0.5},
                                                        {0.5, 0.8660254},
                                                        {0, 1},
                                                        {-0.5, 0.8660254},
                                                        {-0.8660254, 0.5},
                                                        {-1, 0},
                                                        {-0.8660254, -0.5},
                                                        {-0.5, -0.8660254},
                                                        {0, -1},
                                                        {0.5, -0.8660254},
                                                        {0.8660254, -0.5}}};

std::uint32_t index_of_next(const std::vector<Vec3>& points) {
    return static_cast<std::uint32_t>(points.size());
}

void add_fan(std::vector<Triangle>& triangles, std::uint32_t first, std::uint32_t count) {
    for (std::uint32_t i = 2; i < count; ++i) triangles.push_back({first, first + i - 1, first + i});
}

void add_disc(Marks& marks, const Vec3& middle, double radius) {
    const std::uint32_t first = index_of_next(marks.line_points);
    for (const auto& [x, y] : circle) marks.line_points.emplace_back(middle + Vec3(radius * x, radius * y, 0));
    add_fan(marks.line_triangles, first, circle.size());
}

void add_line(Marks& marks, const Vec3& a, const Vec3& b, double half_width) {
    Vec3 along(b.x() - a.x(), b.y() - a.y(), 0);
    const double length = along.norm();
    if (length > 0) {
        along *= half_width / length;
        const Vec3 aside(-along.y(), along.x(), 0);
        const std::uint32_t first = index_of_next(marks.line_points);
        for (const Vec3& corner : {Vec3(a + aside), Vec3(b + aside), Vec3(b - aside), Vec3(a - aside)})
            marks.line_points.push_back(corner);
        add_fan(marks.line_triangles, first, 4);
    }
    add_disc(marks, a, half_width);
    add_disc(marks, b, half_width);
}

}  // namespace

Marks marks_of(const ClashScene& scene, const Camera& camera, std::size_t width, std::size_t height, double thickness) {
    Marks marks;
    const auto seen = [&](const Vec3& point, double nearer) {
        return Vec3(on_screen(point, camera, width, height) - Vec3(0, 0, nearer));
    };
    for (const Patch& patch : scene.patches) {
        const std::uint32_t first = index_of_next(marks.area_points);
        for (const Vec3& corner : patch) marks.area_points.push_back(seen(corner, 0.5));
        add_fan(marks.area_triangles, first, static_cast<std::uint32_t>(patch.size()));
    }
    for (const Line& line : scene.lines) {
        // A step of a surface that the line runs along is as deep as the line is wide, at most.
        add_line(marks, seen(line[0], thickness), seen(line[1], thickness), thickness / 2);
    }
    const bool are_points_all = scene.lines.empty() && scene.patches.empty();
    for (const Vec3& point : scene.points) {
        const double radius = thickness * (are_points_all ? 3 : 1.8);
        add_disc(marks, seen(point, radius), radius);
    }
    return marks;
}

}  // namespace ecods::clash
