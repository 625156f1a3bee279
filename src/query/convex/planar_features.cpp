#include "query/convex/planar_features.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace ecods::convex {

PlanarFeatures::PlanarFeatures(const PosedHulls& hulls, const std::array<HullFeature, 2>& parts, const Vec3& normal,
                               double along)
    : eta_(2 * hulls.delta() + 0x1p-49 * std::abs(along)) {
    Eigen::Index most = 0;
    normal.cwiseAbs().maxCoeff(&most);
    axes_ = {static_cast<std::size_t>((most + 1) % 3), static_cast<std::size_t>((most + 2) % 3)};
    for (std::size_t k = 0; k < 3; ++k) w_[k] = along * normal[static_cast<Eigen::Index>(k)];
    for (const std::size_t side : {0, 1}) {
        const Hull& hull = hulls.hull(side);
        const HullFeature& part = parts[side];
        if (part.kind == Feature::Kind::vertex) {
            add(hulls, side, part.index, 0);
        } else if (part.kind == Feature::Kind::edge) {
            for (const std::uint32_t end : hull.edges[part.index].ends) add(hulls, side, end, part.index);
        } else {
            for (const Hull::Neighbor& corner : hull.cycle_of(part.index)) add(hulls, side, corner.vertex, corner.edge);
        }
    }
    for (const std::size_t side : {0, 1}) of_[side].sides.assign(vertex_count(side), 0);
    for (const std::size_t side : {0, 1}) set_signs(side);
}

void PlanarFeatures::add(const PosedHulls& hulls, std::size_t side, std::uint32_t vertex, std::uint32_t edge) {
    exact::Point p = hulls.rounded(side, vertex);
    if (side == 1) p = exact::minus(p, w_);
    Projected& of = of_[side];
    of.x.push_back(p[axes_[0]]);
    of.y.push_back(p[axes_[1]]);
    of.at.push_back({vertex, edge});
}

// Sets `signs` of polygon `side`: the sides of its edges on which the vertices of the other polygon are. The first loop
// computes only in doubles, so that compilers vectorize it.
void PlanarFeatures::set_signs(std::size_t side) {
    constexpr std::size_t at_once = 16;
    const Projected& own = of_[side];
    Projected& other = of_[1 - side];
    const std::size_t count = vertex_count(1 - side);
    of_[side].signs.assign(edge_count(side) * count, 0);
    std::int8_t* sign = of_[side].signs.data();
    for (std::size_t i = 0; i < edge_count(side); ++i, sign += count) {
        const double ax = own.x[i], ay = own.y[i], bx = own.x[next(side, i)] - ax, by = own.y[next(side, i)] - ay;
        const double B = std::max(std::abs(bx), std::abs(by));
        for (std::size_t first = 0; first < count; first += at_once) {
            const std::size_t some = std::min(count - first, at_once);
            const double *const x = other.x.data() + first, *const y = other.y.data() + first;
            std::array<double, at_once> left, right;
            for (std::size_t j = 0; j < some; ++j) {
                const double cx = x[j] - ax, cy = y[j] - ay, C = std::max(std::abs(cx), std::abs(cy));
                const double turn = bx * cy - by * cx;
                const double error = 8 * eta_ * (B + C) + 16 * (eta_ * eta_) + 0x1p-48 * (B * C) + 0x1p-900;
                left[j] = turn > error ? 1 : 0;
                right[j] = turn < -error ? 1 : 0;
            }
            for (std::size_t j = 0; j < some; ++j) {
                const int is_left = static_cast<int>(left[j]), is_right = static_cast<int>(right[j]);
                sign[first + j] = static_cast<std::int8_t>(is_left - is_right);
                other.sides[first + j] |=
                    static_cast<std::uint8_t>(is_left * on_left + is_right * on_right + (1 - is_left - is_right));
            }
        }
    }
}

bool PlanarFeatures::are_apart(std::size_t side, std::size_t a, std::size_t b, std::size_t c,
                               std::size_t d) const noexcept {
    const double gap = 4 * eta_;
    const auto are = [&](const auto& p, const auto& q) {
        return std::min(p[a], p[b]) - std::max(q[c], q[d]) > gap || std::min(q[c], q[d]) - std::max(p[a], p[b]) > gap;
    };
    return are(of_[side].x, of_[1 - side].x) || are(of_[side].y, of_[1 - side].y);
}

bool PlanarFeatures::may_meet(std::size_t i, std::size_t j) const noexcept {
    return !are_apart(0, i, i, j, j);
}

bool PlanarFeatures::may_be_on(std::size_t side, std::size_t i, std::size_t j) const noexcept {
    return !are_apart(side, i, i, j, next(1 - side, j));
}

bool PlanarFeatures::may_cross(std::size_t i, std::size_t j) const noexcept {
    return !are_apart(0, i, next(0, i), j, next(1, j));
}

}  // namespace ecods::convex
