#include "programs/clash/place.hpp"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "ecods/distance.hpp"
#include "ecods/intersection.hpp"
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

Line line_of(const Vec3& from, const Vec3& to) {
    return is_less(from, to) ? Line{from, to} : Line{to, from};
}

// A side of a polygon in which two faces lie on each other, and the plane of that, by its normal.
struct Side {
    Line line;
    Vec3 normal;

    friend bool operator==(const Side& a, const Side& b) { return a.line == b.line && a.normal == b.normal; }
    friend bool operator<(const Side& a, const Side& b) {
        return a.line == b.line ? is_less(a.normal, b.normal) : Less{}(a.line, b.line);
    }
};

// Adds the outlines of where faces lie on each other. Their triangles cut that into polygons: a side of two of them is
// inside, and no line, also if edges run along it.
void add_outlines(std::vector<Side> sides, std::vector<Line>& lines) {
    std::sort(sides.begin(), sides.end());
    std::vector<Line> inner;
    for (std::size_t i = 0; i < sides.size();) {
        std::size_t end = i + 1;
        while (end < sides.size() && sides[end] == sides[i]) ++end;
        ((end - i) % 2 == 0 ? inner : lines).push_back(sides[i].line);
        i = end;
    }
    std::sort(inner.begin(), inner.end(), Less{});
    std::erase_if(lines,
                  [&](const Line& line) { return std::binary_search(inner.begin(), inner.end(), line, Less{}); });
}

void add_contacts(const Part& a, const Part& b, Place& place, GrowingBox& box, QueryMemory& memory) {
    std::vector<Side> sides;
    for (const TriangleIntersection& contact : intersections(surface_of(a), surface_of(b), memory)) {
        const std::span<const Vec3> corners = contact.shared.corners();
        for (const Vec3& corner : corners) box.add(corner);
        if (corners.size() == 1) place.points.push_back(corners[0]);
        if (corners.size() == 2) place.lines.push_back(line_of(corners[0], corners[1]));
        if (corners.size() <= 2) continue;
        const Vec3 normal = contact.shared.normal.value_or(Vec3::Zero());
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Line line = line_of(corners[i], corners[(i + 1) % corners.size()]);
            sides.push_back({line, is_less(normal, Vec3::Zero()) ? Vec3(Vec3::Zero() - normal) : normal});
        }
    }
    add_outlines(std::move(sides), place.lines);
    std::erase_if(place.lines, [](const Line& line) { return line[0] == line[1]; });
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

Aabb bounds_of(const Part& part) {
    if (!(part.pose == Pose{})) return part.shape->box(part.pose);
    GrowingBox box;
    visit_vertices(part, [&](const Vec3& point) { box.add(point); });
    return {box.min, box.max};
}

Place place_of(const Part& a, const Part& b, const Verdict& verdict, QueryMemory& memory) {
    if (verdict.kind == Kind::clearance) return place_of_gap(a, b, memory);
    const Aabb one = bounds_of(a);
    const Aabb other = bounds_of(b);
    return {.box = {one.min.cwiseMax(other.min), one.max.cwiseMin(other.max)}};
}

Place place_with_lines(const Part& a, const Part& b, const Verdict& verdict, std::size_t line_limit,
                       QueryMemory& memory) {
    Place place = place_of(a, b, verdict, memory);
    if (verdict.kind == Kind::clearance) return place;
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

}  // namespace ecods::clash
