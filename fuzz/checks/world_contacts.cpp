// Worlds of meshes: what is entered first, where bodies first touch, and what a deforming mesh meets first, as asking
// body by body says.
#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <vector>

#include "ecods/cast.hpp"
#include "ecods/contact.hpp"
#include "fuzz/base/failure.hpp"
#include "fuzz/checks/contact_questions.hpp"
#include "fuzz/checks/text.hpp"
#include "fuzz/checks/truth.hpp"
#include "fuzz/checks/way_bodies.hpp"
#include "scenes/numbers_of.hpp"

namespace ecods::fuzz {
namespace {

// Up to max_time; nothing where it is not supported.
std::optional<std::optional<BodyEntry>> entry_of_each(const World& world, BodyId own, const Vec3& motion,
                                                      double max_time, QueryMemory& memory) {
    std::optional<BodyEntry> first;
    for (const BodyId body : world.bodies()) {
        if (numbers_of(body) == own || !may_meet(world, own, body)) continue;
        try {
            const auto found = entering(mesh_at(world, own), motion, mesh_at(world, body), max_time, memory);
            if (found && (!first || found->time < first->entry.time)) first = BodyEntry{body, *found};
        } catch (const NotSupported&) {
            return std::nullopt;
        }
    }
    return first;
}

void check_entering_of_world(const World& world, BodyId own, const Vec3& motion, QueryMemory& memory,
                             Counters& counters) {
    const auto whole = entry_of_each(world, own, motion, 1, memory);
    if (!whole) return;
    std::vector<double> limits{1, 0.5, 0};
    if (*whole) limits.insert(limits.end(), {(*whole)->entry.time, std::nextafter((*whole)->entry.time, 2)});
    for (const double limit : limits) {
        const std::optional<BodyEntry> expected = *entry_of_each(world, own, motion, limit, memory);
        const auto got = world.entering(own, motion, limit, memory);
        if (got == expected) continue;
        throw CheckFailed(fmt::format("first body entered before {:a}", limit),
                          expected ? text(expected->body) : "none", got ? text(got->body) : "none");
    }
    ++counters["checked: first bodies entered in worlds"];
}

void check_deforming_of_world(const World& world, BodyId own, const Vec3& motion, scenes::Random& random,
                              QueryMemory& memory, Counters& counters) {
    const auto bodies = world.bodies();
    if (!are_soon_asked(world, bodies, 8) || !have_moderate_numbers(world, bodies)) return;
    const auto mesh = deformed(mesh_at(world, own), motion, random);
    if (!mesh) return;
    std::optional<CollisionFilter> filter;
    if (random.below(4) == 0) filter = CollisionFilter{.groups = 1, .mask = 2};
    const double max_time = random.below(2) == 0 ? 1 : random.uniform(0, 1);
    std::optional<BodyContact> expected;
    for (const BodyId body : bodies) {
        if (filter && !ecods::may_meet(*filter, world.filter(body))) continue;
        const auto contact = cast(*mesh, mesh_at(world, body), max_time, memory);
        if (contact && (!expected || contact->time < expected->contact.time)) expected = BodyContact{body, *contact};
    }
    const auto got = world.cast(*mesh, max_time, filter, memory);
    if (got != expected) throw CheckFailed("first body that a deforming mesh meets", text(expected), text(got));
    ++counters["checked: casts of deforming meshes in worlds"];
}

}  // namespace

void check_contacts_of_world(const World& world, BodyId own, const Vec3& motion, scenes::Random& random,
                             QueryMemory& memory, Counters& counters) {
    check_entering_of_world(world, own, motion, memory, counters);
    check_deforming_of_world(world, own, motion, random, memory, counters);
    const auto met = world.cast(own, motion, 1, memory);
    if (!met) return;
    const ContactPoint of_world = world.contact_point(own, motion, *met, memory);
    if (of_world != contact_point(mesh_at(world, own), motion, mesh_at(world, met->body), met->contact, memory)) {
        throw CheckFailed("point of a first contact in a world", "that of two bodies", judge::text(of_world.point));
    }
}

}  // namespace ecods::fuzz
