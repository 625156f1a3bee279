// Rounded bodies with small convex cores, in doubles and in fixed precision, beside the searches of triangles and of
// hulls: equal bits, whatever the pair. The option --gtest_random_seed=N draws other pairs.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/double_key.hpp"
#include "ecods/builders.hpp"
#include "ecods/rounded.hpp"
#include "environment/each_environment.hpp"
#include "query/body/core_distance.hpp"
#include "query/body/small_pair.hpp"
#include "scenes/pose_at.hpp"
#include "scenes/random.hpp"
#include "unit/query/equal_closest.hpp"
#include "unit/query/rounded_bodies.hpp"

namespace ecods {
namespace {

using Core = std::shared_ptr<const MeshShape>;
using Ball = std::shared_ptr<const Rounded>;

// How many questions were decided without a search: which bodies are near, and how far they are.
struct Decided {
    int signs = 0, numbers = 0;
};

// Expects the sign of the distance of the cores less the radii and d, if it is decided.
void expect_sign(SmallPair& small, const RoundedPair& pair, double d, int& decided) {
    const auto sign = small.compare(d);
    if (!sign) return;
    ++decided;
    const exact::Limit limit{pair.radii().sum().plus(d)};
    EXPECT_EQ(*sign < 0, cores::within(pair.a.core, pair.b.core, limit, {})) << d;
}

// Expects the answers of the searches.
template <class A, class B>
void expect_as_searched(const Posed<A>& a, const Posed<B>& b, Decided& decided) {
    const RoundedPair pair{a, b};
    SmallPair small(pair);
    const double distance = cores::distance(pair.a.core, pair.b.core, pair.radii().sum(), {});
    expect_sign(small, pair, 0, decided.signs);
    int others = 0;
    for (const double d : {distance, distance / 2, std::nextafter(distance, 0), distance * (1 + 0x1p-40)}) {
        if (d < std::numeric_limits<double>::infinity()) expect_sign(small, pair, d, others);
    }
    const auto found = small.find_closest();
    if (!found) return;
    const ClosestPoints expected = cores::closest(pair.a.core, pair.b.core, pair.radii(), {});
    if (const auto number = found->signed_distance()) {
        ++decided.numbers;
        EXPECT_TRUE(are_equal(positive_part(*number), distance)) << *number << ", " << distance;
    }
    auto points = found->signed_closest();
    if (!points) return;
    points->distance = positive_part(points->distance);
    expect_equal(*points, expected);
}

class RoundedHullsTest : public testing::Test {
  protected:
    struct Pair {
        Ball a, b;
        Pose at_a, at_b;
    };

    // Asks about pairs of make(i), in both orders; at least such parts of the questions must be decided.
    template <class Make>
    void ask(int count, double signs, double numbers, const Make& make) {
        Decided decided;
        for (int i = 0; i < count; ++i) {
            const Pair pair = make(i);
            SCOPED_TRACE(i);
            const Posed<Rounded> a(*pair.a, pair.at_a), b(*pair.b, pair.at_b);
            expect_as_searched(a, b, decided);
            expect_as_searched(b, a, decided);
            expect_as_searched(a, Posed<MeshShape>(b.what->core(), b.pose), decided);
            if (HasFailure()) return;
        }
        EXPECT_GE(decided.signs, signs * 3 * count) << decided.signs << " of " << 3 * count;
        EXPECT_GE(decided.numbers, numbers * 3 * count) << decided.numbers << " of " << 3 * count;
    }

    Vec3 point(double size) { return random_.direction() * random_.uniform(0, size); }
    Vec3 lattice(std::uint32_t size) { return Vec3(random_.below(size), random_.below(size), random_.below(size)); }
    bool coin() { return random_.below(2) == 0; }
    Pose pose(double size) {
        Pose result = random_.turned();
        result.t = point(size);
        return result;
    }

    static Core mesh(std::vector<Vec3> vertices, const Triangle& triangle) {
        return std::make_shared<const MeshShape>(Mesh::create(std::move(vertices), {triangle}));
    }
    // Returns a point, a segment or a triangle.
    Core thin(double size) {
        const std::vector<Vec3> corners{point(size), point(size), point(size)};
        const std::uint32_t kind = random_.below(3);
        return mesh(corners, kind == 0 ? Triangle{0, 0, 0} : kind == 1 ? Triangle{0, 1, 1} : Triangle{0, 1, 2});
    }
    Core solid(double size) {
        switch (random_.below(5)) {
            case 0:
                return box(size * Vec3(random_.uniform(0.5, 2), random_.uniform(0.5, 2), random_.uniform(0.5, 2)));
            case 1:
                return cylinder(size * random_.uniform(0.5, 1), size, 7).solid;
            case 2: {  // a flat polygon
                const std::vector<Vec3> corners{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 0}};
                std::vector<Vec3> scaled;
                for (const Vec3& x : corners) scaled.push_back(size * x);
                return std::make_shared<const ConvexSolid>(scaled);
            }
            default: {
                std::vector<Vec3> points;
                for (int i = 0; i < 12; ++i) points.push_back(size * random_.direction());
                return std::make_shared<const ConvexSolid>(points);
            }
        }
    }
    static Ball around(Core core, double radius) { return std::make_shared<const Rounded>(std::move(core), radius); }

    scenes::Random random_{static_cast<std::uint32_t>(testing::GTEST_FLAG(random_seed)) + 1};
};

TEST_F(RoundedHullsTest, RandomPairsAreDecided) {
    ask(400, 0.99, 0.6, [&](int i) {
        const double size = i % 4 == 0 ? 100 : 2;
        return Pair{around(thin(0.7), random_.uniform(0.01, 0.5)), around(solid(1), coin() ? 0 : 0.25), pose(size),
                    pose(size)};
    });
    ask(200, 0.95, 0.4, [&](int) {
        return Pair{around(solid(1), random_.uniform(0.01, 0.5)), around(coin() ? solid(1) : thin(2), 0.25), pose(2),
                    pose(2)};
    });
}

// Boxes on a lattice: ties of features, feet on diagonals and edges, bodies that touch.
TEST_F(RoundedHullsTest, LatticePairs) {
    ask(600, 0.3, 0.1, [&](int i) {
        const double unit = i % 5 == 0 ? 0x1p-280 : i % 5 == 1 ? 0x1p280 : i % 25 == 2 ? 0x1p-1060 : 1;
        const Core cube = box(unit * (Vec3(1, 1, 1) + lattice(3)));
        const Vec3 p = unit * lattice(4), q = coin() ? p : Vec3(unit * lattice(4)), r = unit * lattice(4);
        const Core core =
            coin() ? mesh({p, q}, coin() ? Triangle{0, 0, 0} : Triangle{0, 1, 1}) : mesh({p, q, r}, Triangle{0, 1, 2});
        Pose turned = at(unit * (lattice(5) - lattice(5)));
        if (coin()) turned.R << 0, -1, 0, 1, 0, 0, 0, 0, 1;
        return Pair{around(core, 0.25 * unit * random_.below(7)), around(cube, coin() ? 0 : 0.5 * unit),
                    at(unit * (lattice(5) - lattice(5))), turned};
    });
}

// Poses that are singular, sheared, mirrored or far; bodies of sizes apart; feet near a diagonal; near contact.
TEST_F(RoundedHullsTest, HardPairs) {
    ask(600, 0.2, 0.1, [&](int i) {
        const double tiny = std::ldexp(random_.uniform(-1, 1), -static_cast<int>(random_.below(70)));
        Pose x = pose(1), y = coin() ? pose(2) : Pose();
        if (i % 3 == 0) y.R(random_.below(3), random_.below(3)) += tiny;
        if (i % 5 == 0) y.R.col(random_.below(3)) *= coin() ? 0 : coin() ? -1 : 0x1p-60;
        if (i % 7 == 0) x.R.col(random_.below(3)) *= coin() ? 0 : 0x1p-60;
        if (i % 11 == 0) x.t *= 0x1p40;
        if (i % 13 == 0) y.t *= 0x1p-300;
        const Core core = i % 2 == 0 ? solid(1) : box({2, 2, 2});
        // Above the diagonal of a face, and at little more or less than the radius from it.
        const double along = random_.uniform(-1, 1), radius = random_.uniform(0, 1) * (coin() ? 1 : tiny * tiny);
        const Vec3 foot(along, along * (coin() ? 1 : -1), 1);
        if (i % 4 == 1) {
            const Vec3 above = foot + Vec3(tiny, 0, coin() ? radius : radius + std::abs(tiny));
            return Pair{sphere(radius, above), around(core, 0), Pose(), coin() ? Pose() : at(tiny, 0, 0)};
        }
        return Pair{around(thin(1), radius), around(core, coin() ? 0 : tiny * tiny), i % 9 == 0 ? y : x, y};
    });
}

// Balls that are far smaller than the box which they almost touch: errors of vertices are of the size of what decides.
TEST_F(RoundedHullsTest, SmallRadii) {
    const auto cube = box({2, 2, 2});
    ask(600, 0, 0, [&](int i) {
        const double radius = std::ldexp(random_.uniform(0.5, 1), -static_cast<int>(30 + random_.below(22)));
        const Pose y = pose(2);
        const double side = i % 3 == 0 ? 1 + radius : random_.uniform(-0.9, 0.9);
        Pose x =
            at(y.R * Vec3(random_.uniform(-0.9, 0.9), i % 3 == 0 ? 1 : side, i % 3 == 0 ? side : 1 + radius) + y.t);
        return Pair{sphere(radius), around(cube, 0), x, y};
    });
}

// The meshes of solids that have more in them than vertices and faces of the hull: no triangles of its edges are named.
TEST_F(RoundedHullsTest, MeshesThatAreNotPlain) {
    const auto cube = box({2, 2, 2})->mesh_ptr();
    std::vector<Vec3> vertices(cube->vertices().begin(), cube->vertices().end());
    std::vector<Triangle> triangles(cube->triangles().begin(), cube->triangles().end());
    const std::array<Triangle, 3> first{{{8, triangles[0][1], triangles[0][2]},
                                         {triangles[0][0], 8, triangles[0][2]},
                                         {triangles[0][0], triangles[0][1], 8}}};
    vertices.push_back((vertices[triangles[0][0]] + vertices[triangles[0][1]] + vertices[triangles[0][2]]) * 0.25 +
                       0.25 * vertices[triangles[0][0]]);
    triangles.insert(triangles.begin(), first.begin(), first.end());
    triangles.erase(triangles.begin() + 3);
    const auto star = std::make_shared<const ConvexSolid>(Mesh::create(vertices, triangles));
    triangles.push_back({0, 0, 1});
    const auto flat = std::make_shared<const ConvexSolid>(Mesh::create(vertices, triangles));
    ask(200, 0.9, 0, [&](int i) {
        const Core core = i % 2 == 0 ? star : flat;
        return Pair{around(thin(0.5), 0.25), around(core, coin() ? 0 : 0.125), pose(3), pose(1)};
    });
}

TEST_F(RoundedHullsTest, Oracle) {
    const auto cube = box({2, 2, 2});
    for (int i = 0; i < 60; ++i) {
        SCOPED_TRACE(i);
        const Ball a = around(thin(0.5), random_.uniform(0.01, 0.5)), b = around(cube, coin() ? 0 : 0.25);
        Pose y = pose(1);
        const Pose x{random_.turned().R, y.t + random_.direction() * random_.uniform(2.3, 3)};
        rounded_bodies::expect_right({a, x}, {b, y});
    }
}

// Bodies whose cores meet, or which are far apart, need no search, and are found in time.
TEST_F(RoundedHullsTest, CoresThatMeet) {
    const Ball ball = sphere(0.5), cube = around(box({2, 2, 2}), 0.125);
    const auto compare = [&](const Vec3& t) {
        const RoundedPair pair{Posed<Rounded>(*ball, at(t)), Posed<Rounded>(*cube, Pose())};
        SmallPair small(pair);
        EXPECT_FALSE(small.find_closest() && t.norm() < 0.5);
        return small.compare(0);
    };
    EXPECT_EQ(compare({0.25, 0.125, 0.0625}), -1);
    EXPECT_EQ(compare({1.5, 0.125, 0.0625}), -1);
    EXPECT_EQ(compare({1.75, 0.125, 0.0625}), 1);
    EXPECT_EQ(compare({1.625, 0.125, 0.0625}), std::nullopt) << "they touch";
}

// Faces with many triangles, all of which tie, are compared once.
TEST_F(RoundedHullsTest, StackedCylinders) {
    const auto tube = cylinder(1, 2, 40).solid;
    const Ball wide = around(tube, 0.25), narrow = around(tube, 0.125);
    const Ball tile = around(mesh({{-0.5, -0.5, 3}, {0.5, -0.5, 3}, {0, 0.5, 3}}, {0, 1, 2}), 0.125);
    const auto expect_few = [](const auto& a, const auto& b, double expected) {
        QueryMemory memory;
        EXPECT_EQ(distance(a, b, memory), expected);
        EXPECT_TRUE(within(a, b, expected, memory));
        EXPECT_FALSE(within(a, b, std::nextafter(expected, 0), memory));
        for (const DistanceTolerance& tolerance : {DistanceTolerance{}, {.relative = 0.5}, {.max_distance = 0.5}}) {
            const DistanceBounds bounds = distance_bounds(a, b, tolerance, memory);
            EXPECT_LE(bounds.lower, expected);
            EXPECT_GE(bounds.upper, expected);
        }
        EXPECT_LE(memory.counts().distances.exact, 32U);
    };
    expect_few(Posed<Rounded>(*wide, Pose()), Posed<Rounded>(*narrow, at(0, 0, 4)), 1.625);
    expect_few(Posed<Rounded>(*tile, Pose()), Posed<Rounded>(*narrow, Pose()), 1.75);
    expect_few(Posed<MeshShape>(*tube, Pose()), Posed<MeshShape>(*tube, at(0, 0, 4)), 2.0);
}

TEST_F(RoundedHullsTest, Bounds) {
    for (int i = 0; i < 200; ++i) {
        const Ball a = around(thin(0.5), random_.uniform(0.01, 0.5)), b = around(solid(1), 0.25);
        const Posed<Rounded> x(*a, pose(3)), y(*b, pose(1));
        const double nearest = distance(x, y);
        const DistanceBounds bounds = distance_bounds(x, y, {});
        EXPECT_LE(key_of(bounds.upper) - key_of(bounds.lower), 1);
        EXPECT_TRUE(within(x, y, bounds.upper));
        EXPECT_TRUE(bounds.lower == bounds.upper || !within(x, y, bounds.lower) || bounds.lower == 0);
        EXPECT_TRUE(bounds.lower == nearest || bounds.upper == nearest);
    }
}

TEST_F(RoundedHullsTest, EachEnvironment) {
    std::vector<Pair> pairs;
    for (int i = 0; i < 30; ++i) {
        const double unit = i % 3 == 0 ? 0x1p-1060 : i % 3 == 1 ? 0x1p290 : 1;
        Pose x = pose(1), y = pose(2);
        x.t *= unit;
        y.t *= unit;
        pairs.push_back({around(thin(unit), unit * 0.25), around(solid(i % 3 == 0 ? 0x1p-290 : unit), 0), x, y});
    }
    struct Found {
        std::optional<int> sign;
        std::optional<ClosestPoints> points;
    };
    const auto ask_all = [&] {
        std::vector<Found> all;
        for (const Pair& pair : pairs) {
            const RoundedPair rounded{Posed<Rounded>(*pair.a, pair.at_a), Posed<Rounded>(*pair.b, pair.at_b)};
            SmallPair small(rounded);
            const auto found = small.find_closest();
            all.push_back({small.compare(0), found ? found->signed_closest() : std::nullopt});
        }
        return all;
    };
    const auto expected = ask_all();
    environment::in_each_environment(ask_all, [&](const auto& found, const std::string& where) {
        SCOPED_TRACE(where);
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            // A guess may be worse in some environment.
            if (found[i].sign && expected[i].sign) {
                EXPECT_EQ(*found[i].sign, *expected[i].sign);
            }
            if (found[i].points && expected[i].points) expect_equal(*found[i].points, *expected[i].points);
        }
    });
}

}  // namespace
}  // namespace ecods
