// RayQuery finds the side of a posed solid's surface on which a point is, by a ray from the point.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "bvh/masks/ray_mask.hpp"
#include "ecods/intersection.hpp"
#include "ecods/results.hpp"
#include "ecods/solid.hpp"
#include "exact/point/frame.hpp"
#include "exact/sign/filter_bound.hpp"
#include "exact/simplex/ray_triangle.hpp"
#include "query/shape/mesh_tree.hpp"

namespace ecods {

inline constexpr std::uint32_t no_triangle = ~std::uint32_t{0};

// Returns the corners of a triangle of a body, followed by other vertices.
template <class... Others>
constexpr std::array<exact::VertexRef, 3 + sizeof...(Others)> corners_and(std::size_t body, const Triangle& triangle,
                                                                          const Others&... others) noexcept {
    return {exact::VertexRef{body, triangle[0]}, {body, triangle[1]}, {body, triangle[2]}, others...};
}

// RayQuery casts rays against one body of a frame. The body's pose must be regular, except for flat_place_of().
class RayQuery {
  public:
    // Prepares rays against body number `body` of `frame`, which must be bound. `tree` must be the tree of the body's
    // mesh. All arguments must outlive this object.
    RayQuery(exact::Frame& frame, std::size_t body, const MeshTree& tree, std::vector<TreeRef>& stack,
             QueryCounts& counts);

    // Returns true if the points in the interior of `triangle`, of body `of`, that are infinitely near to its corner 0
    // are inside the solid. The triangle must have an area. At that corner it must share no segment with a triangle of
    // the solid.
    bool is_inside(std::size_t of, const Triangle& triangle);

    // Returns true if the region beside triangle `index` of this body is inside, on the side from which the triangle's
    // corners turn left. The ray ignores the triangle itself.
    bool is_inside_above(std::uint32_t index);

    struct Place {
        bool is_inside;             // meaningful only if `on` is empty
        std::optional<Feature> on;  // the first feature of the surface that contains the point
    };
    Place place_of(exact::VertexRef point);

    // Returns the side of the surface on which the point p + d (q - p) + d^2 (r - p) is, for an infinitesimal d > 0.
    // The points p, q and r may be equal. The result Side::on names no feature.
    Side side_beside(exact::VertexRef p, exact::VertexRef q, exact::VertexRef r);

    // Returns the place of a point relative to a body without inner points, under any pose, also a singular one. Only
    // triangles with an entry in `has_area` count; all count if `has_area` is empty.
    Place flat_place_of(exact::VertexRef point, std::span<const std::uint8_t> has_area);

  private:
    // An Answer is what the filter proves about a ray and a triangle; `open` if the filter proves nothing.
    enum class Answer : std::uint8_t { misses, crosses, open };

    RayOrigin origin_of(exact::VertexRef point) const;
    std::uint32_t axes_across(std::size_t of, const Triangle& triangle);
    // Calls take(triangle) for each triangle of the body that the ray may meet, until take() returns false.
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
