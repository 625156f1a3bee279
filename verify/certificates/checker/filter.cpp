#include "filter.hpp"

#include <utility>

#include "vectors.hpp"

namespace certificate_checker {
namespace {

constexpr double u = 0x1p-53;              // half the distance from 1 to the next double
constexpr double underflow = 0x1p-1074;    // at most this is lost where a result is subnormal
constexpr double inflation = 1 + 0x1p-48;  // more than the roundings of the few sums of a bound

// The true number is within `error` of `value`. An operation adds what it rounds, u times its result, to what the
// operands are wrong by; the bound is inflated because it is rounded itself. Infinity and NaN are passed on, and no
// comparison that a proof needs holds for them.
struct Approximate {
    double value = 0, error = 0;
};
Approximate rounded(double value, double error) {
    return {value, (error + u * std::abs(value) + underflow) * inflation};
}
Approximate operator+(const Approximate& a, const Approximate& b) {
    return rounded(a.value + b.value, a.error + b.error);
}
Approximate operator-(const Approximate& a, const Approximate& b) {
    return rounded(a.value - b.value, a.error + b.error);
}
Approximate operator*(const Approximate& a, const Approximate& b) {
    return rounded(a.value * b.value, std::abs(a.value) * b.error + std::abs(b.value) * a.error + a.error * b.error);
}

}  // namespace

// Vertices, R and t - origin up to 2^300 and n up to 2^24 let no product of them overflow; what underflows then amounts
// to less than 2^-400.
Filter::Filter(const PosedMesh& a, const PosedMesh& b, double m, Budget& budget)
    : sides_{Side{a.mesh, &a.pose}, Side{b.mesh, &b.pose}}, m_(m), budget_(&budget) {
    for (Side& side : sides_) {
        for (std::size_t i = 0; i < 3; ++i) {
            side.offset[i] = side.pose->t[i] - a.pose.t[i];
            side.magnitude[i] = std::abs(side.offset[i]);
            for (std::size_t l = 0; l < 3; ++l) {
                const double v = side.mesh->magnitude[l], r = std::abs(side.pose->R[i][l]);
                side.magnitude[i] += r * v;
                side.is_moderate = side.is_moderate && std::max({v, r, std::abs(side.offset[i])}) <= 0x1p300;
            }
        }
    }
}

// A corner: its error is as below, with n a coordinate axis. The vector is scaled to at most 1.
//
// Directions: let S = sum of |n_i| magnitude_i. R^T n takes 3 products and 2 sums, v.(R^T n) again, so each is wrong by
// 3u S; the offset, which takes a rounded difference, 3 products and 2 sums, by 4u S; the last sum by u S; a vertex
// that is itself rounded (mesh_of in mesh.cpp) by 2u S. With what comparing two such numbers takes this is 11u S (up
// to terms in u^2), and 16u covers these and the roundings of the bound itself.
void Filter::set_axis(std::size_t k, const AxisLine& source, const std::array<std::uint32_t, 2>& triangles) {
    const auto corner = [&](std::size_t number, std::size_t corner_number) {
        const Side& side = sides_[number];
        const auto& v = side.mesh->vertices[side.mesh->corners(triangles[number])[corner_number % 3]];
        Vector<Approximate> x;
        for (std::size_t i = 0; i < 3; ++i) {
            x[i] = {dot(side.pose->R[i], v) + side.offset[i], 16 * u * side.magnitude[i] + 0x1p-400};
            if (!side.is_moderate) x[i].error = infinity;
        }
        return x;
    };
    const auto& g = source.given;
    Vector<Approximate> n = {{{g[0]}, {g[1]}, {g[2]}}};
    if (source.formula.kind != Kind::given) n = vector_of<Approximate>(source.formula, corner);
    const double size = std::max({std::abs(n[0].value), std::abs(n[1].value), std::abs(n[2].value)});
    // What this underflows is covered by the 2^-400 of directions.
    const double scale =
        size > 0 && size < infinity ? std::ldexp(1, std::clamp(-std::ilogb(size) - 1, -1000, 1000)) : 1;
    double square = 0;
    for (Approximate& x : n) {
        x = {x.value * scale, x.error * scale};
        square += (std::abs(x.value) + x.error) * (std::abs(x.value) + x.error);
    }
    axes_.resize(std::max(axes_.size(), k + 1));
    Axis& axis = axes_[k] = {};
    axis.need = m_ > 0 ? m_ * std::sqrt(square) * inflation : 0;
    for (std::size_t number = 0; number < 2; ++number) {
        const Side& side = sides_[number];
        Direction& d = axis.along[number];
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t l = 0; l < 3; ++l) d.n[l] += side.pose->R[i][l] * n[i].value;
            d.offset += n[i].value * side.offset[i];
            d.error += (16 * u * std::abs(n[i].value) + 2 * n[i].error) * side.magnitude[i];
        }
        d.error = side.is_moderate ? d.error + 0x1p-400 : infinity;
        axis.need += d.error;
    }
    axis.need *= inflation;
}

Filter::Range Filter::box_range(const Side& side, std::uint32_t node, const Direction& d) {
    Range r{d.offset, d.offset};
    for (std::size_t k = 0; k < 3; ++k) {
        const double x = d.n[k] * side.mesh->boxes[node][0][k], y = d.n[k] * side.mesh->boxes[node][1][k];
        r.low += std::min(x, y);
        r.high += std::max(x, y);
    }
    return r;
}

// Calls use(vertex, its place along d) for all corners of the part but such as are within `inner`, which may grow
// meanwhile. The depth of the recursion is that of the tree, which is limited.
template <class Use>
void Filter::visit(const Side& side, std::uint32_t part, const Direction& d, const Range& inner, const Use& use) {
    const auto contains = [&](double x) { return inner.low <= x && x <= inner.high; };
    if (side.mesh->is_triangle(part) || side.mesh->is_leaf(part)) {
        for (const std::uint32_t vertex : side.mesh->all_corners(part)) {
            const double x = dot(d.n, side.mesh->vertices[vertex]) + d.offset;
            if (!contains(x)) use(vertex, x);
        }
        return;
    }
    const Node& node = side.mesh->nodes[part];
    budget_->spend(8 * node.count);
    for (std::uint32_t p = node.first; p < node.first + node.count; ++p) {
        const Range box = box_range(side, p, d);
        if (!contains(box.low) || !contains(box.high)) visit(side, p, d, inner, use);
    }
}

Filter::Range Filter::range(const Side& side, std::uint32_t part, const Direction& d) {
    Range found = {infinity, -infinity};
    visit(side, part, d, found, [&](std::uint32_t, double x) {
        found = {std::min(found.low, x), std::max(found.high, x)};
    });
    return found;
}

// The part reaches at least to high - error, and what is at most high - 4 error in doubles reaches at most to
// high - 3 error.
const std::vector<std::uint32_t>& Filter::extremes(std::size_t side, std::size_t k, std::uint32_t i) {
    const Direction& d = axes_[named_[k]].along[side];
    const std::uint32_t part = sides_[side].parts.first + i;
    Range inner = d.error < infinity ? range(sides_[side], part, d) : Range{infinity, -infinity};
    inner = {inner.low + 4 * d.error, inner.high - 4 * d.error};
    extremes_.clear();
    visit(sides_[side], part, d, inner, [&](std::uint32_t vertex, double) { extremes_.push_back(vertex); });
    return extremes_;
}

// Sets the ranges by boxes, of triangles by corners. NaN is never the greatest.
void Filter::open(const std::array<Node, 2>& parts, std::span<const std::uint32_t> axes) {
    named_ = axes;
    for (const std::size_t number : {0, 1}) {
        Side& side = sides_[number];
        side.parts = parts[number];
        side.ranges.resize(axes.size() * side.parts.count);
        side.is_best.assign(side.ranges.size(), 0);
        for (std::size_t k = 0, at = 0; k < axes.size(); ++k) {
            for (std::uint32_t i = 0; i < side.parts.count; ++i, ++at) {
                if (side.mesh->is_triangle(side.parts.first + i)) {
                    sharpen(number, k, i);
                } else {
                    side.ranges[at] = box_range(side, side.parts.first + i, axes_[axes[k]].along[number]);
                }
            }
        }
    }
    excess_.assign(std::size_t{parts[0].count} * parts[1].count, -infinity);
    for (std::size_t k = 0; k < axes.size(); ++k) {
        const double need = axes_[axes[k]].need;
        const Range *const a = &sides_[0].ranges[k * parts[0].count], *const b = &sides_[1].ranges[k * parts[1].count];
        for (std::uint32_t i = 0; i < parts[0].count; ++i) {
            double* const excess = &excess_[std::size_t{i} * parts[1].count];
            for (std::uint32_t j = 0; j < parts[1].count; ++j) {
                excess[j] = std::max(excess[j], std::max(b[j].low - a[i].high, a[i].low - b[j].high) - need);
            }
        }
    }
}

void Filter::sharpen(std::size_t side, std::size_t k, std::uint32_t i) {
    const std::size_t at = k * sides_[side].parts.count + i;
    if (std::exchange(sides_[side].is_best[at], 1) != 0) return;
    sides_[side].ranges[at] = range(sides_[side], sides_[side].parts.first + i, axes_[named_[k]].along[side]);
}

bool Filter::are_apart(std::uint32_t i, std::uint32_t j) {
    if (excess_[i * sides_[1].parts.count + j] > 0) return true;
    for (std::size_t k = 0; k < named_.size(); ++k) {
        sharpen(0, k, i);
        sharpen(1, k, j);
        const Range &a = sides_[0].ranges[k * sides_[0].parts.count + i],
                    &b = sides_[1].ranges[k * sides_[1].parts.count + j];
        const double need = axes_[named_[k]].need;
        if (b.low - a.high > need || a.low - b.high > need) return true;
    }
    return false;
}

}  // namespace certificate_checker
