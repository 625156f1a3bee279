// A ball that flies through a thin wall between two frames: looking at the frames shows nothing, asking about the way
// does, with the time of contact.
//
// usage: ecods_no_tunnelling [PICTURE.pov]
#include <fmt/core.h>
#include <fmt/ostream.h>

#include <array>

#include "ecods/world.hpp"
#include "examples/stage.hpp"
#include "scenes/shapes.hpp"

int main(int argc, char** argv) {
    using namespace ecods;
    const auto ball_mesh = scenes::sphere(32, 16);  // of radius 1
    const auto wall_mesh = scenes::cube(1);
    const Pose wall_pose{.R = Vec3(0.03125, 3, 2).asDiagonal(), .t = {0, 0, 2}};  // a pose may scale: 0.0625 thick

    World world;
    const BodyId wall = world.create_body(wall_mesh, wall_pose);
    const Vec3 start(-6, -1.5, 1.5), velocity(10, 3, 0.5);  // a frame is a time step
    const BodyId ball = world.create_body(ball_mesh, {.R = 0.5 * Mat3::Identity(), .t = start});

    fmt::print("Looking at frames alone\n");
    for (int frame = 0; frame <= 1; ++frame) {
        world.set_pose(ball, {.R = 0.5 * Mat3::Identity(), .t = start + frame * velocity});
        world.update();
        fmt::print("  frame {}: {} pairs touch\n", frame, world.colliding_pairs().size());
    }

    fmt::print("Asking about the way\n");
    world.set_pose(ball, {.R = 0.5 * Mat3::Identity(), .t = start});
    const auto first = world.cast(ball, velocity);
    if (first) {
        fmt::print("  the ball meets body {} at time {}, {}\n", fmt::streamed(first->body), first->contact.time,
                   fmt::streamed(first->contact.kind));
    }

    // Everything at once, turning as well: each point goes straight from its old place to its new one, so that a body
    // that turns is not rigid between them.
    fmt::print("Both move\n");
    const Mat3 quarter_turn = (Mat3() << 0, -1, 0, 1, 0, 0, 0, 0, 1).finished();
    const std::array bodies{wall, ball};
    const std::array poses{Pose{.R = wall_pose.R, .t = {-5, 0, 2}},
                           Pose{.R = 0.5 * quarter_turn, .t = start + velocity}};
    for (const Meeting& meeting : world.meetings(bodies, poses))
        fmt::print("  {} meet at time {}\n", fmt::streamed(meeting.bodies), meeting.contact.time);

    if (argc > 1 && first) {
        examples::Stage stage({-6, -12, 7}, {-0.9, -0.1, 1.7}, 44);
        stage.add(*wall_mesh, wall_pose, examples::glassy(examples::gray, 0.35));
        const auto ball_at = [&](double time, const examples::Paint& paint) {
            stage.add(*ball_mesh, {.R = 0.5 * Mat3::Identity(), .t = start + time * velocity}, paint);
        };
        ball_at(0, examples::blue);
        ball_at(1, examples::glassy(examples::blue, 0.4));
        ball_at(first->contact.time, examples::red);
        stage.add_segment(start, start + velocity, 0.02, examples::black);
        stage.write(argv[1]);
    }
}
