// What every question about two bodies must say of bodies of which one knows how they are to each other.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "ecods/cast.hpp"
#include "ecods/distance.hpp"
#include "ecods/intersection.hpp"
#include "ecods/solid.hpp"
#include "scenes/pose_at.hpp"
#include "unit/query/solid_soup.hpp"

namespace ecods::bodies {

using ShapePtr = std::shared_ptr<const MeshShape>;

inline constexpr std::array all_forms{MeshForm::surface, MeshForm::solid, MeshForm::convex};

inline ShapePtr make(MeshForm form, const MeshPtr& mesh) {
    if (form == MeshForm::convex) return std::make_shared<const ConvexSolid>(mesh);
    if (form == MeshForm::solid) return std::make_shared<const Solid>(mesh);
    return std::make_shared<const MeshShape>(mesh);
}
inline ShapePtr solid_of(const Soup& soup) {
    return make(MeshForm::solid, soup.mesh());
}
inline ShapePtr surface_from(const Soup& soup) {
    return make(MeshForm::surface, soup.mesh());
}

// How two bodies are to each other.
struct Truth {
    Relation relation = Relation::apart;
    bool is_contained = false;       // they share a point, and their boundaries share none
    std::optional<double> distance;  // at poses that are no maps, where it is known

    Truth turned() const { return {swapped(relation), is_contained, distance}; }
};

inline constexpr Truth contained_truth(Relation relation) {
    return {.relation = relation, .is_contained = true, .distance = 0};
}

// Expects that the answer names corner 0 of a triangle of one body, which is at the point.
inline void expect_contained(const ClosestPoints& points, const Posed<MeshShape>& a, const Posed<MeshShape>& b) {
    EXPECT_EQ(points.distance, 0);
    EXPECT_EQ(points.point_a, points.point_b);
    const bool is_of_a = points.a.kind != Feature::Kind::none;
    const Posed<MeshShape>& part = is_of_a ? a : b;
    const Feature& feature = is_of_a ? points.a : points.b;
    EXPECT_EQ(is_of_a ? points.b : points.a, no_feature);
    EXPECT_EQ(feature.kind, Feature::Kind::vertex);
    EXPECT_EQ(feature.corner, 0U);
    const Mesh& mesh = part.what->mesh();
    ASSERT_LT(feature.triangle, mesh.triangles().size());
    const Vec3 at = part.pose.R * mesh.vertices()[mesh.triangles()[feature.triangle][0]] + part.pose.t;
    const double size = part.pose.R.cwiseAbs().maxCoeff() * 100 + part.pose.t.cwiseAbs().maxCoeff();
    EXPECT_LE((points.point_a - at).cwiseAbs().maxCoeff(), 0x1p-48 * size);
}

// Asks, and expects that the question is counted; of surfaces some count two walks.
template <class Question>
auto counted(const Question& question, const Posed<MeshShape>& a, const Posed<MeshShape>& b, QueryMemory& memory,
             PairWitness& witness) {
    QueryCounts counts;
    const Ask ask(memory, witness, counts);
    auto answer = question(a, b, ask);
    EXPECT_GE(counts.queries, 1U);
    EXPECT_LE(counts.queries, 2U);
    return answer;
}

// Asks in one order, and with one witness all along.
inline void expect_answers(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const Truth& truth,
                           QueryMemory& memory, PairWitness& witness) {
    const Ask ask(memory, witness);
    const bool do_meet = truth.relation != Relation::apart;
    const auto one = [&](const auto& question) { return counted(question, a, b, memory, witness); };
    EXPECT_EQ(one([](auto&... all) { return relation(all...); }), truth.relation);
    EXPECT_EQ(one([](auto&... all) { return intersects(all...); }), do_meet);
    const double d = one([](auto&... all) { return distance(all...); });
    EXPECT_EQ(d == 0, do_meet);
    if (truth.distance) {
        EXPECT_EQ(d, *truth.distance);
    }
    EXPECT_EQ(within(a, b, 0, ask), do_meet);
    EXPECT_EQ(within(a, b, -0.0, ask), do_meet);
    EXPECT_EQ(one([d](auto& x, auto& y, auto& how) { return within(x, y, d / 2, how); }), do_meet);
    EXPECT_TRUE(within(a, b, 2 * d, ask));
    EXPECT_TRUE(within(a, b, std::numeric_limits<double>::infinity(), ask));
    EXPECT_EQ(intersects(a, b, ask), do_meet) << "again";
    const DistanceBounds bounds =
        one([](auto& x, auto& y, auto& how) { return distance_bounds(x, y, {.relative = 0x1p-10}, how); });
    EXPECT_LE(bounds.lower, d);
    EXPECT_GE(bounds.upper, d);
    if (truth.is_contained) {
        EXPECT_EQ(bounds.upper, 0);
    }
    const ClosestPoints points = one([](auto&... all) { return closest(all...); });
    EXPECT_EQ(points.distance, d);
    if (truth.is_contained) {
        EXPECT_EQ(points.kind, ClosestKind::contained);
        expect_contained(points, a, b);
    } else if (do_meet) {
        EXPECT_EQ(points.kind, ClosestKind::intersecting);
    } else {
        EXPECT_LT(points.kind, ClosestKind::intersecting);
    }
    EXPECT_EQ(intersecting_triangles(a, b, ask).empty(), !do_meet || truth.is_contained);
    EXPECT_EQ(intersections(a, b, ask).empty(), !do_meet || truth.is_contained);

    const auto still = one([](auto& x, auto& y, auto& how) { return cast(x, Vec3::Zero(), y, 1, how); });
    ASSERT_EQ(still.has_value(), do_meet);
    const auto moving =
        cast(Moving<MeshShape>(*a.what, a.pose, a.pose), Moving<MeshShape>(*b.what, b.pose, b.pose), 1, ask);
    EXPECT_EQ(moving, still);
    if (!do_meet) return;
    EXPECT_EQ(still->time, 0);
    EXPECT_EQ(still->kind, points.kind);
    if (truth.is_contained) {
        EXPECT_EQ(still->a, points.a);
        EXPECT_EQ(still->b, points.b);
    }
    EXPECT_EQ(cast(a, Vec3(1, 2, 3), b, 0, ask), still);
}

// Asks for the bounds, which do not depend on the order, as far as the truth tells.
inline void expect_signed_bounds(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const Truth& truth,
                                 QueryMemory& memory, PairWitness& witness) {
    const DistanceBounds bounds =
        counted([](auto&... all) { return signed_distance_bounds(all...); }, a, b, memory, witness);
    const bool are_solids = a.what->form() != MeshForm::surface && b.what->form() != MeshForm::surface;
    const double d = distance(a, b, memory);
    EXPECT_EQ(bounds.lower < 0, truth.relation >= Relation::overlapping && are_solids);
    EXPECT_LE(bounds.upper, d);
    if (bounds.lower >= 0) {
        EXPECT_EQ(bounds.lower, d);
        EXPECT_EQ(bounds.upper, d);
    }
}

// Asks in both orders, with a witness that knows nothing, with what the last pose left, and with nonsense.
inline void expect_bodies_at(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const Truth& truth,
                             QueryMemory& memory, PairWitness& kept) {
    PairWitness unknown, nonsense{7, 100'000}, half{PairWitness::none, 2};
    for (PairWitness* const witness : {&unknown, &kept, &nonsense, &half}) {
        expect_answers(a, b, truth, memory, *witness);
        expect_answers(b, a, truth.turned(), memory, *witness);
    }
    expect_signed_bounds(a, b, truth, memory, kept);
    EXPECT_EQ(intersects(a, b), truth.relation != Relation::apart) << "in the thread's own memory";
}

// At poses that are the same map for both, so that the relation stays; of some, two that differ in bits.
inline void expect_bodies(const MeshShape& a, const MeshShape& b, const Truth& truth) {
    QueryMemory memory;
    PairWitness kept;
    Truth at_map = truth;
    for (const Pose& pose : common_poses()) {
        SCOPED_TRACE(testing::Message() << pose.R << "\n, " << pose.t.transpose());
        expect_bodies_at({a, pose}, {b, pose}, at_map, memory, kept);
        Pose other = pose;
        for (double& x : other.R.reshaped()) x = x == 0 ? -0.0 : x;
        expect_bodies_at({a, pose}, {b, other}, at_map, memory, kept);
        if (!truth.is_contained && truth.relation == Relation::apart) at_map.distance.reset();
    }
}

}  // namespace ecods::bodies
