// Random and long polygons, cut into triangles.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "cut_walk.hpp"
#include "scenes/random.hpp"

namespace ecods::scenes::cut_polygon_test {
namespace {

// ---- random walks around triangles of a lattice that a tree joins: each has an interior without holes, but may touch
// itself everywhere.

Walk random_walk(Random& random, std::uint32_t width, std::uint32_t tries) {
    std::map<std::pair<Point, Point>, Point> across;  // by an edge, the third corner of the triangle to its left
    for (std::int64_t x = 0; x < width; ++x) {
        for (std::int64_t y = 0; y < width; ++y) {
            const Point a{x, y}, b{x + 1, y}, c{x + 1, y + 1}, d{x, y + 1};
            const bool is_rising = random.below(2) == 0;
            for (const auto& t : is_rising ? std::array{std::array{a, b, c}, std::array{a, c, d}}
                                           : std::array{std::array{a, b, d}, std::array{b, c, d}}) {
                for (std::size_t k = 0; k < 3; ++k) across[{t[k], t[(k + 1) % 3]}] = t[(k + 2) % 3];
            }
        }
    }
    const auto first =
        std::next(across.begin(), static_cast<std::ptrdiff_t>(random.below(static_cast<std::uint32_t>(across.size()))));
    Walk walk{first->first.first, first->first.second, first->second};
    const auto take = [&](Point a, Point b, Point c) {
        for (int k = 0; k < 3; ++k) {
            across.erase({a, b});
            a = std::exchange(b, std::exchange(c, a));
        }
    };
    take(walk[0], walk[1], walk[2]);
    for (; tries > 0; --tries) {
        const std::size_t i = random.below(static_cast<std::uint32_t>(walk.size()));
        const auto found = across.find({walk[(i + 1) % walk.size()], walk[i]});
        if (found == across.end()) continue;
        const Point corner = found->second;
        take(found->first.first, found->first.second, corner);
        walk.insert(walk.begin() + static_cast<std::ptrdiff_t>(i) + 1, corner);
    }
    return walk;
}

TEST(CutRandomPolygon, CutsWalksThatTouchThemselves) {
    Random random(36);
    for (int i = 0; i < 60 && !HasFailure(); ++i) {
        const std::uint32_t tries = 4 + random.below(150);
        expect_cut(random_walk(random, 1 + random.below(5), tries), PolygonCut::ears);
    }
}

// Edges pass through corners of the walk, where those of other parts are left out.
TEST(CutRandomPolygon, CutsWalksWhoseEdgesPassThroughCorners) {
    Random random(37);
    for (int i = 0; i < 60 && !HasFailure(); ++i) {
        Walk walk = random_walk(random, 2 + random.below(4), 100);
        for (int k = 0; k < 30 && walk.size() > 4; ++k) {
            const std::size_t at = random.below(static_cast<std::uint32_t>(walk.size()));
            const Point& a = walk[(at + walk.size() - 1) % walk.size()];
            const Point& b = walk[at];
            const Point& c = walk[(at + 1) % walk.size()];
            const bool is_between = (a[0] - b[0]) * (c[0] - b[0]) + (a[1] - b[1]) * (c[1] - b[1]) < 0;
            if (is_between && twice_area(a, b, c) == 0) walk.erase(walk.begin() + static_cast<std::ptrdiff_t>(at));
        }
        expect_cut(walk, PolygonCut::ears, true);
    }
}

// Closed walks through any points: the fan or the ears cover what they go round once, or they cross themselves.
TEST(CutRandomPolygon, IsNeverWrongAboutAnyWalk) {
    Random random(38);
    std::size_t cut_count = 0;
    for (int i = 0; i < 3000 && !HasFailure(); ++i) {
        Walk walk(4 + random.below(5));
        const std::uint32_t width = 2 + random.below(3);
        for (Point& p : walk) p = {random.below(width), random.below(width)};
        const Cut made = cut(walk, 0, random.below(2) == 0);
        const std::int64_t whole = twice_area(walk);
        if (made.kind == PolygonCut::crossing || whole == 0) continue;
        ++cut_count;
        expect_covered(walk, made, true, true);
        // No two triangles share a point that is inside of both: some point of a fine lattice would be in both.
        for (std::int64_t x = 1; x < 40 * width; x += 7) {
            for (std::int64_t y = 3; y < 40 * width; y += 11) {
                int count = 0;
                for (const auto& t : made.triangles) {
                    int left = 0;
                    for (std::size_t k = 0; k < 3; ++k) {
                        const Point a{40 * t[k][0], 40 * t[k][1]};
                        const Point b{40 * t[(k + 1) % 3][0], 40 * t[(k + 1) % 3][1]};
                        const std::int64_t area = twice_area(a, b, {x, y});
                        left += area > 0 ? 1 : area < 0 ? -1 : 0;
                    }
                    if (std::abs(left) == 3) ++count;
                }
                EXPECT_LE(count, 1);
            }
        }
    }
    EXPECT_GT(cut_count, 500U);
}

// Long outlines must not take quadratic time: about 10,000 corners of each.
TEST(CutRandomPolygon, CutsLongOutlines) {
    constexpr std::int64_t count = 2500;
    Walk comb, slanted, staircase;
    for (std::int64_t i = 0; i < count; ++i) {
        for (const Point& p : {Point{4 * i, 0}, Point{4 * i + 1, 0}, Point{4 * i + 2, 1000}, Point{4 * i + 3, 1000}})
            comb.push_back(p);
    }
    comb.insert(comb.end(), {{4 * count, 2000}, {-1, 2000}});
    for (const Point& p : comb) slanted.push_back({p[0] + 30 * p[1], p[0] - 30 * p[1]});
    for (std::int64_t i = 0; i < 2 * count; ++i) staircase.insert(staircase.end(), {{i, i}, {i + 1, i}});
    for (std::int64_t i = 2 * count; i > 0; --i) staircase.insert(staircase.end(), {{i, i + 1}, {i - 1, i + 1}});
    for (const Walk* walk : {&comb, &slanted, &staircase}) {
        const Cut made = cut(*walk, 1, true);
        EXPECT_EQ(made.kind, PolygonCut::ears);
        expect_covered(*walk, made, false, false);
    }
}

}  // namespace
}  // namespace ecods::scenes::cut_polygon_test
