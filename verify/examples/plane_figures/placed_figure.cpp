#include "examples/plane_figures/placed_figure.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace ecods::examples {

namespace {

using scenes::FigurePlace;

// Both prisms stand on either side of z = 0, and are so tall that the way along z is longer than ways in the plane.
// These are at most both diameters together.
double tall_enough(const PlacedFigure& a, const PlacedFigure& b) {
    return 2 * (a.diameter() + b.diameter());
}

std::string place_text(const char* kind, const FigurePlace& place, const PlacedFigure& of) {
    return place.outline == 0 ? fmt::format("{} {} of {}", kind, place.index, of.name)
                              : fmt::format("{} {} of hole {} of {}", kind, place.index, place.outline - 1, of.name);
}

Vec2 in_plane(const Vec3& v) {
    return v.head<2>();
}

// A prism on a figure, and what its features are in the plane.
struct Prism {
    const PlacedFigure& of;
    MeshShape shape;

    Prism(const PlacedFigure& placed, double height) : of(placed), shape(scenes::prism(placed.figure, height)) {}

    const Vec3& corner(const Feature& feature, std::uint32_t further) const {
        const Triangle& t = shape.mesh().triangles()[feature.triangle];
        return shape.mesh().vertices()[t[(feature.corner + further) % 3]];
    }
    // An edge that stands on a corner of the figure.
    bool is_upright(const Feature& feature) const {
        return feature.kind == Feature::Kind::edge && in_plane(corner(feature, 0)) == in_plane(corner(feature, 1));
    }
    // An edge above a side.
    bool is_level(const Feature& feature) const {
        return feature.kind == Feature::Kind::edge && corner(feature, 0).z() == corner(feature, 1).z();
    }
    std::optional<FigurePlace> side(const Feature& feature) const {
        // The side's two triangles are behind those above, and one of these may be what names an edge.
        if (const auto side = side_of_prism(of.figure, shape.mesh(), feature.triangle)) return side;
        if (feature.kind != Feature::Kind::edge) return {};
        for (std::size_t i = 0; i < of.figure.outline_count(); ++i) {
            const scenes::Outline& outline = of.figure.outline_at(i);
            for (std::size_t k = 0; k < outline.size(); ++k) {
                const Vec2 &from = outline[k], &to = outline[(k + 1) % outline.size()];
                const Vec2 p = in_plane(corner(feature, 0)), q = in_plane(corner(feature, 1));
                if ((p == from && q == to) || (p == to && q == from)) return FigurePlace{i, k};
            }
        }
        return {};
    }
    // What the feature is in the plane: a corner, or a side.
    std::string text(const Feature& feature) const {
        if (feature.kind != Feature::Kind::vertex && !is_upright(feature)) {
            const auto place = side(feature);
            return place ? place_text("side", *place, of) : "inside " + of.name;
        }
        for (std::size_t i = 0; i < of.figure.outline_count(); ++i) {
            const scenes::Outline& outline = of.figure.outline_at(i);
            const auto at = std::ranges::find(outline, in_plane(corner(feature, 0)));
            if (at != outline.end())
                return place_text("corner", {i, static_cast<std::size_t>(at - outline.begin())}, of);
        }
        return {};
    }
};

// Which of the pairs of features of prisms are contacts of the figures: one of each, at the upper end of the lower
// prism, b's. There is no cap of a's.
bool is_plane_contact(const Prism& a, const Prism& b, const CloseFeatures& close) {
    const Feature &of_a = close.closest.a, &of_b = close.closest.b;
    const bool is_side_of_a = of_a.kind == Feature::Kind::face;
    if (of_b.kind == Feature::Kind::vertex) return b.corner(of_b, 0).z() > 0 && (is_side_of_a || a.is_upright(of_a));
    return b.is_level(of_b) && b.corner(of_b, 0).z() > 0 && b.side(of_b) && a.is_upright(of_a);
}

// From a to b: at distance 0 the library's direction is the normal of a face or the product of edges, whichever way.
Vec2 turned_to_b(const Prism& b, const CloseFeatures& close) {
    const Vec2 normal = in_plane(*close.direction);
    if (close.closest.distance > 0 || close.closest.a.kind == Feature::Kind::face) return normal;
    // A corner of a on a side of b: the first triangle of that side says where its outside is.
    const Mesh& mesh = b.shape.mesh();
    const auto side = b.side(close.closest.b);
    for (std::uint32_t t = 0; t < mesh.triangles().size(); ++t) {
        if (side_of_prism(b.of.figure, mesh, t) != side) continue;
        const Feature face{Feature::Kind::face, t, 0};
        const Vec2 along = in_plane(b.of.pose.R * (b.corner(face, 1) - b.corner(face, 0)));
        const Vec2 outwards(along.y(), -along.x());
        return outwards.dot(normal) > 0 ? Vec2(-normal) : normal;
    }
    return normal;
}

}  // namespace

PlacedFigure::PlacedFigure(const std::string& name_, const scenes::PlaneFigure& figure_, const Vec2& cosine_and_sine,
                           const Vec2& at)
    : name(name_), figure(figure_), flat_(std::make_shared<const MeshShape>(scenes::flat_mesh(figure_))) {
    pose.R.topLeftCorner<2, 2>() << cosine_and_sine.x(), -cosine_and_sine.y(), cosine_and_sine.y(), cosine_and_sine.x();
    pose.t = {at.x(), at.y(), 0};
}

Vec2 PlacedFigure::to_plane(const Vec2& corner) const {
    return in_plane(pose.R * Vec3(corner.x(), corner.y(), 0) + pose.t);
}

double PlacedFigure::diameter() const {
    const Aabb box = box_of(flat_->mesh(), pose);
    return (box.max - box.min).norm();
}

std::vector<std::vector<Vec2>> intersection(const PlacedFigure& a, const PlacedFigure& b) {
    std::vector<std::vector<Vec2>> pieces;
    for (const TriangleIntersection& found : intersections(a.flat(), b.flat())) {
        if (found.shared.corner_count < 3) continue;
        pieces.emplace_back();
        for (const Vec3& corner : found.shared.corners()) pieces.back().push_back(in_plane(corner));
    }
    return pieces;
}

std::vector<Vec2> crossings(const PlacedFigure& a, const PlacedFigure& b) {
    const double height = tall_enough(a, b);
    const Prism tall(a, 2 * height), low(b, height);
    std::vector<Vec2> points;
    for (const auto& [triangles, shared] : intersections({tall.shape, a.pose}, {low.shape, b.pose})) {
        const bool are_sides = side_of_prism(a.figure, tall.shape.mesh(), triangles.a) &&
                               side_of_prism(b.figure, low.shape.mesh(), triangles.b);
        // Upright sides share upright segments, one point of the plane.
        if (are_sides && in_plane(shared.all_corners[0]) == in_plane(shared.corners().back()))
            points.push_back(in_plane(shared.all_corners[0]));
    }
    const auto less = [](const Vec2& p, const Vec2& q) { return std::pair(p.x(), p.y()) < std::pair(q.x(), q.y()); };
    std::ranges::sort(points, less);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
}

std::vector<PlaneContact> contacts(const PlacedFigure& a, const PlacedFigure& b, double distance) {
    // So a corner of b is inside the height of a side of a, and a corner of a crosses the upper ends of b's sides.
    const double height = tall_enough(a, b);
    const Prism tall(a, 3 * height), low(b, height);
    std::vector<PlaneContact> result;
    for (const CloseFeatures& close : close_features({tall.shape, a.pose}, {low.shape, b.pose}, distance)) {
        if (!is_plane_contact(tall, low, close)) continue;
        PlaneContact contact;
        contact.gap = close.closest.distance;
        contact.on_a = in_plane(close.closest.point_a);
        contact.on_b = in_plane(close.closest.point_b);
        if (close.direction) contact.normal = turned_to_b(low, close);
        contact.what = tall.text(close.closest.a) + ", " + low.text(close.closest.b);
        result.push_back(contact);
    }
    return result;
}

std::optional<PlaneDepth> convex_depth(const PlacedFigure& a, const PlacedFigure& b) {
    const double height = tall_enough(a, b);
    const ConvexSolid solid_a(scenes::prism(a.figure, height)), solid_b(scenes::prism(b.figure, height));
    const std::optional<Depth> found = depth({solid_a, a.pose}, {solid_b, b.pose});
    if (!found) return std::nullopt;
    // Two upright edges have no product, and others give normals of sides or ways out of the plane, which are longer:
    // so a side of a or of b it is.
    const bool is_of_a = found->a.kind == Feature::Kind::face;
    const PlacedFigure& of = is_of_a ? a : b;
    const auto side = side_of_prism(of.figure, is_of_a ? solid_a.mesh() : solid_b.mesh(),
                                    is_of_a ? found->a.triangle : found->b.triangle);
    return PlaneDepth{found->depth, in_plane(found->direction), side ? place_text("side", *side, of) : ""};
}

std::optional<PlaneDepthBounds> depth_bounds(const PlacedFigure& a, const PlacedFigure& b) {
    const double height = tall_enough(a, b);
    const Solid solid_a(scenes::prism(a.figure, height)), solid_b(scenes::prism(b.figure, height));
    const std::optional<DepthBounds> found = ecods::depth_bounds({solid_a, a.pose}, {solid_b, b.pose});
    if (!found) return std::nullopt;
    return PlaneDepthBounds{found->lower, found->upper, in_plane(found->parted)};
}

}  // namespace ecods::examples
