// The questions of distance.hpp and solid.hpp about points: answers that are known without predicates, many points at
// once, and what is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <future>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <vector>

#include "ecods/distance.hpp"
#include "ecods/error.hpp"
#include "ecods/solid.hpp"
#include "scenes/shapes.hpp"
#include "unit/query/solid_soup.hpp"

namespace ecods {
namespace {

using scenes::Random;

// Gives corners of equal coordinates one index, so that triangles share vertices and edges by name.
MeshPtr merged(const Soup& soup) {
    const auto less = [](const Vec3& v, const Vec3& w) {
        return std::lexicographical_compare(v.data(), v.data() + 3, w.data(), w.data() + 3);
    };
    std::map<Vec3, std::uint32_t, decltype(less)> index(less);
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles = soup.triangles;
    for (Triangle& triangle : triangles) {
        for (std::uint32_t& corner : triangle) {
            const auto [at, is_new] =
                index.try_emplace(soup.vertices[corner], static_cast<std::uint32_t>(vertices.size()));
            if (is_new) vertices.push_back(soup.vertices[corner]);
            corner = at->second;
        }
    }
    return Mesh::create(vertices, triangles);
}

// A set of cells of the lattice, and the squares between it and the rest. Some squares are seen from inside.
struct Polycube {
    std::set<std::array<int, 3>> cells;

    bool has(std::array<int, 3> cell) const { return cells.contains(cell); }
    Soup soup(double unit) const {
        Soup soup;
        for (const auto& cell : cells) {
            for (int axis = 0; axis < 3; ++axis) {
                for (const int side : {0, 1}) {
                    auto next = cell;
                    next[static_cast<std::size_t>(axis)] += 2 * side - 1;
                    if (has(next)) continue;
                    const auto corner = [&](int p, int q) {
                        Vec3 v(cell[0], cell[1], cell[2]);
                        v[axis] += side;
                        v[(axis + 1) % 3] += p;
                        v[(axis + 2) % 3] += q;
                        return Vec3(unit * v);
                    };
                    soup.add(corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1));
                }
            }
        }
        return soup;
    }
    // The squared distance of a point, in quarters of a cell, from the nearest cell that is in the set or not.
    int square_from(const std::array<int, 3>& quarters, bool is_in_set) const {
        int least = std::numeric_limits<int>::max();
        for (int x = -4; x < 5; ++x) {
            for (int y = -4; y < 5; ++y) {
                for (int z = -4; z < 5; ++z) {
                    if (has({x, y, z}) != is_in_set) continue;
                    const std::array<int, 3> low{4 * x, 4 * y, 4 * z};
                    int square = 0;
                    for (std::size_t k = 0; k < 3; ++k) {
                        const int gap = std::max({low[k] - quarters[k], quarters[k] - low[k] - 4, 0});
                        square += gap * gap;
                    }
                    least = std::min(least, square);
                }
            }
        }
        return least;
    }
};

// Dents, edges that are reflex, a cavity, cells that share an edge or a corner alone; each square is a face of its own.
TEST(KnownPoints, PolycubesAtAllScales) {
    const Polycube dented{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, -1, 0}, {1, 1, 1}}};
    Polycube hollow;
    for (int x = -1; x < 2; ++x) {
        for (int y = -1; y < 2; ++y) {
            for (int z = -1; z < 2; ++z) {
                if (x != 0 || y != 0 || z != 0) hollow.cells.insert({x, y, z});
            }
        }
    }
    QueryMemory memory;
    Random random(3);
    for (const Polycube& polycube : {dented, hollow}) {
        for (const int e : {0, -1000, 1000, -1072}) {
            const double unit = std::ldexp(1.0, e);
            const Soup soup = polycube.soup(unit);
            const bool is_soup = e == 0 && random.below(2) == 0;
            const Solid solid(is_soup ? soup.mesh() : merged(soup));
            Pose mirror;
            mirror.R = Mat3{{0, 0, -1}, {1, 0, 0}, {0, 1, 0}};
            for (const Pose& pose : {Pose{}, mirror}) {
                for (int i = 0; i < 400; ++i) {
                    std::array<int, 3> at{};
                    for (int& x : at) x = static_cast<int>(random.below(21)) - 8;
                    const bool is_outside = polycube.square_from(at, true) > 0;
                    const int square = is_outside ? polycube.square_from(at, true) : polycube.square_from(at, false);
                    // In quarters of a cell. The root is rounded as a double of at least 53 digits is, but for 2^-1072.
                    const double root = std::sqrt(static_cast<double>(square)) / 4;
                    const double expected = std::ldexp(is_outside ? root : -root, e);
                    const Vec3 point = pose.R * Vec3(std::ldexp(at[0] / 4.0, e), std::ldexp(at[1] / 4.0, e),
                                                     std::ldexp(at[2] / 4.0, e));
                    EXPECT_EQ(signed_distance(point, {solid, pose}, memory), expected) << e;
                }
            }
        }
    }
}

// Two wedges share an edge: of two of its four faces, what is between them may be outside.
TEST(KnownPoints, BesideAnEdgeOfFourFaces) {
    Soup soup;
    for (const double y : {1.0, 3.0}) {
        const auto at = [y](int i, double z) { return i == 0 ? Vec3(0, 0, z) : Vec3(4, y + i - 1, z); };
        for (int i = 0; i < 3; ++i) soup.add(at(i, 0), at((i + 1) % 3, 0), at((i + 1) % 3, 4), at(i, 4));
        for (const double z : {0.0, 4.0}) soup.add(at(0, z), at(1, z), at(2, z));
    }
    Random random(8);
    for (int i = 0; i < 40; ++i) {
        for (std::size_t k = soup.triangles.size(); k > 1; --k) {
            std::swap(soup.triangles[k - 1], soup.triangles[random.below(static_cast<std::uint32_t>(k))]);
        }
        const Solid wedges(merged(soup));
        EXPECT_EQ(signed_distance(Vec3(-4, -3, 2.5), {wedges, Pose{}}), 5);
        EXPECT_LT(signed_distance(Vec3(3, 1.125, 2.5), {wedges, Pose{}}), 0);
    }
}

// Doubles do not decide which side of a plate is nearer: the point is beyond the one or the other.
TEST(KnownPoints, BesideThinPlates) {
    for (const double thickness : {0x1p-60, 0x1p-200}) {
        for (const double low : {0.0, -thickness}) {
            const Solid plate(merged(soup_of_box({-1, -1, low}, {1, 1, low + thickness})));
            for (const double z : {1.0, -1.0, 0.5, -0.5}) {
                EXPECT_EQ(signed_distance(Vec3(0.25, 0.125, z), {plate, Pose{}}), std::abs(z)) << z;
            }
        }
    }
}

TEST(KnownPoints, PythagoreanDistances) {
    const Solid cube(scenes::cube(0.5));
    EXPECT_EQ(signed_distance(Vec3(2.5, 3.5, 6.5), {cube, Pose{}}), 7);
    EXPECT_EQ(signed_distance(Vec3(0.25, 3.5, 4.5), {cube, Pose{}}), 5);
    EXPECT_EQ(signed_distance(Vec3(0.25, 0.125, 2.5), {cube, Pose{}}), 2);
    EXPECT_EQ(signed_distance(Vec3(0.25, 0.125, 0.375), {cube, Pose{}}), -0.125);
    EXPECT_EQ(signed_distance(Vec3(0, 0, 0), {cube, Pose{}}), -0.5);  // six faces tie
    const ClosestPoint corner = closest(Vec3(2.5, 3.5, 6.5), {cube, Pose{}});
    EXPECT_EQ(corner.feature.kind, Feature::Kind::vertex);
    EXPECT_EQ(corner.point, Vec3(0.5, 0.5, 0.5));
    EXPECT_EQ(closest(Vec3(-0.0, 0.25, 0.125), {cube, Pose{}}), (ClosestPoint{0, no_feature, Vec3(0, 0.25, 0.125)}));
    EXPECT_EQ(signed_distance(Vec3(0, 0, 0), Posed<MeshShape>(*surface_of(cube), Pose{})), 0.5);
}

TEST(KnownPoints, OnTheSurfaceAndAnUlpBeside) {
    const Solid cube(scenes::cube(1));
    for (const Vec3& on : {Vec3(1, 0.25, 0.5), Vec3(1, 1, 0.5), Vec3(1, 1, 1), Vec3(1, 0, 0)}) {
        EXPECT_EQ(signed_distance(on, {cube, Pose{}}), 0);
        EXPECT_EQ(closest(on, {cube, Pose{}}).distance, 0);
        EXPECT_EQ(closest(on, {cube, Pose{}}).point, on);
        EXPECT_EQ(closest(on, {cube, Pose{}}).feature.kind, Feature::Kind::face);
        const Vec3 out(0x1.0000000000001p0, on[1], on[2]), in(0x1.fffffffffffffp-1, on[1], on[2]);
        EXPECT_EQ(signed_distance(out, {cube, Pose{}}), 0x1p-52);
        EXPECT_EQ(signed_distance(in, {cube, Pose{}}), on[1] == 1 ? 0 : -0x1p-53);
    }
    // A real point that no double is on: under R = 1/3 the face is at fl(1/3), exactly.
    Pose third;
    third.R *= 1.0 / 3;
    EXPECT_EQ(signed_distance(Vec3(1.0 / 3, 0, 0), {cube, third}), 0);
    EXPECT_LT(signed_distance(Vec3(std::nextafter(1.0 / 3, 0.0), 0, 0), {cube, third}), 0);
    // Two products that cancel but for 2^-106: less than any double near 1.
    third.R = Mat3::Identity();
    third.R(0, 0) = 1 + 0x1p-52;
    const Solid more(box({-1, -1, -1}, {1 - 0x1p-52, 1, 1}));
    EXPECT_EQ(signed_distance(Vec3(1, 0, 0), {more, third}), 0x1p-104);
}

// A triangle of no area is no part of the solid, but of the surface.
TEST(KnownPoints, TrianglesOfNoArea) {
    Soup soup = soup_of_box({-1, -1, -1}, {1, 1, 1});
    soup.add({1, 0, 0}, {5, 0, 0}, {3, 0, 0});
    soup.add({0, 0, 7}, {0, 0, 7}, {0, 0, 7});
    const MeshPtr mesh = soup.mesh();
    const Solid solid(mesh);
    const MeshShape surface(mesh);
    EXPECT_EQ(signed_distance(Vec3(4, 3, 0), {solid, Pose{}}), std::sqrt(13.0));
    EXPECT_EQ(signed_distance(Vec3(4, 3, 0), {surface, Pose{}}), 3);
    EXPECT_EQ(closest(Vec3(4, 3, 0), {surface, Pose{}}).feature, (Feature{Feature::Kind::edge, 12, 0}));
    EXPECT_EQ(closest(Vec3(0, 3, 11), {surface, Pose{}}), (ClosestPoint{5, {Feature::Kind::vertex, 13, 0}, {0, 0, 7}}));
    EXPECT_EQ(signed_distance(Vec3(0, 0, 7), {surface, Pose{}}), 0);
}

TEST(KnownPoints, ManyAreEachInTheirOrder) {
    const Solid torus(scenes::torus(20, 10, 0.4));
    Random random(6);
    std::vector<Vec3> points;
    for (int i = 0; i < 300; ++i) points.push_back(random.uniform(0, 2) * random.direction());
    const Pose pose = random.turned();
    QueryMemory memory;
    const auto ask = [&] {
        return std::tuple(closest(points, {torus, pose}), signed_distance(points, {torus, pose}),
                          locate(points, {torus, pose}));
    };
    const auto [nearest, numbers, places] = ask();
    ASSERT_EQ(nearest.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_EQ(nearest[i], closest(points[i], {torus, pose}, memory));
        EXPECT_EQ(numbers[i], signed_distance(points[i], {torus, pose}, memory));
        EXPECT_EQ(places[i], locate(points[i], {torus, pose}, memory));
    }
    std::vector<std::future<bool>> threads;
    for (int i = 0; i < 4; ++i) {
        threads.push_back(
            std::async(std::launch::async, [&] { return ask() == std::tuple(nearest, numbers, places); }));
    }
    for (auto& thread : threads) EXPECT_TRUE(thread.get());
    EXPECT_TRUE(closest(std::span<const Vec3>(), {torus, pose}).empty());
    QueryCounts counts;
    static_cast<void>(signed_distance(points, {torus, pose}, counts));
    EXPECT_EQ(counts.queries, points.size());
}

template <class AskAbout>
void expect_refusal(const AskAbout& ask, std::optional<std::size_t> index) {
    try {
        ask();
        ADD_FAILURE() << "nothing was refused";
    } catch (const InvalidArgument& error) {
        EXPECT_EQ(error.argument, Argument::point);
        EXPECT_EQ(error.part, "(1)");
        EXPECT_EQ(error.index, index);
    }
}

TEST(KnownPoints, MustBeFinite) {
    const Solid cube(scenes::cube(1));
    for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
        const std::vector<Vec3> points{Vec3(0, 0, 0), Vec3(1, 2, 3), Vec3(0, bad, 0)};
        expect_refusal([&] { static_cast<void>(closest(points[2], {cube, Pose{}})); }, {});
        expect_refusal([&] { static_cast<void>(signed_distance(points[2], {cube, Pose{}})); }, {});
        expect_refusal([&] { static_cast<void>(closest(points, {cube, Pose{}})); }, 2);
        expect_refusal([&] { static_cast<void>(signed_distance(points, {cube, Pose{}})); }, 2);
        expect_refusal([&] { static_cast<void>(locate(points, {cube, Pose{}})); }, 2);
    }
}

}  // namespace
}  // namespace ecods
