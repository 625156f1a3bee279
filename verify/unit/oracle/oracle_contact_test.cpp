// The oracle's first contacts: answers made by hand, its two ways against each other, and both against contact at
// single times.
#include <gtest/gtest.h>

#include "oracle/first_contact.hpp"
#include "oracle/oracle.hpp"
#include "scenes/cast_cases.hpp"
#include "scenes/each_case.hpp"

namespace ecods::oracle::oracle_contact_test {
namespace {

struct Body {
    std::vector<Vec3> vertices{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};
    std::vector<Triangle> triangles{{0, 1, 2}};
    Pose pose;

    Soup soup() const { return {vertices, triangles, pose}; }
};

using Contact = std::optional<ExactContact>;

Soup soup(const Mesh& mesh, const Pose& pose) {
    return {mesh.vertices(), mesh.triangles(), pose};
}

Contact first_contact(const scenes::MoveCase& made) {
    return oracle::first_contact(MovingSoup{soup(*made.a, made.from_a), made.to_a},
                                 MovingSoup{soup(*made.b, made.from_b), made.to_b});
}

void expect(const Contact& contact, double time, Closeness kind, const NamedFeature& a, const NamedFeature& b) {
    ASSERT_TRUE(contact);
    EXPECT_EQ(contact->rounded, time);
    EXPECT_EQ(contact->kind, kind);
    EXPECT_EQ(contact->a, a);
    EXPECT_EQ(contact->b, b);
}

// `a` as a translation, and as a motion of its own.
void expect_both(const Body& a, const Vec3& motion, const Body& b, double time, Closeness kind,
                 const NamedFeature& of_a, const NamedFeature& of_b) {
    expect(oracle::first_contact(a.soup(), motion, b.soup()), time, kind, of_a, of_b);
    Pose to = a.pose;
    to.t += motion;
    expect(oracle::first_contact(MovingSoup{a.soup(), to}, MovingSoup{b.soup(), b.pose}), time, kind, of_a, of_b);
}

TEST(OracleContact, OfAVertexThatComesDown) {
    Body a;
    const Body b;
    a.vertices = {Vec3(3, -2, 5), Vec3(0, 0, 0), Vec3(-3, 2, 5)};
    a.pose.t = Vec3(1, 1, 3);
    expect_both(a, Vec3(0, 0, -9), b, 1.0 / 3, Closeness::vertex_face, {0, 0, 1}, {2, 0, 0});
    expect_both(a, Vec3(0, 0, -3), b, 1, Closeness::vertex_face, {0, 0, 1}, {2, 0, 0});
    a.pose.t = Vec3(2, 2, 3);
    expect_both(a, Vec3(0, 0, -4), b, 0.75, Closeness::vertex_edge, {0, 0, 1}, {1, 0, 1});
    a.pose.t = Vec3(0, 4, 3);
    expect_both(a, Vec3(0, 0, -4), b, 0.75, Closeness::vertex_vertex, {0, 0, 1}, {0, 0, 2});
    EXPECT_FALSE(oracle::first_contact(a.soup(), Vec3(0, 0, -2.875), b.soup()));
    EXPECT_FALSE(oracle::first_contact(a.soup(), Vec3(0, 0, 3), b.soup()));
    EXPECT_FALSE(oracle::first_contact(a.soup(), Vec3(0, 0, 0), b.soup()));
    a.pose.t[2] = 0;
    expect_both(a, Vec3(0, 0, -4), b, 0, Closeness::intersecting, {2, 0, 0}, {2, 0, 0});
}

TEST(OracleContact, OfEdges) {
    Body a;
    const Body b;
    // Crosses edge 0, and slides in its direction; then parallel to it, with a vertex in the common part.
    a.vertices = {Vec3(0, -1, 5), Vec3(0, -1, -1), Vec3(0, -9, 0)};
    a.pose.t = Vec3(1, 0, 0);
    expect_both(a, Vec3(1, 2, 0), b, 0.5, Closeness::edge_edge, {1, 0, 0}, {1, 0, 0});
    a.vertices = {Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(0, -9, 1)};
    expect_both(a, Vec3(1, 4, 0), b, 0.25, Closeness::vertex_edge, {0, 0, 0}, {1, 0, 0});
    // A triangle without area, of which corners 0 and 2 are one.
    a.vertices = {Vec3(0, -1, 5), Vec3(0, -1, -1), Vec3(0, -1, 5)};
    expect_both(a, Vec3(1, 2, 0), b, 0.5, Closeness::edge_edge, {1, 0, 0}, {1, 0, 0});
}

TEST(OracleContact, OfRecipes) {
    scenes::Random random(3);
    int known = 0;
    for (const std::string_view name : {"double roots", "casts"}) {
        for (int i = 0; i < 150; ++i) {
            const auto made = scenes::family_named(scenes::move_families(), name).make(random);
            if (!made.time) continue;
            ++known;
            const auto contact = first_contact(made);
            ASSERT_EQ(contact ? contact->rounded : -1, *made.time) << i;
        }
    }
    EXPECT_GT(known, 160);
    for (int i = 0; i < 300; ++i) {
        const auto made = scenes::family_named(scenes::cast_families(), "rational").make(random);
        const auto contact = oracle::first_contact(soup(*made.a, made.pose_a), made.motion, soup(*made.b, made.pose_b));
        ASSERT_EQ(contact ? contact->rounded : -1, *made.time) << i;
    }
}

TEST(OracleContact, LinearProgramsAndCubicsAgree) {
    scenes::Random random(2);
    std::array<int, 6> kinds{};
    scenes::for_each_case(scenes::cast_families(), random, 40, [&](const scenes::CastCase& made) {
        if (made.a->triangles().size() * made.b->triangles().size() > 40) return;
        const Soup a = soup(*made.a, made.pose_a), b = soup(*made.b, made.pose_b);
        Pose to = made.pose_a;
        to.t += made.motion;
        if (to.t - made.pose_a.t != made.motion || made.motion + made.pose_a.t != to.t) return;
        for (int k = 0; k < 3; ++k) to.t[k] = mpq_class(mpq_class(made.pose_a.t[k]) + made.motion[k]).get_d();
        bool is_exact = true;
        for (int k = 0; k < 3; ++k) is_exact = is_exact && mpq_class(to.t[k]) - made.pose_a.t[k] == made.motion[k];
        if (!is_exact) return;
        const auto expected = oracle::first_contact(a, made.motion, b);
        auto got = oracle::first_contact(MovingSoup{a, to}, MovingSoup{b, made.pose_b});
        ++kinds[expected ? static_cast<std::size_t>(expected->kind) : 5];
        ASSERT_EQ(expected.has_value(), got.has_value());
        if (!expected) return;
        Root time = expected->time;
        EXPECT_EQ(got->time.compare(time), 0);
        EXPECT_EQ(got->rounded, expected->rounded);
        EXPECT_EQ(got->kind, expected->kind);
        EXPECT_EQ(got->a, expected->a);
        EXPECT_EQ(got->b, expected->b);
    });
    for (const int count : kinds) EXPECT_GT(count, 3);
}

// Of every family poses at k / 64 that are doubles: no contact before the first time, and contact at it.
TEST(OracleContact, AgreesWithContactAtSingleTimes) {
    scenes::Random random(4);
    int before = 0, at = 0, none = 0;
    scenes::for_each_case(scenes::move_families(), random, 12, [&](const scenes::MoveCase& made) {
        if (made.a->triangles().size() * made.b->triangles().size() > 150) return;
        const auto contact = first_contact(made);
        for (int k = 0; k <= 64; ++k) {
            const double s = k / 64.0;
            const auto between = [&](const Pose& from, const Pose& to) {
                return Pose{from.R * (1 - s) + to.R * s, from.t * (1 - s) + to.t * s};
            };
            const auto is_exact = [&](const Pose& from, const Pose& to, const Pose& pose) {
                bool all = true;
                for (int e = 0; e < 12; ++e) {
                    const auto entry = [&](const Pose& p) { return mpq_class(e < 9 ? p.R.data()[e] : p.t[e - 9]); };
                    all = all && entry(from) + mpq_class(s) * (entry(to) - entry(from)) == entry(pose);
                }
                return all;
            };
            const int order = contact ? contact->time.compare(mpq_class(s)) : 1;
            if (order < 0) break;
            const Pose a = between(made.from_a, made.to_a), b = between(made.from_b, made.to_b);
            if (!a.R.allFinite() || !a.t.allFinite() || !b.R.allFinite() || !b.t.allFinite()) continue;
            if (!is_exact(made.from_a, made.to_a, a) || !is_exact(made.from_b, made.to_b, b)) continue;
            ++(order == 0 ? at : contact ? before : none);
            ASSERT_EQ(intersects(OracleMesh(made.a, a), OracleMesh(made.b, b)), order == 0) << "at " << s;
        }
    });
    EXPECT_GT(before, 300);
    EXPECT_GT(at, 20);
    EXPECT_GT(none, 300);
}

}  // namespace
}  // namespace ecods::oracle::oracle_contact_test
