// What needs no World, out of memory at any point: meshes, shapes, refits, questions about two bodies.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "allocation/each_allocation.hpp"
#include "allocation/new_thread.hpp"
#include "ecods/cast.hpp"
#include "ecods/certificate.hpp"
#include "ecods/contact.hpp"
#include "ecods/distance.hpp"
#include "ecods/error.hpp"
#include "ecods/hit.hpp"
#include "ecods/intersection.hpp"
#include "ecods/shape.hpp"
#include "ecods/solid.hpp"
#include "ecods/turn.hpp"
#include "scenes/shapes.hpp"
#include "unit/allocation/answer_digest.hpp"
#include "unit/allocation/pair_scene.hpp"

namespace ecods::allocation::query_test {
namespace {

// From before both bodies to beyond them.
const Segment through{{3, 0.125, 0.25}, {-3, -0.125, -0.25}};

// From afar to beyond the other one.
std::optional<FirstContact> cast_past(Pair& p) {
    Pose start = p.pose_b;
    start.t[0] += 4;
    return cast({*p.b, start}, -1.5 * start.t, p.first(), 1, {p.memory, p.witness});
}

// To behind the other one, turned over on the way: flat half-way.
std::optional<FirstContact> move_past(Pair& p) {
    Pose end;
    end.R = Vec3(-1, -1, 1).asDiagonal();
    end.t = -0.5 * p.pose_b.t;
    return cast(Moving<MeshShape>(*p.b, p.pose_b, end), Moving<MeshShape>(*p.a, p.pose_a, p.pose_a), 1, p.memory);
}

// About a pivot beside both, so that its way leads past the other one.
std::optional<FirstContact> turn_past(Pair& p) {
    const Turn turn{{0.5, 0.25, 0, 1}, {0, 2, 0}, {0, 2.5, 0.25}};
    return cast(Turning<MeshShape>(*p.b, p.pose_b, turn), p.first(), 1, {p.memory, p.witness});
}

// The other one turns, too.
std::optional<FirstContact> turn_both(Pair& p) {
    const Turn turn{{0.5, 0.25, 0, 1}, {0, 2, 0}, {0, 2.5, 0.25}}, other{{1, 0.125, -0.25, 0}, {0, 1, 0}, {0, 1, 0}};
    const Turning<MeshShape> first(*p.b, p.pose_b, turn), second(*p.a, p.pose_a, other);
    return cast(first, second, 1, {p.memory, p.witness});
}

// The same turn and back, so that a contact is on the first leg, and where it is; then the gap at its end.
std::uint64_t go_past(Pair& p) {
    const WayNode first{{}, {0, 2, 0}}, last{{0.5, 0.25, 0, 1}, {0, 2.5, 0.25}};
    const Way<MeshShape> way(*p.b, p.pose_b, {first, last, first});
    const auto met = cast(way, p.first(), {p.memory, p.witness});
    const auto gap = settle(way, {p.pose_a.R, p.pose_a.t}, p.first(), {p.memory, p.witness});
    const std::uint64_t number = met ? digest(std::optional(met->contact)) + met->leg : 0;
    const bool has_place = met && met->contact.time > 0;
    return number + digest(gap) + (has_place ? digest(contact_point(way, p.first(), *met, p.memory).point[0]) : 0);
}

// Triangles with corners of their own, a face of two halves beside one of one part.
std::shared_ptr<const Mesh> two_prisms() {
    const Vec3 a(0, 0, 0), b(2, 0, 0), c(0, 2, 0), d(0, 0, 1), m(1, 1, 0);
    const std::array<Vec3, 15> corners{a, b, m, a, m, c, a, b, d, b, c, d, c, a, d};
    std::vector<Triangle> triangles;
    for (std::uint32_t i = 0; i < 15; i += 3) triangles.push_back({i, i + 1, i + 2});
    return Mesh::create({corners.begin(), corners.end()}, std::move(triangles));
}

// A cube about all bodies at distances below 8, from which a segment sticks out that is not in the solid.
std::shared_ptr<const Mesh> room_with_an_antenna() {
    const auto cube = scenes::cube(10);
    std::vector<Vec3> vertices(cube->vertices().begin(), cube->vertices().end());
    std::vector<Triangle> triangles(cube->triangles().begin(), cube->triangles().end());
    const auto first = static_cast<std::uint32_t>(vertices.size());
    vertices.insert(vertices.end(), {Vec3(11, 0, 0), Vec3(12, 0, 0)});
    triangles.insert(triangles.begin(), {first, first + 1, first});
    return Mesh::create(std::move(vertices), std::move(triangles));
}

const PairCall questions[] = {
    {"intersects", [](Pair& p) { p.answer = digest(intersects(p.first(), p.second(), p.memory)); }},
    {"intersects, with a witness",
     [](Pair& p) {
         p.answer = digest(intersects(p.first(), p.second(), {p.memory, p.witness}));
     }},
    {"intersects, in a new thread's own memory",
     [](Pair& p) { in_a_new_thread([&] { p.answer = digest(intersects(p.first(), p.second(), p.witness)); }); }},
    {"closest twice, in a new thread's own memory, and what it counted",
     [](Pair& p) {
         in_a_new_thread([&] {
             QueryCounts counts;
             const ClosestPoints once = closest(p.first(), p.second(), counts);
             p.answer = digest(once) + digest(closest(p.first(), p.second(), counts)) + counts.queries;
         });
     }},
    {"relation", [](Pair& p) { p.answer = digest(relation(p.first(), p.second(), p.memory)); }},
    {"intersecting_triangles",
     [](Pair& p) { p.answer = digest(intersecting_triangles(p.first(), p.second(), p.memory).size()); }},
    {"distance", [](Pair& p) { p.answer = digest(distance(p.first(), p.second(), p.memory)); }},
    {"distance, with a witness",
     [](Pair& p) {
         p.answer = digest(distance(p.first(), p.second(), {p.memory, p.witness}));
     }},
    {"first_hit", [](Pair& p) { p.answer = digest(first_hit(through, p.first(), p.memory)); }},
    {"first_hit, with a witness",
     [](Pair& p) {
         p.answer = digest(first_hit(through, p.first(), {p.memory, p.witness}));
     }},
    {"all_hits", [](Pair& p) { p.answer = digest(all_hits(through, p.second(), p.memory)); }},
    {"within",
     [](Pair& p) {
         p.answer = digest(within(p.first(), p.second(), 0.25, {p.memory, p.witness}));
     }},
    {"closest", [](Pair& p) { p.answer = digest(closest(p.first(), p.second(), p.memory)); }},
    {"distance_bounds",
     [](Pair& p) { p.answer = digest(distance_bounds(p.first(), p.second(), {.relative = 0.25}, p.memory)); }},
    {"close_triangles", [](Pair& p) { p.answer = digest(close_triangles(p.first(), p.second(), 0x1p-6, p.memory)); }},
    {"close_features", [](Pair& p) { p.answer = digest(close_features(p.first(), p.second(), 0x1p-6, p.memory)); }},
    {"cast of a translation",
     [](Pair& p) { p.answer = digest(cast(p.second(), -1.5 * p.pose_b.t, p.first(), 1, p.memory)); }},
    {"cast of a translation, with a witness", [](Pair& p) { p.answer = digest(cast_past(p)); }},
    {"cast between poses", [](Pair& p) { p.answer = digest(move_past(p)); }},
    {"cast of a turning body", [](Pair& p) { p.answer = digest(turn_past(p)); }},
    {"cast of two turning bodies", [](Pair& p) { p.answer = digest(turn_both(p)); }},
    {"cast along a way, its point, and the gap at its end", [](Pair& p) { p.answer = go_past(p); }},
    {"certify", [](Pair& p) { p.answer = digest(certify(p.first(), p.second(), p.memory)); }},
    {"certify_distance", [](Pair& p) { p.answer = digest(certify_distance(p.first(), p.second(), p.memory)); }},
    {"certify_within", [](Pair& p) { p.answer = digest(certify_within(p.first(), p.second(), 0x1p-6, p.memory)); }},
    {"certify_hit", [](Pair& p) { p.answer = digest(certify_hit(through, p.first(), p.memory)); }},
    {"intersections", [](Pair& p) { p.answer = digest(intersections(p.first(), p.second(), p.memory)); }},
    {"Solid and relation",
     [](Pair& p) {
         const Solid a(p.a->mesh_ptr()), b(p.b->mesh_ptr());
         p.answer = digest(relation({a, p.pose_a}, {b, p.pose_b}, p.memory));
     }},
    {"relation of solids with T-junctions",
     [](Pair& p) {
         const Solid a(two_prisms());
         p.answer = digest(relation({a, p.pose_a}, {a, p.pose_b}, p.memory));
     }},
    {"convex_hull", [](Pair& p) { p.answer = digest(convex_hull(p.b->mesh().vertices())->digest()); }},
    {"ConvexSolid and distance",
     [](Pair& p) {
         const ConvexSolid a(p.a->mesh().vertices()), b(p.b->mesh().vertices());
         p.answer = digest(distance({a, p.pose_a}, {b, p.pose_b}, {p.memory, p.witness}));
     }},
    {"closest of convex solids that touch",
     [](Pair& p) {
         const ConvexSolid a(scenes::cube(0.5));
         Pose above;
         above.t = Vec3(0.5, 0.25, 1);
         const auto answer = digest(closest({a, p.pose_a}, {a, above}, p.memory));
         above.t[2] = 2;
         p.answer = answer + digest(closest({a, p.pose_a}, {a, above}, p.memory));
     }},
    {"intersects of a surface in a solid",
     [](Pair& p) {
         const Solid room(room_with_an_antenna());
         p.answer = digest(intersects({room, p.pose_a}, p.second(), {p.memory, p.witness}));
     }},
    {"distance and within of a surface in a solid",
     [](Pair& p) {
         const Solid room(room_with_an_antenna());
         const auto answer = digest(distance(p.second(), {room, p.pose_a}, {p.memory, p.witness}));
         p.answer = answer + digest(within(p.second(), {room, p.pose_a}, 0.125, {p.memory, p.witness}));
     }},
    {"closest of a surface in a solid",
     [](Pair& p) {
         const Solid room(room_with_an_antenna());
         p.answer = digest(closest(p.second(), {room, p.pose_a}, {p.memory, p.witness}));
     }},
    {"cast of a surface in a solid",
     [](Pair& p) {
         const Solid room(room_with_an_antenna());
         const auto answer = digest(cast(p.second(), Vec3(-4, 0, 0), {room, p.pose_a}, 1, {p.memory, p.witness}));
         const Moving<MeshShape> moving(*p.b, p.pose_b, p.pose_a), still(room, p.pose_a, p.pose_a);
         p.answer = answer + digest(cast(moving, still, 1, {p.memory, p.witness}));
     }},
    {"first_hit and all_hits in a solid",
     [](Pair& p) {
         const Solid room(room_with_an_antenna());
         const Ray out{Vec3(p.pose_b.t), Vec3(1, 0.25, 0.125)};
         const auto answer = digest(first_hit(out, {room, p.pose_a}, {p.memory, p.witness}));
         p.answer = answer + digest(all_hits(out, {room, p.pose_a}, p.memory));
     }},
    {"closest and signed_distance of points, and locate",
     [](Pair& p) {
         const Solid room(room_with_an_antenna());
         const std::vector<Vec3> points{{11.5, 1, 0}, {1, 2, 3}, {0, 0, 0}, {1e9, 0, 0}};
         Digest found;
         for (const ClosestPoint& near : closest(points, {room, p.pose_a}, p.memory)) {
             found.add(near.distance);
             found.add(near.feature.triangle);
             found.add(near.point);
         }
         for (const double number : signed_distance(points, {room, p.pose_a}, p.memory)) found.add(number);
         for (const Location& location : locate(points, {room, p.pose_a}, p.memory)) found.add(location.side);
         found.add(signed_distance(points[0], p.second(), p.memory));
         p.answer = found.value();
     }},
    {"surface_of",
     [](Pair& p) {
         const Solid room(room_with_an_antenna());
         p.answer = digest(distance({*surface_of(room), p.pose_a}, p.second(), {p.memory, p.witness}));
     }},
    {"depth of convex solids",
     [](Pair& p) {
         const ConvexSolid a(scenes::cube(1)), b(p.b->mesh().vertices());
         p.answer = digest_depth({a, p.pose_a}, {b, p.pose_b}, p);
     }},
    {"depth in long integers",
     [](Pair& p) {
         const ConvexSolid a(scenes::cube(0.5));
         Pose sheared;
         sheared.R(0, 2) = 0x1p-700;
         sheared.t = Vec3(0.9375, 0.25, 0.125);
         p.answer = digest_depth({a, p.pose_a}, {a, sheared}, p);
     }},
    {"signed_distance",
     [](Pair& p) {
         const ConvexSolid a(scenes::cube(1)), b(p.b->mesh().vertices());
         const SignedDistance found = signed_distance({a, p.pose_a}, {b, p.pose_b}, {p.memory, p.witness});
         p.answer = digest(found.distance) + digest(found.point_a) + digest(found.point_b) + digest(found.direction);
     }},
    {"signed_distance_bounds",
     [](Pair& p) {
         const Solid a(scenes::cube(1)), b(scenes::torus(4, 3, 0.25));
         const DistanceBounds bounds = signed_distance_bounds({a, p.pose_a}, {b, p.pose_b}, p.memory);
         p.answer = digest(bounds.upper) + digest(bounds.lower);
     }},
    {"depth_bounds",
     [](Pair& p) {
         const Solid a(scenes::cube(1)), b(scenes::torus(4, 3, 0.25));
         const auto bounds = depth_bounds({a, p.pose_a}, {b, p.pose_b}, p.memory);
         p.answer = bounds ? digest(bounds->parted) + digest(bounds->upper) + digest(bounds->lower) : 1;
     }},
    {"relation of a surface to a solid",
     [](Pair& p) {
         const Solid solid(p.b->mesh_ptr());
         p.answer = digest(relation(p.first(), {solid, p.pose_b}, p.memory));
     }},
    {"locate",
     [](Pair& p) {
         const Solid solid(p.b->mesh_ptr());
         p.answer = digest(locate(Vec3(1, 0, 0), {solid, p.pose_b}, p.memory).side);
     }},
    {"self_intersections", [](Pair& p) { p.answer = digest(self_intersections(p.a->mesh())); }},
    {"MeshShape::box", [](Pair& p) { p.answer = digest(p.a->box(p.pose_b).min.allFinite()); }},
    {"MeshShape::tree_bytes", [](Pair& p) { p.answer = digest(p.a->tree_bytes()); }},
    {"refit without a tree",
     [](Pair& p) {
         const auto vertices = p.a->mesh().vertices();
         p.answer = digest(refit(*p.a, {vertices.begin(), vertices.end()})->digest());
     }},
    {"refit with a tree",
     [](Pair& p) {
         const auto vertices = p.b->mesh().vertices();
         p.b->tree_bytes();
         p.answer = digest(refit(*p.b, {vertices.begin(), vertices.end()})->tree_bytes());
     }},
    {"Mesh::create and a shape of it",
     [](Pair& p) {
         const auto mesh = scenes::cube(0.5);
         p.answer = digest(std::make_shared<MeshShape>(mesh)->tree_bytes());
     }},
};

TEST(QueryOutOfMemory, EveryQuestionIsAnsweredTheNextTime) {
    for (const PairCall& question : questions) {
        Failures failures;
        // Deep in one another, and at distance 2 in contact, decided by exact numbers.
        for (const double distance : {0.75, 2.0, 2.25, 9.0}) {
            fail_each_allocation(trial_of(question, distance), failures);
        }
        EXPECT_EQ(failures.defects, 0u) << question.name << "; first: " << failures.first;
    }
}

// A shape that two bodies share is asked on while one question failed to make its tree.
TEST(QueryOutOfMemory, ASharedShapeKeepsWhatItHas) {
    Failures failures;
    fail_each_allocation<Pair>({.make =
                                    [] {
                                        Pair pair(0.75);
                                        pair.b = pair.a;
                                        return pair;
                                    },
                                .call = [](Pair& p) { p.answer = digest(relation(p.first(), p.second(), p.memory)); },
                                .difference = difference,
                                .go_on = go_on},
                               failures);
    EXPECT_EQ(failures.defects, 0u) << failures.first;
}

}  // namespace
}  // namespace ecods::allocation::query_test
