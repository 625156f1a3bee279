#include "fuzz/run.hpp"

#include <cmath>
#include <exception>

#include "fuzz/bad_input.hpp"
#include "fuzz/failure.hpp"
#include "fuzz/meshes.hpp"
#include "fuzz/motions.hpp"
#include "fuzz/scene.hpp"

namespace ecods::fuzz {
namespace {

Setting make_setting(scenes::Random& random, Counters& counters) {
    Setting setting;
    switch (random.below(8)) {
        case 0:
            // The smallest coordinates are multiples of the smallest subnormal.
            ++counters["scene subnormal"];
            setting.unit = std::ldexp(1.0, -1060);
            break;
        case 1:
            ++counters["scene huge"];
            setting.unit = std::ldexp(1.0, 900);
            break;
        case 2:
            ++counters["scene far from the origin"];
            setting.origin = Vec3(0x1p40, -0x1p45, 3e9);
            break;
        default:
            ++counters["scene of unit size"];
            break;
    }
    for (int i = 0; i < 4; ++i) setting.meshes.push_back(make_mesh(setting.unit, random, counters));
    setting.bodies_max = 2 + random.below(8);
    return setting;
}

void run_frame(Scene& scene, const Setting& setting, const CheckOptions& options, scenes::Random& random,
               Counters& counters) {
    const bool rests = random.below(8) == 0;
    const std::uint64_t tests = scene.worlds[1].statistics().two_body_tests;
    if (!rests) {
        for (std::uint32_t i = 0, count = 1 + random.below(4); i < count; ++i) {
            change(scene, setting, random, counters);
        }
    }
    if (random.below(4) == 0) give_bad_input(scene, random, counters);
    scene.update();
    ++counters["frames"];
    if (rests) {
        ++counters["frames at rest"];
        require(scene.worlds[1].statistics().two_body_tests == tests, "rest", "a pair at rest was tested again");
    }
    check_frame(scene, options, random, counters);
}

}  // namespace

void run(std::uint32_t seed, const CheckOptions& options, Counters& counters) {
    scenes::Random random(seed);
    Failure failure{.seed = seed};
    try {
        const Setting setting = make_setting(random, counters);
        Scene scene;
        for (std::size_t i = 0; i < setting.bodies_max; ++i) {
            scene.create(setting.meshes[random.below(4)], random_pose(setting, random));
        }
        // A scene begins with an update, so that a frame at rest may be the first.
        scene.update();
        check_frame(scene, options, random, counters);
        for (failure.frame = 1; failure.frame <= frames_per_run; ++failure.frame) {
            run_frame(scene, setting, options, random, counters);
        }
        return;
    } catch (const CheckFailed& error) {
        failure.check = error.check;
        failure.detail = error.what();
    } catch (const std::exception& error) {
        failure.check = "unexpected error";
        failure.detail = error.what();
    }
    throw failure;
}

}  // namespace ecods::fuzz
