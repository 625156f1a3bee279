#include "query/solid/solid_search.hpp"

#include <algorithm>

#include "bvh/walks/walk_two.hpp"
#include "exact/sign/frame_signs.hpp"
#include "exact/simplex/common_pose.hpp"
#include "query/intersection/overlap_bound.hpp"

namespace ecods {

using namespace exact;

SolidSearch::SolidSearch(const Posed<Solid>& a, const Posed<Solid>& b, QueryMemory& memory)
    : a_(a),
      b_(b),
      state_(QueryMemoryAccess::state(memory)),
      memory_(SolidMemory::of(memory)),
      bodies_{Body{SolidAccess::parts(*a.what), SolidAccess::tree(*a.what), SolidAccess::shells(*a.what), false},
              Body{SolidAccess::parts(*b.what), SolidAccess::tree(*b.what), SolidAccess::shells(*b.what), false}},
      signs_(memory_.frame) {
    ++state_.counts.queries;
}

SolidRelation SolidSearch::find() {
    const int axis =
        state_.axes.bind({bodies_[0].tree.boxes, a_.pose.R}, {bodies_[1].tree.boxes, b_.pose.R}, b_.pose.t - a_.pose.t);
    if (axis >= 0) return SolidRelation::apart;
    std::array<BodyRef, 2> refs{BodyRef{bodies_[0].parts.proper.mesh.get(), &bodies_[0].tree.extent, &a_.pose},
                                {bodies_[1].parts.proper.mesh.get(), &bodies_[1].tree.extent, &b_.pose}};
    cancel_common_pose(refs);
    memory_.frame.bind(refs);
    memory_.fans.clear();
    for (std::size_t k = 0; k < 2; ++k) {
        bodies_[k].is_mirrored = is_mirror(refs[k].pose->R);
        memory_.met[k].assign(bodies_[k].shells.first.size(), 0);
    }
    walk();
    for (std::size_t k = 0; k < 2; ++k) find_places(k);
    return relation();
}

void SolidSearch::walk() {
    PairContacts contacts(memory_.frame, state_.counts.stages);
    walk_two(bodies_[0].tree.boxes, bodies_[1].tree.boxes, state_.stack,
             OverlapBound(state_.axes.sets(), state_.counts), [&](std::uint32_t i, std::uint32_t j) {
                 take(i, j, contacts);
                 return regions_ != all_regions;
             });
}

void SolidSearch::take(std::uint32_t i, std::uint32_t j, PairContacts& contacts) {
    const std::uint32_t shell_i = bodies_[0].shells.of_triangle[i], shell_j = bodies_[1].shells.of_triangle[j];
    if (shell_i == no_shell || shell_j == no_shell) return;
    const TriangleContact found = contacts.contact(bodies_[0].triangles()[i], bodies_[1].triangles()[j]);
    if (found.kind == ContactKind::none || found.kind == ContactKind::coplanar) return;
    touch_ = true;
    if (found.kind == ContactKind::point) return;
    const Part a{0, i, found.first}, b{1, j, found.second};
    if (a.is_face() && b.is_face()) {
        // Around a segment in which two planes cross there are regions of all kinds.
        regions_ = all_regions;
        return;
    }
    memory_.met[0][shell_i] = memory_.met[1][shell_j] = 1;
    turn_around(a, b);
}

// An edge or a face of a solid.
std::uint64_t SolidSearch::name_of(const Part& part) const {
    if (part.is_face()) return 2 * std::uint64_t{part.triangle} + 1;
    return 2 * std::uint64_t{bodies_[part.solid].parts.edges.edge_of(part.side_ref())};
}

// Reads the regions around a segment that a feature of each solid holds, one of them at least an edge.
void SolidSearch::turn_around(const Part& a, const Part& b) {
    if (!memory_.fans.insert(name_of(a), name_of(b))) return;
    const Part& lead = a.is_face() ? b : a;
    const Triangle& corners = bodies_[lead.solid].triangles()[lead.triangle];
    const auto corner = static_cast<std::size_t>(lead.side);
    const Line line{{lead.solid, corners[corner]}, {lead.solid, corners[(corner + 1) % 3]}};
    memory_.wings.clear();
    add_wings(a, line);
    add_wings(b, line);
    sort_fan(signs_, line.p, line.q, memory_.wings);
    read_sectors();
}

void SolidSearch::add_wings(const Part& part, const Line& line) {
    part.is_face() ? add_face_wings(part, line) : add_edge_wings(part, line);
}

// Turning around the line, one leaves a triangle to where its corners turn left, its outer side unless it faces in, if
// the line has the direction of its side.
void SolidSearch::add_edge_wings(const Part& part, const Line& line) {
    const Body& body = bodies_[part.solid];
    const auto ends_of = [&](const SideRef& side) {
        const Triangle& corners = body.triangles()[side.triangle];
        return std::array{corners[side.corner], corners[(side.corner + 1) % 3]};
    };
    const auto ends = ends_of(part.side_ref());
    const bool is_along = signs_.are_in_order(line.p, line.q, {part.solid, ends[0]}, {part.solid, ends[1]});
    for (const SideRef& side : body.parts.edges.sides(body.parts.edges.edge_of(part.side_ref()))) {
        const bool goes_along = (ends_of(side) == ends) == is_along;
        const std::uint32_t apex = body.triangles()[side.triangle][(side.corner + 2) % 3];
        const bool inside_after = goes_along == faces_in(part.solid, side.triangle);
        memory_.wings.push_back({{part.solid, apex},
                                 side.triangle,
                                 static_cast<std::uint8_t>(part.solid),
                                 static_cast<std::uint8_t>(inside_after),
                                 0});
    }
}

// The two halves of a plane: with a corner on each side of the line.
void SolidSearch::add_face_wings(const Part& part, const Line& line) {
    const Triangle& corners = bodies_[part.solid].triangles()[part.triangle];
    const auto at = [&](std::size_t k) { return VertexRef{part.solid, corners[k]}; };
    const int axis = signs_.normal_axis(at(0), at(1), at(2));
    ECODS_ASSERT(axis >= 0);
    const int turn = signs_.orient2d(at(0), at(1), at(2), axis);
    std::array<bool, 2> has_side{};
    for (std::size_t k = 0; k < 3; ++k) {
        const int side = signs_.orient2d(line.p, line.q, at(k), axis);
        if (side == 0 || has_side[side > 0]) continue;
        has_side[side > 0] = true;
        const bool inside_after = (side == turn) == faces_in(part.solid, part.triangle);
        memory_.wings.push_back(
            {at(k), part.triangle, static_cast<std::uint8_t>(part.solid), static_cast<std::uint8_t>(inside_after), 0});
    }
}

// Each sector between two directions is part of a region: once around, beginning with what is after the last wings.
void SolidSearch::read_sectors() {
    const std::vector<Wing>& wings = memory_.wings;
    std::array<bool, 2> is_inside{};
    for (const Wing& wing : wings) is_inside[wing.solid] = wing.inside_after != 0;
    for (std::size_t i = 0; i < wings.size(); ++i) {
        ECODS_ASSERT(is_inside[wings[i].solid] != (wings[i].inside_after != 0));
        is_inside[wings[i].solid] = wings[i].inside_after != 0;
        if (i + 1 < wings.size() && wings[i + 1].group == wings[i].group) continue;
        if (is_inside[0]) {
            regions_ |= is_inside[1] ? in_both : in_a_only;
        } else if (is_inside[1]) {
            regions_ |= in_b_only;
        }
    }
}

// A shell without a segment of contact is on one side of the other solid's surface.
void SolidSearch::find_places(std::size_t solid) {
    const Body& own = bodies_[solid];
    const unsigned own_only = solid == 0 ? in_a_only : in_b_only, other_only = solid == 0 ? in_b_only : in_a_only;
    RayQuery rays(memory_.frame, 1 - solid, bodies_[1 - solid].tree, memory_.stack, state_.counts);
    for (std::size_t shell = 0; shell < own.shells.first.size() && regions_ != all_regions; ++shell) {
        if (memory_.met[solid][shell] != 0) continue;
        const bool is_inside = rays.is_inside(solid, own.triangles()[own.shells.first[shell]]);
        regions_ |= is_inside ? in_both | other_only : own_only;
    }
}

SolidRelation SolidSearch::relation() const noexcept {
    if ((regions_ & in_both) == 0) return touch_ ? SolidRelation::touching : SolidRelation::apart;
    if ((regions_ & in_a_only) == 0) {
        return (regions_ & in_b_only) == 0 ? SolidRelation::equal : SolidRelation::inside;
    }
    return (regions_ & in_b_only) == 0 ? SolidRelation::contains : SolidRelation::overlapping;
}

}  // namespace ecods
