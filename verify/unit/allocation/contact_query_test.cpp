// Questions about sides of hits, entering, points of contacts, casts to a distance and deforming meshes, out of memory
// at any point. Some have thousands of allocations, since their exact numbers may have any length; so not each one
// fails.
#include <gtest/gtest.h>

#include <memory>
#include <utility>
#include <vector>

#include "ecods/cast.hpp"
#include "ecods/contact.hpp"
#include "ecods/hit.hpp"
#include "ecods/rounded.hpp"
#include "ecods/world.hpp"
#include "unit/allocation/pair_scene.hpp"

namespace ecods::allocation::contact_query_test {
namespace {

// Through the middle of both bodies, along edges of the cube.
const Segment through{{3, 0.125, 0.25}, {-3, -0.125, -0.25}};
const Ray along_an_edge{{-3, 1, 1}, {1, 0, 0}};

void add(Digest& all, const std::vector<SidedHit>& hits) {
    for (const SidedHit& hit : hits) {
        all.add(hit.hit);
        all.add(hit.passage);
        all.add(hit.normal);
    }
}
void add(Digest& all, const std::vector<InsidePart>& parts) {
    for (const InsidePart& part : parts) {
        all.add(part.from_point);
        all.add(part.to_point);
    }
}

const PairCall questions[] = {
    {"sides, normals and lists of hits, and parts inside",
     [](Pair& p) {
         const Solid cube(scenes::cube(1)), ring(p.b->mesh_ptr());
         Digest all;
         add(all, sided_hits(through, {ring, p.pose_b}, p.memory));
         add(all, sided_hits(along_an_edge, {cube, p.pose_a}, p.memory));
         add(all, inside_parts(through, {ring, p.pose_b}, p.memory));
         const auto hit = first_hit(along_an_edge, {cube, p.pose_a}, {p.memory, p.witness});
         all.add(hit_normal(along_an_edge, {cube, p.pose_a}, *hit, p.memory));
         const std::vector<Segment> lines{through, {{3, 0, 0}, {-3, 0, 0}}};
         all.add(all_hits(lines, p.second(), p.memory).hits);
         p.answer = all.value();
     }},
    {"entering and pose_before",
     [](Pair& p) {
         const Solid cube(scenes::cube(0.5)), ring(p.b->mesh_ptr());
         Pose start = p.pose_b;
         start.t[0] += 4;
         const Vec3 motion = -1.5 * start.t;
         Digest all;
         for (const auto& entry : {entering({ring, start}, motion, {cube, p.pose_a}, 1, p.memory),
                                   entering({*p.b, start}, motion, p.first(), 0.75, p.memory),
                                   entering({cube, p.pose_a}, {0, 0, -1}, {cube, {.t = {0.25, 0, -1}}}, 1, p.memory)}) {
             all.add(entry ? entry->time : -1);
         }
         const auto before = pose_before({ring, start}, motion, {cube, p.pose_a}, 0.5, p.memory);
         all.add(before ? before->t : Vec3(0, 0, 0));
         p.answer = all.value();
     }},
    {"contact_point",
     [](Pair& p) {
         const ConvexSolid cube(scenes::cube(0.5));
         const Posed<MeshShape> floor(cube, p.pose_a);
         Digest all;
         for (const Vec3& at : {Vec3(0.25, 0.125, 4), Vec3(1, 0.125, 4), Vec3(1, 1, 4)}) {
             const Posed<MeshShape> falling(cube, {.t = at});
             const auto contact = cast(falling, {0, 0, -6}, floor, 1, {p.memory, p.witness});
             const ContactPoint found = contact_point(falling, {0, 0, -6}, floor, *contact, p.memory);
             all.add(found.point);
             all.add(found.normal);
         }
         p.answer = all.value();
     }},
    {"cast_to_distance",
     [](Pair& p) {
         Pose start = p.pose_b;
         start.t[0] += 4;
         const auto near = cast_to_distance({*p.b, start}, -1.5 * start.t, p.first(), 0.375, 1, {p.memory, p.witness});
         p.answer = digest(near) + digest(cast_to_distance(Posed<Rounded>(sphere(0.125), start), -1.5 * start.t,
                                                           p.first(), 0x1p-60, 1, p.memory));
     }},
    {"Deforming and its casts",
     [](Pair& p) {
         std::vector<Vec3> vertices(p.b->mesh().vertices().begin(), p.b->mesh().vertices().end());
         for (Vec3& v : vertices) v = Vec3(2 * v[1] - 1, v[0] + 0.25, -v[2]);
         const Deforming bends(p.b, std::move(vertices));
         Pose there = p.pose_b;
         there.t[0] += 1.5;
         const ConvexSolid room(scenes::cube(8));
         Digest all;
         all.add(cast(bends, Posed<MeshShape>(*p.a, there), 1, {p.memory, p.witness}));
         all.add(cast(Moving<MeshShape>(*p.a, there, p.pose_b), bends, 1, p.memory));
         all.add(cast(bends, Posed<MeshShape>(room, p.pose_a), 1, p.memory));
         p.answer = all.value();
     }},
    {"entering, contact_point and lists of hits of a World",
     [](Pair& p) {
         World world;
         world.create_body(p.a, p.pose_a);
         world.create_body(p.b, p.pose_b);
         world.update();
         const Posed<Shape> mover(*p.a, {.t = {6, 0.25, 0.125}});
         const Vec3 motion(-8, 0, 0);
         Digest all;
         const auto entry = world.entering(mover, motion, 0.875, p.memory);
         all.add(entry ? entry->entry.time : -1);
         const auto contact = world.cast(mover, motion, 1, p.memory);
         if (contact && contact->contact.time > 0)
             all.add(world.contact_point(mover, motion, *contact, p.memory).point);
         const std::vector<Segment> lines{through};
         for (const BodyHit& hit : world.all_hits(lines, {}, p.memory).hits) all.add(hit.hit);
         p.answer = all.value();
     }},
    {"sides of hits, parts inside and casts of a Deforming of a World",
     [](Pair& p) {
         World world;
         world.create_body(std::make_shared<const Solid>(scenes::cube(1)), p.pose_a);
         world.create_body(std::make_shared<const Solid>(p.b->mesh_ptr()), p.pose_b);
         Digest all;
         for (const BodySidedHit& hit : world.sided_hits(through, {}, p.memory)) all.add(hit.sided.hit);
         for (const BodyInsidePart& part : world.inside_parts(along_an_edge, {}, p.memory)) all.add(part.part.to_point);
         std::vector<Vec3> vertices(p.a->mesh().vertices().begin(), p.a->mesh().vertices().end());
         for (Vec3& v : vertices) v = Vec3(2 * v[1] - 1, v[0] + 0.25, -v[2]);
         const auto contact = world.cast(Deforming(p.a, std::move(vertices)), 1, {}, p.memory);
         all.add(contact ? contact->contact.time : -1);
         p.answer = all.value();
     }},
    {"contact_point of rounded bodies",
     [](Pair& p) {
         const Posed<Rounded> ball(sphere(0.5), {.t = {5, 0.25, 0.125}});
         const Vec3 motion(-8, 0, 0);
         const auto contact = cast(ball, motion, p.first(), 1, {p.memory, p.witness});
         const ContactPoint found = contact_point(ball, motion, p.first(), *contact, p.memory);
         Digest all;
         all.add(found.point);
         all.add(found.normal);
         p.answer = all.value();
     }},
};

TEST(ContactQueryOutOfMemory, EveryQuestionIsAnsweredTheNextTime) {
    for (const PairCall& question : questions) {
        Failures failures;
        for (const double distance : {0.75, 2.25}) {
            const Trial<Pair> trial = trial_of(question, distance);
            fail_each_allocation(trial, failures, stride_of(trial, 150));
        }
        EXPECT_EQ(failures.defects, 0u) << question.name << "; first: " << failures.first;
    }
}

}  // namespace
}  // namespace ecods::allocation::contact_query_test
