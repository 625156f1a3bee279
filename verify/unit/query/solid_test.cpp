#include "ecods/solid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "ecods/error.hpp"
#include "ecods/intersection.hpp"
#include "scenes/shapes.hpp"
#include "unit/query/solid_soup.hpp"

namespace ecods {
namespace {

// Both orders; the same pose for both, and with b moved in its own mesh instead of by its pose.
void expect_relation(const MeshPtr& a, const MeshPtr& b, Relation expected) {
    const Solid x(a), y(b);
    QueryMemory memory;
    for (const Pose& pose : common_poses()) {
        EXPECT_EQ(relation({x, pose}, {y, pose}, memory), expected);
        EXPECT_EQ(relation({y, pose}, {x, pose}, memory), swapped(expected));
        // Two poses that are equal as maps and not as bits: common poses are not cancelled then.
        Pose other = pose;
        for (int k = 0; k < 9; ++k) {
            if (other.R.data()[k] == 0) other.R.data()[k] = -0.0;
        }
        EXPECT_EQ(relation({x, pose}, {y, other}, memory), expected);
        EXPECT_EQ(relation({x, pose}, {x, pose}, memory), Relation::equal);
    }
}

constexpr auto apart = Relation::apart, touching = Relation::touching, overlapping = Relation::overlapping,
               inside = Relation::inside, contains = Relation::contains, equal = Relation::equal;

TEST(Relation, BoxesByTheirIntervals) {
    const Vec3 low(0, 0, 0), high(2, 2, 2);
    const MeshPtr cube = box(low, high);
    expect_relation(cube, box({2, 0, 0}, {4, 2, 2}), touching);   // face on face
    expect_relation(cube, box({2, 1, -1}, {4, 3, 1}), touching);  // part of a face
    expect_relation(cube, box({2, 2, 0}, {4, 4, 2}), touching);   // edge on edge
    expect_relation(cube, box({2, 2, 1}, {4, 4, 5}), touching);   // part of an edge
    expect_relation(cube, box({2, 2, 2}, {4, 4, 4}), touching);   // corner on corner
    expect_relation(cube, box({3, 0, 0}, {4, 2, 2}), apart);
    expect_relation(cube, box({1, 0, 0}, {3, 2, 2}), overlapping);  // flush on four sides
    expect_relation(cube, box({1, 1, 1}, {3, 3, 3}), overlapping);
    expect_relation(cube, box({-1, 0.5, 0.5}, {3, 1, 1}), overlapping);  // through
    expect_relation(cube, box({0.5, 0.5, 0.5}, {1, 1, 1}), contains);
    expect_relation(cube, box({0, 0.5, 0.5}, {1, 1, 1}), contains);  // touching from inside
    expect_relation(cube, box({0, 0, 0}, {1, 1, 1}), contains);
    expect_relation(cube, box({0, 0, 0}, {1, 2, 2}), contains);
    expect_relation(cube, box({-1, 0, 0}, {3, 2, 2}), inside);
    expect_relation(cube, box(low, high, 3), equal);
}

TEST(Relation, WallsThatShareFiftyMillimetresOverlap) {
    expect_relation(box({0, 0, 0}, {4.05, 0.3, 2.5}), box({4, 0, 0}, {8, 0.3, 2.5}), overlapping);
    expect_relation(box({0, 0, 0}, {4, 0.3, 2.5}), box({4, 0, 0}, {8, 0.3, 2.5}), touching);
    expect_relation(box({0, 0, 0}, {4, 0.3, 2.5}), box({1, 0.1, 1}, {3, 0.2, 1.1}), contains);  // a pipe in a wall
}

TEST(Relation, OctahedronInACube) {
    const MeshPtr cube = box({-1, -1, -1}, {1, 1, 1});
    expect_relation(octahedron({0, 0, 0}, 1).mesh(), cube, inside);  // its corners are on the faces
    // Its corners are on corners of triangles, and its edges above sides of them.
    expect_relation(octahedron({0, 0, 0}, 1).mesh(), box({-1, -1, -1}, {1, 1, 1}, 2), inside);
    expect_relation(octahedron({0, 0, 0}, 1).mesh(), box({1, -1, -1}, {-1, 1, 1}, 2), inside);
    expect_relation(octahedron({2, 0, 0}, 1).mesh(), cube, touching);
    expect_relation(octahedron({0, 0, 0}, 1.5).mesh(), cube, overlapping);
    expect_relation(octahedron({0, 0, 0}, 3).mesh(), cube, contains);  // the cube's corners are on its faces
    expect_relation(octahedron({1.5, 1.5, 0}, 1).mesh(), cube,
                    touching);  // its corners are off, its edge on the cube's edge
}

TEST(Relation, NestedShells) {
    Soup outer = soup_of_box({0, 0, 0}, {9, 9, 9});
    outer.add_box({1, 1, 1}, {8, 8, 8});
    Soup shell = soup_of_box({1, 1, 1}, {8, 8, 8});
    shell.add_box({2, 2, 2}, {7, 7, 7});
    expect_relation(outer.mesh(), box({3, 3, 3}, {4, 4, 4}), apart);     // in the cavity
    expect_relation(outer.mesh(), box({1, 3, 3}, {4, 4, 4}), touching);  // on its wall
    expect_relation(outer.mesh(), box({0.5, 3, 3}, {4, 4, 4}), overlapping);
    expect_relation(outer.mesh(), box({0.25, 3, 3}, {0.5, 4, 4}), contains);
    expect_relation(outer.mesh(), shell.mesh(), touching);
    expect_relation(outer.mesh(), box({1, 1, 1}, {8, 8, 8}), touching);  // the plug
    expect_relation(outer.mesh(), box({0, 0, 0}, {9, 9, 9}), inside);
    outer.add_box({3, 3, 3}, {5, 5, 5});  // an island
    expect_relation(outer.mesh(), box({3, 3, 3}, {5, 5, 5}), contains);
    expect_relation(outer.mesh(), box({4, 4, 4}, {6, 6, 6}), overlapping);
}

TEST(Relation, SurfacesApartOneInside) {
    expect_relation(scenes::sphere(20, 10), box({-0.25, -0.25, -0.25}, {0.25, 0.25, 0.25}), contains);
    expect_relation(scenes::torus(24, 12, 0.25), box({-0.25, -0.25, -0.25}, {0.25, 0.25, 0.25}), apart);
}

TEST(Relation, FourTrianglesAtAnEdge) {
    Soup two = soup_of_box({0, 0, 0}, {1, 1, 1});
    two.add_box({1, 1, 0}, {2, 2, 1});  // joined along an edge
    expect_relation(two.mesh(), box({1, 0, 0}, {2, 1, 1}), touching);
    expect_relation(two.mesh(), box({0.5, 0.5, 0}, {1.5, 1.5, 1}), overlapping);
    expect_relation(two.mesh(), box({0, 0, 0}, {2, 2, 1}), inside);
    expect_relation(two.mesh(), box({1, 1, 0.25}, {2, 2, 0.5}), contains);
    Soup part = soup_of_box({0, 0, 0}, {1, 1, 3});
    part.add_box({1, 1, 1}, {2, 2, 2});  // along a part of an edge
    expect_relation(part.mesh(), box({1, 0, 0}, {2, 1, 3}), touching);
    expect_relation(part.mesh(), box({0, 0, 0}, {2, 2, 3}), inside);
}

TEST(Relation, SingularPosesLeaveNoInterior) {
    const Solid cube(box({-1, -1, -1}, {1, 1, 1})), other(box({-1, -1, -1}, {1, 1, 1}, 2));
    QueryMemory memory;
    Pose flat;
    flat.R << 0.5, 0, 0, 0, 0.5, 0, 0, 0, 0;
    Pose line = flat;
    line.R(1, 1) = 0;
    Pose point;
    point.R.setZero();
    const Pose whole;
    for (Pose pose : {flat, line, point}) {
        EXPECT_EQ(relation({cube, pose}, {other, whole}, memory), touching);  // inside it
        EXPECT_EQ(relation({other, whole}, {cube, pose}, memory), touching);
        EXPECT_EQ(relation({cube, pose}, {other, pose}, memory), touching);
        EXPECT_EQ(locate({0, 0, 0}, {cube, pose}, memory).side, Side::on);
        EXPECT_EQ(locate({0, 0, 0.5}, {cube, pose}, memory).side, Side::outside);
        pose.t = Vec3(0, 0, 1);
        EXPECT_EQ(relation({cube, pose}, {other, whole}, memory), touching);
        pose.t = Vec3(0, 0, std::nextafter(1.0, 2.0));
        EXPECT_EQ(relation({cube, pose}, {other, whole}, memory), apart);
    }
    EXPECT_EQ(locate({0.5, 0.25, 0}, {cube, flat}, memory).feature.kind, Feature::Kind::edge);
    EXPECT_EQ(locate({0.5, 0, 0}, {cube, line}, memory).feature.kind, Feature::Kind::vertex);
}

TEST(Relation, TheEmptySetIsNoSolid) {
    Soup antenna;
    antenna.add({0, 0, 0}, {1, 1, 1}, {2, 2, 2});
    try {
        const Solid empty(antenna.mesh());
        ADD_FAILURE() << "a solid without a point";
    } catch (const NotSolid& error) {
        EXPECT_EQ(error.reason, NotSolid::Reason::no_interior);
    }
    EXPECT_THROW(check_solid(*antenna.mesh()), NotSolid);
}

TEST(Relation, ZeroAreaTrianglesAreLeftOut) {
    Soup soup = soup_of_box({0, 0, 0}, {1, 1, 1});
    soup.add({1, 1, 1}, {2, 2, 2}, {3, 3, 3});
    soup.add({0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}, {0.5, 0.5, 0.5});
    const Solid a(soup.mesh()), b(box({1.5, 1.5, 1.5}, {4, 4, 4}));
    QueryMemory memory;
    EXPECT_FALSE(intersects({a, {}}, {b, {}}, memory));
    EXPECT_TRUE(intersects({*surface_of(a), {}}, {b, {}}, memory));
    EXPECT_EQ(relation({a, {}}, {b, {}}, memory), apart);
    EXPECT_EQ(locate({2, 2, 2}, {a, {}}, memory).side, Side::outside);
    EXPECT_EQ(locate({0.5, 0.5, 0.5}, {a, {}}, memory).side, Side::inside);
    Pose flat;
    flat.R(2, 2) = 0;
    EXPECT_EQ(locate({2, 2, 0}, {a, flat}, memory).side, Side::outside);
}

TEST(Relation, HardPoses) {
    // Nearly flush, by one unit in the last place.
    const Solid cube(box({0, 0, 0}, {1, 1, 1}));
    QueryMemory memory;
    const double ulp = std::numeric_limits<double>::epsilon();
    Pose pose;
    for (const auto& [offset, expected] :
         {std::pair{1.0, touching}, std::pair{1 - ulp / 2, overlapping}, std::pair{1 + ulp, apart}}) {
        pose.t = Vec3(offset, 0, 0);
        EXPECT_EQ(relation({cube, {}}, {cube, pose}, memory), expected);
        pose.t = Vec3(0, 0, -offset);
        EXPECT_EQ(relation({cube, {}}, {cube, pose}, memory), expected);
    }
    Pose larger;
    larger.R *= 1 + ulp;
    EXPECT_EQ(relation({cube, {}}, {cube, larger}, memory), inside);
    larger.t = Vec3(-0x1p-900, 0, 0);
    EXPECT_EQ(relation({cube, {}}, {cube, larger}, memory), inside);
    larger.t = Vec3(0x1p-1074, 0, 0);
    EXPECT_EQ(relation({cube, {}}, {cube, larger}, memory), overlapping);
}

}  // namespace
}  // namespace ecods
