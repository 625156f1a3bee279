#include "fuzz/checks/solid_questions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "fuzz/base/failure.hpp"
#include "fuzz/base/mesh_form.hpp"
#include "fuzz/checks/text.hpp"
#include "scenes/numbers_of.hpp"
#include "scenes/random.hpp"

namespace ecods::fuzz {
namespace {

// The oracle cuts all triangles along the planes of the others, in rationals.
constexpr std::size_t triangle_pairs_max = 700;
// Of more bodies, asking all pairs takes long.
constexpr std::size_t few = 40;

std::shared_ptr<const Solid> solid_of(const World& world, BodyId body) {
    return std::dynamic_pointer_cast<const Solid>(world.shape(body));
}

std::string text_of(const BodiesContaining& found) {
    return fmt::format("{}, {} are no solids", text(found.bodies), found.skipped_count);
}

std::vector<PairRelation> pairs_one_by_one(const World& world) {
    std::vector<PairRelation> result;
    QueryMemory memory;
    const auto bodies = world.bodies();
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        for (std::size_t j = i + 1; j < bodies.size(); ++j) {
            if (!may_meet(world, bodies[i], bodies[j])) continue;
            const Relation relation = world.relation(bodies[i], bodies[j], memory);
            if (relation != Relation::apart) {
                result.push_back({{numbers_of(bodies[i]), numbers_of(bodies[j])}, relation});
            }
        }
    }
    return result;
}

BodiesContaining bodies_one_by_one(const World& world, const Vec3& point) {
    BodiesContaining result;
    QueryMemory memory;
    for (const BodyId body : world.bodies()) {
        const auto solid = solid_of(world, body);
        result.skipped_count += solid == nullptr;
        if (!solid) continue;
        const Side side = locate(point, {*solid, world.pose(body)}, memory).side;
        if (side != Side::outside) result.bodies.push_back({numbers_of(body), side});
    }
    return result;
}

// A corner of the body as doubles have it, or a point of its box, or the middle of that.
Vec3 any_point(const World& world, BodyId body, scenes::Random& random) {
    const Aabb box = world.box(body);
    Vec3 point;
    for (int axis = 0; axis < 3; ++axis) {
        const std::uint32_t drawn = random.below(3);
        point[axis] = drawn == 0   ? box.min[axis]
                      : drawn == 1 ? box.max[axis]
                                   : 0.5 * box.min[axis] + 0.5 * box.max[axis];
    }
    const auto solid = solid_of(world, body);
    if (solid && random.below(2) == 0) {
        const auto vertices = solid->mesh().vertices();
        const Pose pose = world.pose(body);
        point = pose.R * vertices[random.below(static_cast<std::uint32_t>(vertices.size()))] + pose.t;
    }
    return point.allFinite() ? point : Vec3(0, 0, 0);
}

void check_point(std::span<World* const> worlds, const Vec3& point, Counters& counters) {
    const BodiesContaining expected = bodies_one_by_one(*worlds.front(), point);
    for (World* world : worlds) {
        BodiesContaining got = world->bodies_containing(point);
        for (BodyAt& at : got.bodies) at.body = numbers_of(at.body);
        if (got.bodies != expected.bodies || got.skipped_count != expected.skipped_count) {
            throw CheckFailed("bodies that contain a point", text_of(expected), text_of(got));
        }
    }
    counters["checked: bodies that contain a point"] += expected.bodies.size();
}

}  // namespace

void SolidQuestions::choose(const World& world, const Truth& truth, std::uint32_t seed) {
    chosen_.clear();
    std::vector<const TruePair*> all, changed;
    for (const TruePair& pair : truth.pairs()) {
        const auto a = solid_of(world, pair.ids.a), b = solid_of(world, pair.ids.b);
        if (!a || !b || dimension_of(*a) < 3 || dimension_of(*b) < 3) continue;
        if (a->mesh().triangles().size() * b->mesh().triangles().size() > triangle_pairs_max) continue;
        all.push_back(&pair);
        if (pair.is_changed) changed.push_back(&pair);
    }
    if (all.empty()) return;
    scenes::Random random(seed);
    const auto& from = changed.empty() ? all : changed;
    const BodyPair ids = from[random.below(static_cast<std::uint32_t>(from.size()))]->ids;
    const auto a = solid_of(world, ids.a), b = solid_of(world, ids.b);
    chosen_.push_back({a, b, judge::SolidTruth({*a, world.pose(ids.a)}, {*b, world.pose(ids.b)})});
}

void SolidQuestions::check(Counters& counters) {
    for (const Chosen& chosen : chosen_) {
        ++counters["checked: pairs of solids against the oracle"];
        ++counters["solids: " + judge::written(chosen.truth.relation())];
        const auto wrong = chosen.truth.ask(memory_);
        if (wrong) throw CheckFailed(wrong->question, wrong->expected, wrong->got);
    }
}

void check_solids(std::span<World* const> worlds, std::uint32_t seed, Counters& counters) {
    const World& first = *worlds.front();
    const auto bodies = first.bodies();
    const bool has_solids = std::ranges::any_of(bodies, [&](BodyId body) { return solid_of(first, body) != nullptr; });
    if (!has_solids || bodies.size() > few) return;
    const auto expected = first.are_relations_listed() ? pairs_one_by_one(first) : std::vector<PairRelation>();
    for (const World* world : worlds) {
        std::vector<PairRelation> got;
        for (const PairRelation& pair : world->relations()) {
            got.push_back({{numbers_of(pair.bodies.a), numbers_of(pair.bodies.b)}, pair.relation});
        }
        if (got != expected) throw CheckFailed("relations", text(expected), text(got));
    }
    counters["checked: relations in worlds"] += expected.size();
    scenes::Random random(seed);
    for (int i = 0; i < 3; ++i) {
        const BodyId body = bodies[random.below(static_cast<std::uint32_t>(bodies.size()))];
        check_point(worlds, any_point(first, body, random), counters);
    }
}

}  // namespace ecods::fuzz
