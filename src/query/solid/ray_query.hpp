// Where a point is with respect to a posed solid, by a ray from it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "bvh/masks/ray_mask.hpp"
#include "ecods/closest_points.hpp"
#include "ecods/intersection.hpp"
#include "ecods/solid.hpp"
#include "exact/point/frame.hpp"
#include "exact/sign/filter_bound.hpp"
#include "exact/simplex/ray_triangle.hpp"
#include "query/shape/mesh_tree.hpp"

namespace ecods {

inline constexpr std::uint32_t no_triangle = ~std::uint32_t{0};

// The corners of a triangle of a body, and then other vertices.
template <class... Others>
constexpr std::array<exact::VertexRef, 3 + sizeof...(Others)> corners_and(std::size_t body, const Triangle& triangle,
                                                                          const Others&... others) noexcept {
    return {exact::VertexRef{body, triangle[0]}, {body, triangle[1]}, {body, triangle[2]}, others...};
}

// Rays against one body of a frame, at a regular pose.
class RayQuery {
  public:
    // `frame` is bound, and `tree` is that of the body's mesh. All arguments must outlive the questions.
    RayQuery(exact::Frame& frame, std::size_t body, const MeshTree& tree, std::vector<TreeRef>& stack,
             QueryCounts& counts);

    // The side of the surface that a point infinitely near to corner 0 of a triangle of body `of`, and inside that
    // triangle, is on. The triangle has an area, and shares no segment with a triangle of the body at the point.
    bool is_inside(std::size_t of, const Triangle& triangle);

    // The same for triangle `index` of the body itself, which does not count: whether the region beside it, to where
    // its corners turn left, is inside.
    bool is_inside_above(std::uint32_t index);

    struct Place {
        bool is_inside;             // if it is not on the surface
        std::optional<Feature> on;  // the first feature that holds it
    };
    Place place_of(exact::VertexRef point);

    // Where a point is that is infinitely near to p: p + d (q - p) + d^2 (r - p) for an infinitesimal d > 0. The points
    // may be equal. If the answer is that it is on the surface, no feature is named.
    Side side_beside(exact::VertexRef p, exact::VertexRef q, exact::VertexRef r);

    // As place_of, under any pose, where nothing is inside: zero-area triangles of the mesh are left out, but not those
    // that the pose makes flat.
    Place flat_place_of(exact::VertexRef point);

  private:
    // Whether the filter is sure that a ray crosses a triangle.
    enum class Answer : std::uint8_t { misses, crosses, open };

    RayOrigin origin_of(exact::VertexRef point) const;
    std::uint32_t axes_across(std::size_t of, const Triangle& triangle);
    // Calls take(triangle) for each triangle of the body that the ray may meet, until it returns false.
    template <class Take>
    void walk(const TreeRay& ray, Take&& take);
    bool crosses_odd(const TreeRay& ray, std::size_t of, const Triangle& triangle, std::uint32_t left_out);
    Answer filter(std::uint32_t triangle, exact::VertexRef from, exact::RayDirection ray);
    bool doubles_are_exact() const noexcept { return frame_.arithmetic() >= exact::Arithmetic::differences; }
    const Triangle& triangle_at(std::size_t of, std::uint32_t index) const {
        return frame_.body(of).mesh->triangles()[index];
    }

    exact::Frame& frame_;
    std::size_t body_;
    const MeshTree& tree_;
    std::vector<TreeRef>& stack_;
    QueryCounts& counts_;
    exact::DeterminantBounds bounds_;
};

}  // namespace ecods
