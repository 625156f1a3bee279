// Convex polytopes that fly in a box, as in the experiment of Cohen, Lin, Manocha and Ponamgi (I-COLLIDE: An
// interactive and exact collision detection system for large-scale environments, 1995): they turn as they go and bounce
// off the walls.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"

namespace ecods::scenes {

struct MovingPolytopesOptions {
    std::size_t count = 1000;
    int corner_count = 27;  // of each; all but a few have 2 n - 4 faces: 50
    double density = 0.05;  // the volume of their balls, of radius 1, divided by the box's
    double step = 0.05;     // how far they go a frame, at most, in units of their radius
    double turn = 0.1;      // the tangent of half the angle by which they turn a frame, at most
    std::uint32_t seed = 1;
};

// The same bits on every machine.
class MovingPolytopes {
  public:
    explicit MovingPolytopes(const MovingPolytopesOptions& options);

    const std::vector<std::shared_ptr<const Mesh>>& meshes() const { return meshes_; }
    const std::vector<Pose>& poses() const { return poses_; }

    // One frame: all move.
    void step();

  private:
    struct Motion {
        Eigen::Quaterniond at, turn;
        Vec3 velocity;
    };

    double half_ = 1;  // of the box, in which the centers stay
    std::vector<std::shared_ptr<const Mesh>> meshes_;
    std::vector<Pose> poses_;
    std::vector<Motion> motions_;
};

}  // namespace ecods::scenes
