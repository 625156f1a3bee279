#include "scenes/moving_polytopes.hpp"

#include <cmath>

#include "scenes/hard_pair_parts.hpp"
#include "scenes/lattice_hull.hpp"
#include "scenes/quaternion.hpp"

namespace ecods::scenes {

MovingPolytopes::MovingPolytopes(const MovingPolytopesOptions& options) {
    Random random(options.seed);
    // Balls of volume 4.19 each; the box has the volume of as many of them as are asked for, divided by the density.
    const double count = static_cast<double>(options.count);
    half_ = 0.5 * std::round(16 * std::cbrt(4.19 * count / options.density)) / 16;
    for (std::size_t i = 0; i < options.count; ++i) {
        const auto radius = [&] { return hard::full(random, 0.5, 1); };
        const Vec3 radii(radius(), radius(), radius());
        meshes_.push_back(to_mesh(ellipsoid_hull(options.corner_count, radii, random), ellipsoid_unit));
        const Vec3 axis = random.uniform(0, options.turn) * random.direction();
        const Eigen::Quaterniond at = random.rotation();
        const Vec3 velocity = random.uniform(0, options.step) * random.direction();
        motions_.push_back({at, unit(1, axis[0], axis[1], axis[2]), velocity});
        const Vec3 place(hard::full(random, -half_, half_), hard::full(random, -half_, half_),
                         hard::full(random, -half_, half_));
        poses_.push_back(Pose::from_quaternion(at, place));
    }
}

void MovingPolytopes::step() {
    for (std::size_t i = 0; i < poses_.size(); ++i) {
        Motion& motion = motions_[i];
        Vec3 place = poses_[i].t + motion.velocity;
        for (int k = 0; k < 3; ++k) {
            if (std::abs(place[k]) <= half_) continue;
            motion.velocity[k] = -motion.velocity[k];
            place[k] = poses_[i].t[k];
        }
        motion.at = compose(motion.turn, motion.at);
        poses_[i] = Pose::from_quaternion(motion.at, place);
    }
}

}  // namespace ecods::scenes
