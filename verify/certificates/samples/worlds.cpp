#include <memory>
#include <vector>

#include "certificates/samples/samples.hpp"
#include "ecods/world.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"

namespace ecods::certificates {
namespace {

Vec3 anywhere(scenes::Random& random, double size) {
    return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

// Boxes on a grid, which touch, and bodies in random poses; some filtered out or switched off, some gone again.
void fill(World& world, std::size_t count, scenes::Random& random) {
    const std::vector<std::shared_ptr<const Mesh>> meshes = {scenes::cube(0.5), scenes::sphere(6, 4),
                                                             scenes::torus(8, 6, 0.4)};
    std::vector<BodyId> ids;
    for (std::size_t k = 0; k < count; ++k) {
        const bool is_brick = random.below(2) == 0;
        Pose pose;
        if (is_brick) {
            for (int axis = 0; axis < 3; ++axis) pose.t[axis] = random.below(4);
        } else {
            pose = Pose::from_quaternion(random.rotation(), anywhere(random, 2));
        }
        ids.push_back(world.create_body({.mesh = is_brick ? meshes[0] : meshes[random.below(3)], .pose = pose}));
        if (random.below(4) == 0) world.set_filter(ids.back(), {.groups = 2, .mask = 1});
    }
    for (std::size_t k = 0; k < count / 4; ++k) {
        const BodyId a = ids[random.below(static_cast<std::uint32_t>(count))],
                     b = ids[random.below(static_cast<std::uint32_t>(count))];
        if (a != b) world.set_pair_enabled(a, b, false);
    }
    world.destroy_body(ids.front());
}

}  // namespace

void make_worlds(std::size_t count, std::uint32_t seed, const std::function<void(const WorldCertificate&)>& take) {
    scenes::Random random(seed);
    QueryMemory memory;
    for (const BroadPhaseKind kind : {BroadPhaseKind::brute_force, BroadPhaseKind::sweep_and_prune,
                                      BroadPhaseKind::kept_candidates, BroadPhaseKind::automatic}) {
        for (std::size_t k = 0; k < count; ++k) {
            World world({.broad_phase = kind});
            fill(world, 12, random);
            world.update();
            take(world.certify(memory));
            for (const double clearance : {0.0, 0.125, 1.0}) {
                world.set_clearance(clearance);
                world.update();
                take(world.certify(memory));
            }
        }
    }
}

}  // namespace ecods::certificates
