// Which boxes a box, a segment or a ball meets: the same in all broad phases, and from trees at the price of what is
// found.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>

#include "ecods/error.hpp"
#include "scenes/expect_invalid.hpp"
#include "scenes/moving_boxes.hpp"
#include "scenes/random.hpp"
#include "unit/broad_phase/lockstep.hpp"
#include "unit/broad_phase/random_boxes.hpp"

namespace ecods::test::find_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
using Found = std::vector<ProxyIndex>;

template <class Question>
Found model_finds(const Model& model, ProxyIndex end, const Question& question) {
    Found found;
    for (ProxyIndex proxy = 0; proxy < end; ++proxy) {
        if (model.has(proxy) && overlap(question, model.box(proxy))) found.push_back(proxy);
    }
    return found;
}

// Boxes that are moved, and one question of each sort at a time.
class Finds : public ::testing::Test {
  protected:
    template <class Question>
    void ask(const Question& question) {
        const Found expected = model_finds(steps_.model, end_, question);
        found_count_ += expected.size();
        for (const auto& engine : steps_.engines) {
            ASSERT_EQ(engine->find(question), expected) << Lockstep::name(*engine);
        }
    }

    Vec3 point(double side) {
        Vec3 result;
        // Lattice points, so that many touch, and others.
        for (int k = 0; k < 3; ++k) result[k] = random_.uniform(-side, side);
        return random_.uniform(0, 1) < 0.7 ? Vec3(result.array().floor()) : result;
    }

    void ask_all(double side) {
        const Vec3 a = point(side), b = point(side), size = point(3).cwiseAbs();
        ask(Aabb{a, a + size});
        ask(Aabb{a, a});
        ask(Segment{a, b});
        ask(Segment{a, a});
        ask(Segment{a, Vec3(b[0], a[1], a[2])});
        ask(Segment{a, a + size});
        ask(Ball{a, size[0]});
        ask(Ball{b, 0});
        ask(Ball{b, size[1] + size[2]});
    }

    void set(ProxyIndex proxy, const Aabb& box) {
        steps_.set(proxy, box);
        end_ = std::max(end_, proxy + 1);
    }

    Lockstep steps_;
    ProxyIndex end_ = 0;
    scenes::Random random_{7};
    std::size_t found_count_ = 0;
};

TEST_F(Finds, AllKindsAgreeWhileBoxesComeGoAndMove) {
    for (const Spread spread : all_spreads) {
        for (const std::size_t count : {10u, 300u}) {
            const std::vector<Aabb> boxes = random_boxes(count, spread, 3);
            const double side = spread == Spread::line ? static_cast<double>(count) / 2 : 15;
            for (ProxyIndex proxy = 0; proxy < count; ++proxy) set(proxy, boxes[proxy]);
            for (int frame = 0; frame < 12; ++frame) {
                for (ProxyIndex proxy = 0; proxy < end_; ++proxy) {
                    const double chance = random_.uniform(0, 1);
                    if (!steps_.model.has(proxy)) {
                        if (chance < 0.3) set(proxy, boxes[proxy % count]);
                        continue;
                    }
                    Aabb box = steps_.model.box(proxy);
                    const Vec3 step = chance < 0.05 ? point(15) : Vec3(0.125, -0.5, 0.25) * (chance < 0.5 ? 1 : 0);
                    box.min += step;
                    box.max += step;
                    chance > 0.97 ? steps_.remove(proxy) : set(proxy, box);
                }
                ask_all(side);  // before the update
                ask_all(side);
                ASSERT_TRUE(steps_.update(Lockstep::Checks::invariants_too));
                ask_all(side);
                if (HasFatalFailure()) return;
            }
        }
        for (ProxyIndex proxy = 0; proxy < end_; ++proxy) {
            if (steps_.model.has(proxy)) steps_.remove(proxy);
        }
        ask(make_box(-1e300, 1e300, -1e300, 1e300, -1e300, 1e300));
    }
    EXPECT_GT(found_count_, 4000u);
}

TEST_F(Finds, NothingIsFoundAmongNoBoxes) {
    ask(make_box(0, 1, 0, 1, 0, 1));
    ask(Segment{Vec3(0, 0, 0), Vec3(1, 1, 1)});
    ask(Ball{Vec3(0, 0, 0), infinity});
    EXPECT_EQ(found_count_, 0u);
}

TEST_F(Finds, FlatHugeAndInfiniteBoxesAreFound) {
    for (ProxyIndex i = 0; i < 80; ++i) set(i, make_cube(i, 0, 0));
    set(80, make_box(-infinity, infinity, 0, 0, -infinity, infinity));
    set(81, make_box(infinity, infinity, 0, 1, 0, 1));
    set(82, make_box(-infinity, -infinity, -infinity, -infinity, 0, 0));
    set(83, make_box(-1.7e308, 1.7e308, 1.7e308, 1.7e308, 0, 0));
    set(84, make_box(0x1p-1074, 0x1p-1074, -0.0, 0, 0, 0));
    set(85, make_box(-0x1p-1074, -0x1p-1074, 0, 0, 0, 0));
    for (int frame = 0; frame < 2; ++frame) {
        ask(make_box(-infinity, infinity, -infinity, infinity, -infinity, infinity));
        ask(make_box(infinity, infinity, 0, 0, 0, 0));
        ask(make_box(0, 0, 0, 0, 0, 0));
        ask(Segment{Vec3(0, 0, 0), Vec3(0, 0, 0)});
        ask(Segment{Vec3(0x1p-1074, 0, 0), Vec3(0, 0, 0)});
        ask(Segment{Vec3(-1.7e308, -1, 0), Vec3(1.7e308, 1, 0)});
        ask(Segment{Vec3(-1.7e308, -1.7e308, 0), Vec3(1.7e308, 1.7e308, 0)});
        ask(Ball{Vec3(0, 0, 0), infinity});
        ask(Ball{Vec3(0, 0, 0), 1.7e308});
        ask(Ball{Vec3(0, 0, 0), 0x1p-1074});
        ask(Ball{Vec3(0, 0, 0), 0});
        ASSERT_TRUE(steps_.update());
    }
}

TEST_F(Finds, WhatIsNoQuestionThrowsAndChangesNothing) {
    for (ProxyIndex i = 0; i < 100; ++i) set(i, make_cube(i, 0, 0));
    for (const auto& engine : steps_.engines) {
        EXPECT_INVALID(engine->find(make_box(1, 0, 0, 1, 0, 1)), Argument::box);
        EXPECT_INVALID(engine->find(make_box(0, std::nan(""), 0, 1, 0, 1)), Argument::box);
        EXPECT_INVALID(engine->find(Segment{Vec3(0, 0, infinity), Vec3(0, 0, 0)}), Argument::segment);
        EXPECT_INVALID(engine->find(Ball{Vec3(0, 0, 0), -1}), Argument::ball);
        EXPECT_EQ(engine->find_counts().calls, 0u);
    }
    ask_all(50);
    for (const auto& engine : steps_.engines) EXPECT_EQ(engine->find_counts().calls, 9u);
}

TEST(Find, ManyThreadsMayAskAtOnce) {
    const auto phase = make_broad_phase(BroadPhaseKind::automatic);
    for (ProxyIndex i = 0; i < 2000; ++i) phase->add(i, make_cube(i % 50, i / 50, 0));
    for (int frame = 0; frame < 5; ++frame) {
        for (ProxyIndex i = 0; i < 2000; i += 3) phase->move(i, make_cube(i % 50 + 0.2 * frame, i / 50, 0));
        std::array<Found, 4> found;
        std::vector<std::thread> threads;
        for (Found& own : found) {
            threads.emplace_back([&] { own = phase->find(Segment{Vec3(0, 0, 0), Vec3(50, 40, 0.5)}); });
        }
        for (std::thread& thread : threads) thread.join();
        EXPECT_GT(found[0].size(), 50u);
        for (const Found& own : found) EXPECT_EQ(own, found[0]);
    }
    EXPECT_EQ(phase->find_counts().calls, 20u);
}

// What questions about a scene cost, while all boxes move.
struct Cost {
    std::uint64_t found = 0, tests = 0, calls = 0, refreshed = 0;
};

template <class Ask>
Cost cost_of(BroadPhase& phase, const scenes::MovingBoxes& scene, Ask&& ask) {
    scenes::Random random(5);
    const FindCounts before = phase.find_counts();
    Cost cost;
    for (int i = 0; i < 40; ++i) {
        const std::size_t at =
            std::min(scene.boxes.size() - 1,
                     static_cast<std::size_t>(random.uniform(0, 1) * static_cast<double>(scene.boxes.size())));
        const Aabb& near = scene.boxes[at];
        cost.found += ask(near).size();
    }
    const FindCounts after = phase.find_counts();
    cost.tests = after.box_tests - before.box_tests;
    cost.calls = after.calls - before.calls;
    cost.refreshed = after.refreshed - before.refreshed;
    return cost;
}

void check_costs(BroadPhase& phase, const scenes::MovingBoxes& scene, const std::string& name) {
    const double levels = std::log2(static_cast<double>(scene.boxes.size()));
    const auto check = [&](const Cost& cost, const char* what) {
        const double allowed = 24 * static_cast<double>(cost.found) + 24 * levels * static_cast<double>(cost.calls);
        EXPECT_LE(static_cast<double>(cost.tests), allowed) << name << ", " << what << ": found " << cost.found;
    };
    check(cost_of(phase, scene, [&](const Aabb& near) { return phase.find(near); }), "box");
    check(cost_of(phase, scene,
                  [&](const Aabb& near) {
                      const Vec3 size = near.max - near.min;
                      return phase.find(Ball{near.min, 2 * size[0]});
                  }),
          "ball");
    check(cost_of(phase, scene,
                  [&](const Aabb& near) {
                      const Vec3 size = near.max - near.min;
                      return phase.find(Segment{near.min - 20 * size, near.max + 10 * size});
                  }),
          "segment");
}

class FindCost : public ::testing::TestWithParam<std::tuple<scenes::BoxLayout, std::size_t>> {};

TEST_P(FindCost, IsWhatIsFoundAndALogarithm) {
    const auto [layout, count] = GetParam();
    const auto scene = scenes::moving_boxes({.layout = layout, .count = count, .frame_count = 40});
    for (const BroadPhaseKind kind : {BroadPhaseKind::automatic, BroadPhaseKind::kept_candidates}) {
        const auto phase = make_broad_phase(kind);
        for (ProxyIndex i = 0; i < count; ++i) phase->add(i, scene.boxes[i]);
        check_costs(*phase, scene, scene.name);
        EXPECT_EQ(phase->find_counts().refreshed, count);
        for (const auto& frame : scene.frames) {
            for (const scenes::BoxMove& move : frame) phase->move(move.index, move.box);
            const std::uint64_t before = phase->find_counts().refreshed;
            phase->find(scene.boxes[0]);
            // Each box that moved is looked at once, and at times the trees are made from scratch.
            EXPECT_LE(phase->find_counts().refreshed - before, frame.size() + count);
            phase->find(scene.boxes[0]);
        }
        check_costs(*phase, scene, scene.name + ", moved");
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, FindCost,
                         ::testing::Combine(::testing::Values(scenes::BoxLayout::dense, scenes::BoxLayout::sparse,
                                                              scenes::BoxLayout::pile, scenes::BoxLayout::decades),
                                            ::testing::Values(std::size_t{1000}, std::size_t{30000})));

// At rest, since a million boxes that move take seconds.
TEST(Find, CostsNoMoreAmongAMillionBoxes) {
    const auto scene = scenes::moving_boxes({.motion = scenes::BoxMotion::none, .count = 1000000, .frame_count = 1});
    const auto phase = make_broad_phase(BroadPhaseKind::automatic);
    for (ProxyIndex i = 0; i < scene.boxes.size(); ++i) phase->add(i, scene.boxes[i]);
    check_costs(*phase, scene, scene.name);
}

// A step within a fat box costs nothing but the comparison that notices it.
TEST(Find, WorkIsProportionalToWhatChanged) {
    const auto phase = make_broad_phase(BroadPhaseKind::automatic);
    for (ProxyIndex i = 0; i < 5000; ++i) phase->add(i, make_cube(2 * (i % 70), 2 * (i / 70), 0));
    phase->find(make_cube(3, 3, 0));
    EXPECT_EQ(phase->find_counts().refreshed, 5000u);
    for (int frame = 1; frame <= 10; ++frame) {
        for (ProxyIndex i = 0; i < 10; ++i) phase->move(i, make_cube(2 * i, 0.25 * frame, 0));
        for (int again = 0; again < 3; ++again) phase->find(make_cube(3, 3, 0));
        EXPECT_EQ(phase->find_counts().refreshed, 5000u + 10 * static_cast<unsigned>(frame));
    }
    phase->move(1, make_cube(2, 2.5, 0));  // where it is
    phase->remove(2);
    phase->find(make_cube(3, 3, 0));
    EXPECT_LE(phase->find_counts().refreshed, 5102u);
}

}  // namespace
}  // namespace ecods::test::find_test
