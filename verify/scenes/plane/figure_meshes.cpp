#include <cmath>
#include <utility>

#include "scenes/plane/plane_figure.hpp"

namespace ecods::scenes {

std::shared_ptr<const Mesh> flat_mesh(const PlaneFigure& figure) {
    const FigureTriangles plane = triangulate(figure);
    std::vector<Vec3> vertices;
    for (const Vec2& v : plane.vertices) vertices.emplace_back(v.x(), v.y(), 0);
    std::vector<Triangle> triangles;
    for (const auto& [a, b, c] : plane.triangles) triangles.push_back({a, b, c});
    return Mesh::create(std::move(vertices), std::move(triangles));
}

std::shared_ptr<const Mesh> prism(const PlaneFigure& figure, double height) {
    if (!(height > 0) || !std::isfinite(height) || height / 2 == 0) throw InvalidHeight(height);
    const FigureTriangles plane = triangulate(figure);
    std::vector<Vec3> vertices;
    for (const double z : {-height / 2, height / 2})
        for (const Vec2& v : plane.vertices) vertices.emplace_back(v.x(), v.y(), z);
    const auto above = static_cast<std::uint32_t>(plane.vertices.size());
    std::vector<Triangle> triangles;
    for (const auto& [a, b, c] : plane.triangles) triangles.push_back({a, c, b});
    for (const auto& [a, b, c] : plane.triangles) triangles.push_back({a + above, b + above, c + above});
    for (const auto& [from, to] : plane.sides) {
        triangles.push_back({from, to, to + above});
        triangles.push_back({from, to + above, from + above});
    }
    return Mesh::create(std::move(vertices), std::move(triangles));
}

std::optional<FigurePlace> side_of_prism(const PlaneFigure& figure, const Mesh& prism, std::size_t triangle) {
    const std::size_t side_count = prism.vertices().size() / 2;  // as many as corners
    const std::size_t first = prism.triangles().size() - 2 * side_count;
    if (triangle < first) return {};
    FigurePlace place{0, (triangle - first) / 2};
    while (place.index >= figure.outline_at(place.outline).size())
        place.index -= figure.outline_at(place.outline++).size();
    return place;
}

}  // namespace ecods::scenes
