// How questions are asked: no answer depends on a memory, a witness or counts, and counts are those of the memory.
#include "ecods/ask.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <optional>
#include <thread>
#include <tuple>
#include <vector>

#include "ecods/cast.hpp"
#include "ecods/certificate.hpp"
#include "ecods/distance.hpp"
#include "ecods/error.hpp"
#include "ecods/hit.hpp"
#include "ecods/intersection.hpp"
#include "ecods/solid.hpp"
#include "scenes/expect_invalid.hpp"
#include "scenes/pose_at.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"

namespace ecods::ask_test {
namespace {

// Two bodies of convex solids, so that every question takes them.
struct Bodies {
    std::shared_ptr<const ConvexSolid> first = std::make_shared<const ConvexSolid>(scenes::sphere(12, 8)->vertices());
    std::shared_ptr<const ConvexSolid> second = std::make_shared<const ConvexSolid>(scenes::cube(0.5));
    Pose pose;

    Posed<ConvexSolid> a() const { return {*first, Pose()}; }
    Posed<ConvexSolid> b() const { return {*second, pose}; }
    Posed<MeshShape> surface_a() const { return {surface_of(*first), Pose()}; }
    Posed<MeshShape> surface_b() const { return {surface_of(*second), pose}; }
};

// A number of each answer: those that are equal have equal numbers.
using Question = std::function<double(const Bodies&, const Ask&)>;
struct Named {
    const char* name;
    Question ask;
};

double number_of(const std::optional<FirstContact>& contact) {
    return contact ? contact->time + contact->a.triangle : -1;
}
double number_of(const std::optional<Hit>& hit) {
    return hit ? hit->parameter + hit->triangle() : -1;
}

const Segment through{Vec3(-3, 0.125, 0.25), Vec3(3, -0.125, -0.25)};
const Ray along{through.a, through.b - through.a};
const Vec3 motion(-2, 0.25, 0.125);

const std::vector<Named>& questions() {
    static const std::vector<Named> all = {
        {"intersects", [](const Bodies& p, const Ask& ask) { return intersects(p.a(), p.b(), ask); }},
        {"relation", [](const Bodies& p, const Ask& ask) { return static_cast<double>(relation(p.a(), p.b(), ask)); }},
        {"intersecting_triangles",
         [](const Bodies& p, const Ask& ask) {
             return static_cast<double>(intersecting_triangles(p.a(), p.b(), ask).size());
         }},
        {"intersections",
         [](const Bodies& p, const Ask& ask) { return static_cast<double>(intersections(p.a(), p.b(), ask).size()); }},
        {"distance", [](const Bodies& p, const Ask& ask) { return distance(p.a(), p.b(), ask); }},
        {"within", [](const Bodies& p, const Ask& ask) { return within(p.a(), p.b(), 0.25, ask); }},
        {"closest", [](const Bodies& p, const Ask& ask) { return closest(p.a(), p.b(), ask).point_a[0]; }},
        // Which bounds they are may depend on all of it.
        {"distance_bounds",
         [](const Bodies& p, const Ask& ask) {
             const double truth = distance(p.a(), p.b());
             const DistanceBounds bounds = distance_bounds(p.a(), p.b(), {.relative = 0x1p-20}, ask);
             return bounds.lower <= truth && truth <= bounds.upper;
         }},
        {"close_triangles",
         [](const Bodies& p, const Ask& ask) {
             return static_cast<double>(close_triangles(p.a(), p.b(), 0.25, ask).size());
         }},
        {"close_features",
         [](const Bodies& p, const Ask& ask) {
             return static_cast<double>(close_features(p.a(), p.b(), 0.25, ask).size());
         }},
        {"first_hit of a segment",
         [](const Bodies& p, const Ask& ask) { return number_of(first_hit(through, p.b(), ask)); }},
        {"first_hit of a ray", [](const Bodies& p, const Ask& ask) { return number_of(first_hit(along, p.b(), ask)); }},
        {"all_hits of a segment",
         [](const Bodies& p, const Ask& ask) { return static_cast<double>(all_hits(through, p.b(), ask).size()); }},
        {"all_hits of a ray",
         [](const Bodies& p, const Ask& ask) { return static_cast<double>(all_hits(along, p.b(), ask).size()); }},
        {"cast of a translation",
         [](const Bodies& p, const Ask& ask) { return number_of(cast(p.b(), motion, p.a(), 1, ask)); }},
        {"cast between poses",
         [](const Bodies& p, const Ask& ask) {
             const Pose to{Mat3::Identity(), p.pose.t + motion};
             return number_of(cast(Moving<MeshShape>(*p.second, p.pose, to), {*p.first, Pose(), Pose()}, 1, ask));
         }},
        {"locate",
         [](const Bodies& p, const Ask& ask) {
             return static_cast<double>(locate({0.75, 0, 0}, p.b(), ask).side);
         }},
        {"relation of a surface",
         [](const Bodies& p, const Ask& ask) {
             const Posed<MeshShape> surface(*surface_of(*p.first), Pose());
             return static_cast<double>(relation(surface, p.b(), ask)) + intersects(surface, p.b(), ask);
         }},
        {"closest to a surface",
         [](const Bodies& p, const Ask& ask) {
             const ClosestPoints points = closest(p.a(), {*surface_of(*p.second), p.pose}, ask);
             return points.point_b[1] + static_cast<double>(points.kind);
         }},
        {"depth",
         [](const Bodies& p, const Ask& ask) {
             const auto found = depth(p.a(), p.b(), ask);
             return found ? found->depth : -1;
         }},
        {"depth_bounds",
         [](const Bodies& p, const Ask& ask) {
             const auto bounds = depth_bounds(p.a(), p.b(), ask);
             return bounds ? bounds->lower : -1;
         }},
        {"certify",
         [](const Bodies& p, const Ask& ask) {
             return static_cast<double>(certify(p.surface_a(), p.surface_b(), ask).claim());
         }},
        {"certify_distance",
         [](const Bodies& p, const Ask& ask) { return certify_distance(p.surface_a(), p.surface_b(), ask).value(); }},
        {"certify_within",
         [](const Bodies& p, const Ask& ask) {
             return static_cast<double>(certify_within(p.surface_a(), p.surface_b(), 0.25, ask).claim());
         }},
        {"certify_hit",
         [](const Bodies& p, const Ask& ask) { return certify_hit(through, p.surface_b(), ask).value(); }},
    };
    return all;
}

std::vector<Pose> poses() {
    scenes::Random random(17);
    std::vector<Pose> all = {at(0), at(1.5), at(0.5, 0.25, 0.125), at(4, 1, 1)};
    for (int i = 0; i < 12; ++i) {
        all.push_back({random.rotation().toRotationMatrix(), random.uniform(0, 2) * random.direction()});
    }
    return all;
}

// In a given memory and in the thread's own; with a witness that others left, and with one of nonsense.
TEST(AskTest, NoAnswerDependsOnHowItIsAsked) {
    Bodies bodies;
    QueryMemory used;
    for (const Named& question : questions()) {
        PairWitness kept;
        for (const Pose& pose : poses()) {
            SCOPED_TRACE(question.name);
            bodies.pose = pose;
            QueryMemory fresh;
            QueryCounts counts;
            PairWitness nonsense{7, 100'000};
            const double expected = question.ask(bodies, fresh);
            EXPECT_EQ(question.ask(bodies, {}), expected);
            EXPECT_EQ(question.ask(bodies, used), expected);
            EXPECT_EQ(question.ask(bodies, counts), expected);
            EXPECT_EQ(question.ask(bodies, kept), expected);
            EXPECT_EQ(question.ask(bodies, kept), expected) << "with the witness that was just left";
            EXPECT_EQ(question.ask(bodies, {kept, counts, used}), expected);
            EXPECT_EQ(question.ask(bodies, {used, nonsense}), expected);
        }
    }
}

// In a new thread's own memory counts are those of a new memory. In one that has counts of other questions, these are
// not counted again.
TEST(AskTest, CountsAreTheWorkOfTheQuestion) {
    Bodies bodies;
    QueryMemory used;
    QueryCounts sum, all;
    for (const Named& question : questions()) {
        for (const Pose& pose : poses()) {
            SCOPED_TRACE(question.name);
            bodies.pose = pose;
            QueryMemory fresh;
            QueryCounts in_own, in_memory, expected = used.counts();
            std::ignore = question.ask(bodies, fresh);
            std::jthread([&] { std::ignore = question.ask(bodies, in_own); }).join();
            EXPECT_EQ(in_own, fresh.counts());
            std::ignore = question.ask(bodies, {used, in_memory});
            expected += in_memory;
            EXPECT_EQ(used.counts(), expected);
            std::ignore = question.ask(bodies, {used, sum});
            all = used.counts();
        }
    }
    EXPECT_GT(sum.queries, poses().size());
    EXPECT_GT(sum.stages.triangle_tests, 0u);
    EXPECT_GT(sum.distances.triangle_bounds, 0u);
    EXPECT_GT(sum.hits.triangle_tests, 0u);
    EXPECT_GT(sum.casts.enclosures, 0u);
    EXPECT_LT(sum.queries, all.queries);
}

TEST(AskTest, AWitnessIsLeftInTheThreadsOwnMemory) {
    const Bodies bodies{.pose = at(4)};
    QueryMemory memory;
    PairWitness in_own, in_memory;
    std::ignore = distance(bodies.a(), bodies.b(), in_own);
    std::ignore = distance(bodies.a(), bodies.b(), {memory, in_memory});
    EXPECT_NE(in_own.a, PairWitness::none);
    EXPECT_EQ(in_own.a, in_memory.a);
    EXPECT_EQ(in_own.b, in_memory.b);
    QueryCounts counts;
    std::ignore = intersects(bodies.a(), bodies.b(), in_own);
    std::ignore = intersects(bodies.a(), bodies.b(), {counts, in_own});
    EXPECT_EQ(counts.queries, 1u);
    EXPECT_EQ(counts.witness_hits, 1u);
}

// References in any order, each where it belongs; none is null.
TEST(AskTest, IsMadeOfReferencesInAnyOrder) {
    QueryMemory memory;
    PairWitness witness;
    QueryCounts counts;
    for (const Ask& ask : {Ask(memory, witness, counts), Ask(counts, memory, witness), Ask(witness, counts, memory)}) {
        EXPECT_EQ(ask.memory, &memory);
        EXPECT_EQ(ask.witness, &witness);
        EXPECT_EQ(ask.counts, &counts);
    }
    const Ask none, one(counts);
    EXPECT_EQ(none.memory, nullptr);
    EXPECT_EQ(none.witness, nullptr);
    EXPECT_EQ(none.counts, nullptr);
    EXPECT_EQ(one.memory, nullptr);
    EXPECT_EQ(one.counts, &counts);
}

// What was refused or thrown leaves the thread's own memory as good as it was.
TEST(AskTest, AQuestionThatThrowsGivesItsMemoryBack) {
    const Bodies bodies{.pose = at(0.5, 0.25, 0.125)};
    const double expected = depth(bodies.a(), bodies.b()).value().depth;
    for (int i = 0; i < 5; ++i) {
        QueryCounts counts;
        EXPECT_INVALID(within(bodies.a(), bodies.b(), -1, counts), Argument::distance);
        Pose flat;
        flat.R.setZero();
        EXPECT_THROW(static_cast<void>(depth(bodies.a(), {*bodies.second, flat}, counts)), SingularPose);
        EXPECT_EQ(depth(bodies.a(), bodies.b(), counts).value().depth, expected);
        QueryCounts of_one;
        EXPECT_TRUE(intersects(bodies.a(), bodies.b(), of_one));
        EXPECT_EQ(of_one.queries, 1u);
    }
}

// Each thread has memories of its own.
TEST(AskTest, ManyThreadsAskInTheirOwnMemories) {
    const auto answers_of_all = [] {
        std::vector<double> answers;
        Bodies bodies;
        for (const Named& question : questions()) {
            for (const Pose& pose : poses()) {
                bodies.pose = pose;
                answers.push_back(question.ask(bodies, {}));
            }
        }
        return answers;
    };
    const std::vector<double> expected = answers_of_all();
    std::vector<std::vector<double>> answers(4);
    {
        std::vector<std::jthread> threads;
        for (auto& own : answers) threads.emplace_back([&] { own = answers_of_all(); });
    }
    for (const auto& own : answers) EXPECT_EQ(own, expected);
}

// An object of the thread's that is destroyed after the memories, as it was made before them.
struct AsksAtTheEnd {
    const Bodies* bodies = nullptr;
    double* answer = nullptr;
    QueryCounts* counts = nullptr;

    ~AsksAtTheEnd() {
        if (bodies == nullptr) return;
        *answer = distance(bodies->a(), bodies->b(), *counts) + distance(bodies->a(), bodies->b());
    }
};

TEST(AskTest, AThreadMayAskUntilItsVeryEnd) {
    const Bodies bodies{.pose = at(4, 1, 1)};
    const double expected = distance(bodies.a(), bodies.b());
    double first = 0, last = 0;
    QueryCounts counts;
    std::thread thread([&] {
        thread_local AsksAtTheEnd at_the_end;
        at_the_end.bodies = &bodies;
        at_the_end.answer = &last;
        at_the_end.counts = &counts;
        first = distance(bodies.a(), bodies.b());
    });
    thread.join();
    EXPECT_EQ(first, expected);
    EXPECT_EQ(last, 2 * expected);
    EXPECT_EQ(counts.queries, 1u);
}

}  // namespace
}  // namespace ecods::ask_test
