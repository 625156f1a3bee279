#include "scenes/approach.hpp"

#include <algorithm>

#include "ecods/distance.hpp"

namespace ecods::scenes {

Approach::Approach(const std::shared_ptr<const Mesh>& resting_mesh, const std::shared_ptr<const Mesh>& moving_mesh)
    : resting_shape_(resting_mesh),
      moving_shape_(moving_mesh),
      moving_index_(resting_mesh == moving_mesh ? 0 : 1),
      resting_ball_(ball_of(*resting_mesh)),
      moving_ball_(ball_of(*moving_mesh)) {}

double Approach::diameter() const {
    return 2 * std::max(resting_ball_.radius, moving_ball_.radius);
}

MeshQuery Approach::at(double distance) const {
    return {{0, place(resting_ball_, resting, Vec3::Zero())},
            {moving_index_, place(moving_ball_, moving, line * distance)}};
}

std::optional<double> Approach::stop_at(double gap) {
    const double radius = diameter() / 2, step = radius / 16;
    const int steps_max = 34 + static_cast<int>(gap / step);
    int steps = steps_max;
    while (steps >= 0 && !is_within(steps * step, gap)) --steps;
    if (steps < 0 || steps == steps_max) return std::nullopt;
    double near = steps * step, far = near + step;
    while (far - near > 0x1p-10 * gap) {
        const double middle = near + (far - near) / 2;
        if (middle == near || middle == far) break;
        (is_within(middle, gap) ? near : far) = middle;
    }
    return far;
}

bool Approach::is_within(double distance, double gap) {
    const MeshQuery query = at(distance);
    return within({resting_shape_, query.a.pose}, {moving_shape_, query.b.pose}, gap, memory_);
}

}  // namespace ecods::scenes
