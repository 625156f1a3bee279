#include "query/depth/inner_polytope.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "simd/dispatch.hpp"

namespace ecods::depths {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

ECODS_ALWAYS_INLINE std::array<double, 3> minus(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
ECODS_ALWAYS_INLINE std::array<double, 3> cross(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
ECODS_ALWAYS_INLINE double dot(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
ECODS_ALWAYS_INLINE double largest(const std::array<double, 3>& a) {
    return std::max(std::max(std::abs(a[0]), std::abs(a[1])), std::abs(a[2]));
}
ECODS_ALWAYS_INLINE double sum_of_magnitudes(const std::array<double, 3>& a) {
    return std::abs(a[0]) + std::abs(a[1]) + std::abs(a[2]);
}

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
    distance_.resize(size, infinity);
    corners_.resize(size);
    vertices_.resize(size);  // Every vertex but three adds two faces at least.
    visible_.resize(size);
    h_.resize(size);  // The last one, whose size is asked.
}

template <int sign>
Furthest InnerPolytope::support(std::size_t side, double nx, double ny, double nz) const noexcept {
    if (hulls_->is_scanned(side)) [[likely]]
        return furthest<sign>(hulls_->side(side), nx, ny, nz);
    const std::array<double, 3> n{sign * nx, sign * ny, sign * nz};
    const std::uint32_t v = face_count_ == 0 ? hulls_->posed().support(side, n)
                                             : hulls_->posed().support(side, n, face(nearest_).corners[0].of(side));
    return {dot({nx, ny, nz}, hulls_->point(side, v)), v};
}

// Adds the vertex that is furthest along a vector, and bounds the depth by how far that is.
void InnerPolytope::add_support(double nx, double ny, double nz) {
    const Furthest p = support<1>(0, nx, ny, nz), q = support<-1>(1, nx, ny, nz);
    add_vertex({p.vertex, q.vertex});
    if (!is_upper_proven()) return;
    const double sum = sum_of_magnitudes({nx, ny, nz}), length = std::sqrt(nx * nx + ny * ny + nz * nz);
    const double along = p.along - q.along + hulls_->bounds().of_support(sum);
    const double upper = along < 0 ? -1 : along / length * RoundedBounds::slack;
    if (upper < upper_) upper_ = upper;
}

void InnerPolytope::set_face(std::uint32_t i, std::uint32_t a, std::uint32_t b, std::uint32_t c) noexcept {
    const auto& first = vertices_[a].m;
    const auto x = minus(vertices_[b].m, first), y = minus(vertices_[c].m, first), n = cross(x, y);
    const double h = dot(n, first), length = std::sqrt(dot(n, n));
    n_error_[i] = hulls_->bounds().of_normal(largest(x), largest(y));
    h_error_[i] = hulls_->bounds().of_height(n_error_[i], sum_of_magnitudes(n));
    nx_[i] = n[0];
    ny_[i] = n[1];
    nz_[i] = n[2];
    h_[i] = h;
    length_[i] = length;
    distance_[i] = h / length;
    corners_[i] = {a, b, c};
}

// Makes a tetrahedron of the first four vertices, if they are certainly not in one plane.
bool InnerPolytope::set_tetrahedron() {
    const auto x = minus(vertices_[1].m, vertices_[0].m), y = minus(vertices_[2].m, vertices_[0].m), n = cross(x, y);
    const double above = dot(n, minus(vertices_[3].m, vertices_[0].m));
    const RoundedBounds& bounds = hulls_->bounds();
    const double error = bounds.of_height(bounds.of_normal(largest(x), largest(y)), sum_of_magnitudes(n));
    if (!(std::abs(above) > 4 * error)) return false;
    const std::uint32_t b = above > 0 ? 2 : 1, c = 3 - b;
    set_face(0, 0, b, c);
    set_face(1, 0, c, 3);
    set_face(2, c, b, 3);
    set_face(3, b, 0, 3);
    face_count_ = 4;
    return true;
}

// The nearest faces are likely to be where the ray from the middle of the set through the origin leaves it: three
// vertices around that, and one on the other side.
bool InnerPolytope::begin() {
    std::array<double, 3> ray = hulls_->middle();
    const double length = std::sqrt(dot(ray, ray));
    if (length > 0x1p-20 * hulls_->bounds().E) {
        for (double& x : ray) x /= -length;
    } else {
        ray = {0.6, 0.64, 0.48};
    }
    // At right angles to the ray and to each other.
    const double s = ray[2] < 0 ? -1 : 1, a = -1 / (s + ray[2]), b = ray[0] * ray[1] * a;
    const std::array<double, 3> e{1 + s * ray[0] * ray[0] * a, s * b, -s * ray[0]},
        f{b, s + ray[1] * ray[1] * a, -ray[1]};
    upper_ = infinity;
    constexpr std::array<std::array<double, 3>, 4> ways{
        {{1, 0, 0.375}, {-0.5, 0.875, 0.375}, {-0.5, -0.875, 0.375}, {0, 0, -1}}};
    // A loop, so that what is always inlined is so once.
    for (const auto& [x, y, z] : ways) {
        add_support(x * e[0] + y * f[0] + z * ray[0], x * e[1] + y * f[1] + z * ray[1],
                    x * e[2] + y * f[2] + z * ray[2]);
    }
    return set_tetrahedron() || begin_anywhere();
}

// A tetrahedron of what is furthest along vectors at right angles to those before.
bool InnerPolytope::begin_anywhere() {
    vertex_count_ = 0;
    const auto add_furthest = [&](const std::array<double, 3>& n) {
        add_support(n[0], n[1], n[2]);
        add_support(-n[0], -n[1], -n[2]);
        const auto& first = vertices_[0].m;
        const auto off = [&](std::uint32_t i) { return std::abs(dot(n, minus(vertices_[i].m, first))); };
        if (off(vertex_count_ - 1) > off(vertex_count_ - 2))
            vertices_[vertex_count_ - 2] = vertices_[vertex_count_ - 1];
        --vertex_count_;
    };
    add_support(1, 0, 0);
    add_support(-1, 0, 0);
    const auto u = minus(vertices_[1].m, vertices_[0].m);
    add_furthest({-u[1], u[0], 0});
    add_furthest(cross(u, minus(vertices_[2].m, vertices_[0].m)));
    return set_tetrahedron();
}

void InnerPolytope::find_nearest() {
    Double4 best = load_anywhere<Double4>(distance_.data());
    Long4 at{0, 1, 2, 3}, best_at = at;
    for (std::uint32_t i = 4; i < face_count_; i += 4) {
        at += 4;
        const Double4 distance = load_anywhere<Double4>(distance_.data() + i);
        const auto is_nearer = distance < best;
        best = select(is_nearer, distance, best);
        best_at = select(is_nearer, at, best_at);
    }
    const Double4 other = shuffle<2, 3, 0, 1>(best);
    const Long4 other_at = shuffle<2, 3, 0, 1>(best_at);
    const auto is_nearer = other < best;
    best = select(is_nearer, other, best);
    best_at = select(is_nearer, other_at, best_at);
    nearest_ = static_cast<std::uint32_t>(best[1] < best[0] ? best_at[1] : best_at[0]);
}

// Lists the faces that the last vertex is beyond.
std::uint32_t InnerPolytope::find_visible() {
    const auto& m = vertices_[vertex_count_ - 1].m;
    std::uint32_t count = 0;
    for (std::uint32_t i = 0; i < face_count_; i += 4) {
        const Double4 height = load_anywhere<Double4>(nx_.data() + i) * m[0] +
                               load_anywhere<Double4>(ny_.data() + i) * m[1] +
                               load_anywhere<Double4>(nz_.data() + i) * m[2] - load_anywhere<Double4>(h_.data() + i);
        auto bits = any_bits((height > 2 * load_anywhere<Double4>(h_error_.data() + i)) & lane_bits<Long4>());
        for (; bits != 0; bits &= bits - 1) {
            const std::uint32_t face =
                i + static_cast<std::uint32_t>(std::countr_zero(static_cast<std::uint64_t>(bits)));
            if (face < face_count_) visible_[count++] = face;
        }
    }
    return count;
}

// The edges of visible faces without those between two of them. Returns how many, or none if there are too many.
std::uint32_t InnerPolytope::find_border(std::uint32_t visible_count) {
    std::uint32_t count = 0;
    for (std::uint32_t i = 0; i < visible_count; ++i) {
        const auto& at = corners_[visible_[i]];
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t from = at[c], to = at[c == 2 ? 0 : c + 1];
            const std::uint64_t edge = std::uint64_t{from} << 32 | to, twin = std::uint64_t{to} << 32 | from;
            std::uint32_t k = 0;
            while (k < count && border_[k] != twin) ++k;
            if (k < count) {
                border_[k] = border_[--count];
            } else {
                border_[count++] = edge;
            }
        }
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

// The depth is not above the distance of a plane of a face of the whole set. Where that is negative, it shows that the
// solids are apart.
//
// The true normal is at least as long as the one as computed less the root of 3 times n_error. Of a thin face that may
// be nothing: its plane may be at any distance, so every face counts as near.
void InnerPolytope::bound_by_nearest() noexcept {
    if (is_upper_proven()) return;
    find_nearest();
    const std::uint32_t i = nearest_;
    const double length = length_[i] / RoundedBounds::slack - 2 * n_error_[i];
    upper_ = length > 0 ? (h_[i] + h_error_[i]) / length * RoundedBounds::slack : infinity;
    // Of a face that the origin is beyond: faces count as near that are not certainly on its inner side.
    if (!(upper_ > 0)) upper_ = 0;
}

void InnerPolytope::remove_face(std::uint32_t i) noexcept {
    const std::uint32_t last = --face_count_;
    for (auto* list : {&nx_, &ny_, &nz_, &h_, &length_, &n_error_, &h_error_, &distance_}) (*list)[i] = (*list)[last];
    corners_[i] = corners_[last];
    distance_[last] = infinity;
}

// Every step adds a vertex or ends the search. A vertex may come over again, where roundings have it, so steps are
// counted.
InnerPolytope::End InnerPolytope::grow() {
    if (!begin()) return End::unknown;
    std::uint32_t steps = 64 + 4 * (hulls_->side(0).count + hulls_->side(1).count);
    for (; steps > 0; --steps) {
        if (upper_ < 0) return End::apart;
        if (!has_space()) add_space();
        find_nearest();
        const std::uint32_t i = nearest_;
        add_support(nx_[i], ny_[i], nz_[i]);
        const auto& m = vertices_[vertex_count_ - 1].m;
        const double height = nx_[i] * m[0] + ny_[i] * m[1] + nz_[i] * m[2] - h_[i];
        if (!(height > 2 * h_error_[i])) {
            bound_by_nearest();
            return upper_ < 0 && is_upper_proven() ? End::apart : End::nearest;
        }
        if (!replace_visible(find_visible())) return End::unknown;
    }
    return End::unknown;
}

InnerPolytope::End InnerPolytope::find(const RoundedHulls& hulls) {
    hulls_ = &hulls;
    face_count_ = vertex_count_ = 0;
    if (!has_space()) add_space();
    std::fill(distance_.begin(), distance_.end(), infinity);
    return dispatch<&InnerPolytope::grow>(*this);
}

}  // namespace ecods::depths
