// Hits of every family of hit_cases.hpp beside the oracle, what must not matter, and what must hold of any.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "scenes/shapes.hpp"
#include "scenes/ship.hpp"
#include "unit/query/expect_right.hpp"

namespace ecods {
namespace {

TEST(HitFamilies, AsTheOracle) {
    const auto count = [](std::string_view family) { return family == "bodies of distances" ? 1500 : 400; };
    expect_each(expect_all_right(scenes::hit_families(), 1, count), 7, 20);
}

TEST(HitFamilies, TheSameBitsInEveryEnvironment) {
    expect_all_right_everywhere(scenes::hit_families(), 2, 20);
}

struct Named {
    const char* name;
    std::shared_ptr<const Mesh> mesh;
};

std::vector<Named> larger_meshes() {
    return {{"cube", scenes::cube(0.5)},
            {"sphere", scenes::sphere(24, 12)},
            {"torus", scenes::torus(24, 16, 0.4)},
            {"ship", scenes::ship()}};
}

// Meshes with trees of several levels, and lines through what is hard: corners as doubles have them, and edges.
TEST(HitFamilies, LargerMeshesAsTheOracle) {
    scenes::Random random(3);
    for (const auto& [name, mesh] : larger_meshes()) {
        SCOPED_TRACE(name);
        const MeshShape shape(mesh);
        QueryMemory memory;
        PairWitness witness;
        for (int i = 0; i < 10; ++i) {
            Pose pose;
            if (i % 2 == 0) pose.R = random.rotation().toRotationMatrix();
            if (i % 3 == 0) pose.t = random.direction();
            const auto any = [&] { return random.below(static_cast<std::uint32_t>(mesh->triangles().size())); };
            const Triangle& t = mesh->triangles()[any()];
            const auto corner = [&](std::size_t k) -> Vec3 { return pose.R * mesh->vertices()[t[k]] + pose.t; };
            Segment segment{4 * random.direction(), corner(0)};
            if (i % 4 == 1) segment.b = 2 * segment.b - segment.a;
            if (i % 4 == 2) segment.a = 2 * corner(0) - corner(1);
            if (i % 4 == 3) segment = {corner(0), 0.5 * (corner(1) + corner(2))};
            ASSERT_NO_FATAL_FAILURE(expect_right(judge::HitTruth(segment, {shape, pose}), memory, witness)) << i;
            const Ray ray{segment.a, segment.b - segment.a, i % 5 == 0 ? 1 : HUGE_VAL};
            ASSERT_NO_FATAL_FAILURE(expect_right(judge::HitTruth(ray, {shape, pose}), memory, witness)) << i;
        }
    }
}

// A closed surface is left as often as it is entered, by who passes through no edge and comes from outside.
TEST(HitFamilies, ParityOfClosedMeshes) {
    scenes::Random random(4);
    QueryMemory memory;
    for (const auto& [name, mesh] : larger_meshes()) {
        if (name == std::string_view("ship")) continue;  // which is open
        const MeshShape shape(mesh);
        std::size_t hit_count = 0;
        for (int i = 0; i < 300; ++i) {
            Pose pose = random.turned();
            const Aabb box = shape.box(pose);
            const double size = (box.max - box.min).norm();
            const Vec3 middle = 0.5 * (box.min + box.max), from = 2 * size * random.direction();
            const Segment segment{middle + from, middle - from + 0.25 * size * random.direction()};
            const std::vector<Hit> hits = all_hits(segment, {shape, pose}, memory);
            if (!std::ranges::all_of(hits, [](const Hit& h) { return h.kind <= HitKind::back; })) continue;
            hit_count += hits.size();
            for (std::size_t k = 0; k < hits.size(); ++k) {
                ASSERT_EQ(hits[k].kind, k % 2 == 0 ? HitKind::front : HitKind::back) << name << ", " << i;
            }
            ASSERT_EQ(hits.size() % 2, 0U) << name << ", " << i;
        }
        EXPECT_GT(hit_count, 20U) << name;
    }
}

// A longer ray hits what the shorter one does, and more. Aimed at the tube, from outside.
TEST(HitFamilies, ALongerRayHitsMore) {
    scenes::Random random(5);
    const MeshShape torus(scenes::torus(24, 16, 0.4));
    QueryMemory memory;
    std::size_t shortened = 0, of_four = 0;
    for (int i = 0; i < 100; ++i) {
        const Vec3 from = 3 * random.direction();
        const double turn = random.uniform(0, 6.25);
        Ray ray{from, Vec3(std::cos(turn), std::sin(turn), 0) + 0.25 * random.direction() - from};
        const std::vector<Hit> all = all_hits(ray, {torus, Pose()}, memory);
        of_four += all.size() == 4;
        for (std::size_t k = 0; k < all.size(); ++k) {
            const double beyond = std::nextafter(all[k].parameter, HUGE_VAL);
            const double before = std::nextafter(all[k].parameter, -HUGE_VAL);
            ray.max_parameter = beyond;
            const std::vector<Hit> some = all_hits(ray, {torus, Pose()}, memory);
            ASSERT_GE(some.size(), k + 1);
            for (std::size_t n = 0; n <= k; ++n) ASSERT_TRUE(judge::is_same(some[n], all[n])) << i;
            ASSERT_EQ(some.size(), std::ranges::count_if(all, [=](const Hit& h) { return h.parameter <= beyond; }))
                << i;
            ray.max_parameter = before;
            ASSERT_EQ(all_hits(ray, {torus, Pose()}, memory).size(),
                      std::ranges::count_if(all, [=](const Hit& h) { return h.parameter <= before; }))
                << i;
            ++shortened;
        }
    }
    EXPECT_GT(shortened, 150U);
    EXPECT_GT(of_four, 10U);
}

// Hits' points as ends of segments, and one as both.
TEST(HitFamilies, OwnAnswersAsArguments) {
    std::size_t asked = 0;
    QueryMemory memory;
    PairWitness witness;
    scenes::for_each_case(scenes::hit_families(), 6, 60, [&](const scenes::HitCase& made) {
        const MeshShape shape(made.mesh);
        const Posed<MeshShape> body{shape, made.pose};
        const auto hits = std::visit([&](const auto& line) { return all_hits(line, body, memory); }, made.line);
        if (hits.empty()) return;
        const Vec3 first = hits.front().point, last = hits.back().leave_point;
        if (!first.allFinite() || !last.allFinite()) return;
        const auto* segment = std::get_if<Segment>(&made.line);
        const Vec3 from = segment != nullptr ? segment->a : std::get<Ray>(made.line).origin;
        for (const Segment& of_answers : {Segment{from, first}, Segment{last, first}, Segment{first, first}}) {
            ++asked;
            ASSERT_NO_FATAL_FAILURE(expect_right(judge::HitTruth(of_answers, body), memory, witness));
        }
    });
    EXPECT_GT(asked, 400U);
}

// A torus of 10,000 triangles with coordinates of 20 bits, so that what is half-way is a double, too.
std::shared_ptr<const Mesh> rounded_torus() {
    return scenes::mapped(*scenes::torus(100, 50, 0.4),
                          [](const Vec3& v) -> Vec3 { return (v * 0x1p20).array().round().matrix() * 0x1p-20; });
}

// The line passes the place half-way, where it hits these triangles, which are listed one after the other.
void expect_at_half(const Vec3& place, const Vec3& direction, const Posed<MeshShape>& body, QueryMemory& memory,
                    HitKind kind, const std::set<std::uint32_t>& triangles) {
    const Segment segment{place - direction, place + direction};
    const std::vector<Hit> hits = all_hits(segment, body, memory);
    std::set<std::uint32_t> found, ranks;
    for (const Hit& hit : hits) {
        if (hit.parameter != 0.5) continue;
        EXPECT_EQ(hit.kind, kind);
        EXPECT_EQ(hit.point, place);
        EXPECT_TRUE(found.insert(hit.triangle()).second);
        ranks.insert(hit.rank);
    }
    EXPECT_EQ(found, triangles);
    EXPECT_EQ(ranks.size(), 1U);
    EXPECT_TRUE(std::ranges::is_sorted(hits, {}, [](const Hit& h) { return std::pair(h.rank, h.triangle()); }));
    EXPECT_EQ(hits.front().rank, 0U);
    const auto first = first_hit(segment, body, memory);
    EXPECT_TRUE(first && judge::is_same(*first, hits.front()));
}

TEST(HitFamilies, AllTrianglesOfAVertexOrAnEdgeAreListed) {
    const auto mesh = rounded_torus();
    ASSERT_EQ(mesh->triangles().size(), 10000U);
    const MeshShape shape(mesh);
    const auto triangles = mesh->triangles();
    scenes::Random random(7);
    QueryMemory memory;
    const auto with = [&](std::initializer_list<std::uint32_t> corners) {
        std::set<std::uint32_t> found;
        for (std::uint32_t i = 0; i < triangles.size(); ++i) {
            const auto has = [&](std::uint32_t corner) {
                return std::ranges::find(triangles[i], corner) != triangles[i].end();
            };
            if (std::ranges::all_of(corners, has)) found.insert(i);
        }
        return found;
    };
    for (int i = 0; i < 100; ++i) {
        const Triangle& t = triangles[random.below(10000)];
        Vec3 direction = random.direction();
        direction = (direction * 0x1p10).array().round() * 0x1p-10;
        const Vec3 p = mesh->vertices()[t[0]], q = mesh->vertices()[t[1]];
        SCOPED_TRACE(i);
        expect_at_half(p, direction, {shape, Pose()}, memory, HitKind::vertex, with({t[0]}));
        expect_at_half(0.5 * (p + q), direction, {shape, Pose()}, memory, HitKind::edge, with({t[0], t[1]}));
        // From one end of the edge to the other.
        const std::vector<Hit> along = all_hits(Segment{p, q}, {shape, Pose()}, memory);
        std::set<std::uint32_t> on_edge;
        for (const Hit& hit : along) {
            if (hit.kind != HitKind::along) continue;
            on_edge.insert(hit.triangle());
            EXPECT_EQ(hit.feature.kind, Feature::Kind::edge);
            EXPECT_EQ(std::pair(hit.parameter, hit.leave_parameter), std::pair(0.0, 1.0));
        }
        EXPECT_EQ(on_edge, with({t[0], t[1]}));
    }
}

}  // namespace
}  // namespace ecods
