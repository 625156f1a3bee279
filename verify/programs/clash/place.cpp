#include "programs/clash/place.hpp"

#include <algorithm>
#include <limits>
#include <set>
#include <span>
#include <vector>

#include "ecods/contact.hpp"
#include "ecods/depth.hpp"
#include "ecods/distance.hpp"
#include "ecods/error.hpp"
#include "ecods/solid.hpp"

namespace ecods::clash {
namespace {

bool is_less(const Vec3& a, const Vec3& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

struct Less {
    bool operator()(const Vec3& a, const Vec3& b) const { return is_less(a, b); }
    bool operator()(const Line& a, const Line& b) const {
        return a[0] == b[0] ? is_less(a[1], b[1]) : is_less(a[0], b[0]);
    }
};

template <class T>
void sort_once(std::vector<T>& all) {
    std::sort(all.begin(), all.end(), Less{});
    all.erase(std::unique(all.begin(), all.end()), all.end());
}

// A box that grows; empty at first.
struct GrowingBox {
    Vec3 min = Vec3::Constant(std::numeric_limits<double>::infinity());
    Vec3 max = -min;

    void add(const Vec3& point) {
        min = min.cwiseMin(point);
        max = max.cwiseMax(point);
    }
    bool has(const Vec3& point) const {
        return (min.array() <= point.array()).all() && (point.array() <= max.array()).all();
    }
    bool is_empty() const { return min[0] > max[0]; }
};

// The posed vertices, rounded.
template <class Visit>
void visit_vertices(const Part& part, const Visit& visit) {
    for (const Triangle& triangle : part.shape->mesh().triangles()) {
        for (const std::uint32_t vertex : triangle) {
            const Vec3& v = part.shape->mesh().vertices()[vertex];
            visit(Vec3(part.pose.R * v + part.pose.t + Vec3::Zero()));
        }
    }
}

void add_part(const Part& part, GrowingBox& box) {
    visit_vertices(part, [&](const Vec3& point) { box.add(point); });
}

// What of the place's box the contacts of the surfaces do not show: vertices inside a solid. Those in the box already,
// or beyond the solid's, are not asked about.
void add_inner_vertices(const Part& part, const Part& solid, GrowingBox& box, QueryMemory& memory) {
    const Aabb bounds = solid.shape->box(solid.pose);
    visit_vertices(part, [&](const Vec3& point) {
        const bool is_near = (bounds.min.array() <= point.array()).all() && (point.array() <= bounds.max.array()).all();
        if (!is_near || box.has(point)) return;
        if (locate(point, solid_of(solid), memory).side != Side::outside) box.add(point);
    });
}

void add_line(const Vec3& from, const Vec3& to, std::vector<Line>& lines) {
    if (from != to) lines.push_back(is_less(from, to) ? Line{from, to} : Line{to, from});
}

// Points that end a line are not single.
void add_contacts(const Part& a, const Part& b, Place& place, GrowingBox& box, QueryMemory& memory) {
    for (const TriangleIntersection& contact : intersections(surface_of(a), surface_of(b), memory)) {
        const std::span<const Vec3> corners = contact.shared.corners();
        for (std::size_t i = 0; i < corners.size(); ++i) {
            box.add(corners[i]);
            if (corners.size() == 1) place.points.push_back(corners[i]);
            if (corners.size() == 2 && i == 1) continue;
            add_line(corners[i], corners[(i + 1) % corners.size()], place.lines);
        }
    }
    sort_once(place.lines);
    sort_once(place.points);
    std::vector<Vec3> ends;
    for (const Line& line : place.lines) ends.insert(ends.end(), line.begin(), line.end());
    sort_once(ends);
    std::erase_if(place.points, [&](const Vec3& p) { return std::binary_search(ends.begin(), ends.end(), p, Less{}); });
}

Place place_of_gap(const Part& a, const Part& b, QueryMemory& memory) {
    const ClosestPoints closest = ecods::closest(surface_of(a), surface_of(b), memory);
    GrowingBox box;
    box.add(closest.point_a);
    box.add(closest.point_b);
    return {.box = {box.min, box.max}, .points = {closest.point_a, closest.point_b}};
}

}  // namespace

Place place_of(const Part& a, const Part& b, const Verdict& verdict, std::size_t line_limit, QueryMemory& memory) {
    if (verdict.kind == Kind::clearance) return place_of_gap(a, b, memory);
    Place place;
    GrowingBox box;
    if (verdict.kind != Kind::equal) add_contacts(a, b, place, box, memory);
    if (verdict.kind == Kind::equal || verdict.relation == "inside") add_part(a, box);
    if (verdict.relation == "contains") add_part(b, box);
    if (verdict.relation == "overlapping" || verdict.relation == "partly_inside") {
        if (b.is_solid) add_inner_vertices(a, b, box, memory);
        if (a.is_solid) add_inner_vertices(b, a, box, memory);
    }
    place.line_count = place.lines.size();
    if (place.lines.size() > line_limit) place.lines.resize(line_limit);
    if (!box.is_empty()) place.box = {box.min, box.max};
    return place;
}

std::shared_ptr<const ConvexSolid> ConvexShapes::find(const Part& part) {
    {
        const std::lock_guard lock(mutex_);
        const auto known = shapes_.find(part.shape.get());
        if (known != shapes_.end()) return known->second;
    }
    std::shared_ptr<const ConvexSolid> convex;
    try {
        convex = std::make_shared<const ConvexSolid>(part.shape->mesh_ptr());
    } catch (const NotConvex&) {
    } catch (const NoInterior&) {
    }
    const std::lock_guard lock(mutex_);
    return shapes_.emplace(part.shape.get(), std::move(convex)).first->second;
}

Interval depth_of(const Part& a, const Part& b, ConvexShapes& shapes, QueryMemory& memory) {
    const auto convex_a = shapes.find(a);
    const auto convex_b = convex_a ? shapes.find(b) : nullptr;
    if (convex_b) {
        const double depth = ecods::depth({*convex_a, a.pose}, {*convex_b, b.pose}, memory).depth;
        return {depth, depth};
    }
    const DepthBounds bounds = depth_bounds(solid_of(a), solid_of(b), memory);
    return {bounds.lower, bounds.upper};
}

}  // namespace ecods::clash
