// First contacts of a body that turns: times that are known, and all pairs of triangles decided one by one.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/next.hpp"
#include "ecods/builders.hpp"
#include "ecods/error.hpp"
#include "ecods/intersection.hpp"
#include "ecods/turn.hpp"
#include "environment/each_environment.hpp"
#include "exact/measure/contact/first_meeting.hpp"
#include "exact/measure/contact/turning_triangles.hpp"
#include "exact/measure/distance/name_features.hpp"
#include "geometry/feature_key.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"
#include "scenes/turn_workloads.hpp"
#include "unit/query/cast_bodies.hpp"

namespace ecods::cast_turning_test {
namespace {

std::optional<FirstContact> cast_at(const MeshShape& a, const Turn& turn, const MeshShape& b, double max_time = 1) {
    QueryMemory memory;
    return cast({a, Pose(), turn}, {b, Pose()}, max_time, memory);
}

// Half a turn: the point (5, 0, 0) is at (3, 4, 0) at a third of the time.
TEST(CastTurning, KnownTimes) {
    const Turn half{{0, 0, 0, 1}, Vec3::Zero(), Vec3::Zero()};
    const MeshShape point = shape_of({{5, 0, 0}, {5, 0, 0}, {5, 0, 0}});
    const MeshShape wall = shape_of({{0, 0, -9}, {0, 0, 9}, {9, 12, 0}});
    const auto contact = cast_at(point, half, wall);
    expect_contact(contact, 1 / 3.0, ClosestKind::vertex_face);
    EXPECT_EQ(contact->b, (Feature{Feature::Kind::face, 0, 0}));
    expect_contact(cast_at(point, half, shape_of({{3, 4, -1}, {3, 4, 1}, {9, 12, 0}})), 1 / 3.0,
                   ClosestKind::vertex_edge);
    expect_contact(cast_at(point, half, shape_of({{3, 4, 0}, {3, 4, 0}, {3, 4, 0}})), 1 / 3.0,
                   ClosestKind::vertex_vertex);
    EXPECT_FALSE(cast_at(point, half, shape_of({{3, -4, 0}, {3, -4, 1}, {3, -5, 0}})));
    EXPECT_FALSE(cast_at(point, half, wall, 1 / 3.0));  // the double is below a third
    EXPECT_TRUE(cast_at(point, half, wall, next_up(1 / 3.0)));
    EXPECT_FALSE(cast_at(point, half, shape_of({{5, 0, 0.5}, {5, 1, 1}, {5, -1, 1}})));
    expect_contact(cast_at(point, half, shape_of({{-5, 0, 0}, {-5, 0, 0}, {-5, 0, 0}})), 1, ClosestKind::vertex_vertex);
    EXPECT_EQ(angle_at(half, 1.0 / 2), std::numbers::pi / 2);
}

// A limit is compared with the real time, and bodies of any size are turned alike.
TEST(CastTurning, Scales) {
    for (const int exponent : {-1000, -300, 0, 300, 900}) {
        const double unit = std::ldexp(1.0, exponent);
        const auto vector = [&](double x, double y, double z) { return Vec3(unit * Vec3(x, y, z)); };
        const Turn half{{0, 0, 0, 1}, vector(1, 2, 3), vector(1, 2, 3)};
        const Vec3 start = vector(6, 2, 3);
        const MeshShape body = shape_of({start, vector(6, 1, 3), vector(6, 1, 4)});
        const MeshShape wall = shape_of({vector(4, 6, 2), vector(4, 6, 4), vector(5, 9, 3)});
        expect_contact(cast_at(body, half, wall), 1 / 3.0, ClosestKind::vertex_edge);
    }
}

// A row of points turns along a ring of points that it nearly touches, and meets a bar half-way.
TEST(CastTurning, LongAndNear) {
    std::vector<Vec3> row, ring;
    const auto on_circle = [](double radius, double degrees) {
        const double angle = degrees * std::numbers::pi / 180;
        return Vec3(radius * std::cos(angle), radius * std::sin(angle), 0);
    };
    for (int i = 0; i < 300; ++i) row.insert(row.end(), 3, on_circle(1, -0.125 * i));
    for (int i = 0; i < 720; ++i) ring.insert(ring.end(), 3, on_circle(1.001, 0.5 * i + 0.25));
    for (const Vec3& corner : {Vec3(0, 0.5, 0), Vec3(0, 1.5, 0), Vec3(0, 1.5, 0)}) ring.push_back(corner);
    const Turn half{{0, 0, 0, 1}, Vec3::Zero(), Vec3::Zero()};
    QueryMemory memory;
    const MeshShape a = shape_of(row), b = shape_of(ring);
    const auto contact = cast({a, Pose(), half}, {b, Pose()}, 1, memory);
    expect_contact(contact, 0.5, ClosestKind::vertex_edge);
    EXPECT_EQ(contact->b.triangle, 720u);
    ring.resize(ring.size() - 3);
    EXPECT_FALSE(cast_at(a, half, shape_of(ring)));
}

// A point glides along its axis through a ring, and is never far from straight.
TEST(CastTurning, PointOnTheAxis) {
    const MeshShape point = shape_of(single_point), ring(scenes::torus(24, 12, 0.25));
    const Turn screw{{1, 0, 0, 1}, Vec3::Zero(), {0, 0, 0.125}};
    QueryCounts counts;
    EXPECT_FALSE(cast({point, Pose(), screw}, {ring, Pose()}, 1, {counts}));
    EXPECT_LT(counts.box_tests, 100u);
    expect_contact(cast_at(point, screw, shape_of({{-1, -1, 0.0625}, {2, -1, 0.0625}, {-1, 2, 0.0625}})), 0.5,
                   ClosestKind::vertex_face);
}

// More than half a turn, the other way, and a body that glides along.
TEST(CastTurning, LongWayAndGlide) {
    const Turn most{{-1, 0, 0, 1}, Vec3::Zero(), Vec3::Zero()}, other{{1, 0, 0, -1}, Vec3::Zero(), Vec3::Zero()};
    const MeshShape point = shape_of({{1, 0, 0}, {1, 0, 0}, {1, 0, 0}}),
                    target = shape_of({{0, -1, -1}, {0, -1, 1}, {0, -3, 0}});
    expect_contact(cast_at(point, most, target), 1, ClosestKind::vertex_edge);
    expect_contact(cast_at(point, other, target), 1, ClosestKind::vertex_edge);
    const Turn screw{{0, 0, 0, 1}, Vec3::Zero(), {0, 0, 6}};
    expect_contact(
        cast_at(shape_of({{5, 0, 0}, {5, 0, 0}, {5, 0, 0}}), screw, shape_of({{3, 4, 2}, {3, 4, 2}, {9, 12, 2}})),
        1 / 3.0, ClosestKind::vertex_vertex);
    const Turn glide{{7, 0, 0, 0}, Vec3::Zero(), {0, 0, 3}};
    expect_contact(
        cast_at(shape_of({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}), glide, shape_of({{-1, -1, 1}, {2, -1, 1}, {-1, 2, 1}})),
        1 / 3.0, ClosestKind::vertex_face);
}

TEST(CastTurning, StartAndWholeTurns) {
    const MeshShape a = shape_of(flat), b = shape_of(needle);
    expect_contact(cast_at(a, {{1, 0, 0, 1}, Vec3::Zero(), Vec3::Zero()}, b), 0, ClosestKind::intersecting);
    const auto refused = [&](const Turn& turn, const std::string& part) {
        try {
            static_cast<void>(cast_at(a, turn, b));
            ADD_FAILURE() << part;
        } catch (const InvalidArgument& error) {
            EXPECT_EQ(error.argument, Argument::turn);
            EXPECT_EQ(error.part, part);
        }
    };
    refused({{0, 0, 0, 0}, Vec3::Zero(), Vec3::Zero()}, "q");
    refused({{-1, 0, 0, 0}, Vec3::Zero(), Vec3::Zero()}, "q");
    refused({{1, std::nan(""), 0, 0}, Vec3::Zero(), Vec3::Zero()}, "q.x");
    refused({{1, 0, 0, 0}, Vec3::Zero(), {0, 0, INFINITY}}, "pivot_to(2)");
}

// The first contact of all pairs of triangles, each decided exactly. The bodies must not meet at the start.
std::optional<FirstContact> of_all_pairs(const Turning<MeshShape>& a, const Vec3& motion, const Posed<MeshShape>& b) {
    const Mesh &x = a.what->mesh(), &y = b.what->mesh();
    const exact::TurnIntegers turn(a.turn.q.w, {a.turn.q.x, a.turn.q.y, a.turn.q.z});
    const Pose world;
    const Vec3 origin = Vec3::Zero();
    std::optional<FirstContact> first;
    for (std::uint32_t i = 0; i < x.triangles().size(); ++i) {
        for (std::uint32_t j = 0; j < y.triangles().size(); ++j) {
            exact::PosedPoints<11> points;
            for (std::size_t k = 0; k < 3; ++k) {
                points[k] = {&a.pose, &x.vertices()[x.triangles()[i][k]]};
                points[3 + k] = {&b.pose, &y.vertices()[y.triangles()[j][k]]};
            }
            points[6] = {&world, &a.turn.pivot_from};
            points[7] = {&world, &a.turn.pivot_to};
            points[8] = {&world, &origin};
            points[9] = {&world, &motion};
            points[10] = {&world, &a.turn.pivot_from};
            const auto meeting = exact::with_integers(points, [&](const auto& integers) {
                exact::TurningTriangles triangles(integers, turn);
                return exact::first_meeting(triangles);
            });
            if (!meeting) continue;
            FirstContact contact;
            contact.time = meeting->time;
            exact::name_features(contact, meeting->features, {i, j});
            if (first && (first->time < contact.time || (first->time == contact.time && rank(*first) <= rank(contact))))
                continue;
            first = contact;
        }
    }
    return first;
}

TEST(CastTurning, FirstOfAllPairs) {
    scenes::Random random(7);
    const MeshShape ball(scenes::sphere(3, 2)), ring(scenes::torus(3, 3, 0.4)), box(scenes::cube(0.5));
    const std::array<const MeshShape*, 3> shapes{&ball, &ring, &box};
    int met = 0, missed = 0;
    for (int run = 0; run < 40; ++run) {
        const MeshShape &a = *shapes[random.below(3)], &b = *shapes[random.below(3)];
        const bool is_lattice = random.below(3) == 0;
        const auto vector = [&](double size) {
            const Vec3 v(random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size));
            return is_lattice ? Vec3(v.array().round()) : v;
        };
        const Pose from = is_lattice ? Pose{Mat3::Identity(), vector(2)} : Pose{random.turned().R, vector(2)};
        const Vec3 v = vector(2), pivot = vector(2), glide = random.below(2) == 0 ? Vec3(Vec3::Zero()) : vector(2);
        const double w = random.below(4) == 0 ? -0.5 : random.uniform(0.25, 1);
        const Turn turn{{is_lattice || v.isZero() ? 1 : w, v[0], v[1], v[2]}, pivot, pivot + glide};
        const Posed<MeshShape> at_start(a, from), other(b, random.below(2) == 0 ? Pose() : random.turned());
        if (intersects(at_start, other)) continue;
        const Turning<MeshShape> turning(a, from, turn);
        const Vec3 motion = run % 2 == 0 ? vector(1) : Vec3(Vec3::Zero());
        const auto expected = of_all_pairs(turning, motion, other);
        const auto contact = run % 2 == 0 ? cast(turning, motion, other) : cast(turning, other);
        ASSERT_EQ(contact.has_value(), expected.has_value()) << run;
        EXPECT_EQ(contact, expected) << run << ' ' << (contact ? contact->time : -1);
        if (run % 8 == 0) {
            environment::in_each_environment([&] { return cast(turning, motion, other); },
                                             [&](const auto& there, const std::string& where) {
                                                 EXPECT_EQ(there, expected) << run << ' ' << where;
                                             });
        }
        ++(contact ? met : missed);
    }
    EXPECT_GE(met, 8);
    EXPECT_GT(missed, 4);
}

TEST(CastTurning, AnglesAndTimes) {
    const Turn quarter{{1, 0, 0, 1}, Vec3::Zero(), Vec3::Zero()};
    EXPECT_EQ(angle_at(quarter, 0), 0);
    EXPECT_EQ(angle_at(quarter, 1), std::numbers::pi / 2);
    EXPECT_EQ(time_at(quarter, std::numbers::pi / 2), next_down(1.0));  // the double is below pi / 2
    EXPECT_EQ(time_at(quarter, next_up(std::numbers::pi / 2)), 1);
    EXPECT_EQ(time_at(quarter, 7), 1);
    EXPECT_EQ(time_at(quarter, 0), 0);
    EXPECT_NEAR(time_at(quarter, 0.5), std::tan(0.25), 1e-15);
    scenes::Random random(3);
    for (int run = 0; run < 30; ++run) {
        const Turn turn{{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)},
                        Vec3::Zero(),
                        Vec3::Zero()};
        const double time = random.uniform(0, 1), angle = angle_at(turn, time);
        EXPECT_NEAR(time_at(turn, angle), time, 1e-12);
        EXPECT_LE(angle_at(turn, next_down(time)), angle);
        EXPECT_LE(angle, angle_at(turn, next_up(time)));
        const double given = random.uniform(-6.28, 6.28);
        const Turn made = about(random.direction(), given, Vec3::Zero());
        EXPECT_NEAR(angle_at(made, 1), std::abs(given), 1e-14);
        EXPECT_NEAR(std::hypot(made.q.w, std::hypot(made.q.x, made.q.y, made.q.z)), 1, 1e-15);
    }
    EXPECT_EQ(about({0, 0, 3}, 0, {1, 2, 3}).q, Quaternion());
    EXPECT_EQ(about({0, 0, 3}, -std::numbers::pi, {1, 2, 3}).q.z, -1);
}

TEST(CastTurning, PosesAndGaps) {
    scenes::Random random(5);
    const MeshShape ring(scenes::torus(8, 6, 0.4));
    for (int run = 0; run < 30; ++run) {
        const auto vector = [&] { return Vec3(random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2)); };
        const Pose from{random.turned().R, vector()}, to{random.turned().R, vector()};
        const Vec3 pivot = vector();
        const Turn turn = between(from, to, pivot);
        EXPECT_GE(turn.q.w, 0);
        EXPECT_LT(end_gap(ring, from, turn, to), 2e-14);
        EXPECT_GT(end_gap(ring, from, turn, to), 0);
        const Pose end = pose_at(from, turn, 1), middle = pose_at(from, turn, 0.5);
        EXPECT_LT((end.R - to.R).norm() + (end.t - to.t).norm(), 2e-14);
        EXPECT_EQ(pose_at(from, turn, 0), from);
        EXPECT_LT((middle.R.transpose() * middle.R - Mat3::Identity()).norm(), 1e-14);
        const Vec3 half = 0.5 * turn.pivot_from + 0.5 * turn.pivot_to;
        EXPECT_LT((middle.R * pivot + middle.t - half).norm(), 1e-14);
    }
    const Pose mirror{Vec3(1, 1, -1).asDiagonal(), Vec3::Zero()}, flat_pose{Vec3(1, 1, 0).asDiagonal(), Vec3::Zero()};
    EXPECT_THROW(static_cast<void>(between(Pose(), mirror, Vec3::Zero())), InvalidArgument);
    EXPECT_THROW(static_cast<void>(between(Pose(), flat_pose, Vec3::Zero())), InvalidArgument);
    EXPECT_EQ(between(Pose(), Pose(), Vec3(1, 2, 3)), (Turn{{}, {1, 2, 3}, {1, 2, 3}}));
    EXPECT_EQ(end_gap(ring, Pose(), Turn(), Pose()), 0);
}

// No unit makes a point larger, and no bound in doubles is as small as these coordinates.
TEST(CastTurning, PointsAtTinyPlaces) {
    const MeshShape point = shape_of({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}});
    const Turn half{{0, 0, 0, 1}, Vec3::Zero(), Vec3::Zero()};
    for (const int exponent : {0, -300, -570, -700, -1070}) {
        const double unit = std::ldexp(1.0, exponent);
        const Turning<MeshShape> a(point, {.t = {5 * unit, 0, 0}}, half);
        const auto contact = cast(a, {point, {.t = {3 * unit, 4 * unit, 0}}});
        ASSERT_TRUE(contact) << exponent;
        EXPECT_EQ(contact->time, 1 / 3.0);
        EXPECT_EQ(contact->kind, ClosestKind::vertex_vertex);
        EXPECT_FALSE(cast(a, {point, {.t = {3 * unit, 3 * unit, 0}}}));
        const Turning<MeshShape> b(point, {.t = {3 * unit, 4 * unit, 0}},
                                   {{1, 2, 3, 4}, {3 * unit, 4 * unit, 0}, {3 * unit, 4 * unit, 0}});
        EXPECT_EQ(cast(a, b)->time, 1 / 3.0) << "of two that turn";
        EXPECT_FALSE(cast(a, Turning<MeshShape>(point, {.t = {unit, unit, 0}}, about({0, 0, 1}, -1, {unit, 0, 0}))));
    }
}

// An arc leaves its chord across the axis only: bounds in doubles see a gap along the axis, however small it is.
TEST(CastTurning, ADiskJustAboveAFloor) {
    const Circumscribed disk = cylinder(1, 0.5, 24);
    const MeshShape floor = shape_of({{-4, -4, -0.25}, {4, -4, -0.25}, {0, 8, -0.25}});
    const Turning<MeshShape> a(*disk.solid, Pose{Mat3::Identity(), Vec3(0, 0, 0x1p-20)},
                               Turn{{0, 0, 0, 1}, Vec3::Zero(), Vec3::Zero()});
    QueryCounts counts;
    EXPECT_FALSE(cast(a, {floor, Pose()}, 1, {counts}));
    EXPECT_EQ(counts.casts.exact, 0U);
}

// All pairs of triangles that meet in one vertex are decided by one exact decision, and the cast leaves them behind.
TEST(CastTurning, DecidesOnceAndLeavesAWitness) {
    QueryCounts counts;
    std::size_t contact_count = 0;
    for (const scenes::TurnWorkload& workload : scenes::turn_workloads(scenes::WorkloadSize::tiny)) {
        const MeshShape shape(workload.meshes[0].mesh);
        for (const scenes::TurnQuery& query : workload.queries) {
            PairWitness witness;
            const Turning<MeshShape> turning(shape, query.a.pose, query.turn);
            const auto contact = cast(turning, {shape, query.b.pose}, 1, {counts, witness});
            if (!contact) continue;
            ++contact_count;
            EXPECT_EQ(witness.a, contact->a.triangle);
            EXPECT_EQ(witness.b, contact->b.triangle);
        }
    }
    EXPECT_EQ(contact_count, 4U);
    EXPECT_LE(counts.casts.exact, contact_count);
}

}  // namespace
}  // namespace ecods::cast_turning_test
