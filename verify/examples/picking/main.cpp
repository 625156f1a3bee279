// Picking with the mouse, and a haptic probe: what does a line from the eye meet first, and what does the tip of a
// probe run into as it moves? Nothing slips through an edge or a vertex.
//
// usage: ecods_picking [PICTURE.pov]
#include <fmt/core.h>
#include <fmt/ostream.h>

#include <array>
#include <string>

#include "ecods/hit.hpp"
#include "ecods/world.hpp"
#include "examples/stage.hpp"
#include "scenes/shapes.hpp"

namespace {

using namespace ecods;

std::string text(const Vec3& v) {
    return fmt::format("({:.6f}, {:.6f}, {:.6f})", v.x(), v.y(), v.z());
}

}  // namespace

int main(int argc, char** argv) {
    World world;
    const auto torus = scenes::torus(48, 24, 0.35);
    const auto cube = scenes::cube(0.5);
    const std::array<std::string, 3> names{"torus", "cube", "ball"};
    const std::array<std::shared_ptr<const Mesh>, 3> meshes{torus, cube, scenes::sphere(24, 12)};
    const std::array<Pose, 3> poses{Pose{.t = {0, 0, 0}}, Pose{.t = {2.25, 0, 0}}, Pose{.t = {0, 2.5, 0}}};
    for (std::size_t i = 0; i < names.size(); ++i)
        world.create_body({.mesh = meshes[i], .pose = poses[i], .user_data = i});

    examples::Stage stage({5, -5, 4}, {0.9, 0.8, 0}, 42);
    for (std::size_t i = 0; i < names.size(); ++i)
        stage.add(*meshes[i], poses[i], i == 0 ? examples::blue : i == 1 ? examples::amber : examples::gray);

    fmt::print("Picking\n");
    const Vec3 eye(1, -3, 3);
    for (const Vec3& target : {Vec3(2.25, 0, 0.5), Vec3(0, 2.5, 0.75), Vec3(0, 0, 0), Vec3(0, -1, 0)}) {
        const auto picked = world.first_hit(Ray{.origin = eye, .direction = target - eye});
        if (!picked) {
            fmt::print("  towards {}: nothing\n", text(target));
            stage.add_segment(eye, target, 0.008, examples::gray);
            continue;
        }
        fmt::print("  towards {}: the {}, triangle {} ({}) at {}\n", text(target), names[world.user_data(picked->body)],
                   picked->hit.triangle(), fmt::streamed(picked->hit.kind), text(picked->hit.point));
        stage.add_segment(eye, picked->hit.point, 0.008, examples::black);
        stage.add_ball(picked->hit.point, 0.045, examples::red);
    }

    // The tip goes in small steps; the segment from its last place to its new one is asked about, so however fast it
    // is, it does not get through. The witness makes the next step cheap, and is never believed.
    fmt::print("A probe\n");
    const MeshShape surface(torus);
    const Posed<MeshShape> body(surface, poses[0]);
    PairWitness witness;
    Vec3 tip(0.25, -2, 0.125);
    const Vec3 step(0.015625, 0.03125, -0.00390625);  // a time step of a millisecond
    for (int i = 1; i <= 100; ++i) {
        const Vec3 next = tip + step;
        if (const auto hit = first_hit(Segment{tip, next}, body, witness)) {
            const Triangle& corners = torus->triangles()[hit->triangle()];
            const auto corner = [&](std::size_t k) { return torus->vertices()[corners[k]]; };
            const Vec3 normal = (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
            fmt::print("  step {} meets triangle {} from its {} at {:.6f} of the step, at {}\n", i, hit->triangle(),
                       fmt::streamed(hit->kind), hit->parameter, text(hit->point));
            const Vec3 force = -400 * normal.dot(next - hit->point) * normal;  // newtons, of a spring of 400 N/m
            fmt::print("  force on the hand {}\n", text(force));
            stage.add_segment(hit->point, hit->point + 0.8 * normal, 0.02, examples::red);
            stage.add_ball(hit->point, 0.045, examples::red);
            break;
        }
        stage.add_ball(next, 0.02, examples::black);
        tip = next;
    }
    if (argc > 1) stage.write(argv[1]);
}
