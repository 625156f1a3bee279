#include "body.hpp"

namespace certificate_checker {

// Vertices, R and t - origin up to 2^300 and n up to 2^24 let no product of them overflow; what underflows then amounts
// to less than 2^-400.
Body::Body(const Mesh& mesh, const Pose& pose, const Vector<double>& origin, Budget& budget)
    : mesh_(&mesh),
      pose_(pose),
      origin_(origin),
      budget_(&budget),
      low_R_(std::min({lowest_bit(pose.R[0]), lowest_bit(pose.R[1]), lowest_bit(pose.R[2])})) {
    for (std::size_t i = 0; i < 3; ++i) {
        offset_[i] = pose_.t[i] - origin[i];
        magnitude_[i] = std::abs(offset_[i]);
        for (std::size_t l = 0; l < 3; ++l) {
            const double v = mesh.magnitude[l], r = std::abs(pose_.R[i][l]);
            magnitude_[i] += r * v;
            is_moderate_ = is_moderate_ && std::max({v, r, std::abs(offset_[i])}) <= 0x1p300;
        }
    }
}

// Let S = sum of |n_i| magnitude_i. R^T n takes 3 products and 2 sums, v.(R^T n) again, so each is wrong by 3u S; the
// offset, which takes a rounded difference, 3 products and 2 sums, by 4u S; the last sum by u S; a vertex that is
// itself rounded (Segment in pair.cpp) by 2u S. With what comparing two such numbers takes this is 11u S, up to terms
// in u^2, and 16u covers these and the roundings of the bound itself.
Direction Body::direction(const Vector<Approximate>& n) const {
    Direction d;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t l = 0; l < 3; ++l) d.n[l] += pose_.R[i][l] * n[i].value;
        d.offset += n[i].value * offset_[i];
        d.error += (16 * u * std::abs(n[i].value) + 2 * n[i].error) * magnitude_[i];
    }
    d.error = is_moderate_ ? d.error + 0x1p-400 : infinity;
    return d;
}

// As a Direction's error, with n a coordinate axis.
Vector<Approximate> Body::approximate_corner(std::uint32_t triangle, std::size_t k) const {
    const auto& v = mesh_->vertices[mesh_->corners(triangle)[k]];
    Vector<Approximate> x;
    for (std::size_t i = 0; i < 3; ++i) {
        x[i].value = dot(pose_.R[i], v) + offset_[i];
        x[i].error = is_moderate_ ? 16 * u * magnitude_[i] + 0x1p-400 : infinity;
    }
    return x;
}

Range<double> Body::box_range(std::uint32_t node, const Direction& d) const {
    Range<double> r{d.offset, d.offset};
    for (std::size_t k = 0; k < 3; ++k) {
        const double x = d.n[k] * mesh_->boxes[node][0][k], y = d.n[k] * mesh_->boxes[node][1][k];
        r.low += std::min(x, y);
        r.high += std::max(x, y);
    }
    return r;
}

// Calls use(vertex, its place along d) for all corners of the part but such as are within `inner`, which may grow
// meanwhile. The depth of the recursion is that of the tree, which is limited.
template <class Use>
void Body::visit(std::uint32_t part, const Direction& d, const Range<double>& inner, const Use& use) const {
    if (mesh_->is_triangle(part) || mesh_->is_leaf(part)) {
        for (const std::uint32_t vertex : mesh_->all_corners(part)) {
            const double x = dot(d.n, mesh_->vertices[vertex]) + d.offset;
            if (!contains(inner, x)) use(vertex, x);
        }
        return;
    }
    const Node& node = mesh_->nodes[part];
    budget_->spend(8 * node.count);
    for (std::uint32_t p = node.first; p < node.first + node.count; ++p) {
        const Range<double> box = box_range(p, d);
        if (!contains(inner, box.low) || !contains(inner, box.high)) visit(p, d, inner, use);
    }
}

Range<double> Body::range(std::uint32_t part, const Direction& d) const {
    Range<double> found = nothing;
    if (mesh_->is_triangle(part) || mesh_->is_leaf(part)) {
        for (const std::uint32_t vertex : mesh_->all_corners(part)) {
            const double x = dot(d.n, mesh_->vertices[vertex]) + d.offset;
            found = {std::min(found.low, x), std::max(found.high, x)};
        }
        return found;
    }
    visit(part, d, found, [&](std::uint32_t, double x) { found = {std::min(found.low, x), std::max(found.high, x)}; });
    return found;
}

// Only corners that may be extreme are looked at in integers: the part reaches at least to found.high - error, and what
// is at most found.high - 4 error in doubles reaches at most to found.high - 3 error.
Range<Integer> Body::exact_range(std::uint32_t part, const Direction& d, const Vector<Integer>& n) const {
    Range<double> inner = d.error < infinity ? range(part, d) : nothing;
    inner = {inner.low + 4 * d.error, inner.high - 4 * d.error};
    std::optional<Range<Integer>> exact;
    visit(part, d, inner, [&](std::uint32_t vertex, double) {
        const Integer x = dot(n, point(vertex));
        budget_->spend(64 + mpz_size(x.get_mpz_t()) * mpz_size(x.get_mpz_t()));
        if (!exact) exact = {x, x};
        if (x < exact->low) exact->low = x;
        if (x > exact->high) exact->high = x;
    });
    return *exact;
}

void Body::set_unit(int low) {
    low_ = low;
    points_.clear();
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t l = 0; l < 3; ++l) R_[k][l] = integer(pose_.R[k][l], low - mesh_->low);
    }
}

const Vector<Integer>& Body::point(std::uint32_t vertex) const {
    const auto [place, is_new] = points_.try_emplace(vertex);
    if (!is_new) return place->second;
    Vector<Integer> v;
    for (std::size_t l = 0; l < 3; ++l) {
        v[l] = mesh_->exact.empty() ? integer(mesh_->vertices[vertex][l], mesh_->low) : mesh_->exact[vertex][l];
    }
    for (std::size_t k = 0; k < 3; ++k) place->second[k] = dot(R_[k], v) + integer(pose_.t[k], low_);
    return place->second;
}

}  // namespace certificate_checker
