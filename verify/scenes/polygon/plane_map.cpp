#include "scenes/polygon/plane_map.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

#include "scenes/polygon/point_tree.hpp"

namespace ecods::scenes {
namespace {

constexpr std::uint32_t nothing = std::numeric_limits<std::uint32_t>::max();

bool is_before(const Vec2& a, const Vec2& b) {
    return a[0] != b[0] ? a[0] < b[0] : a[1] < b[1];
}

// By direction from a place, counter-clockwise from the first one upwards to the right.
bool is_earlier_ray(const Vec2& from, const Vec2& a, const Vec2& b) {
    const bool a_is_left = is_before(a, from);
    const bool b_is_left = is_before(b, from);
    if (a_is_left != b_is_left) return b_is_left;
    return turn(from, a, b) == Sign::positive;
}

}  // namespace

// From the lesser place to the greater.
struct PlaneMap::Edge {
    std::uint32_t from = 0, to = 0;
    std::uint32_t name_from = 0, name_to = 0;
    int winding = 0;
    int box_side = 0;  // 1: the outside is to the right; -1: to the left; 0: no part of the box
};

void PlaneMap::find_places(const PlaneWalk& walk) {
    Vec2 lower = walk.points[0];
    Vec2 upper = walk.points[0];
    for (const Vec2& point : walk.points) {
        lower = lower.cwiseMin(point);
        upper = upper.cwiseMax(point);
    }
    places_ = walk.points;
    for (const Vec2& corner : {lower, Vec2(upper[0], lower[1]), upper, Vec2(lower[0], upper[1])})
        places_.push_back(corner);
    std::sort(places_.begin(), places_.end(), is_before);
    places_.erase(std::unique(places_.begin(), places_.end()), places_.end());
    for (const Vec2& point : walk.points) {
        const auto place = std::lower_bound(places_.begin(), places_.end(), point, is_before);
        place_of_.push_back(static_cast<std::uint32_t>(place - places_.begin()));
    }
}

// Adds the edge in pieces, from place to place. False if there are more edges then than `size_max`.
bool PlaneMap::add_split(std::uint32_t from, std::uint32_t to, Edge edge, const PointTree& tree, std::size_t size_max,
                         std::vector<Edge>& edges) const {
    if (from == to) return true;
    if (from > to) {
        std::swap(from, to);
        std::swap(edge.name_from, edge.name_to);
        edge.winding = -edge.winding;
        edge.box_side = -edge.box_side;
    }
    std::vector<std::uint32_t> stops{to};
    const PlaneTriangle segment(places_[from], places_[to], places_[to]);
    const bool is_too_long = tree.visit_in(segment, [&](std::uint32_t place, const std::array<Sign, 3>&) {
        if (place != from && place != to) stops.push_back(place);
        return edges.size() + stops.size() > size_max;
    });
    if (is_too_long) return false;
    std::sort(stops.begin(), stops.end());
    const std::uint32_t name_to = edge.name_to;
    edge.from = from;
    for (const std::uint32_t stop : stops) {
        edge.to = stop;
        edge.name_to = stop == to ? name_to : nothing;
        edges.push_back(edge);
        edge.from = stop;
        edge.name_from = nothing;
    }
    return true;
}

// One pair of half-edges for all edges between two places.
void PlaneMap::add_half_edges(std::vector<Edge>& edges) {
    std::vector<std::uint32_t> name_of(places_.size(), nothing);
    for (const Edge& edge : edges) {
        if (edge.name_from != nothing) name_of[edge.from] = edge.name_from;
        if (edge.name_to != nothing) name_of[edge.to] = edge.name_to;
    }
    std::stable_sort(edges.begin(), edges.end(),
                     [](const Edge& a, const Edge& b) { return a.from != b.from ? a.from < b.from : a.to < b.to; });
    for (std::size_t i = 0; i < edges.size();) {
        HalfEdge there{.from = edges[i].from, .name = name_of[edges[i].from]};
        HalfEdge back{.from = edges[i].to, .name = name_of[edges[i].to]};
        for (const std::size_t first = i;
             i < edges.size() && edges[i].from == edges[first].from && edges[i].to == edges[first].to; ++i) {
            const Edge& edge = edges[i];
            there.winding += edge.winding;
            there.is_walked = there.is_walked || edge.winding != 0;
            if (edge.winding > 0 && edge.name_from != nothing) there.name = edge.name_from;
            if (edge.winding < 0 && edge.name_to != nothing) back.name = edge.name_to;
            there.is_outer = there.is_outer || edge.box_side < 0;
            back.is_outer = back.is_outer || edge.box_side > 0;
        }
        back.winding = -there.winding;
        back.is_walked = there.is_walked;
        half_edges_.push_back(there);
        half_edges_.push_back(back);
    }
}

// The next half-edge around the face to the left: of those that leave the place where one ends, the first one clockwise
// from its way back.
void PlaneMap::link() {
    std::vector<std::uint32_t> rays(half_edges_.size());
    std::iota(rays.begin(), rays.end(), 0U);
    std::sort(rays.begin(), rays.end(), [&](std::uint32_t a, std::uint32_t b) {
        const std::uint32_t from = half_edges_[a].from;
        if (from != half_edges_[b].from) return from < half_edges_[b].from;
        return is_earlier_ray(places_[from], point(a ^ 1U), point(b ^ 1U));
    });
    for (std::size_t begin = 0; begin < rays.size();) {
        std::size_t end = begin;
        while (end < rays.size() && half_edges_[rays[end]].from == half_edges_[rays[begin]].from) ++end;
        for (std::size_t i = begin; i < end; ++i) {
            half_edges_[rays[i] ^ 1U].next = rays[i == begin ? end - 1 : i - 1];
        }
        begin = end;
    }
}

void PlaneMap::find_faces() {
    for (HalfEdge& half_edge : half_edges_) half_edge.face = nothing;
    const auto add_face = [&](std::uint32_t first) {
        if (half_edges_[first].face != nothing) return;
        const auto face = static_cast<std::uint32_t>(faces_.size());
        faces_.push_back(first);
        for (std::uint32_t at = first; half_edges_[at].face == nothing; at = half_edges_[at].next)
            half_edges_[at].face = face;
    };
    const auto outer =
        std::find_if(half_edges_.begin(), half_edges_.end(), [](const HalfEdge& edge) { return edge.is_outer; });
    add_face(static_cast<std::uint32_t>(outer - half_edges_.begin()));
    for (std::uint32_t i = 0; i < half_edges_.size(); ++i) add_face(i);
}

std::optional<PlaneMap> PlaneMap::create(const PlaneWalk& walk) {
    PlaneMap map;
    map.find_places(walk);
    const PointTree tree(map.places_);
    const std::size_t size_max = 16 * (walk.size() + 4);
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < walk.size(); ++i) {
        const std::size_t j = i + 1 == walk.size() ? 0 : i + 1;
        const Edge edge{.name_from = walk.names[i], .name_to = walk.names[j], .winding = 1};
        if (!map.add_split(map.place_of_[i], map.place_of_[j], edge, tree, size_max, edges)) return std::nullopt;
    }
    // The least place is the lower left corner, and the greatest the upper right one.
    const auto upper_right = static_cast<std::uint32_t>(map.places_.size() - 1);
    const auto place_at = [&](double x, double y) {
        const auto place = std::lower_bound(map.places_.begin(), map.places_.end(), Vec2(x, y), is_before);
        return static_cast<std::uint32_t>(place - map.places_.begin());
    };
    const std::uint32_t lower_right = place_at(map.places_[upper_right][0], map.places_[0][1]);
    const std::uint32_t upper_left = place_at(map.places_[0][0], map.places_[upper_right][1]);
    const std::array<std::uint32_t, 5> box{0, lower_right, upper_right, upper_left, 0};
    for (std::size_t k = 0; k < 4; ++k) {
        const Edge edge{.name_from = nothing, .name_to = nothing, .box_side = 1};
        if (!map.add_split(box[k], box[k + 1], edge, tree, size_max, edges)) return std::nullopt;
    }
    map.add_half_edges(edges);
    map.link();
    map.find_faces();
    return map;
}

std::optional<std::vector<int>> PlaneMap::windings() const {
    constexpr int unknown = std::numeric_limits<int>::min();
    // Outside are all sides of the box, and nothing else.
    for (const HalfEdge& half_edge : half_edges_) {
        if (half_edge.is_outer != (half_edge.face == 0)) return std::nullopt;
    }
    std::vector<int> windings(faces_.size(), unknown);
    windings[0] = 0;
    std::vector<std::uint32_t> known{0};
    while (!known.empty()) {
        const std::uint32_t face = known.back();
        known.pop_back();
        std::uint32_t at = faces_[face];
        do {
            const std::uint32_t other = half_edges_[at ^ 1U].face;
            const int winding = windings[face] - half_edges_[at].winding;
            if (windings[other] == unknown) {
                windings[other] = winding;
                known.push_back(other);
            } else if (windings[other] != winding) {
                return std::nullopt;
            }
            at = half_edges_[at].next;
        } while (at != faces_[face]);
    }
    return windings;
}

PlaneWalk PlaneMap::walk_round(std::uint32_t face) const {
    PlaneWalk walk;
    std::uint32_t at = faces_[face];
    do {
        walk.add(point(at), at);
        at = half_edges_[at].next;
    } while (at != faces_[face]);
    return walk;
}

}  // namespace ecods::scenes
