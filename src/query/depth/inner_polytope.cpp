#include "query/depth/inner_polytope.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "simd/dispatch.hpp"

namespace ecods::depths {

using exact::cross;
using exact::dot;
using exact::largest;
using exact::minus;
using exact::negated;
using exact::Point;
using exact::sum_of_magnitudes;
using exact::times;

namespace {

using Four = convex::FourDoubles;

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

InnerPolytope::Face InnerPolytope::face(std::uint32_t i) const noexcept {
    const auto& at = corners_[i];
    return {{nx_[i], ny_[i], nz_[i]},
            n_error_[i],
            length_[i],
            {vertices_[at[0]].of, vertices_[at[1]].of, vertices_[at[2]].of}};
}

void InnerPolytope::add_space() {
    const std::size_t size = std::max<std::size_t>(128, 2 * h_.size());
    for (auto* list : {&nx_, &ny_, &nz_, &length_, &n_error_, &h_error_}) list->resize(size);
    nearness_.resize(size, -infinity);
    corners_.resize(size);
    vertices_.resize(size);  // every vertex after the first three adds at least two faces
    visible_.resize(size);
    h_.resize(size);  // resized last, because has_space() reads its size
}

std::uint32_t InnerPolytope::support(std::size_t side, const Point& n) const noexcept {
    if (hulls_->is_scanned(side)) [[likely]]
        return hulls_->scan(side, n);
    return face_count_ == 0 ? hulls_->support(side, n) : hulls_->support(side, n, face(nearest_).corners[0].of(side));
}

// Adds the vertex that is furthest along n. If the upper bound of the depth is proven, lowers it to this vertex's
// height along n.
void InnerPolytope::add_support(const Point& n) {
    const DifferenceVertex v{support(0, n), support(1, negated(n))};
    add_vertex(v);
    if (!is_upper_proven()) return;
    const double reach =
        dot(n, hulls_->rounded(0, v.p)) - dot(n, hulls_->rounded(1, v.q)) + bounds_.of_reach(sum_of_magnitudes(n));
    const double upper = reach < 0 ? -1 : reach / std::sqrt(dot(n, n)) * RoundedBounds::slack;
    if (upper < upper_) upper_ = upper;
}

void InnerPolytope::set_face(std::uint32_t i, std::uint32_t a, std::uint32_t b, std::uint32_t c) noexcept {
    const auto& first = vertices_[a].m;
    const auto x = minus(vertices_[b].m, first), y = minus(vertices_[c].m, first), n = cross(x, y);
    const double h = dot(n, first), length = std::sqrt(dot(n, n));
    n_error_[i] = bounds_.of_normal(largest(x), largest(y));
    h_error_[i] = bounds_.of_height(n_error_[i], sum_of_magnitudes(n));
    nx_[i] = n[0];
    ny_[i] = n[1];
    nz_[i] = n[2];
    h_[i] = h;
    length_[i] = length;
    nearness_[i] = -(h / length);
    corners_[i] = {a, b, c};
}

// Makes a tetrahedron of the first four vertices, and returns true. Returns false if the vertices may be in one plane.
bool InnerPolytope::set_tetrahedron() {
    const auto x = minus(vertices_[1].m, vertices_[0].m), y = minus(vertices_[2].m, vertices_[0].m), n = cross(x, y);
    const double above = dot(n, minus(vertices_[3].m, vertices_[0].m));
    const double error = bounds_.of_height(bounds_.of_normal(largest(x), largest(y)), sum_of_magnitudes(n));
    if (!(std::abs(above) > 4 * error)) return false;
    const std::uint32_t b = above > 0 ? 2 : 1, c = 3 - b;
    set_face(0, 0, b, c);
    set_face(1, 0, c, 3);
    set_face(2, c, b, 3);
    set_face(3, b, 0, 3);
    face_count_ = 4;
    return true;
}

// Makes a tetrahedron at the likely place of the nearest faces: there the ray from the middle of the difference through
// the origin leaves the difference. Takes three vertices around that ray, and one on the opposite side. Returns false
// if no tetrahedron was found.
bool InnerPolytope::begin() {
    const Point middle = minus(hulls_->center(1), hulls_->center(0));
    const double length = std::sqrt(dot(middle, middle));
    const Point ray = length > 0x1p-20 * bounds_.E ? times(middle, 1 / length) : Point{0.6, 0.64, 0.48};
    // e and f are unit vectors perpendicular to the ray and to each other.
    const double s = ray[2] < 0 ? -1 : 1, a = -1 / (s + ray[2]), b = ray[0] * ray[1] * a;
    const Point e{1 + s * ray[0] * ray[0] * a, s * b, -s * ray[0]}, f{b, s + ray[1] * ray[1] * a, -ray[1]};
    upper_ = infinity;
    constexpr std::array<Point, 4> ways{{{1, 0, 0.375}, {-0.5, 0.875, 0.375}, {-0.5, -0.875, 0.375}, {0, 0, -1}}};
    // The calls are in a loop so that the code of add_support(), which is always inlined, has only one copy.
    for (const auto& [x, y, z] : ways) {
        add_support(
            {x * e[0] + y * f[0] + z * ray[0], x * e[1] + y * f[1] + z * ray[1], x * e[2] + y * f[2] + z * ray[2]});
    }
    return set_tetrahedron() || begin_anywhere();
}

// Makes a tetrahedron of vertices that are extreme along vectors, each perpendicular to the edges found before. Returns
// false if the vertices may be in one plane.
bool InnerPolytope::begin_anywhere() {
    vertex_count_ = 0;
    const auto add_furthest = [&](const Point& n) {
        add_support(n);
        add_support(negated(n));
        const auto& first = vertices_[0].m;
        const auto off = [&](std::uint32_t i) { return std::abs(dot(n, minus(vertices_[i].m, first))); };
        if (off(vertex_count_ - 1) > off(vertex_count_ - 2))
            vertices_[vertex_count_ - 2] = vertices_[vertex_count_ - 1];
        --vertex_count_;
    };
    add_support({1, 0, 0});
    add_support({-1, 0, 0});
    const auto u = minus(vertices_[1].m, vertices_[0].m);
    add_furthest({-u[1], u[0], 0});
    add_furthest(cross(u, minus(vertices_[2].m, vertices_[0].m)));
    return set_tetrahedron();
}

void InnerPolytope::find_nearest() {
    nearest_ = convex::index_of_greatest(nearness_.data(), face_count_);
}

// Sets visible_ to the faces that the last vertex is beyond, and returns their number.
std::uint32_t InnerPolytope::find_visible() {
    const Point& m = vertices_[vertex_count_ - 1].m;
    std::uint32_t count = 0;
    for (std::uint32_t i = 0; i < face_count_; i += 4) {
        const auto height = load_anywhere<Four>(nx_.data() + i) * m[0] + load_anywhere<Four>(ny_.data() + i) * m[1] +
                            load_anywhere<Four>(nz_.data() + i) * m[2] - load_anywhere<Four>(h_.data() + i);
        convex::for_each_lane(height > 2 * load_anywhere<Four>(h_error_.data() + i), [&](std::uint32_t lane) {
            if (i + lane < face_count_) visible_[count++] = i + lane;
        });
    }
    return count;
}

// Sets border_ to the edges of visible faces, without edges between two visible faces. Returns the number of these
// edges, or 0 if there are too many.
std::uint32_t InnerPolytope::find_border(std::uint32_t visible_count) {
    std::uint32_t count = 0;
    for (std::uint32_t i = 0; i < visible_count; ++i) {
        count = add_edges(corners_[visible_[i]], border_.data(), count);
        if (count > border_max) return 0;
    }
    return count;
}

bool InnerPolytope::replace_visible(std::uint32_t visible_count) {
    const std::uint32_t border_count = find_border(visible_count);
    if (border_count == 0) return false;
    const std::uint32_t apex = vertex_count_ - 1;
    for (std::uint32_t i = 0; i < border_count; ++i) {
        const std::uint32_t face = i < visible_count ? visible_[i] : face_count_++;
        set_face(face, static_cast<std::uint32_t>(border_[i] >> 32), static_cast<std::uint32_t>(border_[i]), apex);
    }
    for (std::uint32_t i = visible_count; i > border_count; --i) remove_face(visible_[i - 1]);
    return true;
}

bool InnerPolytope::replace(std::uint32_t visible_count) {
    return replace_visible(visible_count);
}

// Sets the upper bound of the depth to the distance of the nearest face's plane, unless a proven bound is known. The
// depth is at most the distance of the plane of any face of the whole difference. If that distance is negative, the
// solids are apart.
//
// The true normal is at least as long as the computed one minus sqrt(3) n_error. For a thin face this lower bound may
// be negative: the plane may then be at any distance, so the bound is infinite and every face counts as near.
void InnerPolytope::bound_by_nearest() noexcept {
    if (is_upper_proven()) return;
    find_nearest();
    const std::uint32_t i = nearest_;
    const double length = length_[i] / RoundedBounds::slack - 2 * n_error_[i];
    upper_ = length > 0 ? (h_[i] + h_error_[i]) / length * RoundedBounds::slack : infinity;
    // The origin may be beyond the face. With upper_ = 0, visit_near() leaves out only faces that certainly have the
    // origin on their inner side.
    if (!(upper_ > 0)) upper_ = 0;
}

void InnerPolytope::remove_face(std::uint32_t i) noexcept {
    const std::uint32_t last = --face_count_;
    for (auto* list : {&nx_, &ny_, &nz_, &h_, &length_, &n_error_, &h_error_, &nearness_}) (*list)[i] = (*list)[last];
    corners_[i] = corners_[last];
    nearness_[last] = -infinity;
}

// Grows the polytope. Every step adds a vertex or ends the search. Rounding may add the same vertex again, so the
// number of steps is limited.
InnerPolytope::End InnerPolytope::grow() {
    if (!begin()) return End::unknown;
    std::size_t steps = 64 + 4 * (hulls_->hull(0).vertex_count() + hulls_->hull(1).vertex_count());
    for (; steps > 0; --steps) {
        if (upper_ < 0) return End::apart;
        if (!has_space()) add_space();
        find_nearest();
        const std::uint32_t i = nearest_;
        const Point n{nx_[i], ny_[i], nz_[i]};
        add_support(n);
        const double height = dot(n, vertices_[vertex_count_ - 1].m) - h_[i];
        if (!(height > 2 * h_error_[i])) {
            bound_by_nearest();
            return upper_ < 0 && is_upper_proven() ? End::apart : End::nearest;
        }
        if (!replace_visible(find_visible())) return End::unknown;
    }
    return End::unknown;
}

InnerPolytope::End InnerPolytope::find(const convex::PosedHulls& hulls) {
    hulls_ = &hulls;
    bounds_ = RoundedBounds(hulls);
    if (!bounds_.hold()) return End::unknown;
    face_count_ = vertex_count_ = 0;
    if (!has_space()) add_space();
    std::ranges::fill(nearness_, -infinity);
    return dispatch<&InnerPolytope::grow>(*this);
}

}  // namespace ecods::depths
