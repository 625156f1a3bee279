#include "query/certificate/contact_axis.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/arithmetic.hpp"
#include "bvh/walks/tree_view.hpp"

namespace ecods {

using exact::Integer;

namespace {

// Returns 2^-e v, rounded to doubles, with e such that the largest coordinate is at least 1/2 and below 1. Each
// coordinate is off by less than 2^-51.
Vec3 in_doubles(const exact::LongVector& v) {
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

// Boxes that are beyond the plane by less than this share of the body's size are decided exactly. Boxes that are
// further beyond are outside: rounding and the errors of leaves' corners cannot explain their distance.
constexpr double near_share = 0x1p-18;

}  // namespace

// `margin` is derived as follows: n in doubles is off by 2^-51 on each axis, and each point of the body is at most size
// + origin_size from the origin of coordinates. The plane is computed from a corner of the body, so the plane has the
// errors of any other point.
ContactAxis::ContactAxis(const ProofAxis& named_axis, const SixCorners& corners, const ExactPoints& points,
                         const std::array<BodyFrame, 2>& bodies)
    : axis(named_axis), points_(points), n_(vector_of(axis.formula, corners)) {
    ExactReach a = reach_of(n_, &corners[0]), b = reach_of(n_, &corners[3]);
    const bool is_up = compare(b.low, a.high) >= 0, is_down = compare(a.low, b.high) >= 0;
    // If n and -n both separate weakly, the triangles are in one plane. The axis is then turned so that it points
    // roughly from a to b.
    const Vec3 towards_b = bodies[1].origin - bodies[0].origin;
    if (is_down && (!is_up || in_doubles(n_).dot(towards_b) < 0)) {
        n_ = minus(exact::LongVector{}, n_);
        a.high = -a.low;
        b.low = -b.high;
    }
    halves_[0].exact_plane = a.high;
    halves_[1].exact_plane = b.low;
    const Vec3 n = in_doubles(n_);
    for (std::size_t k = 0; k < 2; ++k) {
        Half& half = halves_[k];
        const BodyFrame& body = bodies[k];
        half.body = &body;
        half.axis = put_on_axis(body, (k == 0 ? 1.0 : -1.0) * n);
        const double size = body.size.sum() + body.origin_size.sum();
        // The error is doubled because the coordinate of the plane's corner is off, too.
        half.margin = (2 * half.axis.error + 0x1p-49 * size) * (1 + 0x1p-20) + half.axis.corner_reach;
        half.near = near_share * body.size.sum();
        half.vertices.assign(body.ref.mesh->vertices().size(), Side::unknown);
        half.nodes.assign(body.tree.nodes.size(), Side::unknown);
        half.leaves.assign(body.tree.leaves.size(), Side::unknown);
        half.plane = -0x1p1000;
        for (const std::uint32_t vertex : body.triangle(k == 0 ? axis.a : axis.b)) {
            const Vec3 y = body.tree.frame.coordinates(body.ref.mesh->vertices()[vertex]);
            half.plane = std::max(half.plane, half.axis.at(y));
        }
    }
}

// Returns two sets of lanes of x: the lanes that are certainly inside, and other lanes that may be inside.
template <class X>
std::array<std::uint32_t, 2> ContactAxis::classify(const Half& half, const X& x) const {
    if (!half.axis.is_bounded) return {0, x.lanes()};
    Reaches<double> reaches;
    find_reaches(half.axis, x, reaches);
    std::uint32_t inside = 0, near = 0;
    for (std::size_t lane = 0; lane < tree_width; ++lane) {
        if (reaches.high[lane] <= half.plane - half.margin) inside |= 1u << lane;
        if (reaches.high[lane] <= half.plane + half.near + half.margin) near |= 1u << lane;
    }
    return {inside & x.lanes(), near & x.lanes() & ~inside};
}

template <class X>
std::uint32_t ContactAxis::lanes_inside(std::size_t body, const X& x) {
    auto [inside, near] = classify(halves_[body], x);
    for (; near != 0; near &= near - 1) {
        if (is_part_inside(body, x, static_cast<std::size_t>(std::countr_zero(near)))) inside |= near & -near;
    }
    return inside;
}
template std::uint32_t ContactAxis::lanes_inside(std::size_t, const BvhNode&);
template std::uint32_t ContactAxis::lanes_inside(std::size_t, const TreeLeaf&);

bool ContactAxis::is_part_inside(std::size_t body, const TreeLeaf& leaf, std::size_t lane) {
    return std::ranges::all_of(leaf.vertices[lane],
                               [&](std::uint32_t vertex) { return is_vertex_inside(body, vertex); });
}

// Returns true if child `lane` of the node is inside, that is, if all its triangles are inside. Only triangles that
// bounds leave undecided are tested.
bool ContactAxis::is_part_inside(std::size_t body, const BvhNode& node, std::size_t lane) {
    Half& half = halves_[body];
    const TreeRef part = node.child[lane];
    const TreeView view(half.body->tree, part);
    const auto known = [&](TreeRef ref) -> Side& {
        return ref.is_leaf() ? half.leaves[ref.index()] : half.nodes[ref.index()];
    };
    bool all = true;
    const auto bound = [&](TreeRef ref) -> std::uint32_t {
        Side& side = known(ref);
        if (!all || side != Side::unknown) {
            all &= side == Side::inside;
            return 0;
        }
        if (ref.is_leaf()) {
            const TreeLeaf& leaf = view.leaf(ref);
            all = lanes_inside(body, leaf) == leaf.lanes();
            side = all ? Side::inside : Side::outside;
            return 0;
        }
        const BvhNode& x = half.body->tree.nodes[ref.index()];
        const auto [inside, near] = classify(half, x);
        all = (inside | near) == x.lanes();
        if (!all) side = Side::outside;
        return near;
    };
    std::vector<TreeRef> stack;
    walk_one(view, stack, bound, [&](TreeRef, std::uint32_t) { return all; });
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
