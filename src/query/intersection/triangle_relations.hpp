// Two posed meshes, ready for exact questions about pairs of their triangles.
#pragma once

#include <array>
#include <cstdint>

#include "ecods/intersection.hpp"
#include "ecods/mesh.hpp"
#include "ecods/predicates.hpp"
#include "exact/point/frame.hpp"
#include "exact/simplex/triangle_filter.hpp"

namespace ecods {

class TriangleRelations {
  public:
    // Cost: constant. Everything that the arguments refer to must outlive the questions.
    void bind(const exact::BodyRef& a, const exact::BodyRef& b);

    // The exact relation of triangle `a` of the first mesh and `b` of the second.
    Relation relation(std::uint32_t a, std::uint32_t b);

    const StageCounts& counts() const noexcept { return counts_; }
    void reset_counts() noexcept { counts_ = {}; }

  private:
    // The corners of a triangle of each body, those of the first body first.
    using Corners = std::array<exact::VertexRef, 6>;

    exact::Points<6> rounded(const Triangle& a, const Triangle& b);
    Relation decide_in_doubles(const exact::Points<6>& points);
    Relation decide_open(const Triangle& a, const Triangle& b, const exact::Points<6>& points,
                         const exact::FilterTrace& trace);
    Relation decide_by_integers(const Corners& corners, const exact::Points<6>& points,
                                const exact::DeterminantBounds& bounds, const exact::FilterTrace& trace);

    exact::Frame frame_;
    std::array<const Triangle*, 2> triangles_{};
    double static_bound_ = 0;         // for every orient3d of points of the two bodies
    bool doubles_are_exact_ = false;  // whether decide_in_doubles answers everything
    StageCounts counts_;
};

}  // namespace ecods
