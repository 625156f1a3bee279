// TriangleRelations decides the relations of pairs of triangles of two posed meshes exactly.
#pragma once

#include <array>
#include <cstdint>

#include "ecods/intersection.hpp"
#include "ecods/mesh.hpp"
#include "ecods/primitives.hpp"
#include "exact/point/frame.hpp"
#include "exact/simplex/triangle_filter.hpp"
#include "query/intersection/plane_signs.hpp"
#include "query/shape/mesh_tree.hpp"

namespace ecods {

// Returns a reference to the count of the stage that decides in integers of this width.
inline std::uint64_t& integer_stage(StageCounts& counts, exact::Arithmetic arithmetic) noexcept {
    return arithmetic == exact::Arithmetic::one_limb    ? counts.one_limb
           : arithmetic == exact::Arithmetic::two_limbs ? counts.two_limbs
                                                        : counts.many_limbs;
}

class TriangleRelations {
  public:
    // Binds the two meshes. Cost: constant. Everything that the arguments refer to must outlive this object.
    void bind(const exact::BodyRef& a, const exact::BodyRef& b);

    // Allows groups of coplanar triangles to be used. Call this function after bind(), with the shapes of the same
    // meshes. Groups are found in the shapes once integers have decided some pairs. Without the call, every pair is
    // decided on its own.
    void offer_groups(const MeshShape& a, const MeshShape& b) noexcept {
        shapes_ = {&a, &b};
        groups_of_ = &MeshShapeAccess::groups;
    }

    // Stops using the groups of the bodies that were bound last.
    void forget_groups() noexcept {
        shapes_ = {};
        planes_.clear();
    }

    // Returns true if groups are in use. A walk may then skip two groups for which are_apart() is true.
    bool uses_groups() const noexcept { return planes_.are_used(); }
    bool are_parted() const noexcept {
        return planes_.are_parted();
    }  // true if the bodies are proven to share no point
    bool are_apart(std::uint32_t group_a, std::uint32_t group_b) { return planes_.are_apart(group_a, group_b); }
    const CoplanarGroups& groups(std::size_t body) const noexcept { return planes_.groups(body); }

    // Returns the exact relation of triangle `a` of the first mesh and triangle `b` of the second.
    Relation relation(std::uint32_t a, std::uint32_t b);

    const StageCounts& counts() const noexcept { return counts_; }
    void reset_counts() noexcept { counts_ = {}; }

  private:
    // Corners holds the corners of a triangle of the first body, then the corners of a triangle of the second.
    using Corners = std::array<exact::VertexRef, 6>;

    exact::Points<6> rounded(const Triangle& a, const Triangle& b);
    Relation decide_in_doubles(const exact::Points<6>& points);
    Relation decide_open(std::uint32_t a, std::uint32_t b, const exact::Points<6>& points,
                         const exact::FilterTrace& trace);
    void find_flat_axis();
    Relation decide_flat(std::uint32_t a, std::uint32_t b, const exact::Points<6>& points);
    bool may_use_groups();
    Relation decide_by_planes(std::uint32_t a, std::uint32_t b, const Corners& corners, const exact::Points<6>& points,
                              const exact::DeterminantBounds& bounds, const exact::FilterTrace& trace);
    Relation decide_by_integers(const Corners& corners, const exact::Points<6>& points,
                                const exact::DeterminantBounds& bounds, const exact::FilterTrace& trace);

    exact::Frame frame_;
    std::array<const Triangle*, 2> triangles_{};
    double static_bound_ = 0;         // error bound of every orient3d of points of both bodies
    bool doubles_are_exact_ = false;  // if true, decide_in_doubles() decides all pairs
    // flat_axis_ is the axis on which all points of both bodies have the same coordinate; -1 if there is none or it is
    // not known yet.
    int flat_axis_ = -1;
    double flat_bound_ = 0;  // error bound of every orient2d along flat_axis_
    // Points to the function that finds the groups of a shape, so that programs without shapes are not linked with
    // trees.
    const CoplanarGroups& (*groups_of_)(const MeshShape&) = nullptr;
    std::array<const MeshShape*, 2> shapes_{};  // null without shapes, and once groups are in use or found to be empty
    std::size_t open_count_ = 0;                // pairs left to integers while shapes_ are set
    PlaneSigns planes_;
    StageCounts counts_;
};

}  // namespace ecods
