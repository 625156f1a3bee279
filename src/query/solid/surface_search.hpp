// On which sides of a posed solid a surface has points (README.md: why what is looked at suffices).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "ecods/solid.hpp"
#include "query/solid/mesh_edges.hpp"
#include "query/solid/pair_contacts.hpp"
#include "query/solid/ray_query.hpp"
#include "query/solid/solid_memory.hpp"
#include "query/solid/surfaces_meet.hpp"

namespace ecods {

class SurfaceSearch {
  public:
    // The pose of the solid must be regular, and the axes of the memory bound to both trees.
    SurfaceSearch(const SurfaceAt& surface, const Solid& solid, const SurfaceAt& boundary, QueryMemory& memory);
    SurfaceSearch(const SurfaceSearch&) = delete;
    SurfaceSearch& operator=(const SurfaceSearch&) = delete;

    SurfaceRelation find();

  private:
    // What a triangle of the surface has in common with the solid's: nothing; some points; or more, and then what lies
    // beside that has been looked at.
    enum Contact : std::uint8_t { none, at_points, looked_at };

    void take(std::uint32_t i, std::uint32_t j);
    void take_coplanar(std::uint32_t i, std::uint32_t j);
    void take_flat(std::uint32_t i, std::uint32_t j);
    void take_segment(std::uint32_t i, const exact::TriangleContact& found, std::uint32_t j);
    void look_beside_edge(std::uint32_t i, int side, const SideRef& edge);
    void place_triangles();
    void join_triangles();
    std::uint32_t piece_of(std::uint32_t vertex);

    // The vertex, edge or face of the solid, which is looked at once for each triangle.
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

    const SurfaceAt& surface_;
    const SurfaceAt& boundary_;
    const Solid& solid_;
    QueryMemoryAccess::State& state_;
    SolidMemory& memory_;
    RayQuery rays_;
    PairContacts contacts_;
    bool has_inner_ = false, has_outer_ = false, touch_ = false;
};

}  // namespace ecods
