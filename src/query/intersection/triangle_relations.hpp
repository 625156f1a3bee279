// Decides the relations of pairs of triangles of two posed meshes exactly.
#pragma once

#include <array>
#include <cstdint>

#include "ecods/intersection.hpp"
#include "ecods/mesh.hpp"
#include "ecods/predicates.hpp"
#include "exact/point/frame.hpp"
#include "exact/simplex/triangle_filter.hpp"
#include "query/intersection/plane_signs.hpp"
#include "query/shape/mesh_tree.hpp"

namespace ecods {

// The count of the stage in which integers of this width decide.
inline std::uint64_t& integer_stage(StageCounts& counts, exact::Arithmetic arithmetic) noexcept {
    return arithmetic == exact::Arithmetic::one_limb    ? counts.one_limb
           : arithmetic == exact::Arithmetic::two_limbs ? counts.two_limbs
                                                        : counts.many_limbs;
}

class TriangleRelations {
  public:
    // Cost: constant. Everything that the arguments refer to must outlive this.
    void bind(const exact::BodyRef& a, const exact::BodyRef& b);

    // Offers the shapes of the meshes, after bind(). Once integers have decided some pairs, coplanar triangles are
    // found in the shapes and decided together. Without shapes every pair is decided on its own.
    void offer_groups(const MeshShape& a, const MeshShape& b) noexcept {
        shapes_ = {&a, &b};
        groups_of_ = &MeshShapeAccess::groups;
    }

    // Stops using the groups of the bodies that were bound last.
    void forget_groups() noexcept {
        shapes_ = {};
        planes_.clear();
    }

    // True if the shapes' groups are used; two groups that are apart may then be skipped.
    bool uses_groups() const noexcept { return planes_.are_used(); }
    bool are_parted() const noexcept { return planes_.are_parted(); }  // true if the bodies are known to share no point
    bool are_apart(std::uint32_t group_a, std::uint32_t group_b) { return planes_.are_apart(group_a, group_b); }
    const CoplanarGroups& groups(std::size_t body) const noexcept { return planes_.groups(body); }

    // The exact relation of triangle `a` of the first mesh and `b` of the second.
    Relation relation(std::uint32_t a, std::uint32_t b);

    const StageCounts& counts() const noexcept { return counts_; }
    void reset_counts() noexcept { counts_ = {}; }

  private:
    // The corners of a triangle of each body, the first body's first.
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
    double static_bound_ = 0;         // bounds the error of every orient3d of points of both bodies
    bool doubles_are_exact_ = false;  // if true, decide_in_doubles decides all pairs
    // The axis on which all points of both bodies have one coordinate; -1 if there is none or it is not known yet.
    int flat_axis_ = -1;
    double flat_bound_ = 0;  // bounds the error of every orient2d along flat_axis_
    // The function that finds groups. As a pointer it keeps trees out of programs that decide triangles without shapes.
    const CoplanarGroups& (*groups_of_)(const MeshShape&) = nullptr;
    std::array<const MeshShape*, 2> shapes_{};  // null if none, or once their groups are used or found empty
    std::size_t open_count_ = 0;                // number of pairs left to integers while there were shapes
    PlaneSigns planes_;
    StageCounts counts_;
};

}  // namespace ecods
