// Bodies in each other at singular poses, at poses of bodies alone, near contact, and wherever the question is asked.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

#include "ecods/hit.hpp"
#include "environment/each_environment.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"
#include "unit/query/bodies.hpp"

namespace ecods::body_poses_test {
namespace {

using namespace bodies;

constexpr auto apart = Relation::apart, touching = Relation::touching, crossing = Relation::crossing,
               inside = Relation::inside, contains = Relation::contains;

void expect_at(const MeshShape& a, const Pose& p, const MeshShape& b, const Pose& q, const Truth& truth) {
    QueryMemory memory;
    PairWitness kept;
    expect_bodies_at({a, p}, {b, q}, truth, memory, kept);
}

Pose scaled(double x, double y, double z, const Vec3& t = Vec3(0, 0, 0)) {
    Pose pose = at(t);
    pose.R.diagonal() = Vec3(x, y, z);
    return pose;
}

// A flat image is one of the surface: inside a solid it touches, as a solid, and is inside, as a surface.
TEST(BodyPoses, FlatImages) {
    const ShapePtr cube = make(MeshForm::solid, box({-2, -2, -2}, {2, 2, 2}));
    const ShapePtr convex = make(MeshForm::convex, box({-2, -2, -2}, {2, 2, 2}));
    const auto mesh = box({-1, -1, -1}, {1, 1, 1});
    const double beyond = std::nextafter(2.0, 3.0);
    for (const ShapePtr& whole : {cube, convex}) {
        for (const MeshForm form : all_forms) {
            const ShapePtr part = make(form, mesh);
            const bool is_solid = form != MeshForm::surface;
            for (const Pose& flat : {scaled(1, 1, 0), scaled(1, 0, 0), scaled(0, 0, 0)}) {
                expect_at(*part, flat, *whole, {}, contained_truth(is_solid ? touching : inside));
                Pose on = flat, off = flat;
                on.t = Vec3(0, 0, 2);
                expect_at(*part, on, *whole, {}, {.relation = touching, .distance = 0});
                off.t = Vec3(0, 0, beyond);
                expect_at(*part, off, *whole, {}, {.relation = apart, .distance = beyond - 2});
                off.t = Vec3(0, 0, 5);
                expect_at(*part, off, *whole, {}, {.relation = apart, .distance = 3});
                // Two flat images share points where their surfaces do.
                expect_at(*part, flat, *whole, scaled(1, 1, 0), {.relation = touching, .distance = 0});
                expect_at(*part, flat, *whole, scaled(1, 1, 0, {0, 0, 1}), {.relation = apart, .distance = 1});
            }
            // The flat image of the large one around the small body, and across it.
            expect_at(*part, {}, *whole, scaled(1, 1, 0, {0, 0, 3}), {.relation = apart, .distance = 2});
            const Relation relation = is_solid ? touching : crossing;
            const auto across = ecods::relation({*part, {}}, {*whole, scaled(1, 1, 0)});
            EXPECT_TRUE(across == relation || across == touching);
            EXPECT_TRUE(intersects({*part, {}}, {*whole, scaled(1, 1, 0)}));
        }
    }
    // Nothing is inside a surface, flat or not.
    const ShapePtr surface = make(MeshForm::surface, box({-2, -2, -2}, {2, 2, 2}));
    expect_at(*make(MeshForm::solid, mesh), scaled(1, 1, 0), *surface, {}, {.relation = apart, .distance = 1});
}

// Just inside, on and just beyond a face, seen from in and from out, at poses of either.
TEST(BodyPoses, OneUnitInTheLastPlace) {
    const double ulp = 0x1p-52;
    for (const MeshForm form : {MeshForm::solid, MeshForm::convex}) {
        const ShapePtr cube = make(form, box({-1, -1, -1}, {1, 1, 1}));
        for (const MeshForm of_part : all_forms) {
            const ShapePtr part = make(of_part, box({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}));
            expect_at(*cube, {}, *part, at(0.5 - ulp / 4, 0, 0), contained_truth(contains));
            expect_at(*cube, {}, *part, at(0.5), {.relation = contains, .distance = 0});
            Pose larger = scaled(2 + 2 * ulp, 2 + 2 * ulp, 2 + 2 * ulp), smaller = scaled(2 - ulp, 2 - ulp, 2 - ulp);
            expect_at(*cube, {}, *part, smaller, contained_truth(contains));
            const bool is_surface = of_part == MeshForm::surface;
            expect_at(*cube, {}, *part, larger,
                      is_surface ? Truth{.relation = apart, .distance = ulp} : contained_truth(inside));
            // Mirrored.
            smaller.R(1, 1) *= -1;
            expect_at(*cube, {}, *part, smaller, contained_truth(contains));
            smaller.R *= 0x1p-1070;
            expect_at(*cube, {}, *part, smaller, contained_truth(contains));
            expect_at(*cube, scaled(0x1p900, -0x1p900, 0x1p900), *part, larger, contained_truth(contains));
        }
    }
}

// Bodies of all forms at random poses, so that all relations are there: against the relation, which has a search of its
// own.
TEST(BodyPoses, AsTheRelationSays) {
    scenes::Random random(8);
    QueryMemory memory;
    PairWitness kept;
    Soup hollow = soup_of_box({-2, -2, -2}, {2, 2, 2});
    hollow.add_box({-1.5, -1.5, -1.5}, {1.5, 1.5, 1.5});
    std::vector<ShapePtr> shapes{solid_of(hollow),
                                 make(MeshForm::solid, scenes::torus(9, 6, 0.375)),
                                 std::make_shared<const ConvexSolid>(scenes::sphere(7, 6)->vertices()),
                                 make(MeshForm::convex, box({-2, -2, -2}, {2, 2, 2}, 2)),
                                 make(MeshForm::surface, scenes::sphere(7, 6)),
                                 make(MeshForm::surface, box({-0.25, -0.25, -0.25}, {0.25, 0.25, 0.25}))};
    std::map<Relation, int> counts;
    int contained_count = 0;
    for (int i = 0; i < 400; ++i) {
        const auto pick = [&] { return shapes[random.below(static_cast<std::uint32_t>(shapes.size()))]; };
        const ShapePtr x = pick(), y = pick();
        Pose p = random.turned(), q = random.turned();
        for (Pose* pose : {&p, &q}) {
            pose->R *= std::ldexp(1.0, static_cast<int>(random.below(3)) - 2);
            if (random.below(4) == 0) pose->R.col(1) *= -1;
            pose->t = random.uniform(0, 1.5) * random.direction();
        }
        const Posed<MeshShape> a(x, p), b(y, q);
        Truth truth{.relation = relation(a, b, memory), .distance = {}};
        ++counts[truth.relation];
        truth.is_contained = truth.relation != apart && intersecting_triangles(a, b, memory).empty();
        contained_count += truth.is_contained;
        expect_bodies_at(a, b, truth, memory, kept);
    }
    EXPECT_EQ(counts.size(), 5U);  // apart, crossing, overlapping, inside, contains
    EXPECT_GT(contained_count, 30);
    EXPECT_GT(counts[apart], 50);
}

// Every number and name of the answers about two bodies.
std::vector<double> all_numbers(const Posed<MeshShape>& a, const Posed<MeshShape>& b, double unit,
                                QueryMemory& memory) {
    PairWitness witness;
    const Ask ask(memory, witness);
    std::vector<double> all;
    const auto add = [&](auto... numbers) { (all.push_back(static_cast<double>(numbers)), ...); };
    const auto add_feature = [&](const Feature& f) { add(static_cast<int>(f.kind), f.triangle, f.corner); };
    for (const auto& [x, y] : {std::pair(&a, &b), {&b, &a}}) {
        const ClosestPoints points = closest(*x, *y, ask);
        add_feature(points.a);
        add_feature(points.b);
        add(points.distance, static_cast<int>(points.kind), intersects(*x, *y, ask), distance(*x, *y, ask),
            within(*x, *y, unit, ask), static_cast<int>(relation(*x, *y, ask)));
        for (int k = 0; k < 3; ++k) add(points.point_a[k], points.point_b[k]);
        const auto contact = cast(*x, Vec3(unit, 0, 0), *y, 1, ask);
        add(contact ? contact->time : -1, contact ? static_cast<int>(contact->kind) : -1);
    }
    const Ray ray{a.pose.t, Vec3(1, 2, 3)};
    for (const Hit& hit : all_hits(ray, b, memory)) {
        add(hit.parameter, hit.rank, static_cast<int>(hit.kind), hit.triangle());
    }
    const auto hit = first_hit(ray, b, ask);
    add(hit ? hit->parameter : -1, hit ? static_cast<int>(hit->kind) : -1);
    return all;
}

// In every mode and with every instruction set.
TEST(BodyPoses, TheSameInEveryEnvironment) {
    scenes::Random random(9);
    QueryMemory memory;
    Soup pieces = soup_of_box({-0.25, -0.25, -0.25}, {0.25, 0.25, 0.25});
    pieces.add({4, 0, 0}, {4, 1, 0}, {4, 0, 1});
    Soup walls = soup_of_box({-2, -2, -2}, {2, 2, 2});
    walls.add({0, 0, 0}, {9, 0, 0}, {0, 0, 0});
    const std::vector<ShapePtr> parts{make(MeshForm::solid, scenes::sphere(6, 4)), surface_from(pieces),
                                      make(MeshForm::convex, box({-1, -1, -1}, {1, 1, 1}))};
    const std::vector<ShapePtr> wholes{solid_of(walls), make(MeshForm::convex, box({-2, -2, -2}, {2, 2, 2}, 2))};
    int contained_count = 0, apart_count = 0;
    for (const int exponent : {0, -1040, -600, 700}) {
        for (int i = 0; i < 12; ++i) {
            const double unit = std::ldexp(1.0, exponent);
            Pose p, q;
            p.R = random.rotation().toRotationMatrix() * unit;
            q.R = i % 4 == 0 ? p.R : Mat3(random.rotation().toRotationMatrix() * unit);
            if (i % 3 == 0) q.R.row(1) *= -1;
            q.t = random.direction() * (0.5 * i) * unit;
            if (i == 11) q.R.col(1) = q.R.col(2);
            const Posed<MeshShape> a(parts[static_cast<std::size_t>(i % 3)], p);
            const Posed<MeshShape> b(wholes[static_cast<std::size_t>(i % 2)], q);
            const auto ask = [&] { return all_numbers(a, b, unit, memory); };
            const auto expected = ask();
            contained_count += expected[7] == static_cast<int>(ClosestKind::contained);
            apart_count += expected[7] < static_cast<int>(ClosestKind::intersecting);
            environment::in_each_environment(ask, [&](const auto& answer, const std::string& where) {
                EXPECT_EQ(answer, expected) << where << ", 2^" << exponent << ", pose " << i;
            });
        }
    }
    EXPECT_GT(contained_count, 4);
    EXPECT_GT(apart_count, 4);
}

}  // namespace
}  // namespace ecods::body_poses_test
