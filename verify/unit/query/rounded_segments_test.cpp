// Spheres and capsules in fixed precision beside the search for closest triangles: equal bits, whatever the pair. The
// option --gtest_random_seed=N draws other pairs.
#include "query/body/rounded_segments.hpp"

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
#include "ecods/contact.hpp"
#include "ecods/error.hpp"
#include "ecods/rounded.hpp"
#include "environment/each_environment.hpp"
#include "query/body/core_distance.hpp"
#include "query/distance/surface_distance.hpp"
#include "scenes/pose_at.hpp"
#include "scenes/random.hpp"
#include "unit/query/equal_closest.hpp"

namespace ecods {
namespace {

using Ball = std::shared_ptr<const Rounded>;

// The answers of the search.
struct Searched {
    Searched(const Posed<Rounded>& a, const Posed<Rounded>& b) {
        const RoundedPair pair{a, b};
        distance = cores::distance(pair.a.core, pair.b.core, pair.radii().sum(), {});
        closest = cores::closest(pair.a.core, pair.b.core, pair.radii(), {});
        apart = surface::signed_closest(pair.a.core, pair.b.core, {}, pair.radii());
    }

    double distance;
    ClosestPoints closest;
    std::optional<CloseFeatures> apart;  // without a value if the cores share a point
};

// The core as a flat solid: fixed precision leaves it to hulls.
Posed<Shape> as_solid(const Posed<Rounded>& body) {
    auto core = std::make_shared<const ConvexSolid>(body.what->core().mesh_ptr());
    return {std::make_shared<const Rounded>(std::move(core), body.what->radius()), body.pose};
}

void expect_patch_of_hulls(const Posed<Rounded>& a, const Posed<Rounded>& b) {
    const Posed<Shape> x(*a.what, a.pose), y(*b.what, b.pose);
    for (const double max_gap : {std::numeric_limits<double>::infinity(), 0.5}) {
        std::optional<ContactPatch> expected;
        try {
            expected = contact_patch(as_solid(a), as_solid(b), {.max_gap = max_gap});
        } catch (const SingularPose&) {
            EXPECT_THROW((void)contact_patch(x, y, {.max_gap = max_gap}), SingularPose);
            continue;
        }
        EXPECT_EQ(contact_patch(x, y, {.max_gap = max_gap}), *expected);
    }
}

// Expects the answers of the search. Returns how many of three questions were decided without it.
int expect_as_searched(const Posed<Rounded>& a, const Posed<Rounded>& b) {
    const auto found = RoundedSegments::find(a, b);
    if (!found) return 0;
    const Searched expected(a, b);
    int count = 0;
    if (!expected.apart) {
        ADD_FAILURE() << "the cores share a point";
        return 0;
    }
    if (const auto distance = found->signed_distance()) {
        ++count;
        EXPECT_TRUE(are_equal(*distance, expected.apart->closest.distance));
        EXPECT_TRUE(are_equal(positive_part(*distance), expected.distance));
    }
    if (const auto closest = found->signed_closest()) {
        ++count;
        expect_equal(*closest, expected.apart->closest);
        ClosestPoints positive = *closest;
        positive.distance = positive_part(positive.distance);
        expect_equal(positive, expected.closest);
    }
    if (const auto direction = found->direction()) {
        ++count;
        EXPECT_TRUE(are_equal(*direction, *expected.apart->direction));
    }
    return count;
}

class RoundedSegmentsTest : public testing::Test {
  protected:
    // Asks about pairs of make(i); `decided` is the least part of the questions that must be decided.
    template <class Make>
    void ask(int count, double decided, const Make& make) {
        int found = 0;
        for (int i = 0; i < count; ++i) {
            const auto [a, b] = make(i);
            SCOPED_TRACE(i);
            found += expect_as_searched(a, b);
            if (i % 8 == 0) expect_patch_of_hulls(a, b);
            if (HasFailure()) return;
        }
        EXPECT_GE(found, decided * 3 * count) << found << " of " << 3 * count;
    }

    struct Pair {
        Posed<Rounded> a, b;
    };

    Vec3 point(double size) { return random_.direction() * random_.uniform(0, size); }
    Vec3 lattice(std::uint32_t size) { return Vec3(random_.below(size), random_.below(size), random_.below(size)); }
    bool coin() { return random_.below(2) == 0; }
    Pose pose(double size) {
        Pose result = random_.turned();
        result.t = point(size);
        return result;
    }

    scenes::Random random_{static_cast<std::uint32_t>(testing::GTEST_FLAG(random_seed)) + 1};
};

TEST_F(RoundedSegmentsTest, RandomPairsAreDecided) {
    ask(600, 0.998, [&](int i) {
        const double size = i % 4 == 0 ? 1000 : 3;
        const auto body = [&]() -> Ball {
            const double radius = random_.uniform(0, 1);
            return coin() ? sphere(radius, coin() ? Vec3(0, 0, 0) : point(1)) : capsule(point(1), point(1), radius);
        };
        return Pair{{body(), pose(size)}, {body(), pose(size)}};
    });
}

// Upright and level rods, on a lattice: parallel, crossing, on one line, with ties of features; and equal centers.
TEST_F(RoundedSegmentsTest, LatticePairs) {
    ask(1000, 0.5, [&](int i) {
        const double unit = i % 5 == 0 ? 0x1p-1070 : i % 5 == 1 ? 0x1p990 : 1;
        const auto body = [&]() -> Ball {
            const double radius = 0.25 * unit * random_.below(7);
            if (random_.below(3) == 0) return sphere(radius, unit * lattice(3));
            const Vec3 p = lattice(3), step = coin() ? Vec3(lattice(3) - lattice(3)) : Vec3(0, 0, random_.below(4));
            return capsule(unit * p, unit * (p + step), radius);
        };
        Pose turned = at(unit * lattice(4));
        if (coin()) turned.R << 0, -1, 0, 1, 0, 0, 0, 0, 1;
        return Pair{{body(), at(unit * lattice(4))}, {body(), turned}};
    });
}

// Poses that are singular, sheared or far; scales apart; nearly parallel rods; a foot near a vertex; near contact.
TEST_F(RoundedSegmentsTest, HardPairs) {
    ask(700, 0.3, [&](int i) {
        const Vec3 p = point(1), q = p + point(1) * (i % 7 == 0 ? 0x1p-40 : 1);
        const double tiny = std::ldexp(random_.uniform(-1, 1), -static_cast<int>(random_.below(70)));
        Pose x = pose(1), y = x;
        y.t += point(2);
        if (i % 3 == 0) y.R(random_.below(3), random_.below(3)) += tiny;
        if (i % 5 == 0) x.R.col(random_.below(3)) *= random_.below(2) == 0 ? 0 : 0x1p-60;
        if (i % 11 == 0) x.t *= 0x1p40;
        if (i % 13 == 0) y.t *= 0x1p-300;
        const Vec3 shift = i % 2 == 0 ? Vec3(random_.direction() * tiny) : point(1);
        const Ball a = capsule(p, q, random_.uniform(0, 0.5));
        const Ball b = coin() ? capsule(p + shift, q + shift, coin() ? 0 : 0.25)
                              : sphere(random_.uniform(0, 1) * (coin() ? 1 : tiny * tiny), p + shift);
        return Pair{{a, x}, {b, i % 4 == 0 ? x : y}};
    });
}

// Coordinates with more digits than are kept: no coordinate may be taken for zero.
TEST_F(RoundedSegmentsTest, DigitsThatAreLost) {
    ask(200, 0.2, [&](int i) {
        const double tiny = i % 2 == 0 ? 0x1p-300 : 0x1p-130;
        const Ball rod = capsule({0, 0, 0}, {0, 0, 2}, 0.25), ball = sphere(0.5);
        const Vec3 t = Vec3(1 + random_.below(3), 0, random_.below(3)) + tiny * lattice(2);
        return Pair{{ball, at(tiny * lattice(2))}, {coin() ? rod : ball, at(t)}};
    });
}

TEST_F(RoundedSegmentsTest, NumbersAtTheMiddleOfTwoDoubles) {
    using exact::FixedNumber;
    using exact::Int128;
    for (const int shift : {0, 20, 60}) {
        const Int128 middle = (Int128{(std::int64_t{1} << 53) + 3} << shift) * 2, unit = Int128{2} << shift;
        for (const int sign : {-1, 1}) {
            // An exact middle goes to the even double.
            EXPECT_EQ((FixedNumber{sign * middle, 0}.rounded(0)), sign * std::ldexp(0x1p53 + 4, shift + 1));
            EXPECT_FALSE((FixedNumber{sign * middle, 1}.rounded(0)));
            EXPECT_FALSE((FixedNumber{sign * (middle + 5), 5}.rounded(0)));
            const auto above = FixedNumber{sign * (middle + 5), 1}.rounded(0);
            const auto below = FixedNumber{sign * (middle - 5), 1}.rounded(0);
            if (shift < 20) continue;
            ASSERT_TRUE(above && below);
            EXPECT_EQ(*above, sign * static_cast<double>(static_cast<std::int64_t>(middle / unit + 1)) * 0x1p1 *
                                  std::ldexp(1, shift));
            EXPECT_LT(std::abs(*below), std::abs(*above));
        }
    }
    EXPECT_FALSE((FixedNumber{3, 3}.rounded(0)));
    EXPECT_EQ((FixedNumber{0, 0}.rounded(0)), 0);
    EXPECT_EQ((FixedNumber{-(Int128{7} << 80), 1}.rounded(-1100)), std::ldexp(-7, -1020));
}

// A vertex of each has its foot inside the other: the one of the first body is named.
TEST_F(RoundedSegmentsTest, RodsThatPointOppositeWays) {
    const Ball up = capsule({0, 0, 0}, {0, 0, 2}, 0.25), down = capsule({1, 0, 1}, {1, 0, -1}, 0.25);
    EXPECT_GE(expect_as_searched({up, Pose()}, {down, Pose()}), 2);
    EXPECT_GE(expect_as_searched({down, Pose()}, {up, Pose()}), 2);
    const auto found = RoundedSegments::find(Posed<Rounded>(up, Pose()), Posed<Rounded>(down, Pose()));
    ASSERT_TRUE(found && found->signed_closest());
    EXPECT_EQ(found->signed_closest()->a, (Feature{Feature::Kind::vertex, 0, 0}));
    EXPECT_EQ(found->signed_closest()->b, (Feature{Feature::Kind::edge, 0, 0}));
}

TEST_F(RoundedSegmentsTest, PatchesAtSingularPoses) {
    const Ball ball = sphere(1, {1, 1, 1});
    const Pose flat{Vec3(1, 1, 0).asDiagonal(), Vec3(5, 0, 0)};
    for (const auto& [x, y] : {std::pair(flat, Pose()), std::pair(Pose(), flat)}) {
        EXPECT_THROW((void)contact_patch(Posed<Shape>(*ball, x), Posed<Shape>(*ball, y)), SingularPose);
        expect_as_searched({ball, x}, {ball, y});
    }
}

TEST_F(RoundedSegmentsTest, PairsWithoutAnswer) {
    const auto is_found = [](const Ball& a, const Pose& pose_a, const Ball& b, const Pose& pose_b) {
        return RoundedSegments::find(Posed<Rounded>(a, pose_a), Posed<Rounded>(b, pose_b)).has_value();
    };
    const Ball ball = sphere(1), rod = capsule({0, 0, 0}, {0, 0, 2}, 0.5);
    EXPECT_FALSE(is_found(ball, at(1), ball, at(1))) << "equal centers";
    EXPECT_FALSE(is_found(ball, at(0, 0, 1), rod, Pose())) << "a center on an axis";
    EXPECT_FALSE(is_found(sphere(0), Pose(), sphere(0), at(1))) << "no radius";
    EXPECT_FALSE(is_found(rod, at(1, 0, 1), rod, at(1, 0, 2))) << "axes that overlap";
    EXPECT_TRUE(is_found(rod, at(1, 0, 1), rod, at(2, 0, 2)));
    EXPECT_TRUE(is_found(ball, at(1), ball, at(1 + 0x1p-52)));
}

// Contacts, and what a mode of rounding could change.
TEST_F(RoundedSegmentsTest, EachEnvironment) {
    std::vector<Pair> pairs;
    for (int i = 0; i < 24; ++i) {
        const double unit = i % 3 == 0 ? 0x1p-1060 : i % 3 == 1 ? 0x1p1000 : 1;
        Pose x = pose(1), y = pose(2);
        x.t *= unit;
        y.t *= unit;
        const Ball a = capsule(unit * point(1), unit * point(1), unit * 0.25), b = sphere(unit, unit * point(0.1));
        pairs.push_back({{a, x}, {i % 2 == 0 ? a : b, y}});
        pairs.push_back({{b, at(unit * Vec3(i, 0, 0))}, {a, at(unit * Vec3(0, i, 1))}});
    }
    const auto ask_all = [&] {
        std::vector<std::optional<ClosestPoints>> all;
        for (const Pair& pair : pairs) {
            const auto found = RoundedSegments::find(pair.a, pair.b);
            all.push_back(found ? found->signed_closest() : std::nullopt);
        }
        return all;
    };
    const auto expected = ask_all();
    environment::in_each_environment(ask_all, [&](const auto& found, const std::string& where) {
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            if (!found[i] || !expected[i]) continue;  // a guess may be worse in some environment
            SCOPED_TRACE(where);
            expect_equal(*found[i], *expected[i]);
        }
    });
}

}  // namespace
}  // namespace ecods
