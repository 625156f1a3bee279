// Normals and sides of hits, and parts of lines inside solids: known answers, and lines through cells of the lattice.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "ecods/error.hpp"
#include "ecods/hit.hpp"
#include "ecods/solid.hpp"
#include "ecods/world.hpp"
#include "scenes/lattice_mesh.hpp"
#include "scenes/pose_at.hpp"
#include "scenes/random.hpp"
#include "unit/query/lattice_line.hpp"
#include "unit/query/solid_soup.hpp"

namespace ecods::hit_sides_test {
namespace {

using Number = LatticeLine::Number;

// A prism with the ridge from (0, 1.5, 2) to (4, 1.5, 2) over the rectangle from (0, 0, 0) to (4, 3, 0).
const Solid& roof() {
    static const Solid solid(
        Mesh::create({{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0}, {0, 1.5, 2}, {4, 1.5, 2}},
                     {{0, 2, 1}, {0, 3, 2}, {0, 1, 5}, {0, 5, 4}, {2, 3, 4}, {2, 4, 5}, {0, 4, 3}, {1, 2, 5}}));
    return solid;
}

TEST(InsideParts, OfARoof) {
    const auto parts = [](const Vec3& a, const Vec3& b) { return inside_parts(Segment{a, b}, {roof(), Pose()}); };
    const auto through = parts({-3, 1.5, 1}, {7, 1.5, 1});
    ASSERT_EQ(through.size(), 1U);
    EXPECT_EQ(through[0].from, 0.3);
    EXPECT_EQ(through[0].to, 0.7);
    EXPECT_EQ(through[0].begin, PartEnd::crosses);
    EXPECT_EQ(through[0].end, PartEnd::crosses);
    EXPECT_EQ(through[0].to_point, Vec3(4, 1.5, 1));
    EXPECT_TRUE(parts({-3, 1.5, 2}, {7, 1.5, 2}).empty());
    EXPECT_TRUE(parts({2, -5, 2}, {2, 8, 2}).empty());
    EXPECT_TRUE(parts({2, 1.5, 1}, {2, 1.5, 1}).empty());
    const auto out = parts({2, 1.5, 1}, {2, 1.5, 5});
    ASSERT_EQ(out.size(), 1U);
    EXPECT_EQ(out[0].from, 0);
    EXPECT_EQ(out[0].to, 0.25);
    EXPECT_EQ(out[0].begin, PartEnd::of_line);
    EXPECT_EQ(out[0].end, PartEnd::crosses);
    const auto ray = inside_parts(Ray{{2, 1.5, 1}, {0, 0, 2}, 0.25}, {roof(), Pose()});
    ASSERT_EQ(ray.size(), 1U);
    EXPECT_EQ(ray[0].to, 0.25);
    EXPECT_EQ(ray[0].end, PartEnd::of_line);
    EXPECT_TRUE(inside_parts(Ray{{2, 1.5, 1}, {0, 0, 2}}, {roof(), Pose{Mat3::Zero(), Vec3::Zero()}}).empty());
}

TEST(SidedHits, OfARoof) {
    const auto sided = sided_hits(Segment{{2, -5, 2}, {2, 8, 2}}, {roof(), Pose()});  // over the ridge
    ASSERT_EQ(sided.size(), 2U);
    for (const SidedHit& hit : sided) {
        EXPECT_EQ(hit.passage, Passage::grazes);
        EXPECT_EQ(hit.before, Side::outside);
        EXPECT_EQ(hit.after, Side::outside);
        ASSERT_TRUE(hit.normal);
        EXPECT_EQ(*hit.normal, Vec3(0, -0.8, 0.6));  // of the face that looks against the line
    }
    const auto along = sided_hits(Segment{{-3, 1.5, 2}, {7, 1.5, 2}}, {roof(), Pose()});
    const auto lies = std::ranges::find_if(along, [](const SidedHit& h) { return h.hit.kind == HitKind::along; });
    ASSERT_NE(lies, along.end());
    EXPECT_EQ(lies->passage, Passage::grazes);
    EXPECT_EQ(*lies->normal, Vec3(-1, 0, 0));  // of the gable, which is met at the same parameter
    const auto begins = sided_hits(Ray{{2, 1.5, 1}, {0, 0, 1}}, {roof(), Pose()});
    ASSERT_GE(begins.size(), 2U);
    EXPECT_EQ(begins[0].passage, Passage::begins);
    EXPECT_EQ(begins[0].before, Side::inside);
    EXPECT_FALSE(begins[0].normal);
    EXPECT_EQ(begins[1].hit.rank, 1U);
    EXPECT_EQ(begins[1].passage, Passage::leaves);
    const auto inwards = sided_hits(Ray{{2, 1.5, 0}, {0, 0, 1}}, {roof(), Pose()});  // from the floor
    EXPECT_EQ(inwards.front().passage, Passage::enters);
    EXPECT_EQ(inwards.front().before, Side::outside);
}

// A pipe through a wall is two pieces outside of it; a pipe in it is one (piercing and protrusion). A duct is in the
// wall for a fifth of its length of 2... along its axis.
TEST(InsideParts, OfAPipeInAWall) {
    const Solid wall(box({-2, -0.125, -2}, {2, 0.125, 2}));
    const auto axis = [&](double from, double to) {
        return inside_parts(Segment{{0, from, 0}, {0, to, 0}}, {wall, Pose()});
    };
    const auto through = axis(-1, 1);
    ASSERT_EQ(through.size(), 1U);
    EXPECT_EQ(through[0].to - through[0].from, 0.125);
    EXPECT_EQ(through[0].begin, PartEnd::crosses);
    EXPECT_EQ(through[0].end, PartEnd::crosses);
    const auto in = axis(0.0625, 2.0625);
    ASSERT_EQ(in.size(), 1U);
    EXPECT_EQ(in[0].begin, PartEnd::of_line);
    EXPECT_EQ(in[0].end, PartEnd::crosses);
}

TEST(SidedHits, OfASurface) {
    // Two squares with a common edge x = 1, in one plane; a line through that edge crosses, one through the border
    // of the surface crosses or grazes.
    const MeshShape sheet(Mesh::create({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {2, 0, 0}}, {{0, 1, 2}, {1, 3, 2}}));
    const auto down = [&](double x, double y) { return sided_hits(Ray{{x, y, 1}, {0, 0, -1}}, {sheet, Pose()}); };
    const auto face = down(0.75, 0.25), edge = down(1, 0.5);
    ASSERT_EQ(face.size(), 1U);
    EXPECT_EQ(face[0].passage, Passage::crosses);
    EXPECT_EQ(face[0].before, Side::outside);
    EXPECT_EQ(*face[0].normal, Vec3(0, 0, 1));
    ASSERT_EQ(edge.size(), 2U);
    for (const SidedHit& hit : edge) EXPECT_EQ(hit.passage, Passage::crosses);
    // A fold, seen from the side: both triangles are on one side of the line.
    const MeshShape fold(Mesh::create({{0, 0, 0}, {0, 2, 0}, {1, 1, 1}, {1, 1, -1}}, {{0, 1, 2}, {0, 1, 3}}));
    const auto past = sided_hits(Segment{{0, 1, 5}, {0, 1, -5}}, {fold, Pose()});
    ASSERT_EQ(past.size(), 2U);
    for (const SidedHit& hit : past) EXPECT_EQ(hit.passage, Passage::grazes);
    // A triangle without area has no normal.
    const MeshShape needle(Mesh::create({{0, 0, 0}, {2, 0, 0}, {1, 0, 0}}, {{0, 1, 2}}));
    const auto of_needle = sided_hits(Ray{{0.5, 0, 1}, {0, 0, -1}}, {needle, Pose()});
    ASSERT_EQ(of_needle.size(), 1U);
    EXPECT_FALSE(of_needle[0].normal);
    EXPECT_EQ(of_needle[0].passage, Passage::grazes);
}

// A point, and a segment that the line runs along, have no area beside the line: it crosses neither.
TEST(SidedHits, OfPointsAndSegments) {
    const Ray ray{{-3, 0, 0}, {1, 0, 0}};
    for (const Vec3& end : {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 1, 0)}) {
        const MeshShape thin(Mesh::create({{0, 0, 0}, end}, {{0, 1, 1}}));
        const auto sides = sided_hits(ray, {thin, Pose()});
        ASSERT_EQ(sides.size(), 1U);
        EXPECT_EQ(sides[0].passage, Passage::grazes);
        EXPECT_FALSE(sides[0].normal);
    }
}

TEST(HitNormal, OfOneHit) {
    const Posed<MeshShape> body(roof(), Pose());
    const Ray ray{{1, 0.5, 5}, {0, 0, -1}};
    const auto hit = first_hit(ray, body);
    ASSERT_TRUE(hit);
    EXPECT_EQ(*hit_normal(ray, body, *hit), Vec3(0, -0.8, 0.6));
    const Ray onto_ridge{{2, 1.75, 5}, {0, -0.25, -3}};
    const auto ridge = first_hit(onto_ridge, body);
    ASSERT_TRUE(ridge);
    EXPECT_EQ(ridge->feature.kind, Feature::Kind::edge);
    EXPECT_EQ(*hit_normal(onto_ridge, body, *ridge), Vec3(0, 0.8, 0.6));  // the side that it comes from
    // The more opposed one of two faces at an edge counts, however large the other one is.
    const MeshShape ridges(Mesh::create({{0, 0, 0}, {0, 2, 0}, {-80, 1, -80}, {4, 1, -3}}, {{0, 1, 2}, {1, 0, 3}}));
    const Ray down{{0, 1, 5}, {0, 0, -1}};
    EXPECT_EQ(*hit_normal(down, {ridges, Pose()}, *first_hit(down, {ridges, Pose()})), Vec3(0.6, 0, 0.8));
    Hit other = *ridge;
    other.feature.triangle = 4000;
    EXPECT_FALSE(hit_normal(onto_ridge, body, other));
    const Ray inside{{2, 1.5, 1}, {0, 0, 1}};
    EXPECT_FALSE(hit_normal(inside, body, *first_hit(inside, body)));
    EXPECT_THROW(static_cast<void>(hit_normal(Ray{{0, 0, 0}, {0, 0, 0}}, body, *hit)), InvalidArgument);
}

TEST(AllHits, OfManyLines) {
    const Posed<MeshShape> body(roof(), Pose());
    const std::vector<Segment> segments{{{2, -5, 2}, {2, 8, 2}}, {{9, 9, 9}, {9, 9, 8}}, {{-3, 1.5, 1}, {7, 1.5, 1}}};
    const HitLists lists = all_hits(segments, body);
    ASSERT_EQ(lists.first.size(), 4U);
    World world;
    world.create_body(std::make_shared<const Solid>(roof().mesh_ptr()), Pose());
    world.update();
    const BodyHitLists in_world = world.all_hits(segments);
    ASSERT_EQ(in_world.first, lists.first);
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const auto hits = all_hits(segments[i], body);
        ASSERT_EQ(lists.of(i).size(), hits.size());
        for (std::size_t k = 0; k < hits.size(); ++k) {
            EXPECT_EQ(lists.of(i)[k].feature, hits[k].feature);
            EXPECT_EQ(in_world.of(i)[k].hit.feature, hits[k].feature);
            EXPECT_EQ(in_world.of(i)[k].hit.parameter, hits[k].parameter);
        }
    }
    const std::vector<Ray> rays{{{2, 1.5, 5}, {0, 0, -1}}, {{0, 0, 0}, {0, 0, 0}}};
    try {
        static_cast<void>(all_hits(rays, body));
        FAIL();
    } catch (const InvalidArgument& error) {
        EXPECT_EQ(error.index, 1U);
    }
    EXPECT_THROW(static_cast<void>(world.all_hits(rays)), InvalidArgument);
    EXPECT_EQ(all_hits(std::vector<Ray>{}, body).first.size(), 1U);
}

// ---- lines through cells of the lattice

struct Expected {
    Number from, to;
    PartEnd begin, end;
};

PartEnd end_of(Side at, Side beyond) {
    if (at == Side::inside) return PartEnd::of_line;
    return beyond == Side::outside ? PartEnd::crosses : beyond == Side::on ? PartEnd::along : PartEnd::grazes;
}

std::vector<Expected> expected_parts(const LatticeLine& line, const std::optional<Number>& end) {
    std::vector<Number> cuts{{0, 1}};
    for (const Number& s : line.breaks()) {
        if (Number{0, 1} < s && (!end || s < *end)) cuts.push_back(s);
    }
    if (end) cuts.push_back(*end);
    std::vector<Expected> parts;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        if (line.side_at(LatticeLine::between(cuts[i], cuts[i + 1])) != Side::inside) continue;
        const Side at = line.side_at(cuts[i + 1]);
        const PartEnd last = end_of(at, line.after(cuts[i + 1]));
        if (!parts.empty() && parts.back().to == cuts[i] && line.side_at(cuts[i]) == Side::inside) {
            parts.back().to = cuts[i + 1];
            parts.back().end = last;
        } else {
            parts.push_back({cuts[i], cuts[i + 1], end_of(line.side_at(cuts[i]), line.before(cuts[i])), last});
        }
    }
    return parts;
}

class LatticeLines : public testing::TestWithParam<bool> {
  protected:
    template <class SegmentOrRay>
    void check(const SegmentOrRay& asked, const std::optional<Number>& end) {
        const LatticeLine line(from, step, cells);
        const auto parts = inside_parts(asked, {*solid, placed.pose});
        const auto expected = expected_parts(line, end);
        ASSERT_EQ(parts.size(), expected.size());
        for (std::size_t i = 0; i < parts.size(); ++i) {
            EXPECT_EQ(parts[i].from, expected[i].from.rounded());
            EXPECT_EQ(parts[i].to, expected[i].to.rounded());
            EXPECT_EQ(parts[i].begin, expected[i].begin);
            EXPECT_EQ(parts[i].end, expected[i].end);
        }
        found += parts.size();
        for (const SidedHit& sided : sided_hits(asked, {*solid, placed.pose})) {
            if (sided.passage == Passage::begins) continue;
            check(sided, line, end);
        }
    }

    void check(const SidedHit& sided, const LatticeLine& line, const std::optional<Number>& end) {
        // No plane of the lattice is met within a face, where the line runs along it over a side of two triangles.
        const auto number = [&](double parameter) -> std::optional<Number> {
            if (parameter == 0) return Number{0, 1};
            if (end && parameter == end->rounded()) return *end;
            for (const Number& s : line.breaks()) {
                if (s.rounded() == parameter) return s;
            }
            return std::nullopt;
        };
        const auto enter = number(sided.hit.parameter), leave = number(sided.hit.leave_parameter);
        EXPECT_EQ(sided.before, enter ? line.before(*enter) : Side::on);
        EXPECT_EQ(sided.after, leave ? line.after(*leave) : Side::on);
        const bool was = sided.before == Side::inside, is = sided.after == Side::inside;
        EXPECT_EQ(sided.passage, was == is ? Passage::grazes : is ? Passage::enters : Passage::leaves);
        ++counts[static_cast<std::size_t>(sided.passage)];
        EXPECT_TRUE(sided.normal.has_value());
        EXPECT_NEAR(sided.normal->norm(), 1, 0x1p-50);
    }

    scenes::Cells cells;
    scenes::PosedMesh placed;
    std::optional<Solid> solid;
    scenes::LatticePoint from{}, step{};
    std::size_t found = 0;
    std::array<std::size_t, 5> counts{};
};

TEST_P(LatticeLines, AreOnTheSidesOfTheCells) {
    scenes::Random random(17);
    const auto all = scenes::polycubes(4);
    for (int round = 0; round < 400; ++round) {
        cells = all[random.below(static_cast<std::uint32_t>(all.size()))];
        if (random.below(2) == 0) {  // two bodies that touch, or one with a hole
            const auto more = scenes::shifted(all[random.below(static_cast<std::uint32_t>(all.size()))],
                                              {static_cast<int>(random.below(3)), static_cast<int>(random.below(3)),
                                               static_cast<int>(random.below(3))});
            cells.insert(cells.end(), more.begin(), more.end());
            cells = scenes::sorted(cells);
        }
        const scenes::LatticeMap map = scenes::random_map(random);
        placed = scenes::place(scenes::boundary(cells, GetParam(), random), map, 0, random);
        solid.emplace(placed.mesh);
        for (int k = 0; k < 6; ++k) {
            scenes::LatticePoint to{};
            for (std::size_t axis = 0; axis < 3; ++axis) {
                from[axis] = static_cast<int>(random.below(12)) - 2;
                to[axis] = random.below(3) == 0 ? from[axis] : static_cast<int>(random.below(12)) - 2;
                if (random.below(2) == 0) from[axis] &= ~1, to[axis] &= ~1;
                step[axis] = to[axis] - from[axis];
            }
            if (step == scenes::LatticePoint{0, 0, 0}) continue;
            const auto mapped = [&](const scenes::LatticePoint& p) {
                return Vec3(map.M * Vec3(p[0] / 2.0, p[1] / 2.0, p[2] / 2.0) + map.o);
            };
            check(Segment{mapped(from), mapped(to)}, Number{1, 1});
            const Vec3 direction = map.M * Vec3(step[0] / 2.0, step[1] / 2.0, step[2] / 2.0);
            check(Ray{mapped(from), direction}, std::nullopt);
            check(Ray{mapped(from), direction, 0.5}, Number{1, 2});
            if (HasFailure()) return;
        }
    }
    EXPECT_GT(found, 400U);
    for (const Passage passage : {Passage::enters, Passage::leaves, Passage::grazes}) {
        EXPECT_GT(counts[static_cast<std::size_t>(passage)], 200U);
    }
}

INSTANTIATE_TEST_SUITE_P(MergedFaces, LatticeLines, testing::Bool());

}  // namespace
}  // namespace ecods::hit_sides_test
