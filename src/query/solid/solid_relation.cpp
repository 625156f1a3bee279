#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "bvh/walks/walk_two.hpp"
#include "exact/sign/frame_signs.hpp"
#include "exact/simplex/common_pose.hpp"
#include "exact/simplex/triangle_contact.hpp"
#include "query/intersection/asking.hpp"
#include "query/intersection/overlap_bound.hpp"
#include "query/solid/fan.hpp"
#include "query/solid/pair_contacts.hpp"
#include "query/solid/ray_query.hpp"
#include "query/solid/relations.hpp"
#include "query/solid/solid_memory.hpp"
#include "query/solid/solid_parts.hpp"
#include "query/solid/surfaces_meet.hpp"

namespace ecods {

using namespace exact;

namespace {

// SolidSearch finds which of the regions `in_both`, `in_a_only` and `in_b_only` two posed solids have, and whether
// their surfaces touch. README.md proves that the regions and the touching determine the relation.
class SolidSearch {
  public:
    // Both poses must be regular.
    SolidSearch(const Posed<Solid>& a, const Posed<Solid>& b, QueryMemory& memory)
        : state_(QueryMemoryAccess::state(memory)),
          memory_(SolidMemory::of(memory)),
          bodies_{Body(a), Body(b)},
          signs_(memory_.frame) {}
    SolidSearch(const SolidSearch&) = delete;
    SolidSearch& operator=(const SolidSearch&) = delete;

    Relation find() {
        ++state_.counts.queries;
        if (are_boxes_apart(bodies_[0].at, bodies_[1].at, state_)) return Relation::apart;
        bind(memory_.frame, bodies_[0].at, bodies_[1].at);
        memory_.fans.clear();
        for (std::size_t k = 0; k < 2; ++k) {
            bodies_[k].is_mirrored = is_mirror(memory_.frame.body(k).pose->R);
            memory_.met[k].assign(bodies_[k].shells.first.size(), 0);
        }
        walk();
        for (std::size_t k = 0; k < 2; ++k) find_places(k);
        return relation();
    }

  private:
    // The bits stand for regions of space without both surfaces: in both solids, in a only, in b only.
    enum : unsigned { in_both = 1, in_a_only = 2, in_b_only = 4, all_regions = 7 };

    struct Body {
        SurfaceAt at;
        const SolidAccess::Parts& parts;
        const Shells& shells;
        bool is_mirrored = false;

        explicit Body(const Posed<Solid>& posed)
            : at(posed), parts(SolidAccess::parts(*posed.what)), shells(SolidAccess::shells(*posed.what)) {}
        std::span<const Triangle> triangles() const { return at.body.mesh->triangles(); }
    };
    // A Part is the part of a triangle on which a segment lies: side number `side`, or the face if `side` is
    // TriangleContact::face.
    struct Part {
        std::size_t solid;
        std::uint32_t triangle;
        int side;

        SideRef side_ref() const noexcept { return {triangle, static_cast<std::uint32_t>(side)}; }
        bool is_face() const noexcept { return side == TriangleContact::face; }
    };
    struct Line {
        VertexRef p, q;
    };

    bool faces_in(std::size_t solid, std::uint32_t triangle) const {
        return (bodies_[solid].shells.faces_in[triangle] != 0) != bodies_[solid].is_mirrored;
    }

    void walk() {
        PairContacts contacts(memory_.frame, state_.counts.stages);
        walk_two(bodies_[0].at.tree.boxes, bodies_[1].at.tree.boxes, state_.stack,
                 OverlapBound(state_.axes.sets(), state_.counts), [&](std::uint32_t i, std::uint32_t j) {
                     take(i, j, contacts);
                     return regions_ != all_regions;
                 });
    }

    void take(std::uint32_t i, std::uint32_t j, PairContacts& contacts) {
        const std::uint32_t shell_i = bodies_[0].shells.of_triangle[i], shell_j = bodies_[1].shells.of_triangle[j];
        if (shell_i == no_shell || shell_j == no_shell) return;
        const TriangleContact found = contacts.contact(bodies_[0].triangles()[i], bodies_[1].triangles()[j]);
        if (found.kind == ContactKind::none || found.kind == ContactKind::coplanar) return;
        touch_ = true;
        if (found.kind == ContactKind::point) return;
        const Part a{0, i, found.first}, b{1, j, found.second};
        if (a.is_face() && b.is_face()) {
            // All three regions occur around a segment in which two faces cross.
            regions_ = all_regions;
            return;
        }
        memory_.met[0][shell_i] = memory_.met[1][shell_j] = 1;
        turn_around(a, b);
    }

    // Returns a number that is unique to the edge or face among all edges and faces of its solid.
    std::uint64_t name_of(const Part& part) const {
        if (part.is_face()) return 2 * std::uint64_t{part.triangle} + 1;
        return 2 * std::uint64_t{bodies_[part.solid].parts.edges.edge_of(part.side_ref())};
    }

    // Adds the regions around a segment that lies on a part of each solid. At least one of the parts must be a side.
    // Each pair of features is handled once.
    void turn_around(const Part& a, const Part& b) {
        if (!memory_.fans.insert(name_of(a), name_of(b))) return;
        const Part& lead = a.is_face() ? b : a;
        const auto corners = corners_from(bodies_[lead.solid].triangles(), lead.side_ref());
        const Line line{{lead.solid, corners[0]}, {lead.solid, corners[1]}};
        memory_.wings.clear();
        add_wings(a, line);
        add_wings(b, line);
        sort_fan(signs_, line.p, line.q, memory_.wings);
        read_sectors();
    }

    void add_wings(const Part& part, const Line& line) {
        part.is_face() ? add_face_wings(part, line) : add_edge_wings(part, line);
    }

    // Adds a wing for each triangle around an edge. If a triangle's side has the direction of the line, a turn around
    // the line leaves the triangle on the side from which its corners turn left. That side is the outer side unless the
    // triangle faces in.
    void add_edge_wings(const Part& part, const Line& line) {
        const Body& body = bodies_[part.solid];
        const std::uint32_t first = corners_from(body.triangles(), part.side_ref())[0],
                            second = corners_from(body.triangles(), part.side_ref())[1];
        const bool is_along = signs_.are_in_order(line.p, line.q, {part.solid, first}, {part.solid, second});
        for (const SideRef& side : body.parts.edges.sides(body.parts.edges.edge_of(part.side_ref()))) {
            const auto [from, to, apex] = corners_from(body.triangles(), side);
            const bool goes_along = (from == first) == is_along;
            const bool inside_after = goes_along == faces_in(part.solid, side.triangle);
            memory_.wings.push_back({{part.solid, apex}, side.triangle, inside_after});
        }
    }

    // Adds a wing for each of the two halves of a face's plane. The wing's apex is a corner of the face on the same
    // side of the line.
    void add_face_wings(const Part& part, const Line& line) {
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
            memory_.wings.push_back({at(k), part.triangle, inside_after});
        }
    }

    // Adds the region of each sector between two wings, in one turn around the line that begins with the first sector.
    void read_sectors() {
        const std::vector<Wing>& wings = memory_.wings;
        std::array<bool, 2> is_inside{};
        for (const Wing& wing : wings) is_inside[wing.apex.body] = wing.inside_after;
        for (std::size_t i = 0; i < wings.size(); ++i) {
            bool& is_inside_own = is_inside[wings[i].apex.body];
            ECODS_ASSERT(is_inside_own != wings[i].inside_after);
            is_inside_own = wings[i].inside_after;
            if (i + 1 < wings.size() && wings[i + 1].group == wings[i].group) continue;
            if (is_inside[0]) {
                regions_ |= is_inside[1] ? in_both : in_a_only;
            } else if (is_inside[1]) {
                regions_ |= in_b_only;
            }
        }
    }

    // Adds the regions beside each shell without a segment of contact. The whole shell is on one side of the other
    // solid's surface, so one ray decides.
    void find_places(std::size_t solid) {
        const Body& own = bodies_[solid];
        const unsigned own_only = solid == 0 ? in_a_only : in_b_only, other_only = solid == 0 ? in_b_only : in_a_only;
        RayQuery rays(memory_.frame, 1 - solid, bodies_[1 - solid].at.tree, memory_.stack, state_.counts);
        for (std::size_t shell = 0; shell < own.shells.first.size() && regions_ != all_regions; ++shell) {
            if (memory_.met[solid][shell] != 0) continue;
            const bool is_inside = rays.is_inside(solid, own.triangles()[own.shells.first[shell]]);
            regions_ |= is_inside ? in_both | other_only : own_only;
        }
    }

    Relation relation() const noexcept {
        if ((regions_ & in_both) == 0) return touch_ ? Relation::touching : Relation::apart;
        if ((regions_ & in_a_only) == 0) {
            return (regions_ & in_b_only) == 0 ? Relation::equal : Relation::inside;
        }
        return (regions_ & in_b_only) == 0 ? Relation::contains : Relation::overlapping;
    }

    QueryMemoryAccess::State& state_;
    SolidMemory& memory_;
    std::array<Body, 2> bodies_;
    PointSigns signs_;
    unsigned regions_ = 0;
    bool touch_ = false;
};

// Returns true if a shell of `solid`, posed as `a`, is inside b. Call it only if the pose of b is regular and the
// surfaces share no point. The pose of `a` may be singular.
bool has_shell_inside(const Solid& solid, const SurfaceAt& a, const SurfaceAt& b, QueryMemory& memory) {
    SolidMemory& own = SolidMemory::of(memory);
    const std::array<BodyRef, 2> bodies{a.body, b.body};
    own.frame.bind(bodies);
    RayQuery rays(own.frame, 1, b.tree, own.stack, QueryMemoryAccess::state(memory).counts);
    const auto triangles = a.body.mesh->triangles();
    return std::ranges::any_of(SolidAccess::shells(solid).first, [&](std::uint32_t triangle) {
        return rays.place_of({0, triangles[triangle][0]}).is_inside;
    });
}

// Returns the relation of two solids if at least one of the poses is singular. The image of a solid under a singular
// matrix is the image of its surface, so it has no inner point. Proof: on a line that is mapped to one point, an inner
// point is between two points of the surface.
Relation flat_relation(const Posed<Solid>& a, const Posed<Solid>& b, QueryMemory& memory) {
    ++QueryMemoryAccess::state(memory).counts.queries;
    const SurfaceAt surface_a(a), surface_b(b);
    const bool is_touching = surfaces_meet(surface_a, surface_b, memory) ||
                             (is_regular(b.pose.R) && has_shell_inside(*a.what, surface_a, surface_b, memory)) ||
                             (is_regular(a.pose.R) && has_shell_inside(*b.what, surface_b, surface_a, memory));
    return is_touching ? Relation::touching : Relation::apart;
}

}  // namespace

Relation solid_relation(const Posed<Solid>& a, const Posed<Solid>& b, const Ask& ask) {
    Asking asking(ask);
    QueryMemory& memory = asking.memory();
    if (is_regular(a.pose.R) && is_regular(b.pose.R)) return SolidSearch(a, b, memory).find();
    return flat_relation(a, b, memory);
}

}  // namespace ecods
