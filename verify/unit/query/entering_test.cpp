// When bodies go into each other: known answers, and cells of the lattice beside the volumes of unit cubes.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "ecods/cast.hpp"
#include "ecods/error.hpp"
#include "ecods/solid.hpp"
#include "ecods/world.hpp"
#include "scenes/lattice_mesh.hpp"
#include "scenes/pose_at.hpp"
#include "scenes/random.hpp"
#include "unit/query/solid_soup.hpp"

namespace ecods {
namespace {

using Points = std::vector<Vec3>;

Points box_of(double x0, double x1, double y0, double y1, double z0, double z1) {
    Points points;
    for (int k = 0; k < 8; ++k) {
        points.emplace_back((k & 1) != 0 ? x1 : x0, (k & 2) != 0 ? y1 : y0, (k & 4) != 0 ? z1 : z0);
    }
    return points;
}
Points raised(Points points, double by) {
    for (Vec3& p : points) p[2] += by;
    return points;
}
Points upside_down(Points points, bool turns = false) {
    for (Vec3& p : points) p = turns ? Vec3(p[1], p[0], -p[2]) : Vec3(p[0], p[1], -p[2]);
    return points;
}

struct Known {
    const char* name;
    Points a;
    std::vector<Points> b;
    Vec3 motion;
    std::optional<double> first, of_solids, of_meshes;
};

// Each of b's parts is a convex body of its own.
std::vector<Known> known_answers() {
    const auto never = std::optional<double>();
    const Points cube = box_of(0, 1, 0, 1, 0, 1), floor = box_of(-5, 5, -5, 5, -1, 0);
    // A roof that stands on its ridge, z >= |y|; the same with the ridge up, along x and along y.
    const Points roof{{-2, 0, 0}, {2, 0, 0}, {-2, -1, 1}, {2, -1, 1}, {-2, 1, 1}, {2, 1, 1}};
    const Points ridge_x = upside_down(roof), ridge_y = upside_down(roof, true);
    const Points tip{{0, 0, 0}, {-1, -1, 2}, {-1, 1, 2}, {1, -1, 2}, {1, 1, 2}}, tip_up = upside_down(tip);
    const Points beside = box_of(1, 2, 1, 2, 1, 2);
    return {
        {"slides on a floor", cube, {floor}, {2, 0, 0}, 0, never, never},
        {"is lifted off a floor", cube, {floor}, {0, 0, 1}, 0, never, never},
        {"is pushed into a floor", cube, {floor}, {0, 0, -1}, 0, 0, 0},
        {"is pushed obliquely", cube, {floor}, {1, 0, -1}, 0, 0, 0},
        {"is lifted obliquely", cube, {floor}, {1, 2, 1}, 0, never, never},
        {"falls from 1/2", raised(cube, 0.5), {floor}, {0, 0, -1}, 0.5, 0.5, 0.5},
        {"falls and touches at the end", raised(cube, 0.5), {floor}, {0, 0, -0.5}, 1, never, never},
        {"slides to a step", cube, {floor, box_of(2, 3, 0, 1, 0, 1)}, {2, 0, 0}, 0, 0.5, 0.5},
        {"slides along a wall", cube, {floor, box_of(2, 3, 1, 2, 0, 1)}, {4, 0, 0}, 0, never, never},
        {"passes along an edge", cube, {box_of(2, 3, 1, 2, 1, 2)}, {4, 0, 0}, 0.25, never, never},
        {"passes over a step", raised(cube, 1), {floor, box_of(2, 3, 0, 1, 0, 1)}, {4, 0, 0}, 0.25, never, never},
        {"equal cubes stacked, pushed", cube, {box_of(0, 1, 0, 1, -1, 0)}, {0, 0, -1}, 0, 0, never},
        {"equal cubes, falling", raised(cube, 0.5), {box_of(0, 1, 0, 1, -1, 0)}, {0, 0, -1}, 0.5, 0.5, 0.5},
        {"equal cubes side by side, pushed", cube, {box_of(1, 2, 0, 1, 0, 1)}, {1, 0, 0}, 0, 0, never},
        {"in a slot of its height with an end",
         cube,
         {floor, box_of(-5, 5, -5, 5, 1, 2), box_of(2, 3, -5, 5, 0, 1)},
         {4, 0, 0},
         0,
         0.25,
         0.25},
        {"edge across an edge, pushed", roof, {ridge_y}, {0, 0, -1}, 0, 0, 0},
        {"edge across an edge, along its own", roof, {ridge_y}, {1, 0, 0}, 0, never, never},
        {"edge on an edge, less steep than the slope", roof, {ridge_x}, {0, 1, -0.5}, 0, never, never},
        {"edge on an edge, along the slope", roof, {ridge_x}, {0, 1, -1}, 0, never, never},
        {"edge on an edge, steeper than the slope", roof, {ridge_x}, {0, 1, -2}, 0, 0, 0},
        {"tip on a tip, along a face", tip, {tip_up}, {1, 0, -2}, 0, never, never},
        {"tip on a tip, below the face", tip, {tip_up}, {1, 0, -3}, 0, 0, 0},
        {"corner at a corner, diagonally in", cube, {beside}, {1, 1, 1}, 0, 0, 0},
        {"corner at a corner, in the plane of faces", cube, {beside}, {1, 1, 0}, 0, never, never},
        {"corner along an edge", cube, {beside}, {2, 0, 0}, 0, never, never},
    };
}

std::optional<double> lesser(const std::optional<double>& x, const std::optional<double>& y) {
    if (!x || !y) return x ? x : y;
    return std::min(*x, *y);
}
std::optional<double> time_of(const auto& found) {
    return found ? std::optional(found->time) : std::nullopt;
}

TEST(Entering, HasTheKnownAnswers) {
    for (const Known& known : known_answers()) {
        SCOPED_TRACE(known.name);
        const ConvexSolid a(convex_hull(known.a));
        const MeshShape of_a(a.mesh_ptr());
        std::optional<double> first, of_solids, of_meshes;
        World solids, surfaces;
        for (const Points& points : known.b) {
            const auto b = std::make_shared<const ConvexSolid>(convex_hull(points));
            const auto of_b = std::make_shared<const MeshShape>(b->mesh_ptr());
            solids.create_body(b, Pose());
            surfaces.create_body(of_b, Pose());
            const auto entry = entering({a, Pose()}, known.motion, {*b, Pose()});
            EXPECT_EQ(time_of(entering({*b, Pose()}, -known.motion, {a, Pose()})), time_of(entry));
            of_solids = lesser(of_solids, time_of(entry));
            of_meshes = lesser(of_meshes, time_of(entering({of_a, Pose()}, known.motion, {*of_b, Pose()})));
            first = lesser(first, time_of(cast({a, Pose()}, known.motion, {*b, Pose()})));
            if (entry) {
                const auto before = pose_before({a, Pose()}, known.motion, {*b, Pose()}, entry->time);
                ASSERT_TRUE(before);
                EXPECT_LE((before->t - entry->time * known.motion).norm(), 0x1p-48);
            }
        }
        EXPECT_EQ(first, known.first);
        EXPECT_EQ(of_solids, known.of_solids);
        EXPECT_EQ(of_meshes, known.of_meshes);
        solids.update();
        surfaces.update();
        EXPECT_EQ(time_of([&] {
                      const auto met = solids.entering(Posed<Shape>(a, Pose()), known.motion);
                      return met ? std::optional(met->entry) : std::nullopt;
                  }()),
                  known.of_solids);
        const auto met = surfaces.entering(Posed<Shape>(of_a, Pose()), known.motion);
        EXPECT_EQ(met ? std::optional(met->entry.time) : std::nullopt, known.of_meshes);
    }
}

// A cube that rests on a floor slides along it, is lifted, and is pushed; and one leaves a slot that touches it on two
// sides: it never goes into a wall.
TEST(Entering, FromRest) {
    const Solid cube(box({0, 0, 0}, {1, 1, 1})), floor(box({-5, -1, -5}, {5, 0, 5}));
    EXPECT_FALSE(entering({cube, at({-3, 0, 0})}, {1, 0, 0}, {floor, Pose()}));
    EXPECT_FALSE(entering({cube, Pose()}, {0, 1, 0}, {floor, Pose()}));
    EXPECT_EQ(entering({cube, at({3, 0, 0})}, {0, -1, 0}, {floor, Pose()})->time, 0);
    const Solid wall(box({0, -1, 0}, {3, 0, 1}));
    for (const double y : {0.0, 2.0}) {
        EXPECT_FALSE(entering({cube, Pose()}, {5, 0, 0}, {wall, at({0, y, 0})}));
        EXPECT_FALSE(cast({cube, at({3.5, 0, 0})}, {5, 0, 0}, {wall, at({0, y, 0})}));
    }
    // At rest, only what overlaps enters.
    EXPECT_FALSE(entering({cube, Pose()}, {0, 0, 0}, {floor, Pose()}));
    const auto overlapping = entering({cube, at({0, -0.5, 0})}, {0, 0, 0}, {floor, Pose()});
    ASSERT_TRUE(overlapping);
    EXPECT_EQ(overlapping->a, no_feature);
    EXPECT_FALSE(pose_before({cube, at({0, -0.5, 0})}, {0, 1, 0}, {floor, Pose()}, 0.25));
}

// Only a real time before max_time counts, though it may round to it.
TEST(Entering, UpToATime) {
    const Solid cube(box({0, 0, 0}, {1, 1, 1})), floor(box({-5, -1, -5}, {5, 0, 5}));
    const MeshShape cube_surface(cube.mesh_ptr()), floor_surface(floor.mesh_ptr());
    const auto times = [&](double height, double fall, double max_time) {
        const auto of_solids = entering({cube, at({0, height, 0})}, {0, -fall, 0}, {floor, Pose()}, max_time);
        const auto of_surfaces =
            entering({cube_surface, at({0, height, 0})}, {0, -fall, 0}, {floor_surface, Pose()}, max_time);
        EXPECT_EQ(time_of(of_solids), time_of(of_surfaces));
        return time_of(of_solids);
    };
    const std::optional<double> never;
    EXPECT_EQ(times(1, 2, 0.5), never);
    EXPECT_EQ(times(1, 2, std::nextafter(0.5, 1)), 0.5);
    EXPECT_EQ(times(1, 2, 7), 0.5);
    EXPECT_EQ(times(1, 3, 1 / 3.0), never) << "1/3 is above the double";
    EXPECT_EQ(times(1, 3, std::nextafter(1 / 3.0, 1)), 1 / 3.0);
    EXPECT_EQ(times(1, 10, 0.1), 0.1) << "1/10 is below the double";
    EXPECT_EQ(times(1, 10, std::nextafter(0.1, 0)), never);
    EXPECT_EQ(times(0, 1, 0), never);
    EXPECT_EQ(times(0, 1, 0x1p-1074), 0);
    EXPECT_EQ(entering({cube, at({0, -0.5, 0})}, {0, 1, 0}, {floor, Pose()}, 0)->time, 0) << "in it at the start";
    // An edge slides into a face of its plane: boxes of one height on a floor.
    const auto slides = [&](double max_time) {
        return time_of(entering({cube, at({-3, 0, 0})}, {4, 0, 0}, {cube, Pose()}, max_time));
    };
    EXPECT_EQ(slides(1), 0.5);
    EXPECT_EQ(slides(0.5), never);
    EXPECT_EQ(slides(std::nextafter(0.5, 1)), 0.5);
}

TEST(Entering, RefusesByName) {
    const Solid cube(box({0, 0, 0}, {1, 1, 1}));
    const MeshShape surface(cube.mesh_ptr());
    const ConvexSolid flat(Mesh::create({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}));
    EXPECT_THROW(static_cast<void>(entering({cube, Pose()}, {1, 0, 0}, {surface, Pose()})), NotSupported);
    EXPECT_THROW(static_cast<void>(entering({flat, Pose()}, {1, 0, 0}, {cube, Pose()})), NotSupported);
    EXPECT_THROW(static_cast<void>(entering({cube, {Mat3::Zero(), Vec3::Zero()}}, {1, 0, 0}, {cube, Pose()})),
                 NotSupported);
    EXPECT_THROW(static_cast<void>(entering({cube, Pose()}, {NAN, 0, 0}, {cube, Pose()})), InvalidArgument);
    EXPECT_THROW(static_cast<void>(entering({cube, Pose()}, {1, 0, 0}, {cube, Pose()}, -1)), InvalidArgument);
    EXPECT_THROW(static_cast<void>(entering({cube, Pose()}, {1, 0, 0}, {cube, Pose()}, NAN)), InvalidArgument);
    for (const double time : {-1.0, 1.125, std::numeric_limits<double>::infinity()}) {
        EXPECT_THROW(static_cast<void>(pose_before({cube, Pose()}, {1, 0, 0}, {cube, Pose()}, time)), InvalidArgument);
    }
    World world;
    world.create_body(std::make_shared<const MeshShape>(cube.mesh_ptr()), at({50, 0, 0}));
    world.update();
    EXPECT_THROW(static_cast<void>(world.entering(Posed<Shape>(cube, Pose()), {1, 0, 0})), NotSupported);
}

// ---- cells of the lattice: the interiors meet while two cells overlap

// A fraction, den > 0.
struct Number {
    std::int64_t num, den;

    friend bool operator<(const Number& x, const Number& y) { return x.num * y.den < y.num * x.den; }
};

std::optional<double> entry_of_cells(const scenes::Cells& a, const scenes::LatticePoint& m, const scenes::Cells& b) {
    std::optional<Number> best;
    for (const auto& p : a) {
        for (const auto& q : b) {
            Number from{0, 1}, to{1, 1};
            bool meets = true;
            for (std::size_t k = 0; k < 3; ++k) {
                const std::int64_t w = q[k] - p[k];  // the cells overlap while |w - s m| < 1
                if (m[k] == 0) {
                    meets = meets && w == 0;
                    continue;
                }
                const int sign = m[k] > 0 ? 1 : -1;
                from = std::max(from, Number{sign * w - 1, sign * m[k]});
                to = std::min(to, Number{sign * w + 1, sign * m[k]});
            }
            if (meets && from < to && (!best || from < *best)) best = from;
        }
    }
    if (!best) return std::nullopt;
    return static_cast<double>(best->num) / static_cast<double>(best->den);
}

class EnteringCells : public testing::TestWithParam<bool> {};

TEST_P(EnteringCells, HaveTheTimesOfTheirVolumes) {
    scenes::Random random(5);
    const auto all = scenes::polycubes(4);
    const auto any = [&] { return all[random.below(static_cast<std::uint32_t>(all.size()))]; };
    const auto number = [&](int least, std::uint32_t count) { return least + static_cast<int>(random.below(count)); };
    std::array<int, 3> counts{};  // never, at the start, later
    for (int round = 0; round < 400; ++round) {
        const scenes::LatticePoint offset{number(-3, 7), number(-3, 7), number(-3, 7)};
        const scenes::Cells a = any(), b = scenes::shifted(any(), offset);
        scenes::LatticePoint motion{};
        const bool is_aimed = random.below(3) != 0;
        for (std::size_t k = 0; k < 3; ++k) motion[k] = is_aimed ? offset[k] * number(0, 3) : number(-4, 9);
        const scenes::LatticeMap map = scenes::random_map(random);
        const auto p = scenes::place(scenes::boundary(a, GetParam(), random), map, 0, random);
        const auto q = scenes::place(scenes::boundary(b, GetParam(), random), map, 0, random);
        const Vec3 m = map.M * Vec3(motion[0], motion[1], motion[2]);
        const Solid of_a(p.mesh), of_b(q.mesh);
        const auto expected = entry_of_cells(a, motion, b);
        ASSERT_EQ(time_of(entering({of_a, p.pose}, m, {of_b, q.pose})), expected) << "round " << round;
        ++counts[!expected ? 0 : *expected == 0 ? 1 : 2];
    }
    EXPECT_GT(*std::ranges::min_element(counts), 40);
}

INSTANTIATE_TEST_SUITE_P(MergedFaces, EnteringCells, testing::Bool());

}  // namespace
}  // namespace ecods
