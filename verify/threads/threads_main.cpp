// Shapes shared by threads that ask first of all and all at once; worlds with several workers; questions to a const
// world. The thread sanitizer ends the program where two threads meet; a wrong answer ends it, too. What it prints is
// the same for every instruction set.
#include <atomic>
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <functional>
#include <optional>
#include <sstream>
#include <thread>
#include <vector>

#include "ecods/ecods.hpp"
#include "environment/instruction_sets.hpp"

namespace {

using namespace ecods;

// A wavy disc: enough triangles for a tree of three levels.
std::shared_ptr<const Mesh> make_mesh() {
    constexpr std::uint32_t side = 24;
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
    for (std::uint32_t i = 0; i <= side; ++i) {
        for (std::uint32_t j = 0; j <= side; ++j) {
            const double x = i / 12.0 - 1, y = j / 12.0 - 1;
            vertices.emplace_back(x, y, 0.25 * std::sin(3 * x) * std::cos(2 * y));
            if (i == side || j == side) continue;
            const std::uint32_t at = i * (side + 1) + j;
            triangles.push_back({at, at + 1, at + side + 1});
            triangles.push_back({at + 1, at + side + 2, at + side + 1});
        }
    }
    return Mesh::create(std::move(vertices), std::move(triangles));
}

Pose pose_of(int i) {
    Pose pose;
    const double angle = 0.7 * i;
    pose.R << std::cos(angle), -std::sin(angle), 0, std::sin(angle), std::cos(angle), 0, 0, 0, 1;
    pose.t = Vec3(0.9 * (i % 5), 0.9 * (i / 5 % 5), 0.2 * (i % 3));
    return pose;
}

void run_in_threads(int count, const std::function<void(int)>& work) {
    std::vector<std::thread> threads;
    for (int i = 0; i < count; ++i) threads.emplace_back(work, i);
    for (std::thread& thread : threads) thread.join();
}

class Workers final : public Executor {
  public:
    explicit Workers(std::size_t count) : count_(count) {}
    std::size_t worker_count() const noexcept override { return count_; }
    void run(std::size_t task_count, const std::function<void(std::size_t, std::size_t)>& task) override {
        std::atomic<std::size_t> next = 0;
        run_in_threads(static_cast<int>(count_), [&](int worker) {
            for (std::size_t i = next++; i < task_count; i = next++) task(i, static_cast<std::size_t>(worker));
        });
    }

  private:
    std::size_t count_;
};

bool shared_shapes_answer_alike() {
    const MeshShape a(make_mesh()), b(make_mesh());
    std::atomic<int> wrong = 0;
    std::vector<std::vector<TrianglePair>> first(25);
    QueryMemory memory;
    const MeshShape c(make_mesh()), d(make_mesh());
    for (int i = 0; i < 25; ++i)
        first[static_cast<std::size_t>(i)] = intersecting_triangles({c, pose_of(0)}, {d, pose_of(i)}, memory);
    run_in_threads(4, [&](int) {
        QueryMemory given;
        const Pose pose_a = pose_of(0);
        for (int i = 0; i < 25; ++i) {
            const Pose pose_b = pose_of(i);
            const auto& expected = first[static_cast<std::size_t>(i)];
            if (intersecting_triangles({a, pose_a}, {b, pose_b}, given) != expected) ++wrong;
            if (intersects({a, pose_a}, {b, pose_b}) == expected.empty()) ++wrong;
            if (!contains(a.box(pose_b), Aabb{pose_b.t, pose_b.t})) ++wrong;
        }
    });
    return wrong == 0;
}

// What one world says to questions that go through all of it, as a number.
std::uint64_t answers_of(const World& world, const std::vector<BodyId>& bodies, const Ask& ask) {
    std::uint64_t sum = 0;
    const auto add = [&](std::uint64_t word) { sum = 31 * sum + word; };
    for (int i = 0; i < 4; ++i) {
        const Vec3 from(0.3 * i - 1, 0.4 * i - 1, 3), to(2, 0.3 * i, -3);
        const auto hit = world.first_hit(Segment{from, to}, {}, ask);
        add(hit ? hit->body.slot + 64 * hit->hit.triangle() : 0);
        add(world.all_hits(Ray{from, to - from}, {}, ask).size());
        const BodyId body = bodies[static_cast<std::size_t>(i)];
        const auto met = world.cast(body, Vec3(0.25 * i, 1, 0), 1, ask);
        add(met ? met->body.slot : 0);
        const auto turned = world.cast(body, Turn{{1, 0, 0, 0.25 * i}, Vec3::Zero(), to}, 1, ask);
        add(turned ? turned->body.slot : 0);
        add(world.meetings({&body, 1}, std::vector<Motion>{Translation{to}}, ask).size());
        add(world.nearest(body, World::no_limit, ask)->body.slot);
        add(world.intersecting_bodies({world.shape(body), pose_of(i + 3)}, ask).size());
        add(world.intersecting_triangles(body, {world.shape(body), pose_of(i + 1)}, ask).size());
        add(world.meetings({&body, 1}, std::vector{pose_of(i + 5)}, ask).size());
    }
    PairWitness witness;
    const Posed<MeshShape> first(static_cast<const MeshShape&>(*world.shape(bodies[0])), world.pose(bodies[0]));
    const Posed<MeshShape> second(static_cast<const MeshShape&>(*world.shape(bodies[1])), world.pose(bodies[1]));
    for (int i = 0; i < 4; ++i) {  // small steps of one segment
        const Segment step{{0.01 * i, 0.2, 3}, {0.2, 0.3, -3}};
        const auto hit =
            ask.memory != nullptr ? first_hit(step, first, {*ask.memory, witness}) : first_hit(step, first);
        add(hit ? hit->triangle() + 1 : 0);
    }
    add(certify_distance(first, second, ask).step_count() > 0);
    return sum;
}

// A const world is asked by threads, first of all after its bodies moved: what it has to bring up to date for questions
// is brought up to date by one of them. Half of them give a memory; the questions of the others are written into a
// trace.
bool questions_answer_alike() {
    World world, other;
    std::vector<BodyId> bodies, of_other;
    std::ostringstream trace;
    world.trace_to(trace, {.questions = true});
    for (int i = 0; i < 60; ++i) bodies.push_back(world.create_body(make_mesh(), pose_of(i)));
    for (int i = 0; i < 60; ++i) of_other.push_back(other.create_body(make_mesh(), pose_of(i)));
    std::atomic<int> wrong = 0;
    for (int frame = 0; frame < 2; ++frame) {
        world.update();
        other.update();
        for (int i = frame; i < 60; i += 20) {
            world.set_pose(bodies[static_cast<std::size_t>(i)], pose_of(i + frame));
            other.set_pose(of_other[static_cast<std::size_t>(i)], pose_of(i + frame));
        }
        QueryMemory memory;
        const std::uint64_t expected = answers_of(other, of_other, memory);
        const World& same = world;
        run_in_threads(4, [&](int i) {
            QueryMemory given;
            if (answers_of(same, bodies, i % 2 == 0 ? Ask(given) : Ask()) != expected) ++wrong;
        });
    }
    world.end_trace();
    std::istringstream in(trace.str());
    const ReplayReport report = replay(in);
    // Two frames, two threads and four bodies: two questions about a line each, two casts, the nearest body, meetings
    // of poses and of motions.
    return wrong == 0 && !report.difference && report.question_count == 2 * 2 * 4 * 7;
}

// Questions that an executor runs are asked by threads at once, beside others that give a memory.
bool depths_answer_alike() {
    World world({.executor = std::make_shared<Workers>(2)});
    const auto solid = std::make_shared<const ConvexSolid>(make_mesh()->vertices());
    for (int i = 0; i < 60; ++i) world.create_body(solid, pose_of(i));
    const World& same = world;
    QueryCounts counts;
    const auto expected = same.depths(counts);
    std::atomic<int> wrong = 0;
    run_in_threads(4, [&](int i) {
        QueryMemory given;
        QueryCounts own;
        if (same.depths(i % 2 == 0 ? Ask(given, own) : Ask(own)) != expected || own != counts) ++wrong;
        if (same.signed_distances(0.25, own).size() < expected.size()) ++wrong;
    });
    return wrong == 0 && expected.size() > 60;
}

// One digest for each world, of all its frames: none if they differ.
std::optional<std::uint64_t> digest_of_worlds() {
    const auto mesh = make_mesh();
    std::vector<std::uint64_t> digests;
    for (const std::size_t count : {1, 2, 4}) {
        constexpr BroadPhaseKind kinds[] = {BroadPhaseKind::brute_force, BroadPhaseKind::sweep_and_prune,
                                            BroadPhaseKind::kept_candidates};
        World world({.broad_phase = kinds[count / 2], .executor = std::make_shared<Workers>(count)});
        std::uint64_t digest = 0;
        std::vector<BodyId> bodies;
        for (int i = 0; i < 60; ++i) bodies.push_back(world.create_body(mesh, pose_of(i)));
        for (int frame = 0; frame < 4; ++frame) {
            for (int i = 0; i < 60; i += 1 + frame)
                world.set_pose(bodies[static_cast<std::size_t>(i)], pose_of(i + 7 * frame));
            world.update();
            digest = digest * 31 + world.digest();
        }
        const World& same = world;
        run_in_threads(4, [&](int i) {
            same.pose(bodies[static_cast<std::size_t>(i)]);
            same.colliding_pairs();
            same.digest();
            same.statistics();
        });
        digests.push_back(digest);
    }
    if (digests[0] != digests[1] || digests[0] != digests[2]) return std::nullopt;
    return digests[0];
}

}  // namespace

int main() {
    environment::limit_by_variable_or_exit();
    const bool shapes = shared_shapes_answer_alike();
    const bool questions = questions_answer_alike() && depths_answer_alike();
    const auto worlds = digest_of_worlds();
    std::printf("shapes %s, questions %s, worlds %s", shapes ? "ok" : "WRONG", questions ? "ok" : "WRONG",
                worlds ? "ok" : "WRONG");
    std::printf(", digest %016" PRIx64 "\n", worlds.value_or(0));
    return shapes && questions && worlds ? 0 : 1;
}
