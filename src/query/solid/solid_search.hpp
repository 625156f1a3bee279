// Which open regions two posed solids make, and whether they touch (README.md: why that is all there is to know).
#pragma once

#include <array>
#include <cstdint>

#include "ecods/solid.hpp"
#include "exact/simplex/triangle_contact.hpp"
#include "query/solid/fan.hpp"
#include "query/solid/pair_contacts.hpp"
#include "query/solid/ray_query.hpp"
#include "query/solid/solid_memory.hpp"
#include "query/solid/solid_parts.hpp"

namespace ecods {

// The pose of each must be regular.
class SolidSearch {
  public:
    SolidSearch(const Posed<Solid>& a, const Posed<Solid>& b, QueryMemory& memory);
    SolidSearch(const SolidSearch&) = delete;
    SolidSearch& operator=(const SolidSearch&) = delete;

    SolidRelation find();

  private:
    // Kinds of open regions, as bits.
    enum : unsigned { in_both = 1, in_a_only = 2, in_b_only = 4, all_regions = 7 };

    struct Body {
        const SolidAccess::Parts& parts;
        const MeshTree& tree;
        const Shells& shells;
        bool is_mirrored;

        std::span<const Triangle> triangles() const { return parts.proper.mesh->triangles(); }
    };
    // A triangle of a solid, and what of it a segment lies on: a side, or TriangleContact::face.
    struct Part {
        std::size_t solid;
        std::uint32_t triangle;
        int side;

        SideRef side_ref() const noexcept { return {triangle, static_cast<std::uint32_t>(side)}; }
        bool is_face() const noexcept { return side == exact::TriangleContact::face; }
    };
    struct Line {
        exact::VertexRef p, q;
    };

    void walk();
    void take(std::uint32_t i, std::uint32_t j, PairContacts& contacts);
    void turn_around(const Part& a, const Part& b);
    std::uint64_t name_of(const Part& part) const;
    void add_wings(const Part& part, const Line& line);
    void add_edge_wings(const Part& part, const Line& line);
    void add_face_wings(const Part& part, const Line& line);
    bool faces_in(std::size_t solid, std::uint32_t triangle) const {
        return (bodies_[solid].shells.faces_in[triangle] != 0) != bodies_[solid].is_mirrored;
    }
    void read_sectors();
    void find_places(std::size_t solid);
    SolidRelation relation() const noexcept;

    const Posed<Solid>& a_;
    const Posed<Solid>& b_;
    QueryMemoryAccess::State& state_;
    SolidMemory& memory_;
    std::array<Body, 2> bodies_;
    PointSigns signs_;
    unsigned regions_ = 0;
    bool touch_ = false;
};

}  // namespace ecods
