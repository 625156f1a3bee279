// Finds balls outside a solid. Vertices in such a ball need no ray.
#pragma once

#include <cstddef>

#include "ecods/pose.hpp"
#include "ecods/shape.hpp"
#include "exact/point/point.hpp"

namespace ecods {

// A RoundedVertex is a point R v + t in doubles, and an upper bound of the error of each coordinate.
struct RoundedVertex {
    RoundedVertex(const Pose& pose, const Vec3& v) noexcept
        : point(exact::pose_point(pose.R, v, pose.t)), error(exact::point_error_bound(pose.R, v.cwiseAbs(), pose.t)) {}

    exact::Point point;
    double error;
};

// An OutsideBall is a ball around a vertex that is outside a solid. It shares no point with the solid's boundary, so
// all of it is outside. In a cloud of many pieces, most vertices are in the ball around an earlier one.
class OutsideBall {
  public:
    // Makes a ball that contains no vertex yet. `boundary` must outlive this object.
    OutsideBall(const Posed<MeshShape>& boundary, QueryMemory& memory) : boundary_(boundary), memory_(memory) {}

    // Returns true if the vertex is certainly in the ball.
    bool contains(const RoundedVertex& vertex) noexcept;

    // Sets the ball to one around the vertex, which must be outside the solid. Does nothing if the number of balls so
    // far exceeds the number of vertices found in them by more than `spare_count`, because a ball takes longer than a
    // ray.
    void find_around(const RoundedVertex& vertex);

  private:
    static constexpr std::size_t spare_count = 8;

    const Posed<MeshShape>& boundary_;
    QueryMemory& memory_;
    exact::Point center_{};
    double radius_ = 0;
    std::size_t ball_count_ = 0, held_count_ = 0;
};

}  // namespace ecods
