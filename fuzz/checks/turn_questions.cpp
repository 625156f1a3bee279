// A body that turns, in all worlds, while others are translated, go straight to poses, turn or rest.
#include <fmt/format.h>

#include <optional>
#include <vector>

#include "ecods/turn.hpp"
#include "fuzz/checks/truth.hpp"
#include "fuzz/checks/way_bodies.hpp"
#include "fuzz/checks/way_questions.hpp"
#include "judge/along_questions.hpp"
#include "judge/turn_truth.hpp"

namespace ecods::fuzz {
namespace {

// Exact decisions about turns that tie or graze take up to milliseconds.
constexpr std::size_t slower = 64;

// A turn, by simple numbers, about a point that bodies are near.
Turn any_turn(const World& world, const std::vector<BodyId>& bodies, scenes::Random& random) {
    const auto part = [&] { return 0.25 * random.below(9) - 1; };
    Turn turn{{part(), part(), part(), part()}, any_point(world, bodies, random), Vec3::Zero()};
    if (random.below(8) == 0) turn.q = {1, 0, 0, 0};
    if (turn.q.w <= 0 && turn.q.x == 0 && turn.q.y == 0 && turn.q.z == 0) turn.q.z = 1;
    turn.pivot_to = random.below(2) == 0 ? turn.pivot_from : any_point(world, bodies, random);
    return turn;
}

// Returns a way of a few legs, the first of which is the turn.
Along any_way(const World& world, const std::vector<BodyId>& bodies, const Turn& turn, scenes::Random& random) {
    Along along{{{{1, 0, 0, 0}, turn.pivot_from}, {turn.q, turn.pivot_to}}};
    for (auto left = 1 + random.below(3); left > 0; --left) {
        const Turn next = any_turn(world, bodies, random);
        along.nodes.push_back({next.q, random.below(2) == 0 ? along.nodes.back().pivot : next.pivot_to});
    }
    return along;
}

bool are_soon_judged(const Posed<MeshShape>& a, const Posed<MeshShape>& b) {
    constexpr std::size_t triangle_pairs_judged = 40;
    const auto count = [](const Posed<MeshShape>& body) { return body.what->mesh().triangles().size(); };
    const bool are_surfaces = a.what->form() == MeshForm::surface && b.what->form() == MeshForm::surface;
    return are_surfaces && count(a) * count(b) <= triangle_pairs_judged;
}

// A translation; or, if `may_turn`, also a turn, or the straight way to the pose of some body. Nothing if it has no
// end.
std::optional<Motion> any_motion(const World& world, const std::vector<BodyId>& bodies, bool may_turn,
                                 scenes::Random& random) {
    const Vec3 by = any_point(world, bodies, random) - any_point(world, bodies, random);
    if (!by.allFinite()) return std::nullopt;
    const auto kind = may_turn ? random.below(4) : 3;
    if (kind == 0) return any_turn(world, bodies, random);
    if (kind > 1) return Translation{by};
    return Straight{world.pose(bodies[random.below(static_cast<std::uint32_t>(bodies.size()))])};
}

// A body that turns and one at rest, judged by the oracle, where it takes no longer than the worlds.
void check_truth(const World& world, BodyId turning, const Turn& turn, BodyId other, Counters& counters) {
    const auto a = world.shape(turning), b = world.shape(other);
    const Posed<MeshShape> moved = mesh_at(*a, world.pose(turning)), rests = mesh_at(*b, world.pose(other));
    if (!are_soon_judged(moved, rests)) return;
    QueryMemory memory;
    PairWitness witness;
    const judge::TurnTruth truth({*moved.what, moved.pose, turn}, rests, 4);
    if (const auto wrong = truth.ask(memory, witness)) {
        throw CheckFailed("turn, by the oracle: " + wrong->question, wrong->expected, wrong->got);
    }
    ++counters["checked: turns, by the oracle"];
}

std::optional<BodyContact> first_met(const World& world, BodyId own, const Motion& motion, QueryMemory& memory) {
    std::optional<BodyContact> met;
    for (const BodyId body : world.bodies()) {
        if (body == own || !may_meet(world, own, body)) continue;
        const auto contact = cast(mesh_at(world, own), motion, mesh_at(world, body), Motion(), 1, memory);
        if (contact && (!met || contact->time < met->contact.time)) met = BodyContact{body, *contact};
    }
    return met;
}

void require_met(const char* what, const std::optional<BodyContact>& got, const std::optional<BodyContact>& met) {
    const bool is_same =
        got.has_value() == met.has_value() &&
        (!got || (numbers_of(got->body) == numbers_of(met->body) && got->contact.time == met->contact.time));
    if (!is_same) throw CheckFailed(what, text(met), text(got));
}

// One body goes along a way while all others rest; judged by the oracle, too, where that takes no longer.
void check_way(std::span<World* const> worlds, BodyId own, const Along& along, Counters& counters) {
    const World& first = *worlds.front();
    QueryMemory memory;
    std::optional<BodyContact> met;
    try {
        validate(along.nodes);
        met = first_met(first, own, along, memory);
    } catch (const InvalidArgument&) {  // opposite nodes
        return;
    } catch (const NotSupported&) {
        ++counters["ways that are not supported"];
        return;
    }
    for (World* world : worlds) require_met("first body met on a way", world->cast(numbers_of(own), along), met);
    ++counters["checked: ways of worlds"];
    counters["checked: bodies met on ways"] += met.has_value();
    const auto bodies = first.bodies();
    const BodyId other = met ? met->body : bodies[bodies.front() == own ? 1 : 0];
    const auto a = first.shape(own), b = first.shape(other);
    const Posed<MeshShape> moved = mesh_at(*a, first.pose(own)), rests = mesh_at(*b, first.pose(other));
    if (!are_soon_judged(moved, rests)) return;
    const Way<MeshShape> way(*moved.what, moved.pose, along.nodes);
    if (const auto wrong = judge::ask_about_along(way, rests, memory)) {
        throw CheckFailed("way, by the oracle: " + wrong->question, wrong->expected, wrong->got);
    }
    ++counters["checked: ways, by the oracle"];
}

}  // namespace

void check_turns(std::span<World* const> worlds, std::uint32_t seed, Counters& counters) {
    const World& first = *worlds.front();
    const auto bodies = first.bodies();
    if (bodies.size() < 2 || bodies.size() > very_few || !are_soon_asked(first, bodies, slower)) return;
    scenes::Random random(seed);
    const BodyId own = bodies[random.below(static_cast<std::uint32_t>(bodies.size()))];
    const Turn turn = any_turn(first, bodies, random);
    // Others move or rest. Where numbers are long, they do not turn (turn.hpp has what this costs).
    const bool may_turn = have_moderate_numbers(first, bodies);
    std::vector<BodyId> moved{numbers_of(own)};
    std::vector<Motion> motions{turn}, of_all;
    for (const BodyId body : bodies) {
        of_all.push_back(body == own ? Motion(turn) : Motion());
        if (body == own || random.below(3) != 0) continue;
        const std::optional<Motion> motion = any_motion(first, bodies, may_turn, random);
        if (!motion) continue;
        of_all.back() = *motion;
        moved.push_back(numbers_of(body));
        motions.push_back(of_all.back());
    }
    QueryMemory memory;
    std::optional<BodyContact> met;
    std::vector<Meeting> expected;
    try {
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            const auto a = first.shape(bodies[i]);
            const Posed<MeshShape> posed_a = mesh_at(*a, first.pose(bodies[i]));
            for (std::size_t j = 0; j < bodies.size(); ++j) {
                if (i == j || !may_meet(first, bodies[i], bodies[j])) continue;
                const auto b = first.shape(bodies[j]);
                const Posed<MeshShape> posed_b = mesh_at(*b, first.pose(bodies[j]));
                if (bodies[i] == own) {
                    const auto contact = cast(posed_a, turn, posed_b, Motion(), 1, memory);
                    if (contact && (!met || contact->time < met->contact.time)) met = BodyContact{bodies[j], *contact};
                }
                if (i > j) continue;
                const auto contact = cast(posed_a, of_all[i], posed_b, of_all[j], 1, memory);
                if (contact) expected.push_back({{bodies[i], bodies[j]}, *contact});
            }
        }
    } catch (const NotSupported&) {  // of a turn that is nearly a whole one, or very far (turn.hpp)
        ++counters["turns that are not supported"];
        return;
    }
    for (World* world : worlds) {
        require_met("first body that a turn meets", world->cast(numbers_of(own), turn), met);
    }
    require_meetings(worlds, expected, moved, motions);
    const BodyId other = met ? met->body : bodies[bodies.front() == own ? 1 : 0];
    if (may_meet(first, own, other)) check_truth(first, own, turn, other, counters);
    ++counters["checked: turns of worlds"];
    counters["checked: bodies met by turns"] += met.has_value();
    counters["checked: pairs that meet on any way"] += expected.size();
    if (may_turn && random.below(2) == 0) check_way(worlds, own, any_way(first, bodies, turn, random), counters);
}

}  // namespace ecods::fuzz
