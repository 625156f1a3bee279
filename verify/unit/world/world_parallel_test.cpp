// The two-body tests of an update on several threads: nothing can be told from outside.

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>

#include "ecods/world.hpp"
#include "scenes/numbers_of.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"
#include "scenes/thread_executor.hpp"
#include "unit/world/world_fixture.hpp"

namespace ecods::world_parallel_test {
namespace {

std::vector<std::uint64_t> counts(const World& world) {
    const Statistics s = world.statistics();
    const QueryCounts& q = s.queries;
    std::vector<std::uint64_t> result{s.updates,        s.moved_bodies, s.two_body_tests,  s.cache_hits,
                                      s.visited_pairs,  s.body_count,   s.colliding_count, s.overlapping_count,
                                      s.filtered_count, q.queries,      q.box_tests,       q.stages.triangle_tests};
    for (const Stage& stage : stages) result.push_back(q.stages.*stage.count);
    return result;
}

// A crowd in which some move, many collide, and some are filtered out; what it did, frame by frame.
struct Film {
    std::vector<std::vector<BodyPair>> lists;
    std::vector<std::vector<std::uint64_t>> counts;
    std::vector<std::uint64_t> digests;
    bool operator==(const Film&) const = default;
};

Film film(const std::shared_ptr<Executor>& executor) {
    World world({.broad_phase = BroadPhaseKind::sweep_and_prune, .executor = executor});
    scenes::Random random(7);
    const auto torus = scenes::torus(12, 6, 0.5);
    const auto pose = [&] {
        Pose p = at(random.uniform(0, 12), random.uniform(0, 12), random.uniform(0, 12));
        p.R = random.rotation().toRotationMatrix();
        return p;
    };
    std::vector<BodyId> bodies;
    for (int i = 0; i < 250; ++i) bodies.push_back(world.create_body(torus, pose()));
    for (int i = 0; i < 250; i += 9) world.set_filter(bodies[i], {.mask = 0});
    Film result;
    for (int frame = 0; frame < 6; ++frame) {
        world.update();
        result.lists.push_back(numbers_of(world.colliding_pairs()));
        result.lists.push_back(numbers_of(world.overlapping_pairs()));
        result.lists.push_back(numbers_of(world.began()));
        result.lists.push_back(numbers_of(world.ended()));
        result.counts.push_back(counts(world));
        result.digests.push_back(world.digest());
        for (int i = 0; i < 100; ++i) world.set_pose(bodies[random.below(250)], pose());
    }
    world.update();
    world.check_invariants();
    return result;
}

TEST(WorldParallel, ListsEventsDigestsAndCountsAreTheSameForAnyNumberOfWorkers) {
    const Film alone = film(nullptr);
    EXPECT_GT(alone.lists[0].size(), 100u);
    EXPECT_GT(alone.lists[1].size(), 10 * 32u) << "there are pairs for many tasks";
    for (std::size_t worker_count = 1; worker_count <= 4; ++worker_count) {
        const auto executor = std::make_shared<ThreadExecutor>(worker_count);
        EXPECT_EQ(film(executor), alone) << worker_count << " workers";
        EXPECT_GT(executor->runs, 5);
    }
}

TEST(WorldParallel, FewPairsAreNotHandedOut) {
    const auto executor = std::make_shared<ThreadExecutor>(2);
    World world({.executor = executor});
    world.create_body(scenes::cube(0.5), at(0));
    world.create_body(scenes::cube(0.5), at(0.5));
    world.update();
    EXPECT_EQ(executor->runs, 0);
    EXPECT_EQ(world.colliding_pairs().size(), 1u);
}

// ---- what goes wrong

constexpr ShapeKind ball_kind{3};

class Ball final : public Shape {
  public:
    ShapeKind kind() const noexcept override { return ball_kind; }
    Aabb box(const Pose& pose) const override { return {pose.t - Vec3::Ones(), pose.t + Vec3::Ones()}; }
    std::uint64_t digest() const noexcept override { return 3; }
};

// All balls whose boxes overlap touch; those at negative x fail, and say where they are.
class BallTest final : public TwoBodyTest {
  public:
    bool intersects(const Posed<Shape>& a, const Posed<Shape>& b, const Ask&) const override {
        ++calls;
        if (fails && a.pose.t.x() < 0) throw std::runtime_error(std::to_string(a.pose.t.x()));
        return a.pose.t != b.pose.t;
    }
    Relation relation(const Posed<Shape>&, const Posed<Shape>&, const Ask&) const override {
        return Relation::touching;
    }

    std::atomic<bool> fails = false;
    mutable std::atomic<int> calls = 0;
};

class WorldParallelFailure : public testing::TestWithParam<std::size_t> {
  protected:
    static std::shared_ptr<Executor> make_executor() {
        if (GetParam() == 0) return nullptr;
        return std::make_shared<ThreadExecutor>(GetParam());
    }
    WorldParallelFailure() {
        world.set_test(ball_kind, ball_kind, test);
        for (int i = 0; i < 400; ++i) bodies.push_back(world.create_body(std::make_shared<Ball>(), at(1.5 * i)));
        world.update();
    }
    World world{{.executor = make_executor()}};
    std::shared_ptr<BallTest> test = std::make_shared<BallTest>();
    std::vector<BodyId> bodies;
};

INSTANTIATE_TEST_SUITE_P(Workers, WorldParallelFailure, testing::Values(0, 1, 2, 3, 4));

TEST_P(WorldParallelFailure, TheErrorOfThePairThatComesFirstIsThrownAfterAllTestsEnded) {
    const auto colliding = list(world.colliding_pairs());
    ASSERT_EQ(colliding.size(), 399u);
    test->fails = true;
    test->calls = 0;
    // All move; from the 100th on they fail.
    for (int i = 0; i < 400; ++i) world.set_pose(bodies[i], at(i < 100 ? 0.75 + 1.5 * i : 0.75 - 1.5 * i));
    const std::uint64_t tests = world.statistics().two_body_tests;
    std::string first;
    for (int attempt = 0; attempt < 3; ++attempt) {
        try {
            world.update();
            ADD_FAILURE();
        } catch (const std::runtime_error& error) {
            if (first.empty()) first = error.what();
            EXPECT_EQ(error.what(), first);
        }
        EXPECT_EQ(test->calls, 398 * (attempt + 1)) << "every pair is tested, the failing ones, too";
        EXPECT_EQ(list(world.colliding_pairs()), colliding);
        EXPECT_EQ(world.statistics().two_body_tests, tests);
    }
    EXPECT_EQ(std::stod(first), 0.75 - 1.5 * 100);
    test->fails = false;
    world.update();
    EXPECT_EQ(world.colliding_pairs().size(), 398u);
    EXPECT_EQ(list(world.ended()), (std::vector<BodyPair>{{bodies[99], bodies[100]}}));
    EXPECT_TRUE(world.began().empty());
    world.check_invariants();
}

class BrokenExecutor : public testing::Test {
  protected:
    using Task = std::function<void(std::size_t, std::size_t)>;
    BrokenExecutor() {
        world.set_test(ball_kind, ball_kind, std::make_shared<BallTest>());
        for (int i = 0; i < 200; ++i) world.create_body(std::make_shared<Ball>(), at(1.5 * i));
    }
    // The update fails, changes nothing, and is done by the next.
    template <class Expected>
    void expect_failure() {
        EXPECT_THROW(world.update(), Expected);
        EXPECT_TRUE(world.colliding_pairs().empty());
        executor->script = [](std::size_t task_count, const Task& task) {
            for (std::size_t i = task_count; i-- > 0;) task(i, i % 2);
        };
        world.update();
        EXPECT_EQ(world.colliding_pairs().size(), 199u);
        world.check_invariants();
    }
    std::shared_ptr<ScriptedExecutor> executor = std::make_shared<ScriptedExecutor>();
    World world{{.executor = executor}};
};

TEST_F(BrokenExecutor, ForgetsATask) {
    executor->script = [](std::size_t task_count, const Task& task) {
        for (std::size_t i = 1; i < task_count; ++i) task(i, 0);
    };
    expect_failure<ExecutorFailed>();
}

TEST_F(BrokenExecutor, RunsATaskTwice) {
    executor->script = [](std::size_t task_count, const Task& task) {
        for (std::size_t i = 0; i < task_count; ++i) task(i, 0);
        task(1, 1);
    };
    expect_failure<ExecutorFailed>();
}

TEST_F(BrokenExecutor, InventsATask) {
    executor->script = [](std::size_t task_count, const Task& task) {
        for (std::size_t i = 0; i <= task_count; ++i) task(i, 0);
    };
    expect_failure<ExecutorFailed>();
}

TEST_F(BrokenExecutor, InventsAWorker) {
    executor->script = [](std::size_t task_count, const Task& task) {
        for (std::size_t i = 0; i < task_count; ++i) task(i, i == 1 ? 2 : 0);
    };
    expect_failure<ExecutorFailed>();
}

// The first test that is run goes on until it is released.
class SlowTest final : public TwoBodyTest {
  public:
    bool intersects(const Posed<Shape>&, const Posed<Shape>&, const Ask&) const override {
        if (!has_begun.exchange(true)) is_released.wait(false);
        return true;
    }
    Relation relation(const Posed<Shape>&, const Posed<Shape>&, const Ask&) const override {
        return Relation::touching;
    }

    mutable std::atomic<bool> has_begun = false;
    std::atomic<bool> is_released = false;
};

TEST_F(BrokenExecutor, RunsTwoTasksAtOnceAsOneWorker) {
    const auto test = std::make_shared<SlowTest>();
    world.set_test(ball_kind, ball_kind, test);
    executor->script = [&](std::size_t task_count, const Task& task) {
        std::thread slow([&] { task(0, 1); });
        while (!test->has_begun) std::this_thread::yield();
        task(1, 1);
        test->is_released = true;
        test->is_released.notify_all();
        slow.join();
        for (std::size_t i = 2; i < task_count; ++i) task(i, 0);
    };
    expect_failure<ExecutorFailed>();
}

TEST_F(BrokenExecutor, Throws) {
    executor->script = [](std::size_t, const Task& task) {
        task(0, 0);
        throw std::logic_error("no threads today");
    };
    expect_failure<std::logic_error>();
}

}  // namespace
}  // namespace ecods::world_parallel_test
