#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "bvh/walks/walk_two.hpp"
#include "exact/sign/frame_signs.hpp"
#include "exact/simplex/common_pose.hpp"
#include "exact/simplex/flat_contact.hpp"
#include "query/intersection/asking.hpp"
#include "query/intersection/overlap_bound.hpp"
#include "query/solid/pair_contacts.hpp"
#include "query/solid/pieces.hpp"
#include "query/solid/ray_query.hpp"
#include "query/solid/relations.hpp"
#include "query/solid/solid_memory.hpp"
#include "query/solid/solid_parts.hpp"
#include "query/solid/surfaces_meet.hpp"

namespace ecods {

using namespace exact;

namespace {

// SurfaceSearch finds the sides of a posed solid's boundary on which a surface has points. README.md proves that the
// places examined here suffice.
class SurfaceSearch {
  public:
    // The pose of the solid must be regular, and the axes in the memory must be bound to both trees.
    SurfaceSearch(const SurfaceAt& surface, const Solid& solid, const SurfaceAt& boundary, QueryMemory& memory)
        : surface_(surface),
          boundary_(boundary),
          solid_(solid),
          state_(QueryMemoryAccess::state(memory)),
          memory_(SolidMemory::of(memory)),
          rays_(bind(memory_.frame, surface, boundary), 1, boundary.tree, memory_.stack, state_.counts),
          contacts_(memory_.frame, state_.counts.stages) {}
    SurfaceSearch(const SurfaceSearch&) = delete;
    SurfaceSearch& operator=(const SurfaceSearch&) = delete;

    Relation find() {
        memory_.fans.clear();
        memory_.contacts.assign(surface_.body.mesh->triangles().size(), none);
        walk_two(surface_.tree.boxes, boundary_.tree.boxes, state_.stack,
                 OverlapBound(state_.axes.sets(), state_.counts), [&](std::uint32_t i, std::uint32_t j) {
                     if (boundary_.has(j)) take(i, j);
                     return !is_decided();
                 });
        if (!is_decided()) place_triangles();
        if (is_decided()) return Relation::crossing;
        if (has_inner_) return Relation::inside;
        return touch_ ? Relation::touching : Relation::apart;
    }

  private:
    // A Contact classifies what a triangle of the surface shares with the solid's boundary: nothing; only isolated
    // points; or more, and then the sides beside the shared set have been stored.
    enum Contact : std::uint8_t { none, at_points, looked_at };

    // Returns true at the first call for triangle i and this vertex or edge of the solid, so that each pair is examined
    // once.
    bool is_new(std::uint32_t i, std::uint64_t vertex_or_edge) { return memory_.fans.insert(i, vertex_or_edge); }
    void note(Side side) noexcept {
        has_inner_ |= side == Side::inside;
        has_outer_ |= side == Side::outside;
    }
    bool is_decided() const noexcept { return has_inner_ && has_outer_; }
    void mark(std::uint32_t i, Contact contact) noexcept {
        touch_ = true;
        memory_.contacts[i] = std::max(memory_.contacts[i], static_cast<std::uint8_t>(contact));
    }
    const Triangle& triangle(std::uint32_t i) const { return surface_.body.mesh->triangles()[i]; }
    const Triangle& boundary_triangle(std::uint32_t j) const { return boundary_.body.mesh->triangles()[j]; }

    void take(std::uint32_t i, std::uint32_t j) {
        const TriangleContact found = contacts_.contact(triangle(i), boundary_triangle(j));
        switch (found.kind) {
            case ContactKind::none:
                return;
            case ContactKind::point:
                return mark(i, at_points);
            case ContactKind::segment:
                return take_segment(i, found, j);
            case ContactKind::coplanar:
                return take_coplanar(i, j);
            case ContactKind::flat:
                return take_flat(i, j);
        }
    }

    // Sets the Contact of triangle i, which is coplanar with triangle j, and stores no side. If a region of triangle i
    // ends at coplanar triangles of the solid, the region also ends at triangles of the solid that are not coplanar;
    // the pairs of triangle i with the latter store the side of the region.
    void take_coplanar(std::uint32_t i, std::uint32_t j) {
        enum class Shared { nothing, points, face, no_area };
        const Shared shared = with_signs(memory_.frame, corners_of(triangle(i), boundary_triangle(j)), [](auto& signs) {
            const int axis = signs.normal_axis(3);
            if (signs.normal_axis(0) < 0) return Shared::no_area;
            if (coplanar_pair(signs, axis) == Relation::apart) return Shared::nothing;
            return coplanar_faces_overlap(signs, axis) ? Shared::face : Shared::points;
        });
        if (shared == Shared::no_area) return take_flat(i, j);
        if (shared != Shared::nothing) mark(i, shared == Shared::face ? looked_at : at_points);
    }

    void take_segment(std::uint32_t i, const TriangleContact& found, std::uint32_t j) {
        mark(i, looked_at);
        if (found.second != TriangleContact::face) {
            return look_beside_edge(i, found.first, {j, static_cast<std::uint32_t>(found.second)});
        }
        if (found.first == TriangleContact::face) {
            has_inner_ = has_outer_ = true;
            return;
        }
        // A side of triangle i is in a face of the solid, so the triangle's interior is on the same side of the face as
        // its third corner. The side from which the face's corners turn left is outside, unless the face faces in.
        const auto corner = static_cast<std::size_t>(found.first + 2) % 3;
        const auto vertices = corners_and(1, boundary_triangle(j), VertexRef{0, triangle(i)[corner]});
        const int side = with_signs(memory_.frame, vertices, [](auto& signs) { return signs.orient3d(0, 1, 2, 3); });
        const bool is_mirrored = is_mirror(memory_.frame.body(1).pose->R);
        const bool faces_in = (SolidAccess::shells(solid_).faces_in[j] != 0) != is_mirrored;
        note((side > 0) == faces_in ? Side::inside : Side::outside);
    }

    // Stores the sides of the solid on which triangle i has points beside `edge`, with which triangle i shares a
    // segment. `side` is the triangle's side along the edge; or TriangleContact::face if the edge passes through the
    // triangle's interior, and then the sides of both halves of the triangle are stored.
    void look_beside_edge(std::uint32_t i, int side, const SideRef& edge) {
        const MeshEdges& edges = SolidAccess::parts(solid_).edges;
        if (!is_new(i, 2 * std::uint64_t{edges.edge_of(edge)})) return;
        const auto ends = corners_from(boundary_.body.mesh->triangles(), edge);
        const VertexRef p{1, ends[0]}, q{1, ends[1]};
        const auto corner = [&](std::size_t k) { return VertexRef{0, triangle(i)[k]}; };
        if (side != TriangleContact::face) {
            return note(rays_.side_beside(p, q, corner(static_cast<std::size_t>(side + 2) % 3)));
        }
        const auto sides = with_signs(memory_.frame, corners_and(0, triangle(i), p, q), [](auto& signs) {
            const int axis = signs.normal_axis(0);
            return std::array{signs.orient2d(3, 4, 0, axis), signs.orient2d(3, 4, 1, axis),
                              signs.orient2d(3, 4, 2, axis)};
        });
        for (const int wanted : {1, -1}) {
            const auto at = static_cast<std::size_t>(std::ranges::find(sides, wanted) - sides.begin());
            note(rays_.side_beside(p, q, corner(at)));
        }
    }

    // Processes triangle i if it is a segment or a point. The boundary divides a segment into pieces; a piece begins at
    // the segment's first end, at an edge that the segment crosses, or at a vertex. Stores the side of each piece.
    void take_flat(std::uint32_t i, std::uint32_t j) {
        const FlatContact found = with_signs(memory_.frame, corners_of(triangle(i), boundary_triangle(j)),
                                             [](auto& signs) { return flat_contact(signs); });
        if (!found.meets) return;
        const bool is_first = memory_.contacts[i] != looked_at;
        mark(i, looked_at);
        if (found.from == found.to) return;  // the triangle is a point, on the boundary
        if (found.crosses) {
            has_inner_ = has_outer_ = true;
            return;
        }
        const auto corner = [&](int k) { return VertexRef{0, triangle(i)[static_cast<std::size_t>(k)]}; };
        const VertexRef to = corner(found.to);
        if (is_first) note(rays_.side_beside(corner(found.from), to, to));
        for (std::uint32_t k = 0; k < 3; ++k) {
            const Triangle& corners = boundary_triangle(j);
            const VertexRef p{1, corners[k]}, q{1, corners[(k + 1) % 3]};
            if (found.holds_vertex[k] && is_new(i, 2 * std::uint64_t{p.vertex} + 1)) note(rays_.side_beside(p, to, to));
            if (!found.crosses_edge[k]) continue;
            const std::uint64_t edge = SolidAccess::parts(solid_).edges.edge_of({j, k});
            if (is_new(i, 2 * edge)) note(rays_.side_beside(p, q, to));
        }
    }

    // Stores the sides of triangles that share no segment with the boundary. Triangles that share no point with the
    // boundary, and are connected over corners, form a piece, which is on one side of the boundary: one ray decides the
    // side of each piece.
    void place_triangles() {
        const auto all = surface_.body.mesh->triangles();
        VertexPieces pieces(*surface_.body.mesh, memory_.parents);
        for (std::uint32_t i = 0; i < all.size(); ++i) {
            if (memory_.contacts[i] == none) pieces.join(all[i]);
        }
        memory_.placed.assign(surface_.body.mesh->vertices().size(), 0);
        for (std::uint32_t i = 0; i < all.size() && !is_decided(); ++i) {
            const Triangle& corners = all[i];
            const VertexRef p{0, corners[0]};
            if (memory_.contacts[i] == at_points) {
                note(rays_.side_beside(p, {0, corners[1]}, {0, corners[2]}));
            } else if (memory_.contacts[i] == none) {
                std::uint8_t& is_placed = memory_.placed[pieces.piece_of(corners[0])];
                if (is_placed == 0) note(rays_.side_beside(p, p, p));
                is_placed = 1;
            }
        }
    }

    const SurfaceAt& surface_;
    const SurfaceAt& boundary_;
    const Solid& solid_;
    QueryMemoryAccess::State& state_;
    SolidMemory& memory_;
    RayQuery rays_;
    PairContacts contacts_;
    bool has_inner_ = false, has_outer_ = false, touch_ = false;
};

}  // namespace

Relation surface_relation(const Posed<MeshShape>& surface, const Posed<Solid>& solid, const Ask& ask) {
    Asking asking(ask);
    QueryMemory& memory = asking.memory();
    auto& state = QueryMemoryAccess::state(memory);
    ++state.counts.queries;
    const SurfaceAt of(surface), boundary(solid);
    if (!is_regular(solid.pose.R)) {
        // The posed solid is then the image of its surface, and has no inner point.
        return surfaces_meet(of, boundary, memory) ? Relation::touching : Relation::apart;
    }
    if (are_boxes_apart(of, boundary, state)) return Relation::apart;
    return SurfaceSearch(of, *solid.what, boundary, memory).find();
}

}  // namespace ecods
