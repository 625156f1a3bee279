// The constrained Delaunay triangulation of a figure, by CGAL. Sides share corners at most, so no point is constructed.
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <vector>

#include "scenes/plane/plane_figure.hpp"

namespace ecods::scenes {

namespace {

enum class Region { unknown, outside, inside };

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using Face =
    CGAL::Constrained_triangulation_face_base_2<Kernel, CGAL::Triangulation_face_base_with_info_2<Region, Kernel>>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex, Face>,
                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;

// Across a side one goes from outside to inside or back, across other edges one stays: holes are not in each other.
void find_regions(Triangulation& triangulation) {
    std::vector<Triangulation::Face_handle> faces = {triangulation.infinite_face()};
    faces.front()->info() = Region::outside;
    while (!faces.empty()) {
        const auto face = faces.back();
        faces.pop_back();
        for (int i = 0; i < 3; ++i) {
            const auto neighbor = face->neighbor(i);
            if (neighbor->info() != Region::unknown) continue;
            const bool is_inside = (face->info() == Region::inside) != face->is_constrained(i);
            neighbor->info() = is_inside ? Region::inside : Region::outside;
            faces.push_back(neighbor);
        }
    }
}

bool is_counterclockwise(const Outline& outline) {
    std::vector<Kernel::Point_2> points;
    for (const Vec2& v : outline) points.emplace_back(v.x(), v.y());
    return CGAL::orientation_2(points.begin(), points.end(), Kernel()) == CGAL::LEFT_TURN;
}

// Corners and sides alone.
FigureTriangles sides_of(const PlaneFigure& figure) {
    FigureTriangles result;
    for (std::size_t i = 0; i < figure.outline_count(); ++i) {
        const Outline& outline = figure.outline_at(i);
        const auto first = static_cast<std::uint32_t>(result.vertices.size());
        const auto count = static_cast<std::uint32_t>(outline.size());
        const bool is_turned = is_counterclockwise(outline) != (i == 0);
        for (std::uint32_t k = 0; k < count; ++k) {
            const std::uint32_t from = first + k, to = first + (k + 1) % count;
            if (is_turned) {
                result.sides.push_back({to, from});
            } else {
                result.sides.push_back({from, to});
            }
        }
        result.vertices.insert(result.vertices.end(), outline.begin(), outline.end());
    }
    return result;
}

}  // namespace

FigureTriangles triangulate(const PlaneFigure& figure) {
    check_figure(figure);
    FigureTriangles result = sides_of(figure);
    Triangulation triangulation;
    std::vector<Triangulation::Vertex_handle> handles;
    for (const Vec2& v : result.vertices) {
        handles.push_back(triangulation.insert(Kernel::Point_2(v.x(), v.y())));
        handles.back()->info() = static_cast<std::uint32_t>(handles.size() - 1);
    }
    for (const auto& [from, to] : result.sides) triangulation.insert_constraint(handles[from], handles[to]);
    for (const auto face : triangulation.all_face_handles()) face->info() = Region::unknown;
    find_regions(triangulation);
    for (const auto face : triangulation.finite_face_handles()) {
        if (face->info() != Region::inside) continue;
        std::array<std::uint32_t, 3> t = {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
        std::ranges::rotate(t, std::ranges::min_element(t));
        result.triangles.push_back(t);
    }
    std::ranges::sort(result.triangles);
    return result;
}

}  // namespace ecods::scenes
