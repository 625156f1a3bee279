// Polygons of each kind, cut into triangles.
#include "scenes/polygon/cut_polygon.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>

#include "cut_walk.hpp"

namespace ecods::scenes::cut_polygon_test {
namespace {

TEST(CutPolygon, KeepsTheFansOfConvexPolygons) {
    const Walk walk{{0, 0}, {4, 0}, {6, 3}, {4, 6}, {1, 5}};
    expect_cut(walk, PolygonCut::fan);
    const Polygon polygon = polygon_of(walk, 0, true);
    std::vector<Triangle> triangles{{7, 8, 9}};
    EXPECT_EQ(cut_polygon(polygon.vertices, polygon.corners, triangles), PolygonCut::fan);
    EXPECT_EQ(triangles, (std::vector<Triangle>{{7, 8, 9}, {0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
}

TEST(CutPolygon, CutsDentsFromEachCorner) {
    expect_cut({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {0, 1}}, PolygonCut::ears);
    expect_cut({{0, 0}, {8, 0}, {8, 6}, {6, 6}, {6, 2}, {4, 2}, {4, 6}, {2, 6}, {2, 2}, {0, 2}}, PolygonCut::ears);
    // A spiral, which has two ears at all times.
    expect_cut({{0, 0},
                {7, 0},
                {7, 7},
                {1, 7},
                {1, 2},
                {5, 2},
                {5, 5},
                {3, 5},
                {3, 4},
                {4, 4},
                {4, 3},
                {2, 3},
                {2, 6},
                {6, 6},
                {6, 1},
                {0, 1}},
               PolygonCut::ears);
}

TEST(CutPolygon, LosesNoCornerOnAStraightEdge) {
    expect_cut({{0, 0}, {1, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 1}}, PolygonCut::ears);
    expect_cut({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {1, 4}}, PolygonCut::ears);
    const Walk half{{0, 0}, {2, 0}, {4, 0}, {0, 4}};
    EXPECT_EQ(cut(half, 0, true).kind, PolygonCut::ears);
    EXPECT_EQ(cut({half[1], half[2], half[3], half[0]}, 0, true).kind, PolygonCut::fan);
}

TEST(CutPolygon, TakesHolesThatBridgesJoin) {
    // Two holes, one behind the other; the bridges lie on one line with sides of the first hole.
    expect_cut({{0, 0},
                {9, 0},
                {9, 9},
                {0, 9},
                {0, 0},
                {2, 2},
                {2, 4},
                {4, 4},
                {4, 2},
                {6, 2},
                {6, 4},
                {8, 4},
                {8, 2},
                {6, 2},
                {4, 2},
                {2, 2}},
               PolygonCut::ears);
    // A bridge that passes through a corner of the other hole.
    expect_cut({{0, 0},
                {9, 0},
                {9, 9},
                {0, 9},
                {0, 0},
                {6, 6},
                {6, 8},
                {8, 8},
                {8, 6},
                {6, 6},
                {0, 0},
                {3, 3},
                {3, 5},
                {4, 5},
                {3, 3}},
               PolygonCut::ears, true);
    // A hole that touches the outline in a corner, and one that touches a side of it.
    expect_cut({{0, 0}, {4, 2}, {3, 3}, {2, 4}, {0, 0}, {0, 8}, {8, 8}, {8, 0}}, PolygonCut::ears);
    expect_cut({{0, 0}, {8, 0}, {8, 8}, {4, 8}, {4, 6}, {6, 0}, {2, 0}, {4, 6}, {4, 8}, {0, 8}}, PolygonCut::ears, true,
               true);
}

TEST(CutPolygon, TakesTwoPartsThatMeetInACorner) {
    expect_cut({{0, 0}, {2, 0}, {2, 2}, {4, 2}, {4, 4}, {2, 4}, {2, 2}, {0, 2}}, PolygonCut::ears);
    // A tooth that reaches the other side.
    expect_cut({{0, 0}, {8, 0}, {8, 8}, {5, 8}, {4, 0}, {3, 8}, {0, 8}}, PolygonCut::ears, true);
}

TEST(CutPolygon, CoversSpikesWithTrianglesOfNoArea) {
    expect_cut({{0, 0}, {4, 0}, {4, 4}, {6, 6}, {4, 4}, {0, 4}}, PolygonCut::ears, false, true);
    expect_cut({{0, 0}, {4, 0}, {4, 4}, {6, 6}, {9, 6}, {6, 6}, {4, 4}, {0, 4}}, PolygonCut::ears, false, true);
    // Into the polygon: a slit, which costs none.
    expect_cut({{0, 0}, {4, 0}, {4, 4}, {2, 2}, {2, 1}, {2, 2}, {4, 4}, {0, 4}}, PolygonCut::ears);
}

TEST(CutPolygon, PassesOverRepeatedCorners) {
    expect_cut({{0, 0}, {0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {2, 1}, {2, 1}, {0, 1}}, PolygonCut::ears);
}

TEST(CutPolygon, SaysThatAnOutlineCrossesItself) {
    expect_cut({{0, 0}, {4, 4}, {4, 0}, {0, 4}}, PolygonCut::crossing);
    expect_cut({{0, 0}, {4, 0}, {4, 4}, {0, 0}, {4, 0}, {4, 4}}, PolygonCut::crossing);           // twice round
    expect_cut({{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}, {2, 2}, {4, 2}, {4, 4}, {2, 4}, {2, 2}},  // a hole turned over
               PolygonCut::crossing);
    expect_cut({{0, 0}, {5, 9}, {10, 0}, {0, 6}, {10, 6}}, PolygonCut::crossing);
    // Its fan goes round the first corner by more than a whole turn.
    expect_cut({{0, 0}, {2, 0}, {1, 2}, {-2, 1}, {-2, -2}, {1, -3}, {3, 1}}, PolygonCut::crossing);
}

TEST(CutPolygon, KeepsTheFanOfCornersOnOneLine) {
    const std::vector<Vec3> vertices{{0, 0, 0}, {1, 2, 3}, {2, 4, 6}, {-1, -2, -3}};
    std::vector<Triangle> triangles;
    EXPECT_EQ(cut_polygon(vertices, std::array{0U, 1U, 2U, 3U}, triangles), PolygonCut::fan);
    EXPECT_EQ(cut_polygon(vertices, std::array{0U, 0U, 0U, 0U}, triangles), PolygonCut::fan);
    EXPECT_EQ(triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 0, 0}, {0, 0, 0}}));
}

// The dent is decided by the last bit, and the normal by numbers that are gone once they are rounded.
TEST(CutPolygon, DecidesExactly) {
    const double last_bit = 0x1p-52;
    for (const double dent : {-last_bit, 0.0, last_bit}) {
        const std::vector<Vec3> vertices{{0, 0, 0}, {2, 0, 0}, {1 + dent, 1 + dent, 0}, {0, 2, 0}};
        std::vector<Triangle> triangles;
        EXPECT_EQ(cut_polygon(vertices, std::array{1U, 2U, 3U, 0U}, triangles),
                  dent > 0 ? PolygonCut::fan : PolygonCut::ears)
            << dent;
        EXPECT_EQ(triangles.size(), 2U);
        for (const Triangle& triangle : triangles)
            EXPECT_TRUE(dent > 0 || std::count(triangle.begin(), triangle.end(), 2U) > 0);
    }
    for (const double scale : {0x1p-1074, 0x1p-600, 0x1p+1020}) {
        std::vector<Vec3> vertices;
        for (const auto& [x, y] : {std::pair{-3, -3}, {3, -3}, {3, 3}, {2, 3}, {2, -2}, {-3, -2}})
            vertices.emplace_back(x * scale, y * scale, 7 * scale);
        std::vector<Triangle> triangles;
        EXPECT_EQ(cut_polygon(vertices, std::array{0U, 1U, 2U, 3U, 4U, 5U}, triangles), PolygonCut::ears) << scale;
    }
}

TEST(CutPolygon, LooksAlongTheAxisThatShowsMost) {
    // Almost on edge along z, where rounding is all that is left of its area; the dent is seen along x.
    std::vector<Vec3> vertices;
    for (const auto& [y, z] : {std::pair{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {0, 1}})
        vertices.emplace_back(y == 3 && z == 3 ? 0x1p-40 : 0, y, z);
    std::vector<Triangle> triangles;
    const std::array corners{0U, 1U, 2U, 3U, 4U, 5U};
    EXPECT_EQ(cut_polygon(vertices, corners, triangles), PolygonCut::ears);
    double area = 0;
    for (const auto& [a, b, c] : triangles)
        area += ((vertices[b] - vertices[a]).cross(vertices[c] - vertices[a]))[0] / 2;
    EXPECT_EQ(area, 5);
    EXPECT_FALSE(is_in_a_plane(vertices, corners));
    vertices[2][0] = 0;
    EXPECT_TRUE(is_in_a_plane(vertices, corners));
}

}  // namespace
}  // namespace ecods::scenes::cut_polygon_test
