// Walks in the plane as polygons in space, and the triangles into which they are cut, against areas and edges in whole
// numbers. All coordinates are small integers, so that products are exact.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "scenes/polygon/cut_polygon.hpp"

namespace ecods::scenes::cut_polygon_test {

using Point = std::array<std::int64_t, 2>;
using Walk = std::vector<Point>;

inline std::int64_t twice_area(const Point& a, const Point& b, const Point& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

inline std::int64_t twice_area(const Walk& walk) {
    std::int64_t area = 0;
    for (std::size_t i = 2; i < walk.size(); ++i) area += twice_area(walk[0], walk[i - 1], walk[i]);
    return area;
}

// A mesh of one polygon: the walk in a slanted plane, on which x and y stand above the other axes.
struct Polygon {
    std::vector<Vec3> vertices;
    std::vector<std::uint32_t> corners;
};

// One vertex for all corners in one place, or for each its own.
inline Polygon polygon_of(const Walk& walk, int axis, bool shares_vertices) {
    Polygon polygon;
    std::map<Point, std::uint32_t> vertex_of;
    for (const Point& point : walk) {
        const auto next = static_cast<std::uint32_t>(polygon.vertices.size());
        const auto [entry, is_new] = vertex_of.try_emplace(point, next);
        polygon.corners.push_back(shares_vertices ? entry->second : next);
        if (!is_new && shares_vertices) continue;
        Vec3 vertex;
        vertex[axis] = static_cast<double>(point[0] - 2 * point[1]) / 4;
        vertex[(axis + 1) % 3] = static_cast<double>(point[0]);
        vertex[(axis + 2) % 3] = static_cast<double>(point[1]);
        polygon.vertices.push_back(vertex);
    }
    return polygon;
}

struct Cut {
    PolygonCut kind;
    std::vector<std::array<Point, 3>> triangles;
};

inline Cut cut(const Walk& walk, int axis, bool shares_vertices) {
    const Polygon polygon = polygon_of(walk, axis, shares_vertices);
    std::vector<Triangle> triangles;
    Cut result{cut_polygon(polygon.vertices, polygon.corners, triangles), {}};
    EXPECT_TRUE(is_in_a_plane(polygon.vertices, polygon.corners));
    for (const Triangle& triangle : triangles) {
        std::array<Point, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3& v = polygon.vertices[triangle[k]];
            corners[k] = {static_cast<std::int64_t>(v[(axis + 1) % 3]), static_cast<std::int64_t>(v[(axis + 2) % 3])};
        }
        result.triangles.push_back(corners);
    }
    return result;
}

using Edges = std::map<std::pair<Point, Point>, int>;  // the lesser end first; there counts 1, back -1

inline void add_edge(const Point& a, const Point& b, int count, Edges& edges) {
    if (a == b) return;
    int& sum = a < b ? edges[{a, b}] : edges[{b, a}];
    sum += a < b ? count : -count;
}

// The triangles have areas of one sign, which sum up to that of the walk, and edges that add up to the walk's: so they
// cover what the walk bounds, each point as often as it goes round it. All corners are corners of triangles.
inline void expect_covered(const Walk& walk, const Cut& cut, bool may_split, bool may_have_zero_area) {
    const std::int64_t whole = twice_area(walk);
    std::int64_t sum = 0;
    Edges edges;
    std::set<Point> corners;
    for (const auto& triangle : cut.triangles) {
        const std::int64_t area = twice_area(triangle[0], triangle[1], triangle[2]);
        EXPECT_TRUE(area == 0 ? may_have_zero_area : (area > 0) == (whole > 0));
        sum += area;
        corners.insert(triangle.begin(), triangle.end());
        for (std::size_t k = 0; k < 3; ++k) add_edge(triangle[k], triangle[(k + 1) % 3], 1, edges);
    }
    EXPECT_EQ(sum, whole);
    for (std::size_t i = 0; i < walk.size(); ++i) {
        EXPECT_TRUE(corners.contains(walk[i]));
        add_edge(walk[i], walk[(i + 1) % walk.size()], -1, edges);
    }
    if (may_split) return;
    for (const auto& [edge, count] : edges) EXPECT_EQ(count, 0);
}

// From each corner, or from some of many, in both directions, in the planes of all axes, with and without shared
// vertices.
inline void expect_cut(Walk walk, PolygonCut kind, bool may_split = false, bool may_have_zero_area = false) {
    std::string text;
    for (const Point& p : walk) text += std::to_string(p[0]) + "," + std::to_string(p[1]) + " ";
    SCOPED_TRACE(text);
    const std::size_t step = 1 + walk.size() / 20;
    for (std::size_t turn = 0; turn * step < 2 * walk.size() && !testing::Test::HasFailure(); ++turn) {
        if (turn == walk.size() / step) std::reverse(walk.begin(), walk.end());
        std::rotate(walk.begin(), walk.begin() + static_cast<std::ptrdiff_t>(step), walk.end());
        const Cut made = cut(walk, static_cast<int>(turn % 3), turn % 2 == 0);
        if (kind == PolygonCut::crossing) {
            EXPECT_EQ(made.kind, kind);
            EXPECT_EQ(made.triangles.size(), walk.size() - 2);
        } else {
            EXPECT_NE(made.kind, PolygonCut::crossing);
            expect_covered(walk, made, may_split, may_have_zero_area);
            if (kind == PolygonCut::fan) {
                EXPECT_EQ(made.kind, PolygonCut::fan);
            }
        }
    }
}

}  // namespace ecods::scenes::cut_polygon_test
