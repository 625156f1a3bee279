#include "fuzz/bad_input.hpp"

#include <array>
#include <limits>
#include <string>

#include "fuzz/failure.hpp"

namespace ecods::fuzz {
namespace {

template <class Expected, class Call>
void expect_error(const char* name, World& world, Counters& counters, Call call) {
    const std::uint64_t digest = world.digest();
    const std::size_t body_count = world.statistics().body_count;
    try {
        call();
        throw CheckFailed("bad input", std::string(name) + " was accepted");
    } catch (const Expected&) {
        ++counters[name];
    } catch (const Error& error) {
        throw CheckFailed("bad input", std::string(name) + " gave another error: " + error.what());
    }
    require(world.digest() == digest && world.statistics().body_count == body_count, "bad input",
            std::string(name) + " changed the world");
}

Pose broken(Pose pose, scenes::Random& random) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const std::array<double, 3> values = {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity};
    const double value = values[random.below(3)];
    const std::uint32_t entry = random.below(12);
    (entry < 9 ? pose.R(entry / 3, entry % 3) : pose.t[entry - 9]) = value;
    return pose;
}

}  // namespace

void give_bad_input(Scene& scene, scenes::Random& random, Counters& counters) {
    if (scene.bodies.empty()) return;
    const Body& body = scene.bodies[random.below(static_cast<std::uint32_t>(scene.bodies.size()))];
    const Pose bad = broken(body.pose, random);
    const BodyId stale =
        scene.dead.empty() ? BodyId{} : scene.dead[random.below(static_cast<std::uint32_t>(scene.dead.size()))];
    const std::uint32_t kind = random.below(8);
    for (World& world : scene.worlds) {
        switch (kind) {
            case 0:
                expect_error<InvalidPose>("bad pose set", world, counters, [&] { world.set_pose(body.id, bad); });
                break;
            case 1:
                expect_error<InvalidPose>("bad pose created", world, counters,
                                          [&] { world.create_body(body.mesh, bad); });
                break;
            case 2:
                expect_error<StaleBody>("stale body moved", world, counters, [&] { world.set_pose(stale, body.pose); });
                break;
            case 3:
                expect_error<StaleBody>("stale body destroyed", world, counters, [&] { world.destroy_body(stale); });
                break;
            case 4:
                expect_error<StaleBody>("stale body asked for", world, counters,
                                        [&] { world.relation(body.id, stale); });
                break;
            case 5:
                expect_error<SameBody>("same body twice", world, counters, [&] { world.relation(body.id, body.id); });
                break;
            case 6:
                expect_error<NullArgument>("null mesh", world, counters,
                                           [&] { world.set_shape(body.id, std::shared_ptr<const Mesh>()); });
                break;
            default:
                expect_error<InvalidVertex>("bad vertex", world, counters, [&] {
                    const double nan = std::numeric_limits<double>::quiet_NaN();
                    world.create_body(Mesh::create({Vec3(0, 0, 0), Vec3(0, nan, 0)}, {{0, 1, 1}}), body.pose);
                });
                break;
        }
    }
}

}  // namespace ecods::fuzz
