#include "scenes/room.hpp"

#include <cmath>
#include <string>

#include "scenes/mesh_builder.hpp"
#include "scenes/quaternion.hpp"
#include "scenes/random.hpp"
#include "scenes/ship.hpp"

namespace ecods::scenes {

namespace {

struct Flight {
    Vec3 position;
    Vec3 velocity;
    Eigen::Quaterniond attitude;
    Eigen::Quaterniond turn;  // of one frame
};

Pose pose_of(const Flight& flight) {
    return {flight.attitude.toRotationMatrix(), flight.position};
}

Flight take_off(Random& random, const RoomOptions& options) {
    Flight flight;
    for (int axis = 0; axis < 3; ++axis) {
        flight.position[axis] = random.uniform(-options.side / 2, options.side / 2);
        flight.velocity[axis] = random.uniform(-options.speed_max, options.speed_max);
    }
    flight.attitude = random.rotation();
    // The tangent of half the angle along the axis of the turn, and 1: a turn without any sine, once it is made a unit.
    // Two statements, because compilers differ in which factor of a product they draw first.
    const Vec3 axis = random.direction();
    const Vec3 spin = axis * (random.uniform(0, options.spin_max) / 2);
    flight.turn = unit(1, spin.x(), spin.y(), spin.z());
    return flight;
}

void fly(Flight& flight, double wall) {
    flight.position += flight.velocity;
    for (int axis = 0; axis < 3; ++axis) {
        double& x = flight.position[axis];
        if (std::abs(x) <= wall) continue;
        x = std::copysign(wall, x) * 2 - x;
        flight.velocity[axis] = -flight.velocity[axis];
    }
    flight.attitude = compose(flight.turn, flight.attitude);
}

}  // namespace

double calibrated_side() {
    return 15;
}

double calibrated_side_by_density(std::size_t ships) {
    return on_grid(calibrated_side() * std::cbrt(static_cast<double>(ships) / 32));
}

Scene room(const RoomOptions& options) {
    Random random(options.seed);
    Scene scene;
    scene.meshes.push_back({"ship", ship()});

    std::vector<Flight> flights;
    for (std::size_t i = 0; i < options.ship_count; ++i) {
        flights.push_back(take_off(random, options));
        scene.bodies.push_back({"ship " + std::to_string(i), 0, pose_of(flights[i])});
    }

    const auto moving =
        static_cast<std::size_t>(std::round(options.moving_share * static_cast<double>(options.ship_count)));
    for (std::size_t f = 0; f < options.frame_count; ++f) {
        Frame& frame = scene.frames.emplace_back();
        for (std::size_t i = 0; i < moving; ++i) {
            fly(flights[i], options.side / 2);
            frame.moves.push_back({i, pose_of(flights[i])});
        }
    }
    return scene;
}

}  // namespace ecods::scenes
