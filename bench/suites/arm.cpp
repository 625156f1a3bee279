// The closest pair of an arm of six links and 21 obstacles at each step of a motion, with its points: World's, and
// what a loop over all pairs with witnesses takes.
#include <fmt/core.h>

#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>
#include <vector>

#include "ecods/distance.hpp"
#include "ecods/world.hpp"
#include "harness/statistics.hpp"
#include "harness/stopwatch.hpp"
#include "oracle/convex.hpp"
#include "scenes/random.hpp"
#include "suites/comparison.hpp"
#include "suites/suite.hpp"
#include "suites/timed_rows.hpp"

namespace ecods::bench {

namespace {

using Hull = std::shared_ptr<const ConvexSolid>;

constexpr std::size_t link_count = 6, obstacle_count = 21;
constexpr std::uint64_t arm_group = 1, obstacle_group = 2;
constexpr double link_length = 0.32, link_half = 0.15, least_far = 0.7, most_far = 1.4;

// The hull of two regular polygons.
Hull prism_of(double x, double y, double half_height, int sides) {
    std::vector<Vec3> points;
    for (int i = 0; i < sides; ++i) {
        const double angle = 2 * std::numbers::pi * i / sides;
        for (const double z : {-half_height, half_height}) {
            points.emplace_back(x * std::cos(angle), y * std::sin(angle), z);
        }
    }
    return std::make_shared<const ConvexSolid>(points);
}

class Arm {
  public:
    Arm() {
        scenes::Random random(7);
        for (std::size_t i = 0; i < link_count; ++i) {
            const double radius = 0.07 - 0.005 * static_cast<double>(i);
            links_.push_back(prism_of(radius, radius, link_half, 16));
        }
        for (std::size_t i = 0; i < obstacle_count; ++i) {
            const auto size = [&] { return random.uniform(0.1, 0.2); };
            const double x = size(), y = size(), half_height = size();
            obstacles_.push_back(prism_of(x, y, half_height, i % 3 == 0 ? 12 : 4));
            Pose pose = random.turned();
            pose.t = random.uniform(least_far, most_far) * random.direction();
            obstacle_poses_.push_back(pose);
        }
        go_to(0);
    }

    void go_to(std::size_t step) {
        const double s = 0.002 * static_cast<double>(step);
        Eigen::Isometry3d joint = Eigen::Isometry3d::Identity();
        poses_.clear();
        for (std::size_t i = 0; i < link_count; ++i) {
            const auto of = static_cast<double>(i);
            const Vec3 axis = i % 2 == 0 ? Vec3::UnitZ() : Vec3::UnitY();
            joint = joint * Eigen::AngleAxisd(0.9 * std::sin(s * (1 + 0.3 * of) + of), axis);
            poses_.push_back(Pose::from_isometry(joint * Eigen::Translation3d(0, 0, link_half)));
            joint = joint * Eigen::Translation3d(0, 0, link_length);
        }
    }

    Posed<ConvexSolid> link(std::size_t i) const { return {*links_[i], poses_[i]}; }
    Posed<ConvexSolid> obstacle(std::size_t i) const { return {*obstacles_[i], obstacle_poses_[i]}; }
    const std::vector<Pose>& poses() const { return poses_; }

    // Creates the bodies of the arm, then the obstacles; returns the arm's.
    std::vector<BodyId> create_bodies(World& world) const {
        std::vector<BodyId> ids;
        for (std::size_t i = 0; i < link_count; ++i) {
            ids.push_back(world.create_body({.shape = links_[i], .pose = poses_[i], .filter = {.groups = arm_group}}));
        }
        for (std::size_t i = 0; i < obstacle_count; ++i) {
            world.create_body(
                {.shape = obstacles_[i], .pose = obstacle_poses_[i], .filter = {.groups = obstacle_group}});
        }
        return ids;
    }

  private:
    std::vector<Hull> links_, obstacles_;
    std::vector<Pose> poses_, obstacle_poses_;
};

// OwnLoop does what a caller would write: it asks all pairs with a witness each, then for the points of the closest.
class OwnLoop {
  public:
    double ask(const Arm& arm) {
        double least = World::no_limit;
        std::size_t least_i = 0, least_j = 0;
        for (std::size_t i = 0; i < link_count; ++i) {
            for (std::size_t j = 0; j < obstacle_count; ++j) {
                const double d = distance(arm.link(i), arm.obstacle(j), {memory_, witness(i, j)});
                if (d < least) std::tie(least, least_i, least_j) = std::tuple(d, i, j);
            }
        }
        return signed_distance(arm.link(least_i), arm.obstacle(least_j), {memory_, witness(least_i, least_j)}).distance;
    }

  private:
    PairWitness& witness(std::size_t i, std::size_t j) { return witnesses_[i * obstacle_count + j]; }

    QueryMemory memory_;
    std::vector<PairWitness> witnesses_ = std::vector<PairWitness>(link_count * obstacle_count);
};

class OfWorld {
  public:
    explicit OfWorld(const Arm& arm) : ids_(arm.create_bodies(world_)) {}

    double ask(const Arm& arm, QueryCounts* counts = nullptr) {
        world_.set_poses(ids_, arm.poses());
        Ask ask(memory_);
        ask.counts = counts;
        return world_.closest_pair(World::no_limit, arm_group, obstacle_group, ask)->distance;
    }

  private:
    World world_;
    std::vector<BodyId> ids_;
    QueryMemory memory_;
};

// The least signed distance of all pairs, by the oracle.
double true_least(const Arm& arm) {
    double least = World::no_limit;
    for (std::size_t i = 0; i < link_count; ++i) {
        for (std::size_t j = 0; j < obstacle_count; ++j) {
            const auto a = arm.link(i), b = arm.obstacle(j);
            const oracle::ConvexPair pair(a.what->mesh(), a.pose, b.what->mesh(), b.pose);
            const double d =
                pair.share_a_point() ? -oracle::nearest(pair.depth()->depth) : oracle::nearest(pair.distance());
            least = std::min(least, d);
        }
    }
    return least;
}

template <class Pass>
double microseconds_a_step(Arm& arm, std::size_t step_count, const Pass& pass) {
    const Stopwatch watch;
    for (std::size_t step = 0; step < step_count; ++step) {
        arm.go_to(step);
        pass();
    }
    return watch.nanoseconds() / 1000 / static_cast<double>(step_count);
}

}  // namespace

SuiteResult run_arm(const SuiteOptions& options) {
    const std::size_t step_count = options.is_quick() ? 20 : 3000, judged_count = options.is_quick() ? 1 : 10;
    SuiteResult result;
    Arm arm;
    OwnLoop loop;
    OfWorld world(arm);
    QueryCounts counts;
    std::size_t wrong = 0;
    for (std::size_t step = 0; step < step_count; ++step) {
        arm.go_to(step);
        const double found = world.ask(arm, &counts);
        const bool is_judged = step % (step_count / judged_count) == 0;
        wrong += is_judged ? found != true_least(arm) : found > 0 && found != loop.ask(arm);
    }
    std::vector<double> loop_us, world_us;
    for (std::size_t repetition = 0; repetition < options.repetition_count; ++repetition) {
        loop_us.push_back(microseconds_a_step(arm, step_count, [&] { loop.ask(arm); }));
        world_us.push_back(microseconds_a_step(arm, step_count, [&] { world.ask(arm); }));
    }
    Table table{.title = "An arm of 6 links and 21 obstacles: the closest pair and its points at each step",
                .header = {"how", "us/step", "pairs asked", "of loop", "wrong"}};
    table.notes = {medians_of(options.repetition_count) + ", of " + fmt::format("{}", step_count) +
                       " steps; the arm's kinematics (half a microsecond) are inside. Loop: distance() of all pairs "
                       "with a witness each, then signed_distance() of the closest one.",
                   fmt::format("World: set_poses() and closest_pair() of two groups. Wrong: of {} steps the oracle's "
                               "least distance, of the others the loop's, where it is positive.",
                               judged_count)};
    const double asked = static_cast<double>(counts.queries) / static_cast<double>(step_count);
    table.rows.push_back({"loop with witnesses", fmt::format("{:.2f}", median(loop_us)),
                          fmt::format("{}", link_count * obstacle_count + 1), "1", "-"});
    table.rows.push_back({"World::closest_pair", fmt::format("{:.2f}", median(world_us)), fmt::format("{:.2f}", asked),
                          share_text(world_us, loop_us), fmt::format("{}", wrong)});
    result.is_right = wrong == 0;
    print(table);
    result.sections.push_back({"An arm among obstacles", {}, {table}, {}});
    return result;
}

}  // namespace ecods::bench
