#include "query/certificate/contact_axis.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/arithmetic.hpp"

namespace ecods {

using exact::Integer;

namespace {

// About v 2^-e, for the e with which the longest coordinate is below 1 and at least 1/2: off by less than 2^-51.
Vec3 in_doubles(const IntegerVector3& v) {
    int width = 0;
    for (const Integer& x : v) width = std::max(width, x.bit_width());
    Vec3 result;
    for (std::size_t k = 0; k < 3; ++k) {
        const Integer x = width > 53 ? v[k] >> (width - 53) : v[k] << (53 - width);
        const double size = x.is_zero() ? 0 : static_cast<double>(static_cast<std::int64_t>(x.limbs()[0]));
        result[static_cast<int>(k)] = (x.sign() < 0 ? -size : size) * 0x1p-53;
    }
    return result;
}

Integer extreme(const IntegerVector3& n, const IntegerVector3* corners, bool is_high) {
    Integer result = dot(n, corners[0]);
    for (std::size_t c = 1; c < 3; ++c) {
        const Integer x = dot(n, corners[c]);
        if ((compare(x, result) > 0) == is_high) result = x;
    }
    return result;
}

// Points that are beyond the plane by more than rounding and a leaf's corners explain are not looked at exactly.
constexpr double near_share = 0x1p-18;

}  // namespace

// The bound: n in doubles is off by 2^-51 on each axis, and a point of the body by no more than size + origin_size from
// where coordinates are counted. The plane is that of a corner of the body, and has the errors of any other point.
ContactAxis::ContactAxis(const ProofAxis& named, const SixCorners& corners, const ExactPoints& points,
                         const std::array<Body, 2>& bodies, const Vec3& towards_b)
    : named_(named), points_(points), n_(normal_of(named.formula, corners)) {
    const bool is_up = compare(extreme(n_, &corners[3], false), extreme(n_, &corners[0], true)) >= 0;
    const bool is_down = compare(extreme(n_, &corners[0], false), extreme(n_, &corners[3], true)) >= 0;
    if (is_down && (!is_up || in_doubles(n_).dot(towards_b) < 0)) n_ = minus({}, n_);
    const Vec3 n = in_doubles(n_);
    for (std::size_t k = 0; k < 2; ++k) {
        Half& half = halves_[k];
        half.body = bodies[k];
        half.sign = k == 0 ? 1 : -1;
        half.axis = put_on_axis(*half.body.frame, half.sign * n);
        half.exact_plane = extreme(n_, &corners[3 * k], k == 0);
        const double size = half.body.frame->size.sum() + half.body.frame->origin_size.sum();
        half.margin = (2 * half.axis.error + 0x1p-49 * size) * (1 + 0x1p-20);
        half.near = near_share * half.body.frame->size.sum();
        half.vertices.assign(half.body.mesh->vertices().size(), Side::unknown);
        half.nodes.assign(half.body.tree->nodes.size(), Side::unknown);
        half.leaves.assign(half.body.tree->leaves.size(), Side::unknown);
        const std::uint32_t triangle = k == 0 ? named.a : named.b;
        half.plane = -0x1p1000;
        const LocalFrame& frame = half.body.tree->frame;
        for (const std::uint32_t vertex : half.body.mesh->triangles()[triangle]) {
            const Vec3 y = frame.coordinates(half.body.mesh->vertices()[vertex]);
            half.plane = std::max(half.plane,
                                  half.axis.p[0] * y[0] + half.axis.p[1] * y[1] + half.axis.p[2] * y[2] + half.axis.q);
        }
        // The coordinates y of the corner are off, too.
        half.margin += half.axis.corner_reach;
    }
}

// Those that are inside, and those that may be.
std::array<std::uint32_t, 2> ContactAxis::classify(const Half& half, const Reaches& reaches,
                                                   std::uint32_t lanes) const {
    if (!half.axis.is_bounded) return {0, lanes};
    std::uint32_t inside = 0, near = 0;
    for (std::size_t lane = 0; lane < tree_width; ++lane) {
        if (reaches.high[lane] <= half.plane - half.margin) inside |= 1u << lane;
        if (reaches.high[lane] <= half.plane + half.near + half.margin) near |= 1u << lane;
    }
    return {inside & lanes, near & lanes & ~inside};
}

std::uint32_t ContactAxis::lanes_inside(std::size_t body, const BvhNode& node) {
    Reaches reaches;
    find_reaches(halves_[body].axis, node, reaches);
    auto [inside, near] = classify(halves_[body], reaches, node.lanes());
    for (; near != 0; near &= near - 1) {
        if (is_inside(body, node.child[static_cast<std::size_t>(std::countr_zero(near))])) inside |= near & -near;
    }
    return inside;
}

std::uint32_t ContactAxis::lanes_inside(std::size_t body, const TreeLeaf& leaf) {
    Reaches reaches;
    find_reaches(halves_[body].axis, leaf, reaches);
    auto [inside, near] = classify(halves_[body], reaches, leaf.lanes());
    for (; near != 0; near &= near - 1) {
        const Triangle& corners = leaf.vertices[static_cast<std::size_t>(std::countr_zero(near))];
        if (std::ranges::all_of(corners, [&](std::uint32_t vertex) { return is_vertex_inside(body, vertex); }))
            inside |= near & -near;
    }
    return inside;
}

// Depth first, without recursion: a part is inside if all that bounds leave open in it is.
bool ContactAxis::is_inside(std::size_t body, TreeRef part) {
    Half& half = halves_[body];
    const auto known = [&](TreeRef ref) -> Side& {
        return ref.is_leaf() ? half.leaves[ref.index()] : half.nodes[ref.index()];
    };
    if (known(part) != Side::unknown) return known(part) == Side::inside;
    std::vector<TreeRef> stack{part};
    bool all = true;
    while (!stack.empty() && all) {
        const TreeRef top = stack.back();
        stack.pop_back();
        if (known(top) != Side::unknown) {
            all = known(top) == Side::inside;
        } else if (top.is_leaf()) {
            const TreeLeaf& leaf = half.body.tree->leaves[top.index()];
            all = lanes_inside(body, leaf) == leaf.lanes();
            known(top) = all ? Side::inside : Side::outside;
        } else {
            const BvhNode& node = half.body.tree->nodes[top.index()];
            Reaches reaches;
            find_reaches(half.axis, node, reaches);
            auto [inside, near] = classify(half, reaches, node.lanes());
            all = (inside | near) == node.lanes();
            if (!all) known(top) = Side::outside;
            for (; near != 0; near &= near - 1)
                stack.push_back(node.child[static_cast<std::size_t>(std::countr_zero(near))]);
        }
    }
    known(part) = all ? Side::inside : Side::outside;
    return all;
}

bool ContactAxis::is_vertex_inside(std::size_t body, std::uint32_t vertex) {
    Half& half = halves_[body];
    Side& side = half.vertices[vertex];
    if (side == Side::unknown) {
        const int order = compare(dot(n_, points_.vertex(body, vertex)), half.exact_plane);
        side = (body == 0 ? order <= 0 : order >= 0) ? Side::inside : Side::outside;
    }
    return side == Side::inside;
}

}  // namespace ecods
