// Which boxes are near a box, and which are near each other: bounds that hold, all within the limit, near ones first,
// and little work.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "ecods/error.hpp"
#include "environment/float_mode.hpp"
#include "geometry/box_distance.hpp"
#include "scenes/expect_invalid.hpp"
#include "scenes/random.hpp"
#include "unit/broad_phase/lockstep.hpp"

namespace ecods::test::visit_near_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// ---- the bound

TEST(DistanceBelow, IsABoundAndATightOne) {
    scenes::Random random(3);
    const auto integer = [&] { return std::floor(random.uniform(-1000000, 1000000)); };
    for (int i = 0; i < 20000; ++i) {
        Aabb a, b;
        long double square = 0;
        for (int axis = 0; axis < 3; ++axis) {
            a.min[axis] = integer();
            a.max[axis] = a.min[axis] + random.below(500000);
            b.min[axis] = integer();
            b.max[axis] = b.min[axis] + random.below(500000);
            const double gap = std::max({a.min[axis] - b.max[axis], b.min[axis] - a.max[axis], 0.0});
            square += static_cast<long double>(gap) * gap;
        }
        const long double truth = std::sqrt(square);  // off by 2^-64, where the bound leaves 2^-48
        for (const environment::FloatMode& mode : environment::float_modes) {
            for (const int exponent : {-480, 0, 400, 700, -700}) {
                const auto scaled = [&](const Aabb& box) {
                    return Aabb{std::ldexp(1.0, exponent) * box.min, std::ldexp(1.0, exponent) * box.max};
                };
                const Aabb x = scaled(a), y = scaled(b);
                double lower = 0;
                {
                    const environment::InFloatMode in_mode(mode);
                    lower = distance_below(x, y);
                }
                const long double unscaled = std::ldexp(static_cast<long double>(lower), -exponent);
                ASSERT_LE(unscaled, truth);
                // At scales where squares do not count, the largest gap is the bound.
                const long double least = exponent == 700 || exponent == -700 ? truth / 1.7321L : truth;
                ASSERT_GE(unscaled, least * (1 - 0x1p-46L));
            }
        }
    }
}

TEST(DistanceBelow, EndsOfTheRangeOfDoubles) {
    constexpr double largest = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
    const auto point = [](double x) { return Aabb{Vec3(x, 0, 0), Vec3(x, 0, 0)}; };
    EXPECT_EQ(distance_below(point(0), point(least)), 0);
    EXPECT_EQ(distance_below(point(infinity), point(infinity)), 0);
    EXPECT_EQ(distance_below({Vec3(-infinity, 0, 0), Vec3(infinity, 0, 0)}, point(3)), 0);
    EXPECT_GT(distance_below(point(-largest), point(largest)), 0.99 * largest);
    EXPECT_LE(distance_below(point(0), point(largest)), largest);
    EXPECT_LT(0.99 * 0x1p-900, distance_below(point(0), point(0x1p-900)));
}

TEST(DistanceBelow, BoxesWithinAreNoNearer) {
    scenes::Random random(5);
    for (int i = 0; i < 20000; ++i) {
        const auto any = [&](double size) {
            const Vec3 at(random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-4, 4));
            return Aabb{at, at + Vec3::Constant(size)};
        };
        const Aabb a = any(1), b = any(0.5);
        const Vec3 part(random.uniform(0, 0.5), random.uniform(0, 0.5), random.uniform(0, 0.5));
        ASSERT_GE(distance_below({a.min + part, a.max - part}, b), distance_below(a, b));
    }
}

// ---- the visits

double limit_after(double limit, double found) {
    return std::min(limit, found);
}

class VisitsNear : public ::testing::Test {
  protected:
    void require_all(const Aabb& box, double limit) {
        for (const auto& engine : steps_.engines) {
            std::vector<std::pair<double, ProxyIndex>> got, expected;
            engine->visit_near(box, limit, [&](ProxyIndex proxy) {
                got.emplace_back(distance_below(box, steps_.model.box(proxy)), proxy);
                return infinity;
            });
            for (ProxyIndex proxy = 0; proxy < end_; ++proxy) {
                if (!steps_.model.has(proxy)) continue;
                const double lower = distance_below(box, steps_.model.box(proxy));
                if (lower <= limit) expected.emplace_back(lower, proxy);
            }
            std::ranges::sort(expected);
            ASSERT_EQ(got, expected) << Lockstep::name(*engine);
        }
    }
    void require_all_pairs(double limit) {
        using Pair = std::pair<double, ProxyPair>;
        std::vector<Pair> expected;
        for (ProxyIndex a = 0; a < end_; ++a) {
            for (ProxyIndex b = a + 1; b < end_; ++b) {
                if (!steps_.model.has(a) || !steps_.model.has(b)) continue;
                const double lower = distance_below(steps_.model.box(a), steps_.model.box(b));
                if (lower <= limit) expected.push_back({lower, {a, b}});
            }
        }
        std::ranges::sort(expected);
        for (const auto& engine : steps_.engines) {
            std::vector<Pair> got;
            engine->visit_near_pairs(limit, [&](ProxyPair pair) {
                got.push_back({distance_below(steps_.model.box(pair.a), steps_.model.box(pair.b)), pair});
                return infinity;
            });
            if (engine->kind() == BroadPhaseKind::brute_force || steps_.model.size() <= 64) std::ranges::sort(got);
            ASSERT_EQ(got, expected) << Lockstep::name(*engine);
        }
    }
    Aabb any_box(double side) {
        const Vec3 at(random_.uniform(-side, side), random_.uniform(-side, side), random_.uniform(-side, side));
        const double size = random_.below(20) == 0 ? random_.uniform(0, side) : random_.uniform(0, 1);
        return {at, at + Vec3::Constant(size)};
    }

    Lockstep steps_;
    ProxyIndex end_ = 0;
    scenes::Random random_{17};
};

TEST_F(VisitsNear, AllWithinTheLimitInOrderWhileBoxesComeMoveAndGo) {
    for (const double side : {3.0, 12.0}) {
        for (end_ = 0; end_ < 300; ++end_) steps_.set(end_, any_box(side));
        for (int round = 0; round < 8; ++round) {
            for (const double limit : {0.0, 0.5, 2.0, infinity}) require_all(any_box(side), limit);
            for (const double limit : {0.0, 0.5}) require_all_pairs(limit);
            for (int i = 0; i < 40; ++i) steps_.set(random_.below(end_), any_box(side));
            for (int i = 0; i < 10; ++i) {
                const ProxyIndex proxy = random_.below(end_);
                if (steps_.model.has(proxy)) steps_.remove(proxy);
            }
        }
    }
    // Few: all are tested.
    for (ProxyIndex proxy = 0; proxy < end_; ++proxy) {
        if (proxy % 10 != 0 && steps_.model.has(proxy)) steps_.remove(proxy);
    }
    require_all(any_box(3), infinity);
    require_all_pairs(infinity);
}

TEST_F(VisitsNear, BadArgumentsAreRefused) {
    const auto visit = [](ProxyIndex) { return infinity; };
    const auto visit_pair = [](ProxyPair) { return infinity; };
    for (const auto& engine : steps_.engines) {
        for (const double bad : {-1.0, -infinity, std::numeric_limits<double>::quiet_NaN()}) {
            EXPECT_INVALID(engine->visit_near(make_cube(0, 0, 0), bad, visit), Argument::distance);
            EXPECT_INVALID(engine->visit_near_pairs(bad, visit_pair), Argument::distance);
        }
        EXPECT_INVALID(engine->visit_near({Vec3(0, 1, 0), Vec3(0, 0, 0)}, 1, visit), Argument::box);
    }
}

// A lattice of 27,000 cubes, one of them a little out of place: the nearest of a place, and the closest pair, are found
// without looking at more than what is around them, and at the places that could have been.
TEST(VisitsNearCounts, WorkIsThatOfWhatIsNear) {
    constexpr int side = 30;
    for (const auto kind :
         {BroadPhaseKind::sweep_and_prune, BroadPhaseKind::kept_candidates, BroadPhaseKind::automatic}) {
        const auto engine = make_broad_phase(kind);
        ProxyIndex count = 0;
        for (int x = 0; x < side; ++x) {
            for (int y = 0; y < side; ++y) {
                for (int z = 0; z < side; ++z) engine->add(count++, make_cube(2 * x, 2 * y, 2 * z));
            }
        }
        engine->move(12345, make_cube(2 * (12345 / 900) + 0.5, 2 * (12345 / 30 % 30), 2 * (12345 % 30)));
        const auto tests_of = [&](const auto& ask) {
            const std::uint64_t before = engine->find_counts().box_tests;
            ask();
            return engine->find_counts().box_tests - before;
        };
        int visits = 0;
        const Aabb asked = make_cube(21.75, 30.25, 40, 0.125);
        const std::uint64_t tests = tests_of([&] {
            double limit = infinity;
            engine->visit_near(asked, limit, [&](ProxyIndex proxy) {
                ++visits;
                return limit = limit_after(limit, distance_below(asked, engine->box(proxy)));
            });
        });
        EXPECT_EQ(visits, 1);
        EXPECT_LE(tests, 300u);
        visits = 0;
        const std::uint64_t pair_tests = tests_of([&] {
            double limit = infinity;
            engine->visit_near_pairs(limit, [&](ProxyPair pair) {
                ++visits;
                return limit = limit_after(limit, distance_below(engine->box(pair.a), engine->box(pair.b)));
            });
        });
        EXPECT_EQ(visits, 1);
        EXPECT_LE(pair_tests, 100u * count) << "of 364 million pairs";
    }
}

}  // namespace
}  // namespace ecods::test::visit_near_test
