#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "fuzz/base/failure.hpp"
#include "fuzz/base/user_shape.hpp"
#include "fuzz/checks/checks.hpp"
#include "fuzz/checks/text.hpp"
#include "scenes/numbers_of.hpp"

namespace ecods::fuzz {
namespace {

void require_relation(Relation got, Relation expected, const char* check) {
    if (got != expected) throw CheckFailed(check, text(expected), text(got));
}

void require_triangles(World& world, BodyId a, BodyId b, const std::vector<TrianglePair>& expected, const char* check) {
    std::vector<TrianglePair> got;
    try {
        got = world.intersecting_triangles(a, b);
    } catch (const NotSupported&) {
        // Tests of shapes of the caller's own need not give triangles.
        if (world.shape(a)->kind() != ShapeKind::mesh() || world.shape(b)->kind() != ShapeKind::mesh()) return;
        throw;
    }
    if (got == expected) return;
    throw CheckFailed(check, text(expected), text(got));
}

void require_bodies(const std::vector<BodyId>& got, const std::vector<BodyId>& expected, const char* check) {
    if (got == expected) return;
    throw CheckFailed(check, text(expected), text(got));
}

// Checks rounded bodies beside the oracle. Relations of some are not decided.
void check_rounded(World& world, const TruePair& pair, Counters& counters) {
    const auto [a, b] = pair.ids;
    const oracle::RoundedDistance& truth = *pair.rounded;
    const double distance = truth.distance();
    ++counters[distance > 0 ? "checked: rounded bodies apart" : "checked: rounded bodies that meet"];
    const auto require = [&](bool holds, const char* check) {
        if (!holds) throw CheckFailed(check, fmt::format("distance {:a}", distance), "another answer");
    };
    require(world.intersects(a, b) == pair.do_meet() && world.intersects(b, a) == pair.do_meet(),
            "rounded: intersects");
    require(world.distance(a, b) == distance && world.distance(b, a) == distance, "rounded: distance");
    for (const double d : {distance, std::nextafter(distance, 0), 0.5 * distance}) {
        if (std::isfinite(d)) require(world.within(a, b, d) == (truth.compare(d) <= 0), "rounded: within");
    }
    const ClosestPoints points = world.closest(a, b);
    require(points.distance == distance, "rounded: distance of closest points");
    if (points.kind < ClosestKind::intersecting) {
        require(points.point_a == truth.point(0) && points.point_b == truth.point(1), "rounded: closest points");
        const SignedDistance found = world.signed_distance(a, b), turned = world.signed_distance(b, a);
        require(found.distance == truth.signed_distance() && turned.distance == found.distance,
                "rounded: signed distance");
        require(found.point_a == points.point_a && found.point_b == points.point_b && turned.point_a == found.point_b,
                "rounded: points of the signed distance");
    }
    try {
        const Relation got = world.relation(a, b), turned = world.relation(b, a);
        require((got == Relation::apart) == (truth.compare(0) > 0), "rounded: relation");
        require((got == Relation::touching) == (truth.compare(0) == 0), "rounded: relation, touching");
        const bool is_subset = got == Relation::inside || got == Relation::contains;
        require(is_subset ? turned != got : turned == got, "rounded: relation, swapped");
        ++counters["checked: relations of rounded bodies"];
    } catch (const NotSupported&) {
        require(truth.compare(0) < 0, "rounded: a relation that is refused");
    }
}

const char* name_of(Relation relation) {
    return relation == Relation::apart      ? "pairs: apart, boxes overlap"
           : relation == Relation::touching ? "pairs: touching"
                                            : "pairs: crossing";
}

}  // namespace

void check_answers(World& world, const Truth& truth, Counters& counters) {
    for (const TruePair& pair : truth.pairs()) {
        if (!pair.is_changed) continue;
        const auto& [ids, verdict] = std::tie(pair.ids, pair.verdict);
        ++counters["checked: pairs against the oracle"];
        counters["checked: triangle pairs that touch"] += verdict.triangles.size();
        ++counters[name_of(verdict.relation)];
        counters["checked: bodies of which a part is inside another"] += pair.is_a_inside || pair.is_b_inside;
        if (pair.rounded) {
            check_rounded(world, pair, counters);
            continue;
        }
        const auto require_relation = [&](Relation got, const char* check) {
            if (pair.are_surfaces) return fuzz::require_relation(got, verdict.relation, check);
            // The relation of solids itself is judged if they have few triangles (solid_questions).
            if ((got != Relation::apart) != pair.do_meet()) throw CheckFailed(check, text(verdict.relation), text(got));
        };
        require_relation(world.relation(ids.a, ids.b), "relation");
        require_relation(world.relation(ids.b, ids.a), "relation, swapped");
        if (world.intersects(ids.b, ids.a) != pair.do_meet()) {
            throw CheckFailed("intersects", text(verdict.relation), "the contrary");
        }
        // Shapes at the poses of the bodies, beside a body and beside each other.
        const Asked a(world.shape(ids.a), world.pose(ids.a)), b(world.shape(ids.b), world.pose(ids.b));
        require_relation(world.relation(a, ids.b), "relation of a shape and a body");
        require_relation(world.relation(b, a), "relation of two shapes");
        std::vector<TrianglePair> expected = verdict.triangles;
        require_triangles(world, ids.a, ids.b, expected, "triangle pairs");
        for (TrianglePair& triangles : expected) std::swap(triangles.a, triangles.b);
        std::ranges::sort(expected);
        require_triangles(world, ids.b, ids.a, expected, "triangle pairs, swapped");
    }
}

void check_queries(World& world, const Truth& truth, BodyId body, Counters& counters) {
    ++counters["checked: queries with a copy of a body"];
    const Aabb box = world.box(body);
    std::vector<BodyId> expected;
    for (const BodyId other : world.bodies()) {
        if (oracle::boxes_overlap(box, world.box(other))) expected.push_back(other);
    }
    require_bodies(world.overlapping_bodies(box), expected, "bodies in a box");

    // A body touches its copy.
    if (!truth.knows(body)) return;
    const BodyId name = numbers_of(body);
    expected = {name};
    std::vector<BodyId> met_by_surface = expected;
    for (const TruePair& pair : truth.pairs()) {
        const bool is_a = pair.ids.a == name;
        if (!pair.do_meet() || (!is_a && pair.ids.b != name)) continue;
        const BodyId other = is_a ? pair.ids.b : pair.ids.a;
        expected.push_back(other);
        const bool is_inside = is_a ? pair.is_a_inside : pair.is_b_inside;
        if (pair.verdict.relation != Relation::apart || is_inside) met_by_surface.push_back(other);
    }
    std::ranges::sort(expected);
    std::ranges::sort(met_by_surface);
    auto got = numbers_of(world.intersecting_bodies({world.shape(body), world.pose(body)}));
    std::erase_if(got, [&](BodyId found) { return !truth.knows(found); });
    require_bodies(got, expected, "bodies that a shape touches");

    // A mesh is a surface, with all its triangles.
    if (truth.has_all_triangles(name) && !truth.has_rounded()) {
        got = numbers_of(world.intersecting_bodies({mesh_of(*world.shape(body)), world.pose(body)}));
        std::erase_if(got, [&](BodyId found) { return !truth.knows(found); });
        require_bodies(got, met_by_surface, "bodies that a mesh touches");
    }

    // With a filter, only those that name it and that it names.
    const CollisionFilter filter = world.filter(body);
    std::erase_if(expected, [&](BodyId other) {
        const CollisionFilter of_other = world.filter(other);
        return (filter.groups & of_other.mask) == 0 || (of_other.groups & filter.mask) == 0;
    });
    got = numbers_of(world.intersecting_bodies({{world.shape(body), world.pose(body)}, filter}));
    std::erase_if(got, [&](BodyId found) { return !truth.knows(found); });
    require_bodies(got, expected, "bodies that a shape touches and may meet");
}

}  // namespace ecods::fuzz
