#include "fuzz/checks/way_questions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>

#include "ecods/cast.hpp"
#include "ecods/contact.hpp"
#include "ecods/hit.hpp"
#include "ecods/rounded.hpp"
#include "ecods/solid.hpp"
#include "fuzz/base/failure.hpp"
#include "fuzz/checks/text.hpp"
#include "fuzz/checks/truth.hpp"
#include "fuzz/checks/way_bodies.hpp"
#include "scenes/numbers_of.hpp"
#include "scenes/random.hpp"

namespace ecods::fuzz {
namespace {

template <class Line>
std::vector<Hit> hits_of(const Line& line, const Shape& shape, const Pose& pose, QueryMemory& memory) {
    if (const auto* rounded = dynamic_cast<const Rounded*>(&shape)) return rounded->all_hits(line, pose, memory);
    return all_hits(line, mesh_at(shape, pose), memory);
}

// Returns ask(a, b) about two bodies of a world, each as a mesh or as a rounded body.
template <class Function>
auto with_pair(const World& world, BodyId a, BodyId b, const Function& ask) {
    const auto first = world.shape(a), second = world.shape(b);
    const auto* const round_a = dynamic_cast<const Rounded*>(first.get());
    const auto* const round_b = dynamic_cast<const Rounded*>(second.get());
    const Pose at_a = world.pose(a), at_b = world.pose(b);
    if (round_a == nullptr && round_b == nullptr) return ask(mesh_at(*first, at_a), mesh_at(*second, at_b));
    if (round_a == nullptr) return ask(mesh_at(*first, at_a), Posed<Rounded>(*round_b, at_b));
    const Posed<Rounded> moved(*round_a, at_a);
    if (round_b == nullptr) return ask(moved, mesh_at(*second, at_b));
    return ask(moved, Posed<Rounded>(*round_b, at_b));
}

// Returns the first contact of two bodies of a world, of which the first is translated.
std::optional<FirstContact> cast_of(const World& world, BodyId a, const Vec3& motion, BodyId b, QueryMemory& memory) {
    return with_pair(world, a, b, [&](const auto& x, const auto& y) { return cast(x, motion, y, 1, memory); });
}

// The point of a contact in a world is that of two bodies; the normal is a unit vector, and the opposite one if the
// bodies are exchanged, unless another pair of features comes first then.
void check_point_of(const World& world, BodyId own, const Vec3& motion, const BodyContact& met, QueryMemory& memory,
                    Counters& counters) {
    const auto point_of = [&](BodyId a, const Vec3& way, BodyId b, const FirstContact& contact) {
        return with_pair(world, a, b,
                         [&](const auto& x, const auto& y) { return contact_point(x, way, y, contact, memory); });
    };
    const auto is_rounded = [&](BodyId body) {
        return dynamic_cast<const Rounded*>(world.shape(body).get()) != nullptr;
    };
    const auto is_mesh = [&](BodyId body) { return world.shape(body)->kind() == ShapeKind::mesh(); };
    if (!(is_mesh(own) || is_rounded(own)) || !(is_mesh(met.body) || is_rounded(met.body))) return;
    const ContactPoint got = world.contact_point(own, motion, met, memory);
    const bool is_same = got == point_of(own, motion, met.body, met.contact);
    if (!is_same || got.normal.has_value() != (met.contact.time > 0) ||
        (got.normal && std::abs(got.normal->norm() - 1) > 0x1p-50)) {
        throw CheckFailed("point of a contact in a world", "that of two bodies", judge::text(got.point));
    }
    ++counters["checked: points of first contacts in worlds"];
    if (!got.normal || (is_mesh(own) && is_mesh(met.body))) return;
    const auto back = cast_of(world, met.body, Vec3(-motion), own, memory);
    if (!back || back->a != met.contact.b || back->b != met.contact.a) return;
    const auto normal = point_of(met.body, Vec3(-motion), own, *back).normal;
    if (!normal || *normal != Vec3(-*got.normal)) {
        throw CheckFailed("normal of a rounded contact, exchanged", judge::text(Vec3(-*got.normal)),
                          normal ? judge::text(*normal) : "none");
    }
    ++counters["checked: normals of rounded contacts, exchanged"];
}

// Everything but the order of hits whose parameters round to the same.
auto fields(const BodyHit& h) {
    return std::tuple(h.hit.parameter, numbers_of(h.body), h.hit.triangle(), h.hit.kind, h.hit.leave_parameter,
                      h.hit.feature.kind, h.hit.feature.corner);
}

// Ranks follow the order, and hits of one rank that of bodies and triangles; of shapes of the caller's own that come
// after meshes.
void require_order(const std::vector<BodyHit>& hits, const World& world) {
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const Hit& hit = hits[i].hit;
        bool holds = i > 0 || hit.rank == 0;
        if (i > 0) {
            const BodyHit& before = hits[i - 1];
            const bool is_tie = hit.rank == before.hit.rank;
            const bool is_mesh = world.shape(hits[i].body)->kind() == ShapeKind::mesh();
            holds = hit.parameter >= before.hit.parameter && (is_tie || hit.rank == before.hit.rank + 1) &&
                    (!is_tie || before.body <= hits[i].body) &&
                    (!is_tie || !is_mesh || before.body != hits[i].body || before.hit.triangle() < hit.triangle());
        }
        if (!holds) throw CheckFailed("order of hits", "ascending", text(hits));
    }
}

// The sides of hits are those of the same hits, and between two hits that follow each other a line has one side.
template <class Line>
void check_sides(const Line& line, const Posed<MeshShape>& body, QueryMemory& memory, Counters& counters) {
    const std::vector<Hit> hits = all_hits(line, body, memory);
    const std::vector<SidedHit> sided = sided_hits(line, body, memory);
    const auto fail = [&](std::size_t i) {
        throw CheckFailed("sides of hits", "one side between hits", fmt::format("hit {} of {}", i, sided.size()));
    };
    if (sided.size() != hits.size()) fail(0);
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const SidedHit& now = sided[i];
        if (now.hit.parameter != hits[i].parameter || now.hit.feature != hits[i].feature) fail(i);
        if (i == 0 || now.hit.rank == sided[i - 1].hit.rank) continue;
        const SidedHit& before = sided[i - 1];
        const bool are_sides = before.after != Side::on && now.before != Side::on;
        if (are_sides && before.hit.kind != HitKind::along && before.after != now.before) fail(i);
    }
    counters["checked: sides of hits"] += sided.size();
}

// In a world of meshes, sided_hits() has the hits of all_hits() in their order, each with the sides that it has in the
// list of its body; and inside_parts() has the parts of each body in their order, and all in that of where they begin.
template <class Line>
void check_sides_of_world(const World& world, const Line& line, const std::optional<CollisionFilter>& filter,
                          QueryMemory& memory, Counters& counters) {
    const auto hits = world.all_hits(line, filter, memory);
    const auto sided = world.sided_hits(line, filter, memory);
    const auto parts = world.inside_parts(line, filter, memory);
    const auto require = [&](bool holds, const char* what) {
        if (!holds)
            throw CheckFailed(what, "those of each body", fmt::format("{} hits, {} parts", sided.size(), parts.size()));
    };
    require(sided.size() == hits.size(), "sides of hits in a world");
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const bool is_same = fields(hits[i]) == fields({sided[i].body, sided[i].sided.hit});
        require(is_same && hits[i].hit.rank == sided[i].sided.hit.rank, "hits with sides in a world");
    }
    require(std::ranges::is_sorted(parts, {}, [](const BodyInsidePart& p) { return p.part.from; }), "order of parts");
    std::size_t part_count = 0;
    for (const BodyId body : world.bodies()) {
        const Posed<MeshShape> mesh = mesh_at(world, body);
        const bool is_asked = !filter || ecods::may_meet(*filter, world.filter(body));
        std::size_t next = 0;
        const auto of_body = is_asked ? sided_hits(line, mesh, memory) : std::vector<SidedHit>();
        for (const BodySidedHit& each : sided) {
            if (each.body != body) continue;
            const SidedHit& s = each.sided;
            const bool is_known = next < of_body.size();
            const SidedHit expected = is_known ? of_body[next++] : SidedHit();
            require(is_known && std::tuple(s.before, s.after, s.passage, s.normal) ==
                                    std::tuple(expected.before, expected.after, expected.passage, expected.normal),
                    "sides of a hit in a world");
        }
        require(next == of_body.size(), "hits of a body with sides");
        const auto solid = std::dynamic_pointer_cast<const Solid>(world.shape(body));
        if (!solid || !is_asked) continue;
        const auto expected = inside_parts(line, {solid, world.pose(body)}, memory);
        std::vector<InsidePart> got;
        for (const BodyInsidePart& each : parts) {
            if (each.body == body) got.push_back(each.part);
        }
        require(got == expected, "parts inside a body of a world");
        part_count += got.size();
    }
    require(part_count == parts.size(), "parts inside bodies of a world");
    counters["checked: sides of hits in worlds"] += sided.size();
    counters["checked: parts of lines inside bodies of worlds"] += part_count;
}

template <class Line>
void check_line(std::span<World* const> worlds, const Line& line, const std::optional<CollisionFilter>& filter,
                Counters& counters) {
    const World& first = *worlds.front();
    QueryMemory memory;
    std::vector<BodyHit> expected;
    for (const BodyId body : first.bodies()) {
        if (filter && !ecods::may_meet(*filter, first.filter(body))) continue;
        const auto shape = first.shape(body);
        try {
            for (const Hit& hit : hits_of(line, *shape, first.pose(body), memory)) expected.push_back({body, hit});
            if (shape->kind() == ShapeKind::mesh())
                check_sides(line, mesh_at(*shape, first.pose(body)), memory, counters);
        } catch (const NotSupported&) {  // of a radius that is tiny beside its core (rounded.hpp)
            ++counters["lines at rounded bodies that are not decided"];
            return;
        }
    }
    const auto by_fields = [](const BodyHit& a, const BodyHit& b) { return fields(a) < fields(b); };
    std::ranges::sort(expected, by_fields);
    std::optional<BodyHit> least;
    for (World* world : worlds) {
        auto got = world->all_hits(line, filter);
        require_order(got, *world);
        const std::optional<BodyHit> leads = got.empty() ? std::nullopt : std::optional(got.front());
        const auto found = world->first_hit(line, filter, memory);
        if (found.has_value() != leads.has_value() || (found && fields(*found) != fields(*leads))) {
            throw CheckFailed("first hit", text(leads), text(found));
        }
        if (world == worlds.front()) least = leads;
        if (leads && fields(*leads) != fields(*least)) throw CheckFailed("first hit", text(least), text(leads));
        std::ranges::sort(got, by_fields);
        const bool is_same = std::ranges::equal(got, expected, {}, fields, fields);
        if (!is_same) throw CheckFailed("hits of all bodies", text(expected), text(got));
    }
    const auto is_mesh = [&](BodyId body) { return first.shape(body)->kind() == ShapeKind::mesh(); };
    if (std::ranges::all_of(first.bodies(), is_mesh)) {
        check_sides_of_world(*worlds.back(), line, filter, memory, counters);
    }
    ++counters["checked: segments and rays in worlds"];
    counters["checked: hits in worlds"] += expected.size();
}

}  // namespace

void check_hits(std::span<World* const> worlds, std::uint32_t seed, Counters& counters) {
    const World& first = *worlds.front();
    const auto bodies = first.bodies();
    if (bodies.empty()) return;
    scenes::Random random(seed);
    std::optional<CollisionFilter> filter;
    if (random.below(4) == 0) filter = CollisionFilter{.groups = 1, .mask = 2};
    const Vec3 a = any_point(first, bodies, random), b = any_point(first, bodies, random);
    const Segment segment{a, random.below(6) == 0 ? a : b};
    check_line(worlds, segment, filter, counters);
    Ray ray{any_point(first, bodies, random), b - a};
    if (random.below(3) == 0) ray.direction = Vec3::Unit(static_cast<int>(random.below(3)));
    if (!ray.direction.allFinite() || ray.direction.isZero(0)) ray.direction = Vec3::UnitX();
    if (random.below(2) == 0) ray.max_parameter = random.below(2) == 0 ? 1 : random.uniform(0, 2);
    check_line(worlds, ray, {}, counters);
    const auto is_rounded = [&](BodyId body) {
        return dynamic_cast<const Rounded*>(first.shape(body).get()) != nullptr;
    };
    if (std::ranges::any_of(bodies, is_rounded)) return;  // the order is that of meshes
    const World& one = *worlds[seed % worlds.size()];
    seed % 2 == 0 ? check_hit_order(one, segment, counters) : check_hit_order(one, ray, counters);
}

void check_casts(std::span<World* const> worlds, std::uint32_t seed, Counters& counters) {
    const World& first = *worlds.front();
    const auto bodies = first.bodies();
    if (bodies.size() < 2 || bodies.size() > few || !are_soon_asked(first, bodies)) return;
    scenes::Random random(seed);
    QueryMemory memory;
    const BodyId own = bodies[random.below(static_cast<std::uint32_t>(bodies.size()))];
    const Vec3 motion = any_point(first, bodies, random) - any_point(first, bodies, random);
    if (!motion.allFinite()) return;
    std::optional<BodyContact> expected;
    const auto own_shape = first.shape(own);
    for (const BodyId body : bodies) {
        if (body == own || !may_meet(first, own, body)) continue;
        const auto contact = cast_of(first, own, motion, body, memory);
        if (contact && (!expected || contact->time < expected->contact.time)) expected = BodyContact{body, *contact};
    }
    // Where kinds differ, a test may have the features' order of its own; the times are the same.
    const auto require = [&](const char* what, const std::optional<BodyContact>& got,
                             const std::optional<BodyContact>& right) {
        const bool is_same =
            got.has_value() == right.has_value() &&
            (!got || (numbers_of(got->body) == numbers_of(right->body) && got->contact.time == right->contact.time &&
                      (first.shape(right->body)->kind() != ShapeKind::mesh() ||
                       own_shape->kind() != ShapeKind::mesh() || got->contact == right->contact)));
        if (!is_same) throw CheckFailed(what, text(right), text(got));
    };
    for (World* world : worlds) {
        const BodyId id = numbers_of(own);
        require("first body met", world->cast(id, motion), expected);
        if (!expected) continue;
        // Rounded once, a time is at most a limit that the real one is not above, and next to the other side of it.
        const double time = expected->contact.time;
        require("first body met up to a limit", world->cast(id, motion, std::nextafter(time, 2)), expected);
        if (time > 0) require("first body met before it", world->cast(id, motion, std::nextafter(time, 0)), {});
    }
    const World& one = *worlds[seed % worlds.size()];
    if (const auto met = one.cast(numbers_of(own), motion)) {
        check_point_of(one, numbers_of(own), motion, *met, memory, counters);
    }
    // A copy of it meets it at once, or a body before it that touches it.
    const auto of_copy = one.cast({one.shape(numbers_of(own)), one.pose(numbers_of(own))}, motion, 1, memory);
    if (!of_copy || of_copy->contact.time != 0 || numbers_of(of_copy->body) > numbers_of(own)) {
        throw CheckFailed("first body that a copy meets", "itself, at once", text(of_copy));
    }
    ++counters["checked: bodies cast in worlds"];
    counters["checked: bodies met by these"] += expected.has_value();
}

void check_meetings(std::span<World* const> worlds, std::uint32_t seed, Counters& counters) {
    const World& first = *worlds.front();
    const auto bodies = first.bodies();
    if (bodies.size() > very_few || !are_soon_asked(first, bodies)) return;
    scenes::Random random(seed);
    // Bodies go where others are, or stay.
    std::vector<BodyId> moved;
    std::vector<Pose> poses;
    for (const BodyId body : bodies) {
        if (random.below(3) == 0) continue;
        Pose to = first.pose(bodies[random.below(static_cast<std::uint32_t>(bodies.size()))]);
        if (random.below(2) == 0) to.R = first.pose(body).R;
        moved.push_back(numbers_of(body));
        poses.push_back(to);
    }
    const auto way_of = [&](BodyId body, const Shape& shape) {
        const auto found = std::ranges::find(moved, numbers_of(body));
        const Pose from = first.pose(body);
        return Moving<MeshShape>(*mesh_at(shape, from).what, from,
                                 found == moved.end() ? from : poses[static_cast<std::size_t>(found - moved.begin())]);
    };
    QueryMemory memory;
    std::vector<Meeting> expected;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        for (std::size_t j = i + 1; j < bodies.size(); ++j) {
            if (!may_meet(first, bodies[i], bodies[j])) continue;
            const auto a = first.shape(bodies[i]), b = first.shape(bodies[j]);
            const auto contact = cast(way_of(bodies[i], *a), way_of(bodies[j], *b), 1, memory);
            if (contact) expected.push_back({{bodies[i], bodies[j]}, *contact});
        }
    }
    require_meetings(worlds, expected, moved, poses);
    ++counters["checked: moves of worlds"];
    counters["checked: pairs that meet on the way"] += expected.size();
}

}  // namespace ecods::fuzz
