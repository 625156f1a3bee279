// Which boxes a segment, a ray or a box on the move may meet: all that are met, in the order of their bounds, the same
// of all broad phases, and with little work.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "bounds/moving_box.hpp"
#include "broad_phase/boxes/along_walk.hpp"
#include "ecods/error.hpp"
#include "scenes/expect_invalid.hpp"
#include "scenes/moving_boxes.hpp"
#include "scenes/random.hpp"
#include "unit/broad_phase/lockstep.hpp"
#include "unit/broad_phase/random_boxes.hpp"

namespace ecods::test::visit_along_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

using Visits = std::vector<std::pair<double, ProxyIndex>>;

class VisitsAlong : public ::testing::Test {
  protected:
    // `ask(engine, visit)` asks; `moving` is what it asks about.
    template <class Ask>
    void require_all(const MovingBox& moving, double limit, const Ask& ask) {
        Visits expected;
        for (ProxyIndex proxy = 0; proxy < end_; ++proxy) {
            if (!steps_.model.has(proxy)) continue;
            const double from = moving.meets_from(steps_.model.box(proxy));
            if (from <= limit && from < infinity) expected.emplace_back(from, proxy);
        }
        std::ranges::sort(expected);
        // All of them, and then the first half: what is later than the last of these is not visited.
        for (const std::size_t stop : {expected.size(), expected.size() / 2}) {
            Visits first = expected;
            if (stop < expected.size()) {
                first.resize(stop + 1);
                for (std::size_t i = stop + 1; i < expected.size() && expected[i].first == first[stop].first; ++i) {
                    first.push_back(expected[i]);
                }
            }
            for (const auto& engine : steps_.engines) {
                Visits got;
                ask(*engine, [&](ProxyIndex proxy) {
                    got.emplace_back(moving.meets_from(steps_.model.box(proxy)), proxy);
                    return got.size() > stop ? got[stop].first : infinity;
                });
                ASSERT_EQ(got, first) << Lockstep::name(*engine);
            }
            visit_count_ += first.size();
        }
    }
    void require_all() {
        const Segment segment{any_place(), random_.below(8) == 0 ? any_place() : any_corner()};
        require_all(MovingBox(segment), 1,
                    [&](const BroadPhase& engine, const auto& visit) { engine.visit_along(segment, visit); });
        Ray ray{any_corner(), any_direction()};
        if (random_.below(2) == 0) ray.max_parameter = random_.uniform(0, 8);
        require_all(MovingBox(ray), ray.max_parameter,
                    [&](const BroadPhase& engine, const auto& visit) { engine.visit_along(ray, visit); });
        const Aabb box = any_box();
        const Vec3 motion = any_direction();
        for (const double limit : {0.0, 0.5, 1.0, infinity}) {
            require_all(MovingBox(box, motion), limit, [&](const BroadPhase& engine, const auto& visit) {
                engine.visit_along(box, motion, limit, visit);
            });
        }
    }
    Vec3 any_place() { return {random_.uniform(-side_, side_), random_.uniform(-side_, side_), random_.uniform(0, 2)}; }
    // Along an axis now and then, and of no length.
    Vec3 any_direction() {
        Vec3 direction(random_.uniform(-9, 9), random_.uniform(-9, 9), random_.uniform(-9, 9));
        for (double& x : direction) x = random_.below(4) == 0 ? 0 : x;
        return direction == Vec3::Zero() ? Vec3(Vec3::UnitY()) : direction;
    }
    Vec3 any_corner() {
        const ProxyIndex proxy = random_.below(end_);
        if (!steps_.model.has(proxy)) return any_place();
        const Aabb box = steps_.model.box(proxy);
        return {box.min[0], box.max[1], random_.below(2) == 0 ? box.min[2] : box.max[2]};
    }
    Aabb any_box() {
        const double size = random_.below(20) == 0 ? random_.uniform(0, side_) : random_.uniform(0, 1);
        const Vec3 at = any_place();
        return {at, at + Vec3::Constant(size)};
    }

    Lockstep steps_;
    ProxyIndex end_ = 0;
    double side_ = 3;
    std::size_t visit_count_ = 0;
    scenes::Random random_{19};
};

TEST_F(VisitsAlong, AllThatAreMetInOrderWhileBoxesComeMoveAndGo) {
    for (const double side : {3.0, 12.0}) {
        side_ = side;
        for (end_ = 0; end_ < 300; ++end_) steps_.set(end_, any_box());
        for (int round = 0; round < 12; ++round) {
            for (int i = 0; i < 6; ++i) require_all();
            for (int i = 0; i < 40; ++i) steps_.set(random_.below(end_), any_box());
            for (int i = 0; i < 10; ++i) {
                const ProxyIndex proxy = random_.below(end_);
                if (steps_.model.has(proxy)) steps_.remove(proxy);
            }
        }
    }
    EXPECT_GT(visit_count_, 5000u);
    // Few: all are tested.
    for (ProxyIndex proxy = 0; proxy < end_; ++proxy) {
        if (proxy % 10 != 0 && steps_.model.has(proxy)) steps_.remove(proxy);
    }
    for (int i = 0; i < 6; ++i) require_all();
}

// Nothing that a segment meets is left out: find() is exact.
TEST_F(VisitsAlong, NoBoxIsLost) {
    for (end_ = 0; end_ < 400; ++end_) steps_.set(end_, any_box());
    for (int i = 0; i < 500; ++i) {
        const Segment segment{any_corner(), any_corner()};
        const Aabb box = any_box();
        const Vec3 motion = any_direction();
        std::vector<ProxyIndex> along, at_end;
        steps_.engines[3]->visit_along(segment, [&](ProxyIndex proxy) {
            along.push_back(proxy);
            return infinity;
        });
        steps_.engines[3]->visit_along(box, motion, 1, [&](ProxyIndex proxy) {
            at_end.push_back(proxy);
            return infinity;
        });
        std::ranges::sort(along);
        std::ranges::sort(at_end);
        ASSERT_TRUE(std::ranges::includes(along, steps_.engines[0]->find(segment)));
        ASSERT_TRUE(std::ranges::includes(at_end, steps_.engines[0]->find(box)));
    }
}

TEST_F(VisitsAlong, BadArgumentsAreRefused) {
    const auto visit = [](ProxyIndex) { return infinity; };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const auto& engine : steps_.engines) {
        EXPECT_INVALID(engine->visit_along(Segment{Vec3(nan, 0, 0), Vec3(0, 0, 0)}, visit), Argument::segment);
        EXPECT_INVALID(engine->visit_along(Ray{Vec3(0, 0, 0), Vec3(0, 0, 0)}, visit), Argument::ray);
        EXPECT_INVALID(engine->visit_along(Ray{.max_parameter = -1}, visit), Argument::ray);
        EXPECT_INVALID(engine->visit_along(make_cube(0, 0, 0), Vec3(0, infinity, 0), 1, visit), Argument::motion);
        EXPECT_INVALID(engine->visit_along({Vec3(0, 1, 0), Vec3(0, 0, 0)}, Vec3(0, 1, 0), 1, visit), Argument::box);
        for (const double bad : {-1.0, -infinity, nan}) {
            EXPECT_INVALID(engine->visit_along(make_cube(0, 0, 0), Vec3(0, 1, 0), bad, visit), Argument::time);
        }
    }
}

// Eight boxes at once have the bounds that each has by itself, to the last bit.
TEST_F(VisitsAlong, BlocksAreMetAsTheirBoxesAre) {
    for (int i = 0; i < 4000; ++i) {
        BoxBlock block;
        std::array<Aabb, BoxBlock::width> boxes;
        std::uint32_t present = 0;
        for (std::uint32_t lane = 0; lane < BoxBlock::width; ++lane) {
            boxes[lane] = any_box();
            if (random_.below(10) == 0) boxes[lane].max[1] = infinity;
            if (random_.below(10) == 0) boxes[lane].min[0] = -infinity;
            if (random_.below(5) == 0) continue;
            block.set(lane, packed_box(key_box(boxes[lane])));
            present |= 1u << lane;
        }
        Aabb moving_box = any_box();
        if (i % 10 == 0) moving_box.max[2] = infinity;
        const MovingBox moving(moving_box, any_direction());
        std::array<double, BoxBlock::width> from;
        meet_block(block, moving, from);
        for (std::uint32_t lane = 0; lane < BoxBlock::width; ++lane) {
            const double expected = (present >> lane & 1) != 0 ? moving.meets_from(boxes[lane]) : infinity;
            ASSERT_EQ(from[lane], expected);
        }
    }
}

// ---- what it costs

class AlongCost : public ::testing::TestWithParam<std::tuple<scenes::BoxLayout, std::size_t>> {};

// The first box that is met is found with the work of those that could have been; all of them, with that of these.
TEST_P(AlongCost, IsWhatIsVisitedAndALogarithm) {
    const auto [layout, count] = GetParam();
    const auto scene = scenes::moving_boxes({.layout = layout, .count = count, .frame_count = 10});
    const double levels = std::log2(static_cast<double>(count));
    for (const BroadPhaseKind kind :
         {BroadPhaseKind::sweep_and_prune, BroadPhaseKind::automatic, BroadPhaseKind::kept_candidates}) {
        const auto phase = make_broad_phase(kind);
        for (ProxyIndex i = 0; i < count; ++i) phase->add(i, scene.boxes[i]);
        for (const auto& frame : scene.frames) {
            for (const scenes::BoxMove& move : frame) phase->move(move.index, move.box);
        }
        for (const bool only_first : {false, true}) {
            scenes::Random random(5);
            std::uint64_t visits = 0;
            const std::uint64_t before = phase->find_counts().box_tests;
            for (int i = 0; i < 40; ++i) {
                const Aabb near = scene.boxes[random.below(static_cast<std::uint32_t>(count))];
                const Vec3 size = near.max - near.min;
                const auto visit = [&](ProxyIndex) {
                    ++visits;
                    return only_first ? 0 : infinity;
                };
                phase->visit_along(Segment{near.min - 20 * size, near.max + 10 * size}, visit);
                phase->visit_along(near, 10 * size, 1, visit);
            }
            const auto tests = static_cast<double>(phase->find_counts().box_tests - before);
            EXPECT_LE(tests, 24 * static_cast<double>(visits) + 80 * 24 * levels)
                << scene.name << ": visited " << visits;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, AlongCost,
                         ::testing::Combine(::testing::Values(scenes::BoxLayout::dense, scenes::BoxLayout::sparse,
                                                              scenes::BoxLayout::pile, scenes::BoxLayout::decades),
                                            ::testing::Values(std::size_t{1000}, std::size_t{30000})));

}  // namespace
}  // namespace ecods::test::visit_along_test
