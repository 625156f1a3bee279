#include "body.hpp"

#include <algorithm>

namespace certificate_checker {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
// Up to this size of vertices, of R and of t - origin, no product of the three, and of n below 1, overflows.
constexpr double moderate = 0x1p300;
// More than all underflows of such products amount to.
constexpr double underflows = 0x1p-400;

Vector<Approximate> approximate(const Vector<double>& x) {
    return {{{x[0], 0}, {x[1], 0}, {x[2], 0}}};
}

bool contains(const Range& range, double x) {
    return range.low <= x && x <= range.high;
}

}  // namespace

Body::Body(const Mesh& mesh, const Pose& pose, const Vector<double>& origin, Budget& budget)
    : mesh_(&mesh), pose_(pose), budget_(&budget) {
    measure(origin);
}

Body::Body(const Piece& piece, const Vector<double>& origin, Budget& budget)
    : piece_(piece), pose_{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {}}, budget_(&budget) {
    own_mesh_.triangles = {{0, 1, 1}};
    own_mesh_.position = {0};
    const auto from = approximate(piece.from);
    const auto way = approximate(piece.to) - from;
    for (const auto& half : piece.s) {
        const Approximate s = (Approximate{half[0]} + Approximate{half[1]}) * Approximate{0.5};
        auto& vertex = own_mesh_.vertices.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
            const Approximate x = from[k] + s * way[k];
            vertex[k] = x.value;
            slack_[k] = std::max(slack_[k], x.error);
        }
    }
    certificate_checker::measure(own_mesh_);
    measure(origin);
}

void Body::measure(const Vector<double>& origin) {
    for (std::size_t i = 0; i < 3; ++i) {
        offset_[i] = pose_.t[i] - origin[i];
        magnitude_[i] = std::abs(offset_[i]);
        for (std::size_t l = 0; l < 3; ++l) {
            const double v = mesh().magnitude[l], r = std::abs(pose_.R[i][l]);
            magnitude_[i] += r * v;
            is_moderate_ = is_moderate_ && v <= moderate && r <= moderate && std::abs(offset_[i]) <= moderate;
        }
    }
}

std::optional<std::uint32_t> Body::triangle(std::uint32_t number) const {
    if (number >= mesh().position.size()) return std::nullopt;
    return static_cast<std::uint32_t>(mesh().nodes.size()) + mesh().position[number];
}

// Let S = sum of |n_i| magnitude_i. R^T n takes 3 products and 2 sums, v.(R^T n) again, so each is wrong by 3u S; the
// offset, which takes a rounded difference, 3 products and 2 sums, by 4u S; the last sum by u S. This is 8u S with what
// comparing two such numbers takes, up to terms in u^2, and 16u covers these and the roundings of the bound itself.
Direction Body::direction(const Vector<Approximate>& n) const {
    Direction d;
    for (std::size_t i = 0; i < 3; ++i) {
        const double size = std::abs(n[i].value), wrong = n[i].error;
        for (std::size_t l = 0; l < 3; ++l) d.n[l] += pose_.R[i][l] * n[i].value;
        d.offset += n[i].value * offset_[i];
        d.error += (16 * u * size + 2 * wrong) * magnitude_[i] + 2 * (size + wrong) * slack_[i];
    }
    d.error = is_moderate_ ? d.error + underflows : infinity;
    return d;
}

// As a Direction's error, with n a coordinate axis.
Vector<Approximate> Body::approximate_corner(std::uint32_t triangle_part, std::size_t k) const {
    const auto& v = mesh().vertices[mesh().corners(triangle_part)[k]];
    Vector<Approximate> x;
    for (std::size_t i = 0; i < 3; ++i) {
        x[i].value = pose_.R[i][0] * v[0] + pose_.R[i][1] * v[1] + pose_.R[i][2] * v[2] + offset_[i];
        x[i].error = is_moderate_ ? 16 * u * magnitude_[i] + 2 * slack_[i] + underflows : infinity;
    }
    return x;
}

Range Body::box_range(std::uint32_t node, const Direction& d) const {
    const Box& box = mesh().boxes[node];
    Range r{d.offset, d.offset};
    for (std::size_t k = 0; k < 3; ++k) {
        const double x = d.n[k] * box[0][k], y = d.n[k] * box[1][k];
        r.low += std::min(x, y);
        r.high += std::max(x, y);
    }
    return r;
}

Range Body::outer_range(std::uint32_t part, const Direction& d) const {
    return mesh().is_triangle(part) ? range(part, d) : box_range(part, d);
}

// Calls use(vertex, its place along d) for all corners of the part but such as are within `inner`, which may change
// meanwhile. The depth of the recursion is that of the tree, which is limited.
template <class Use>
void Body::visit(std::uint32_t part, const Direction& d, const Range& inner, const Use& use) const {
    if (mesh().is_triangle(part)) {
        for (const std::uint32_t vertex : mesh().corners(part)) {
            const auto& v = mesh().vertices[vertex];
            const double x = d.n[0] * v[0] + d.n[1] * v[1] + d.n[2] * v[2] + d.offset;
            if (!contains(inner, x)) use(vertex, x);
        }
        return;
    }
    const Node& node = mesh().nodes[part];
    budget_->spend(8 * node.count);
    for (std::uint32_t p = node.first; p < node.first + node.count; ++p) {
        if (!mesh().is_triangle(p)) {
            const Range box = box_range(p, d);
            if (contains(inner, box.low) && contains(inner, box.high)) continue;
        }
        visit(p, d, inner, use);
    }
}

Range Body::range(std::uint32_t part, const Direction& d) const {
    Range found;
    visit(part, d, found, [&](std::uint32_t, double x) {
        found.low = std::min(found.low, x);
        found.high = std::max(found.high, x);
    });
    return found;
}

// Only corners that may be extreme are looked at in integers: the part reaches at least to found.high - error, and what
// is at most found.high - 4 error in doubles reaches at most to found.high - 3 error.
ExactRange Body::exact_range(std::uint32_t part, const Direction& d, const Vector<Integer>& n) const {
    Range inner;
    if (d.error < infinity) {
        const Range found = range(part, d);
        inner = {found.low + 4 * d.error, found.high - 4 * d.error};
    }
    std::optional<ExactRange> exact;
    std::uint32_t last = std::numeric_limits<std::uint32_t>::max();
    visit(part, d, inner, [&](std::uint32_t vertex, double) {
        if (vertex == last) return;
        last = vertex;
        const Integer x = dot(n, point(vertex));
        budget_->spend(64 + mpz_size(x.get_mpz_t()) * mpz_size(x.get_mpz_t()));
        if (!exact) exact = {x, x};
        if (x < exact->low) exact->low = x;
        if (x > exact->high) exact->high = x;
    });
    return *exact;
}

int Body::lowest_bit() const {
    int low_R = 0, low_t = 0;
    if (piece_) {
        for (const auto* const point : {&piece_->from, &piece_->to}) {
            for (const double x : *point) low_t = std::min(low_t, low_bit(x));
        }
        for (const auto& half : piece_->s) low_R = std::min({low_R, low_bit(half[0]), low_bit(half[1])});
        return low_t + low_R - 1;
    }
    for (const auto& row : pose_.R) {
        for (const double x : row) low_R = std::min(low_R, low_bit(x));
    }
    for (const double x : pose_.t) low_t = std::min(low_t, low_bit(x));
    return std::min(low_R + mesh_->low, low_t);
}

void Body::set_unit(int low) {
    low_ = low;
    points_.clear();
    if (piece_) return;
    for (std::size_t k = 0; k < 3; ++k) {
        t_[k] = integer(pose_.t[k], low);
        for (std::size_t l = 0; l < 3; ++l) R_[k][l] = integer(pose_.R[k][l], low - mesh_->low);
    }
}

const Vector<Integer>& Body::point(std::uint32_t vertex) const {
    const auto [place, is_new] = points_.try_emplace(vertex);
    Vector<Integer>& x = place->second;
    if (!is_new) return x;
    for (std::size_t k = 0; k < 3; ++k) {
        if (piece_) {
            // Twice the point is (2 - s) from + s to, where s is the sum of the two doubles.
            const int low_s = std::min({0, low_bit(piece_->s[vertex][0]), low_bit(piece_->s[vertex][1])});
            const Integer s = integer(piece_->s[vertex][0], low_s) + integer(piece_->s[vertex][1], low_s);
            const int low = low_ + 1 - low_s;
            x[k] = (integer(2, low_s) - s) * integer(piece_->from[k], low) + s * integer(piece_->to[k], low);
            continue;
        }
        const auto& v = mesh_->vertices[vertex];
        x[k] = t_[k];
        for (std::size_t l = 0; l < 3; ++l) x[k] += R_[k][l] * integer(v[l], mesh_->low);
    }
    return x;
}

const Vector<Integer>& Body::corner(std::uint32_t triangle_part, std::size_t k) const {
    return point(mesh().corners(triangle_part)[k]);
}

}  // namespace certificate_checker
