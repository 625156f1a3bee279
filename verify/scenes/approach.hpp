// A copy of a mesh that comes along a line towards another mesh that rests, up to where their distance is a gap.
#pragma once

#include <memory>
#include <optional>

#include "ecods/intersection.hpp"
#include "ecods/shape.hpp"
#include "scenes/mesh_ball.hpp"
#include "scenes/mesh_pairs.hpp"

namespace ecods::scenes {

// Whether poses are that near is asked of the library; who uses the queries has its distances checked.
class Approach {
  public:
    Approach(const std::shared_ptr<const Mesh>& resting_mesh, const std::shared_ptr<const Mesh>& moving_mesh);

    Mat3 resting = Mat3::Identity(), moving = Mat3::Identity();
    Vec3 line = Vec3::UnitX();

    // Of the larger of the two balls.
    double diameter() const;

    // The middle of the ball of mesh 0, at rest, and that of mesh 1, or of mesh 0 where there is but one, so far apart
    // along the line.
    MeshQuery at(double distance) const;

    // How far apart they are where they are a little farther than the gap, to one part in 1000 of it; nothing if steps
    // of a sixteenth of a radius pass the other by.
    std::optional<double> stop_at(double gap);

  private:
    bool is_within(double distance, double gap);

    MeshShape resting_shape_, moving_shape_;
    std::size_t moving_index_;
    QueryMemory memory_;
    Ball resting_ball_, moving_ball_;
};

}  // namespace ecods::scenes
