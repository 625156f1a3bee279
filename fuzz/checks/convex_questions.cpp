#include "fuzz/checks/convex_questions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "ecods/distance.hpp"
#include "ecods/error.hpp"
#include "ecods/solid.hpp"
#include "fuzz/base/failure.hpp"
#include "fuzz/checks/text.hpp"
#include "fuzz/checks/truth.hpp"
#include "judge/convex_truth.hpp"
#include "scenes/numbers_of.hpp"
#include "scenes/random.hpp"

namespace ecods::fuzz {
namespace {

// Of more bodies, asking all pairs takes long.
constexpr std::size_t few = 40;

std::shared_ptr<const ConvexSolid> convex_of(const World& world, BodyId body) {
    return std::dynamic_pointer_cast<const ConvexSolid>(world.shape(body));
}

// Two bodies, by numbers, their distance, and how deep they are if that is 0.
struct Answer {
    BodyPair bodies;
    double distance = 0;
    std::optional<Depth> depth = {};

    friend bool operator==(const Answer&, const Answer&) = default;
};

std::string text(const Answer& answer) {
    std::string result = fuzz::text(answer.bodies) + fmt::format(" {:a}", answer.distance);
    return answer.depth ? result + " deep " + judge::text(*answer.depth) : result;
}

void require_same(const char* check, const std::vector<Answer>& got, const std::vector<Answer>& expected) {
    if (got != expected) throw CheckFailed(check, fuzz::text(expected), fuzz::text(got));
}

// Of all pairs that are not filtered out; nothing if a body's pose is singular, which all questions must then name.
std::optional<std::vector<Answer>> ask_one_by_one(const World& world) {
    std::vector<Answer> result;
    QueryMemory memory;
    std::vector<BodyId> bodies = world.bodies();
    std::erase_if(bodies, [&](BodyId body) { return !convex_of(world, body); });
    for (const BodyId body : bodies) {
        const Mat3 R = world.pose(body).R;
        if (orient3d(Vec3::Zero(), R.col(0), R.col(1), R.col(2)) == Sign::zero) return std::nullopt;
    }
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const auto a = convex_of(world, bodies[i]);
        for (std::size_t j = i + 1; j < bodies.size(); ++j) {
            if (!may_meet(world, bodies[i], bodies[j])) continue;
            const auto b = convex_of(world, bodies[j]);
            const Posed<ConvexSolid> first{*a, world.pose(bodies[i])}, second{*b, world.pose(bodies[j])};
            Answer& answer = result.emplace_back(
                Answer{{numbers_of(bodies[i]), numbers_of(bodies[j])}, ecods::distance(first, second, memory)});
            if (answer.distance == 0) answer.depth = depth(first, second, memory);
        }
    }
    return result;
}

void require_singular(World& world) {
    bool is_named = false;
    try {
        std::ignore = world.depths();
    } catch (const SingularPose& error) {
        is_named = convex_of(world, error.body) != nullptr;
    }
    if (!is_named) throw CheckFailed("distances of convex solids", "SingularPose of a body", "something else");
}

// Where the rounded distance is the limit, the real one decides, which is not known here.
void check_limit(World& world, double limit, std::vector<Answer> expected) {
    std::vector<Answer> got;
    for (const PairDistance& pair : world.signed_distances(limit)) {
        if (!convex_of(world, pair.bodies.a) || !convex_of(world, pair.bodies.b)) continue;
        got.push_back({{numbers_of(pair.bodies.a), numbers_of(pair.bodies.b)}, pair.distance});
    }
    std::erase_if(expected, [&](const Answer& answer) { return answer.distance > limit; });
    for (Answer& answer : expected) {
        if (answer.depth && answer.depth->depth > 0) answer.distance = -answer.depth->depth;
        answer.depth.reset();
    }
    const auto is_open = [&](const Answer& answer) { return limit > 0 && answer.distance == limit; };
    std::erase_if(expected, is_open);
    std::erase_if(got, is_open);
    require_same("distances of convex solids", got, expected);
}

// Depths of rounded bodies have tests of their own; a rounded body under a singular pose may end the question.
void check_depths(World& world, std::vector<Answer> expected) {
    std::vector<BodyDepth> depths;
    try {
        depths = world.depths();
    } catch (const SingularPose& error) {
        if (convex_of(world, error.body)) throw;
        return;
    }
    std::vector<Answer> got;
    for (const BodyDepth& pair : depths) {
        if (!convex_of(world, pair.bodies.a) || !convex_of(world, pair.bodies.b)) continue;
        got.push_back({{numbers_of(pair.bodies.a), numbers_of(pair.bodies.b)}, 0, pair.depth});
    }
    std::erase_if(expected, [](const Answer& answer) { return !answer.depth; });
    require_same("depths of convex solids", got, expected);
}

// In both orders.
void check_pair(World& world, const Answer& expected) {
    const auto [a, b] = expected.bodies;
    Answer got{expected.bodies, world.distance(b, a)};
    if (got.distance == 0) got.depth = world.depth(a, b);
    require_same("a pair of convex solids", {got}, {expected});
    const auto at = [&](BodyId body) { return ecods::Asked(world.shape(body), world.pose(body)); };
    Answer of_shapes{expected.bodies, world.distance(at(a), b)};
    if (got.distance == 0) of_shapes.depth = world.depth(at(a), at(b));
    require_same("a pair of convex solids that are no bodies", {of_shapes}, {expected});
    const auto closest = world.closest(b, a), swapped = world.closest(a, b);
    const bool is_same = (closest.kind < ClosestKind::intersecting) == (expected.distance > 0) &&
                         swapped.kind == closest.kind && closest.distance == expected.distance &&
                         closest.point_a == swapped.point_b && closest.a == swapped.b;
    if (!is_same) throw CheckFailed("where two convex solids are closest", text(expected), "another distance");
    const SignedDistance to_b = world.signed_distance(a, b), to_a = world.signed_distance(b, a);
    const double wanted = expected.depth && expected.depth->depth > 0 ? -expected.depth->depth : expected.distance;
    const bool is_mirrored = to_a.distance == to_b.distance && to_a.kind == to_b.kind && to_a.a == to_b.b &&
                             to_a.b == to_b.a && to_a.point_a == to_b.point_b && to_a.point_b == to_b.point_a &&
                             to_a.direction == -to_b.direction;
    const bool is_found = to_b.distance == wanted && (expected.depth ? to_b.direction == expected.depth->direction
                                                                     : to_b.point_a == swapped.point_a);
    if (!is_mirrored || !is_found) {
        throw CheckFailed("a signed distance", text(expected), judge::text(to_b) + " and " + judge::text(to_a));
    }
    if (!expected.depth) return;
    const Depth back = world.depth(b, a).value();
    const bool is_opposite = back.depth == expected.depth->depth && back.a == expected.depth->b &&
                             back.b == expected.depth->a && back.direction == -expected.depth->direction;
    if (!is_opposite) throw CheckFailed("a depth, swapped", text(expected), text(Answer{expected.bodies, 0, back}));
}

}  // namespace

void check_convex(std::span<World* const> worlds, std::uint32_t seed, Counters& counters) {
    const World& first = *worlds.front();
    const auto bodies = first.bodies();
    const bool has_convex = std::ranges::any_of(bodies, [&](BodyId body) { return convex_of(first, body) != nullptr; });
    if (!has_convex || bodies.size() > few) return;
    const auto expected = ask_one_by_one(first);
    scenes::Random random(seed);
    double limit = 0;
    if (expected && !expected->empty()) {
        limit = (*expected)[random.below(static_cast<std::uint32_t>(expected->size()))].distance;
    }
    for (World* world : worlds) {
        if (!expected) {
            require_singular(*world);
            continue;
        }
        check_depths(*world, *expected);
        for (const double d : {0.0, limit, std::nextafter(limit, 0), std::numeric_limits<double>::infinity()}) {
            check_limit(*world, d, *expected);
        }
        if (!expected->empty()) {
            check_pair(*world, (*expected)[random.below(static_cast<std::uint32_t>(expected->size()))]);
        }
    }
    if (!expected) return;
    ++counters["checked: depths and distances of all convex solids"];
    counters["convex solids: apart"] += static_cast<std::uint64_t>(
        std::ranges::count_if(*expected, [](const Answer& answer) { return !answer.depth; }));
    counters["convex solids: deep"] += static_cast<std::uint64_t>(
        std::ranges::count_if(*expected, [](const Answer& answer) { return answer.depth.has_value(); }));
}

}  // namespace ecods::fuzz
