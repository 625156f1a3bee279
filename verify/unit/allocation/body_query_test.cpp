// Questions about rounded bodies, flat solids and contact patches, out of memory at any point. They have thousands of
// allocations, since their exact numbers may have any length; so not each one fails.
#include <gtest/gtest.h>

#include <array>
#include <span>
#include <vector>

#include "ecods/contact.hpp"
#include "ecods/hit.hpp"
#include "ecods/rounded.hpp"
#include "ecods/solid.hpp"
#include "unit/allocation/pair_scene.hpp"

namespace ecods::allocation::body_query_test {
namespace {

const PairCall questions[] = {
    {"questions about rounded bodies",
     [](Pair& p) {
         const Rounded padded(p.a, 0x1p-60);
         const auto ball = sphere(0.1, {0.125, 0, 0}), bone = capsule({0, 0, 0}, {1e-200, 0, 1}, 0x1p-1074);
         const Posed<Rounded> first(padded, p.pose_a);
         const HalfSpace ground(Vec3(0, 0x1p-30, 1), -5);
         Digest all;
         for (const auto& other : {ball, bone}) {
             const Posed<Rounded> second(other, p.pose_b);
             all.add(intersects(first, second, {p.memory, p.witness}));
             all.add(distance(first, second, {p.memory, p.witness}));
             all.add(closest(first, second, {p.memory, p.witness}));
             all.add(relation(second, p.first(), {p.memory, p.witness}));
             all.add(distance_bounds(first, second, {.relative = 0.25}, {p.memory, p.witness}));
             all.add(signed_distance(second, {ball, p.pose_a}, {p.memory, p.witness}).distance);
             all.add(signed_distance(Vec3(0.1, 0.2, 1e-200), second, p.memory));
             all.add(locate(Vec3(0.1, 0.2, 1e-200), second, p.memory).side);
             const auto contact = cast(first, {1, 0.5, 1e-200}, second, 1, p.memory);
             all.add(contact ? contact->time : -1);
             const Pose to{p.pose_a.R, p.pose_a.t + Vec3(1, 0.5, 1e-200)}, low{p.pose_a.R, Vec3(0, 0, -9)};
             const Moving<Rounded> moving(padded, p.pose_a, to), falling(other, p.pose_b, low);
             const auto met = cast(moving, Moving<Rounded>(other, p.pose_b, p.pose_b), 1, p.memory);
             all.add(met ? met->time : -1);
             const auto landed = cast(falling, Moving<HalfSpace>(ground, Pose(), Pose()), 1, p.memory);
             all.add(landed ? landed->time : -1);
             const Ray ray{{-9, 0.01, 1e-200}, {1, 1e-3, 0}};
             for (const Hit& hit : other->all_hits(ray, p.pose_b, p.memory)) all.add(hit.parameter);
             if (const auto hit = other->first_hit(ray, p.pose_b, p.memory)) all.add(hit->point[1]);
         }
         p.answer = all.value();
     }},
    {"flat convex solids",
     [](Pair& p) {
         const std::vector<Vec3> corners{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 0}};
         const ConvexSolid plate{std::span<const Vec3>(corners)}, rod{std::span<const Vec3>(corners.data(), 2)};
         const Posed<ConvexSolid> a(plate, p.pose_a), b(rod, p.pose_b);
         p.answer = digest(signed_distance(a, b, {p.memory, p.witness}).distance) + digest_depth(a, b, p) +
                    digest(signed_distance(a, a, p.memory).direction) + digest(relation(a, b, p.memory));
     }},
    {"contact_patch",
     [](Pair& p) {
         const ConvexSolid a(scenes::cube(1)), b(p.b->mesh().vertices());
         const PatchLimits limits{.max_corners = 3, .min_cos_squared = 0x1p-20};
         const ContactPatch patch = contact_patch({a, p.pose_a}, {b, p.pose_b}, limits, {p.memory, p.witness});
         const auto deep = depth_along({a, p.pose_a}, {a, p.pose_a}, Vec3(1, 2, 3), p.memory);
         p.answer = digest(patch.distance) + digest(patch.corners[0].middle) + digest(deep->parameter);
     }},
};

TEST(BodyQueryOutOfMemory, EveryQuestionIsAnsweredTheNextTime) {
    for (const PairCall& question : questions) {
        Failures failures;
        for (const double distance : {0.75, 2.25}) {
            const Trial<Pair> trial = trial_of(question, distance);
            fail_each_allocation(trial, failures, stride_of(trial, 200));
        }
        EXPECT_EQ(failures.defects, 0u) << question.name << "; first: " << failures.first;
    }
}

}  // namespace
}  // namespace ecods::allocation::body_query_test
