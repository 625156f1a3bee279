#include "query/intersection/plane_signs.hpp"

#include "base/assert.hpp"
#include "exact/simplex/common_pose.hpp"

namespace ecods {

using namespace exact;

namespace {

// Returns the key of a sign in a cache. Planes of the two bodies have different keys; indices of triangles, groups and
// vertices have 31 bits.
std::uint64_t key_of(std::size_t body, std::uint32_t own, std::uint32_t other) noexcept {
    return (std::uint64_t{own} << 33) | (std::uint64_t{other} << 1) | body;
}

std::uint32_t group_of(const CoplanarGroups& groups, std::uint32_t triangle) noexcept {
    return groups.empty() ? CoplanarGroups::none : groups.of_triangle[triangle];
}

}  // namespace

void PlaneSigns::use(Frame& frame, const CoplanarGroups& a, const CoplanarGroups& b) noexcept {
    frame_ = &frame;
    groups_ = {&a, &b};
    turn_ = {};
}

// Returns -1 if the pose mirrors the body, otherwise 1. The sign is computed on first use, because often no pair of
// planes needs it.
int PlaneSigns::turn(std::size_t body) {
    if (turn_[body] == 0) turn_[body] = is_mirror(frame_->body(body).pose->R) ? -1 : 1;
    return turn_[body];
}

bool PlaneSigns::are_triangles_apart(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t group_a = group_of(*groups_[0], a), group_b = group_of(*groups_[1], b);
    return group_a != CoplanarGroups::none && group_b != CoplanarGroups::none && are_apart(group_a, group_b);
}

Sides PlaneSigns::complete(Sides sides, std::size_t body, std::uint32_t own, std::uint32_t other) {
    if (sides[0] != 0 && sides[1] != 0 && sides[2] != 0) return sides;
    const std::uint32_t group = group_of(*groups_[body], own);
    if (sides == Sides{0, 0, 0} && group != CoplanarGroups::none) {
        const std::uint32_t other_group = group_of(*groups_[1 - body], other);
        if (other_group != CoplanarGroups::none) {
            const int all = side_of_parallel(body, group, other_group);
            if (all != not_parallel) return {all, all, all};
        }
    }
    const std::uint32_t plane = group == CoplanarGroups::none ? own : groups_[body]->first[group];
    const Triangle& corners = triangle(1 - body, other);
    for (std::size_t i = 0; i < 3; ++i) {
        if (sides[i] == 0) sides[i] = side(body, plane, corners[i]);
    }
    return sides;
}

// Computes side_of_parallel() from one triangle of each group. Let p be the triangle of `body`, q the other triangle,
// and n = normal(p0, p1, p2). If n . (q1 - q0) = n . (q2 - q0) = 0, then n . x is the same for all points x of the
// plane of q. Proof: a triangle of positive area spans its plane in the mesh, and affine maps keep this, so every point
// of the plane is q0 + s (q1 - q0) + t (q2 - q0) for some real s and t. If the pose makes n zero, all signs are zero,
// too.
int PlaneSigns::compute_side_of_parallel(std::size_t body, std::uint32_t group, std::uint32_t other_group) {
    ++computed_count_;
    const std::size_t other = 1 - body;
    const Triangle& p = triangle(body, groups_[body]->first[group]);
    const Triangle& q = triangle(other, groups_[other]->first[other_group]);
    const std::array<VertexRef, 6> corners{VertexRef{body, p[0]}, {body, p[1]},  {body, p[2]},
                                           {other, q[0]},         {other, q[1]}, {other, q[2]}};
    return frame_->with_integers(corners, []<class Kernel>(const IntegerPoints<Kernel, 6>& points) {
        const auto& at = points.at;
        const auto n = Kernel::normal(at[0], at[1], at[2]);
        if (Kernel::side(n, at[3], at[4]) != 0 || Kernel::side(n, at[3], at[5]) != 0) return not_parallel;
        return Kernel::side(n, at[0], at[3]);
    });
}

int PlaneSigns::side_of_parallel(std::size_t body, std::uint32_t group, std::uint32_t other_group) {
    return parallel_.get(key_of(body, group, other_group), [&] {
        const int side = compute_side_of_parallel(body, group, other_group);
        is_parted_ |= part_bodies(body, group, other_group, side);
        return side;
    });
}

// Returns true if two parallel planes are proven to have the bodies on both sides of the gap between them. Plane P is
// that of `group` of `body`, plane Q that of `other_group`; `side` is the side of P on which Q is. The open slab
// between P and Q is free of both bodies if all of `body` is on the closed side of P away from Q, and all of the other
// body is on the closed side of Q away from P. A pose R multiplies the side of a point relative to a plane of its mesh
// by the sign of det R. If det R is zero, the body is in P, and so on both closed sides.
bool PlaneSigns::part_bodies(std::size_t body, std::uint32_t group, std::uint32_t other_group, int side) {
    const std::size_t other = 1 - body;
    const int own_side = groups_[body]->side[group], other_side = groups_[other]->side[other_group];
    if ((side != 1 && side != -1) || own_side == 0 || other_side == 0) return false;
    if (turn(body) * own_side != -side) return false;
    return compute_side_of_parallel(other, other_group, group) == -turn(other) * other_side;
}

int PlaneSigns::side(std::size_t body, std::uint32_t own, std::uint32_t vertex) {
    return sides_.get(key_of(body, own, vertex), [&] {
        ++computed_count_;
        const Triangle& p = triangle(body, own);
        const std::array<VertexRef, 4> corners{VertexRef{body, p[0]}, {body, p[1]}, {body, p[2]}, {1 - body, vertex}};
        return frame_->with_integers(corners,
                                     [](const auto& points) { return ExactSigns(points).orient3d(0, 1, 2, 3); });
    });
}

}  // namespace ecods
