#include "query/depth/nearest_planes.hpp"

#include <algorithm>

namespace ecods::depths {
namespace {

// Returns true if the ascending list `level` contains the vertex.
bool contains(const std::vector<std::uint32_t>& level, std::uint32_t v) noexcept {
    if (level.size() > 8) return std::ranges::binary_search(level, v);
    return std::ranges::find(level, v) != level.end();
}

}  // namespace

FixedPlane::Vector NearestPlanes::point(std::size_t side, std::uint32_t vertex) const {
    return hulls_->fixed({side, vertex});
}

// Sets `level` to all vertices of a solid that may be extreme along the exact normal of the face.
void NearestPlanes::find_level(std::size_t side, const InnerPolytope::Face& face, Level& level) {
    level.clear();
    const std::uint32_t start = face.corners[0].of(side);
    const exact::Point n = side == 0 ? face.n : exact::negated(face.n);
    const auto heights = hulls_->heights(side, n, face.n_error);
    if (hulls_->is_scanned(side)) return hulls_->list_furthest(heights, level);
    climb_to_level(side, heights, hulls_->support(side, n, start), level);
}

// Sets `level` to the vertices that may be extreme, for a solid that is not scanned. Begins at a vertex `top` that is
// nearly extreme, and follows edges between vertices that may be extreme. All other neighbors of listed vertices are
// certainly less far than the furthest listed vertex. So the exactly furthest listed vertex is at least as far as all
// its neighbors, and hence extreme in the whole solid. Edges between listed vertices connect it to all vertices that
// are as far.
void NearestPlanes::climb_to_level(std::size_t side, const convex::PosedHulls::Heights& heights, std::uint32_t top,
                                   Level& level) {
    const convex::Hull& hull = hulls_->hull(side);
    std::vector<std::uint32_t>& marks = marks_[side];
    if (marks.size() < hull.vertex_count()) marks.resize(hull.vertex_count());
    const std::uint32_t mark = next_mark();
    const double least = heights.of(top) - heights.margin;
    level.push_back(top);
    marks[top] = mark;
    for (std::size_t i = 0; i < level.size(); ++i) {
        for (const convex::Hull::Neighbor& neighbor : hull.neighbors_of(level[i])) {
            if (marks[neighbor.vertex] == mark) continue;
            marks[neighbor.vertex] = mark;
            if (!(heights.of(neighbor.vertex) < least)) level.push_back(neighbor.vertex);
        }
    }
    std::ranges::sort(level);
}

// Returns a mark that no vertex in marks_ has.
std::uint32_t NearestPlanes::next_mark() noexcept {
    if (++mark_ == 0) {
        for (auto& marks : marks_) std::ranges::fill(marks, 0);
        mark_ = 1;
    }
    return mark_;
}

// Returns the vertex, edge or face whose vertices are exactly those of `level`; nullopt if there is none.
std::optional<convex::HullFeature> NearestPlanes::feature_of(std::size_t side, const Level& level) const noexcept {
    const convex::Hull& hull = hulls_->hull(side);
    convex::LevelEdges edges;
    for (const convex::Hull::Neighbor& neighbor : hull.neighbors_of(level[0])) {
        if (!contains(level, neighbor.vertex)) continue;
        if (edges.count == 2) return std::nullopt;
        edges.add(neighbor.edge);
    }
    if (edges.count != std::min<std::size_t>(level.size() - 1, 2)) return std::nullopt;
    const convex::HullFeature feature = edges.feature(hull, level[0]);
    if (feature.kind != Feature::Kind::face) return feature;
    const auto cycle = hull.cycle_of(feature.index);
    const bool is_face = cycle.size() == level.size() &&
                         std::ranges::all_of(cycle, [&](const auto& corner) { return contains(level, corner.vertex); });
    return is_face ? std::optional(feature) : std::nullopt;
}

// Returns true if the plane certainly contains all vertices of the two features, which are all vertices near the plane.
// The vertices of the first corner are in the plane. For an edge it suffices that a second vertex is, and for a face
// that a second and a third vertex are, since no three vertices of a face are on one line. A vertex of one solid is
// known to be in the plane if it forms a corner together with the vertex that the other solid has in the first corner.
bool NearestPlanes::ties_for_certain(const Plane& plane, const DifferenceFace& features) const {
    const auto is = [&](Feature::Kind a, Feature::Kind b) { return features[0].kind == a && features[1].kind == b; };
    // Three vertices determine the plane of their two edges, or of their face.
    if (is(Feature::Kind::edge, Feature::Kind::edge) || is(Feature::Kind::face, Feature::Kind::vertex) ||
        is(Feature::Kind::vertex, Feature::Kind::face)) {
        return true;
    }
    if (!is_exact_) return false;
    const DifferenceVertex& first = plane.corners[0];
    for (std::size_t side = 0; side < 2; ++side) {
        const Level& level = levels_[plane.levels][side];
        const std::uint32_t from = first.of(side);
        const auto is_known = [&](std::uint32_t v) {
            return v == from || std::ranges::any_of(plane.corners, [&](const DifferenceVertex& corner) {
                       return corner.of(side) == v && corner.of(1 - side) == first.of(1 - side);
                   });
        };
        std::size_t missing = std::min<std::size_t>(level.size(), 3);
        for (std::size_t i = 0; i < level.size() && missing > 0; ++i) missing -= is_known(level[i]) ? 1 : 0;
        for (std::size_t i = 0; i < level.size() && missing > 0; ++i) {
            if (is_known(level[i])) continue;
            if (plane.fixed.sign_along(exact::difference(point(side, level[i]), point(side, from))) != 0) return false;
            --missing;
        }
    }
    return true;
}

// Returns the vertex furthest beyond the plane, from the vertices near the plane that levels_ lists. If no vertex is
// beyond, returns nullopt and reduces the lists to the vertices in the plane.
std::optional<DifferenceVertex> NearestPlanes::keep_ties(const Plane& plane) {
    auto& levels = levels_[plane.levels];
    if (!is_exact_) return keep_level(*pair_, plane.corners, levels);
    return keep_level(levels, plane.corners[0], [&](std::size_t side, std::uint32_t from, std::uint32_t to) {
        const int sign = plane.fixed.sign_along(exact::difference(point(side, to), point(side, from)));
        return side == 0 ? sign : -sign;
    });
}

bool NearestPlanes::is_in_known_plane(const std::array<DifferenceVertex, 3>& corners) const noexcept {
    return std::ranges::any_of(planes_, [&](const Plane& plane) {
        const auto& levels = levels_[plane.levels];
        return std::ranges::all_of(
            corners, [&](const DifferenceVertex& v) { return contains(levels[0], v.p) && contains(levels[1], v.q); });
    });
}

FixedPlane::Vector NearestPlanes::difference(const DifferenceVertex& v) const {
    return exact::difference(point(0, v.p), point(1, v.q));
}

FixedPlane NearestPlanes::plane_of(const std::array<DifferenceVertex, 3>& corners) const {
    return {{difference(corners[0]), difference(corners[1]), difference(corners[2])}, hulls_->fixed_unit(), is_exact_};
}

// Appends the plane of `face` to planes_ and returns in_plane, if it is the plane of a face of M (nearest_planes.hpp).
// If it is not, returns not_in_plane and sets `beyond` to a vertex beyond the plane. Returns thin or unknown if neither
// is proven.
auto NearestPlanes::add(const InnerPolytope::Face& face, DifferenceVertex& beyond) -> Found {
    if (!(face.length > 4 * face.n_error)) return Found::thin;
    const std::size_t at = planes_.size();
    if (levels_.size() == at) levels_.emplace_back();
    auto& levels = levels_[at];
    for (std::size_t side = 0; side < 2; ++side) find_level(side, face, levels[side]);
    const auto has_corners = [&] {
        return std::ranges::all_of(face.corners, [&](const DifferenceVertex& v) {
            return contains(levels[0], v.p) && contains(levels[1], v.q);
        });
    };
    Plane plane{face.corners, plane_of(face.corners), {}, at};
    std::optional<convex::HullFeature> a = feature_of(0, levels[0]), b = feature_of(1, levels[1]);
    if (!a || !b || !has_corners() || !ties_for_certain(plane, {*a, *b})) {
        if (const std::optional<DifferenceVertex> furthest = keep_ties(plane)) {
            beyond = *furthest;
            return Found::not_in_plane;
        }
        a = feature_of(0, levels[0]);
        b = feature_of(1, levels[1]);
        if (!a || !b || !has_corners()) return Found::unknown;
    }
    plane.face = {*a, *b};
    planes_.push_back(plane);
    return Found::in_plane;
}

bool NearestPlanes::is_beyond(const InnerPolytope::Face& face, const DifferenceVertex& v) const {
    if (!is_exact_) return is_beyond_exactly(*pair_, face.corners, v);
    const FixedPlane plane = plane_of(face.corners);
    return plane.sign_along(exact::difference(difference(v), difference(face.corners[0]))) > 0;
}

// Sets planes_ to the planes of all faces of the polytope that may be nearest, except thin faces, whose corners are
// added to thin_. Returns false if it is not proven that planes_ and thin_ have all such faces.
bool NearestPlanes::find_planes(InnerPolytope& polytope) {
    for (int steps = 0; steps < steps_max; ++steps) {
        thin_.clear();
        Found found = Found::in_plane;
        DifferenceVertex beyond;
        polytope.visit_near([&](std::uint32_t i) {
            if (found == Found::not_in_plane || found == Found::unknown) return;
            const InnerPolytope::Face face = polytope.face(i);
            if (is_in_known_plane(face.corners)) return;
            found = add(face, beyond);
            if (found == Found::thin) thin_.push_back(face.corners);
        });
        if (found == Found::unknown) return false;
        if (found != Found::not_in_plane) {
            return polytope.is_upper_proven() || is_in_known_plane(polytope.face(polytope.nearest()).corners);
        }
        const auto is_beyond_it = [&](const InnerPolytope::Face& face) { return is_beyond(face, beyond); };
        if (!polytope.insert(beyond, is_beyond_it)) return false;
    }
    return false;
}

// Returns true if each thin face is in a known plane, or is further than the nearest plane.
bool NearestPlanes::thin_faces_are_further(const Plane& nearest) const {
    return std::ranges::all_of(thin_, [&](const auto& corners) {
        return is_in_known_plane(corners) || compare_exactly(*pair_, corners, nearest.corners) > 0;
    });
}

int NearestPlanes::compare(const Plane& x, const Plane& y) const {
    if (x.side == 0 || y.side == 0) return x.side - y.side;
    if (const std::optional<int> sign = x.fixed.compare(y.fixed)) return *sign;
    return compare_exactly(*pair_, x.corners, y.corners);
}

std::size_t NearestPlanes::first_plane() const {
    std::size_t first = 0;
    for (std::size_t i = 1; i < planes_.size(); ++i) {
        const int sign = compare(planes_[i], planes_[first]);
        if (sign < 0 || (sign == 0 && order_of(planes_[i].face, planes_[first].face) < 0)) first = i;
    }
    return first;
}

auto NearestPlanes::find(const ConvexPair& pair, convex::PosedHulls& hulls, InnerPolytope& polytope)
    -> std::optional<Shown> {
    pair_ = &pair;
    hulls_ = &hulls;
    is_exact_ = hulls.has_fixed_points();
    planes_.clear();
    const bool has_found = find_planes(polytope);
    bool is_known = has_found && !planes_.empty();
    for (Plane& plane : planes_) {
        const std::optional<int> side = plane.fixed.side();
        if (!side) {
            is_known = false;
            continue;
        }
        if (*side < 0) return Shown{};
        plane.side = *side;
    }
    if (!is_known) return std::nullopt;
    const Plane& plane = planes_[planes_.size() == 1 ? 0 : first_plane()];
    if (!thin_faces_are_further(plane)) return std::nullopt;
    const std::optional<double> depth = plane.side == 0 ? 0 : plane.fixed.distance();
    const std::optional<Vec3> direction = plane.fixed.direction();
    if (!depth || !direction) return measure_exactly(pair, plane.face, plane.corners);
    return ExactDepth{plane.face, *depth, *direction};
}

}  // namespace ecods::depths
