// Every broad phase against the model over thousands of frames of the motions that broke others.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "scenes/random.hpp"
#include "unit/broad_phase/lockstep.hpp"

namespace ecods::test {
namespace {

struct Scene {
    const char* name;
    int numbers;  // proxies that may be present
    int frames;
    int lattice;                 // coordinates are integers below this; 0: any doubles in the unit cube
    double size;                 // the largest extent
    int move_one_in;             // of the boxes, in a frame
    int teleport_one_in;         // of the moves
    int change_one_in;           // of the numbers, added or removed in a frame
    Vec3 spread = Vec3::Ones();  // 0 on an axis: all boxes are in the same place there
    bool drifts = false;         // boxes keep their extents, and move by a fiftieth of the largest one at most
};

void PrintTo(const Scene& scene, std::ostream* out) {
    *out << scene.name;
}

class Motion : public ::testing::TestWithParam<std::tuple<Scene, int>> {
  protected:
    Scene scene = std::get<0>(GetParam());
    scenes::Random generator{static_cast<std::uint32_t>(std::get<1>(GetParam()))};
    Lockstep lockstep;

    int below(int n) { return static_cast<int>(generator.below(static_cast<std::uint32_t>(n))); }
    bool one_in(int n) { return below(n) == 0; }
    double unit() { return generator.uniform(0, 1); }

    double coordinate(int axis) { return scene.spread[axis] * (scene.lattice > 0 ? below(scene.lattice) : unit()); }
    double extent() {
        if (one_in(5)) return 0;
        return scene.lattice > 0 ? below(static_cast<int>(scene.size) + 1) : scene.size * unit();
    }

    Aabb anywhere() {
        Aabb box;
        for (int axis = 0; axis < 3; ++axis) {
            box.min[axis] = coordinate(axis);
            box.max[axis] = box.min[axis] + extent();
        }
        return box;
    }

    // A step of one lattice unit, one unit in the last place, or a fraction of the size.
    double step(double from) {
        const double sign = one_in(2) ? 1 : -1;
        if (scene.lattice > 0) return from + sign;
        if (one_in(4)) return std::nextafter(from, sign * 2);
        return from + sign * 0.1 * scene.size * unit();
    }

    Aabb drifted(Aabb box) {
        for (int axis = 0; axis < 3; ++axis) {
            const double by = 0.02 * scene.size * (2 * unit() - 1);
            box.min[axis] += by;
            box.max[axis] = std::max(box.min[axis], box.max[axis] + by);
        }
        return box;
    }

    Aabb moved(Aabb box) {
        if (scene.drifts) return drifted(box);
        constexpr double infinity = std::numeric_limits<double>::infinity();
        const int axis = below(3);
        switch (below(10)) {
            case 0:  // one side
                box.max[axis] = std::max(box.min[axis], step(box.max[axis]));
                return box;
            case 1:  // the other
                box.min[axis] = std::min(box.max[axis], step(box.min[axis]));
                return box;
            case 2:  // to nothing
                box.max = box.min;
                return box;
            case 3:  // onto another box, exactly
                if (const ProxyIndex other = static_cast<ProxyIndex>(below(scene.numbers)); lockstep.model.has(other)) {
                    return lockstep.model.box(other);
                }
                return box;
            case 4:  // against another box, exactly
                if (const ProxyIndex other = static_cast<ProxyIndex>(below(scene.numbers)); lockstep.model.has(other)) {
                    const double width = extent();
                    box.min[axis] = lockstep.model.box(other).max[axis];
                    box.max[axis] = box.min[axis] + width;
                }
                return box;
            case 5:  // over all others, rarely
                if (one_in(10)) {
                    const double reach = one_in(3) ? infinity : 1000;
                    box.min = Vec3::Constant(-reach);
                    box.max = Vec3::Constant(reach);
                    return box;
                }
                [[fallthrough]];
            default: {
                if (!box.min.allFinite() || !box.max.allFinite()) return anywhere();
                const double by = step(box.min[axis]) - box.min[axis];
                box.min[axis] += by;
                box.max[axis] = std::max(box.min[axis], box.max[axis] + by);
                return box;
            }
        }
    }
};

TEST_P(Motion, AllAgreeWithTheModel) {
    std::uint64_t pairs = 0, began = 0;
    for (int frame = 0; frame < scene.frames; ++frame) {
        // Where all jump, candidates are not worth keeping: most frames are calm enough that they are kept.
        const bool is_calm = frame % 64 >= 16;
        const auto takes_part = [&] { return !is_calm || one_in(scene.numbers > 200 ? 16 : 4); };
        for (int number = 0; number < scene.numbers; ++number) {
            const auto proxy = static_cast<ProxyIndex>(number);
            if (frame == 0 || (one_in(scene.change_one_in) && takes_part())) {
                if (lockstep.model.has(proxy)) {
                    lockstep.remove(proxy);
                    if (one_in(2)) lockstep.add(proxy, anywhere());
                } else {
                    lockstep.add(proxy, anywhere());
                }
            } else if (lockstep.model.has(proxy) && one_in(scene.move_one_in) && takes_part()) {
                lockstep.move(proxy, one_in(scene.teleport_one_in) ? anywhere() : moved(lockstep.model.box(proxy)));
            }
        }
        const bool is_small = scene.numbers <= 40;
        ASSERT_TRUE(
            lockstep.update(is_small || frame % 16 == 0 ? Lockstep::Checks::invariants_too : Lockstep::Checks::answers))
            << "frame " << frame;
        pairs += lockstep.model.pairs.size();
        began += lockstep.model.began.size();
    }
    // The scene did what it is here for.
    EXPECT_GT(pairs, 0u);
    EXPECT_GT(began, 0u);
    EXPECT_GT(lockstep.sweep_counts().swaps, 0u);
    const BroadPhaseCounts& kept = lockstep.counts(BroadPhaseKind::kept_candidates);
    EXPECT_GT(kept.candidates_filtered + kept.rebuilds, 0u);
    if (scene.drifts) {
        EXPECT_GT(kept.escaped, kept.rebuilds) << "boxes have margins, and leave them";
    }
    if (scene.numbers == 600) {
        EXPECT_LT(kept.rebuilds, static_cast<std::uint64_t>(scene.frames) / 2) << "boxes are searched one by one, too";
        EXPECT_GT(kept.rebuilds, 2u);
    }
}

const Scene scenes[] = {
    {.name = "few_on_lattice",
     .numbers = 5,
     .frames = 4000,
     .lattice = 4,
     .size = 2,
     .move_one_in = 2,
     .teleport_one_in = 10,
     .change_one_in = 20},
    {.name = "dozen_on_lattice",
     .numbers = 12,
     .frames = 3000,
     .lattice = 8,
     .size = 3,
     .move_one_in = 2,
     .teleport_one_in = 20,
     .change_one_in = 50},
    {.name = "forty_on_lattice",
     .numbers = 40,
     .frames = 1000,
     .lattice = 12,
     .size = 3,
     .move_one_in = 3,
     .teleport_one_in = 10,
     .change_one_in = 100},
    {.name = "in_one_place",
     .numbers = 20,
     .frames = 1000,
     .lattice = 2,
     .size = 1,
     .move_one_in = 3,
     .teleport_one_in = 5,
     .change_one_in = 30,
     .spread = Vec3::Zero()},
    {.name = "on_a_line",
     .numbers = 60,
     .frames = 500,
     .lattice = 40,
     .size = 2,
     .move_one_in = 2,
     .teleport_one_in = 20,
     .change_one_in = 100,
     .spread = Vec3(0, 1, 0)},
    {.name = "hundred_all_move",
     .numbers = 100,
     .frames = 400,
     .lattice = 0,
     .size = 0.3,
     .move_one_in = 1,
     .teleport_one_in = 1000,
     .change_one_in = 1000},
    {.name = "hundred_all_drift",
     .numbers = 100,
     .frames = 400,
     .lattice = 0,
     .size = 0.3,
     .move_one_in = 1,
     .teleport_one_in = 500,
     .change_one_in = 1000,
     .drifts = true},
    {.name = "two_thousand_all_drift",
     .numbers = 2000,
     .frames = 24,
     .lattice = 0,
     .size = 0.1,
     .move_one_in = 1,
     .teleport_one_in = 1000,
     .change_one_in = 1000,
     .drifts = true},
    {.name = "three_hundred_few_move",
     .numbers = 300,
     .frames = 400,
     .lattice = 0,
     .size = 0.2,
     .move_one_in = 60,
     .teleport_one_in = 10,
     .change_one_in = 5000},
    {.name = "three_hundred_few_move_on_lattice",
     .numbers = 300,
     .frames = 400,
     .lattice = 20,
     .size = 4,
     .move_one_in = 60,
     .teleport_one_in = 10,
     .change_one_in = 5000},
    {.name = "six_hundred_drift_and_jump",
     .numbers = 600,
     .frames = 200,
     .lattice = 0,
     .size = 0.15,
     .move_one_in = 4,
     .teleport_one_in = 20,
     .change_one_in = 300},
    {.name = "four_hundred_teleport",
     .numbers = 400,
     .frames = 60,
     .lattice = 0,
     .size = 0.1,
     .move_one_in = 1,
     .teleport_one_in = 1,
     .change_one_in = 50},
    {.name = "nothing_but_removal",
     .numbers = 30,
     .frames = 1000,
     .lattice = 5,
     .size = 2,
     .move_one_in = 1000,
     .teleport_one_in = 2,
     .change_one_in = 2},
};

INSTANTIATE_TEST_SUITE_P(Scenes, Motion, ::testing::Combine(::testing::ValuesIn(scenes), ::testing::Values(1, 2)),
                         [](const auto& instance) {
                             return std::get<0>(instance.param).name + std::string("_") +
                                    std::to_string(std::get<1>(instance.param));
                         });

}  // namespace
}  // namespace ecods::test
