#include "query/convex/planar_features.hpp"

#include <algorithm>
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
}

void PlanarFeatures::add(const PosedHulls& hulls, std::size_t side, std::uint32_t vertex, std::uint32_t edge) {
    exact::Point p = hulls.rounded(side, vertex);
    if (side == 1) p = exact::minus(p, w_);
    of_[side].push_back({p[axes_[0]], p[axes_[1]], vertex, edge});
}

bool PlanarFeatures::are_apart(const Corner& a, const Corner& b, const Corner& c, const Corner& d) const noexcept {
    const double gap = 4 * eta_;
    return std::min(a.x, b.x) - std::max(c.x, d.x) > gap || std::min(c.x, d.x) - std::max(a.x, b.x) > gap ||
           std::min(a.y, b.y) - std::max(c.y, d.y) > gap || std::min(c.y, d.y) - std::max(a.y, b.y) > gap;
}

bool PlanarFeatures::may_meet(std::size_t i, std::size_t j) const noexcept {
    return !are_apart(of_[0][i], of_[0][i], of_[1][j], of_[1][j]);
}

bool PlanarFeatures::may_be_on(std::size_t side, std::size_t i, std::size_t j) const noexcept {
    const Corner& corner = of_[side][i];
    return !are_apart(corner, corner, of_[1 - side][j], next(1 - side, j)) && sign(1 - side, j, corner) == 0;
}

int PlanarFeatures::sign(std::size_t side, std::size_t i, const Corner& c) const noexcept {
    const Corner &a = of_[side][i], &b = next(side, i);
    const double bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
    const double B = std::max(std::abs(bx), std::abs(by)), C = std::max(std::abs(cx), std::abs(cy));
    const double turn = bx * cy - by * cx;
    const double error = 8 * eta_ * (B + C) + 16 * (eta_ * eta_) + 0x1p-48 * (B * C) + 0x1p-900;
    return turn > error ? 1 : turn < -error ? -1 : 0;
}

// Uses that a point outside a convex polygon is on the inner side of some edge and on the outer side of another.
auto PlanarFeatures::is_inside(std::size_t side, std::size_t i) const noexcept -> Answer {
    std::array<bool, 3> has{};
    for (std::size_t j = 0; j < edge_count(1 - side); ++j) {
        has[static_cast<std::size_t>(1 + sign(1 - side, j, of_[side][i]))] = true;
        if (has[0] && has[2]) return Answer::no;
    }
    return has[1] ? Answer::open : Answer::yes;
}

// Uses that two segments cross if each has its ends on both sides of the other one's line.
auto PlanarFeatures::do_cross(std::size_t i, std::size_t j) const noexcept -> Answer {
    if (are_apart(of_[0][i], next(0, i), of_[1][j], next(1, j))) return Answer::no;
    Answer answer = Answer::yes;
    for (const std::size_t side : {0, 1}) {
        const std::size_t own = side == 0 ? i : j, other = side == 0 ? j : i;
        const int from = sign(side, own, of_[1 - side][other]), to = sign(side, own, next(1 - side, other));
        if (from * to > 0) return Answer::no;
        if (from * to == 0) answer = Answer::open;
    }
    return answer;
}

}  // namespace ecods::convex
