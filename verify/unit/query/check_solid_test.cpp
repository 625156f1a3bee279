#include "ecods/solid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "ecods/error.hpp"
#include "ecods/intersection.hpp"
#include "environment/each_environment.hpp"
#include "scenes/expect_invalid.hpp"
#include "unit/query/solid_soup.hpp"

namespace ecods {
namespace {

TEST(CheckSolid, NamesAnEdgeThatIsNotClosed) {
    Soup soup = soup_of_box({0, 0, 0}, {1, 1, 1});
    soup.triangles.erase(soup.triangles.begin() + 5);  // of the face y = 0
    try {
        check_solid(*soup.mesh());
        FAIL();
    } catch (const NotSolid& error) {
        EXPECT_EQ(error.reason, NotSolid::Reason::open_edge);
        // One of the three neighbours, by the edge that it shares with the triangle that is gone: the least of them.
        EXPECT_EQ(error.triangle, 3u);
        const Triangle& named = soup.triangles[error.triangle];
        EXPECT_EQ(error.vertices[0], named[static_cast<std::size_t>(error.corner)]);
        EXPECT_EQ(error.vertices[1], named[static_cast<std::size_t>(error.corner + 1) % 3]);
        for (int k = 0; k < 3; ++k) {
            EXPECT_EQ(error.points[0][static_cast<std::size_t>(k)], soup.vertices[error.vertices[0]][k]);
        }
    }
    EXPECT_INVALID(Solid{soup.mesh()}, NotSolid::Reason::open_edge);
    EXPECT_INVALID(Solid{nullptr}, Argument::null);
}

TEST(CheckSolid, ClosedAlongLines) {
    // A face of four parts beside one of one part: long edges face halves.
    Soup soup;
    soup.add_box({0, 0, 0}, {1, 1, 1});
    const Soup fine = soup_of_box({0, 0, 0}, {1, 1, 1}, 2);
    Soup mixed;
    for (std::size_t i = 2; i < soup.triangles.size(); ++i) {
        const auto& t = soup.triangles[i];
        mixed.add(soup.vertices[t[0]], soup.vertices[t[1]], soup.vertices[t[2]]);
    }
    EXPECT_INVALID(check_solid(*mixed.mesh()), NotSolid::Reason::open_edge);
    for (std::size_t i = 0; i < 8; ++i) {
        const auto& t = fine.triangles[i];
        mixed.add(fine.vertices[t[0]], fine.vertices[t[1]], fine.vertices[t[2]]);
    }
    check_solid(*mixed.mesh());
    EXPECT_TRUE(self_intersections(*mixed.mesh()).empty());
    const Solid solid(mixed.mesh()), same(box({0, 0, 0}, {1, 1, 1}, 3)), below(box({0, 0, -1}, {1, 1, 0}));
    QueryMemory memory;
    EXPECT_EQ(relation({solid, {}}, {same, {}}, memory), Relation::equal);
    EXPECT_EQ(relation({below, {}}, {solid, {}}, memory), Relation::touching);
    mixed.triangles.pop_back();
    EXPECT_INVALID(check_solid(*mixed.mesh()), NotSolid::Reason::open_edge);
}

// Corners p, p + d and p + 3 d, of which one difference is no double: computed, a normal is not zero.
TEST(CheckSolid, ZeroAreaThatRoundingHides) {
    const Vec3 p(-0x1.3c01788a9278cp-1, 0x1.aa42ad66b829fp+0, 0x1.08ea25f2f1b10p-1);
    const Vec3 q(-0x1.24ac050a63e9cp-2, 0x1.76a7a4b072938p-1, 0x1.7a82ed99eb3bcp-2);
    const Vec3 r(0x1.8201d30b1e25cp-2, -0x1.2289e3c4c476ap+0, 0x1.2f80c407ebbd0p-4);
    // It sticks out of a box on both sides, and would meet its surface there if it were a triangle of the surface.
    Soup soup = soup_of_box({-1, -1, -1}, {1, 1, 1});
    soup.add(p, q, r);
    environment::in_each_environment(
        [&] {
            check_solid(*soup.mesh());
            return self_intersections(*soup.mesh()).empty();
        },
        [](bool answer, const std::string& where) { EXPECT_TRUE(answer) << where; });
}

TEST(CheckSolid, NegativeZeroIsZero) {
    Soup soup = soup_of_box({0, 0, 0}, {1, 1, 1});
    for (std::size_t i = 0; i < soup.vertices.size(); i += 2) {
        for (int k = 0; k < 3; ++k) {
            if (soup.vertices[i][k] == 0) soup.vertices[i][k] = -0.0;
        }
    }
    check_solid(*soup.mesh());
}

TEST(SelfIntersections, ListsEveryPairOnce) {
    Soup crossing = soup_of_box({0, 0, 0}, {2, 2, 2});
    crossing.add_box({1, 1, 1}, {3, 3, 3});
    const auto pairs = self_intersections(*crossing.mesh());
    EXPECT_FALSE(pairs.empty());
    EXPECT_TRUE(std::ranges::is_sorted(pairs));
    for (const TrianglePair& pair : pairs) EXPECT_LT(pair.a, pair.b);
    try {
        check_solid(*crossing.mesh());
        FAIL();
    } catch (const NotSolid& error) {
        EXPECT_EQ(error.reason, NotSolid::Reason::self_intersection);
        EXPECT_EQ(error.triangles, pairs.front());
    }

    Soup twice = soup_of_box({0, 0, 0}, {1, 1, 1});
    twice.add_box({0, 0, 0}, {1, 1, 1});  // every triangle a second time
    EXPECT_EQ(self_intersections(*twice.mesh()).size(), 12u);

    Soup folded;
    folded.add({0, 0, 0}, {2, 0, 0}, {1, 2, 0});
    folded.add({0, 0, 0}, {2, 0, 0}, {1, 1, 0});
    EXPECT_EQ(self_intersections(*folded.mesh()), (std::vector<TrianglePair>{{0, 1}}));

    Soup flat;  // beside each other
    flat.add({0, 0, 0}, {2, 0, 0}, {1, 2, 0});
    flat.add({0, 0, 0}, {2, 0, 0}, {1, -1, 0});
    flat.add({1, 2, 0}, {3, 2, 0}, {3, 3, 0});
    flat.add({1, 0, 0}, {1.5, 0, 0}, {1, 0, 1});  // along a part of an edge
    flat.add({1, 1, 0}, {1, 1, 1}, {2, 1, 1});    // a corner on a face
    EXPECT_TRUE(self_intersections(*flat.mesh()).empty());
    flat.add({0.75, 0.5, 0}, {1.25, 0.5, 0}, {1, 0.5, 1});  // a side in a face
    EXPECT_EQ(self_intersections(*flat.mesh()), (std::vector<TrianglePair>{{0, 5}}));
}

TEST(SelfIntersections, FansAcrossAVertex) {
    const Vec3 v(0, 0, 0);
    Soup through;  // both have the corner v, and the second leaves through the first
    through.add(v, {2, -1, 0}, {2, 1, 0});
    through.add(v, {1, 0, -1}, {1, 0, 1});
    EXPECT_EQ(self_intersections(*through.mesh()).size(), 1u);
    Soup away;
    away.add(v, {2, -1, 0}, {2, 1, 0});
    away.add(v, {-1, 0, -1}, {-1, 0, 1});
    EXPECT_TRUE(self_intersections(*away.mesh()).empty());
    Soup edge;  // its side lies in the first one's face
    edge.add(v, {2, -1, 0}, {2, 1, 0});
    edge.add(v, {1, 0, 0}, {1, 0, 1});
    EXPECT_EQ(self_intersections(*edge.mesh()).size(), 1u);
}

TEST(Solid, IsAMeshShape) {
    const auto solid = std::make_shared<const Solid>(box({0, 0, 0}, {1, 1, 1}));
    const std::shared_ptr<const Shape> shape = solid;
    EXPECT_EQ(shape->kind(), ShapeKind::mesh());
    EXPECT_EQ(shape->digest(), solid->mesh().digest());
}

}  // namespace
}  // namespace ecods
