#include <gtest/gtest.h>

#include <array>

#include "ecods/intersection.hpp"
#include "ecods/solid.hpp"
#include "oracle/solid.hpp"
#include "unit/query/solid_soup.hpp"

namespace ecods::surface_relation_test {
namespace {

constexpr auto apart = Relation::apart, touching = Relation::touching, inside = Relation::inside,
               partly_inside = Relation::crossing;

Soup square(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    Soup soup;
    soup.add(a, b, c, d);
    return soup;
}
Soup segment(const Vec3& a, const Vec3& b) {
    Soup soup;
    soup.add(a, b, a);
    return soup;
}
Soup both(Soup a, const Soup& b) {
    for (const Triangle& t : b.triangles) a.add(b.vertices[t[0]], b.vertices[t[1]], b.vertices[t[2]]);
    return a;
}

// In one pose for both, which is cancelled, and in two that are equal as maps.
void expect_surface(const Soup& surface, const MeshPtr& mesh, Relation expected) {
    const MeshShape shape(surface.mesh());
    const Solid solid(mesh);
    QueryMemory memory;
    for (const Pose& pose : common_poses()) {
        EXPECT_EQ(relation({shape, pose}, {solid, pose}, memory), expected);
        Pose other = pose;
        for (int k = 0; k < 9; ++k) {
            if (other.R.data()[k] == 0) other.R.data()[k] = -0.0;
        }
        EXPECT_EQ(relation({shape, pose}, {solid, other}, memory), expected);
    }
}

const MeshPtr cube = box({0, 0, 0}, {2, 2, 2});

TEST(Relation, SquaresAtACube) {
    expect_surface(square({0, 0, 3}, {2, 0, 3}, {2, 2, 3}, {0, 2, 3}), cube, apart);
    expect_surface(square({0, 0, 2}, {2, 0, 2}, {2, 2, 2}, {0, 2, 2}), cube, touching);     // a face
    expect_surface(square({-1, -1, 2}, {5, 0, 2}, {3, 5, 2}, {-2, 4, 2}), cube, touching);  // around it
    expect_surface(square({2, 0, 2}, {4, 0, 2}, {4, 2, 2}, {2, 2, 2}), cube, touching);     // beside it, in its plane
    expect_surface(square({2, 2, 2}, {4, 2, 2}, {4, 4, 2}, {2, 4, 2}), cube, touching);     // the same, at a corner
    expect_surface(square({1, 1, 2}, {1, 1, 4}, {2, 2, 4}, {2, 2, 2}), cube, touching);     // standing on it
    expect_surface(square({1, 1, 2}, {1, 1, 1}, {2, 2, 1}, {2, 2, 2}), cube, inside);       // hanging from it
    expect_surface(square({0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}), cube, inside);       // across
    expect_surface(square({0, 0, 0}, {2, 0, 0}, {2, 2, 2}, {0, 2, 2}), cube, inside);       // diagonally
    expect_surface(square({0.5, 0.5, 1}, {1, 0.5, 1}, {1, 1, 1}, {0.5, 1, 1}), cube, inside);  // off the surface
    expect_surface(square({0, 0, 1}, {3, 0, 1}, {3, 2, 1}, {0, 2, 1}), cube, partly_inside);
    expect_surface(square({1, 1, 1}, {1, 1, 3}, {2, 2, 3}, {2, 2, 1}), cube, partly_inside);
    expect_surface(square({-1, -1, 1}, {3, -1, 1}, {3, 3, 1}, {-1, 3, 1}), cube, partly_inside);
    expect_surface(square({-1, 3, 0}, {3, -1, 0}, {3, -1, 2}, {-1, 3, 2}), cube, partly_inside);  // through two edges
    expect_surface(square({-1, 1, 0}, {1, -1, 0}, {1, -1, 2}, {-1, 1, 2}), cube, touching);       // along an edge
    expect_surface(square({-1, -1, 0}, {0, 0, 0}, {0, 0, 2}, {-1, -1, 2}), cube, touching);       // from an edge
    expect_surface(square({-1, -1, 0}, {1, 1, 0}, {1, 1, 2}, {-1, -1, 2}), cube, partly_inside);  // over an edge
}

TEST(Relation, PartsOfASurface) {
    const Soup in = square({0.5, 0.5, 1}, {1, 0.5, 1}, {1, 1, 1}, {0.5, 1, 1});
    const Soup out = square({0, 0, 3}, {2, 0, 3}, {2, 2, 3}, {0, 2, 3});
    const Soup on = square({0, 0, 2}, {2, 0, 2}, {2, 2, 2}, {0, 2, 2});
    expect_surface(both(in, out), cube, partly_inside);
    expect_surface(both(on, out), cube, touching);
    expect_surface(both(on, in), cube, inside);
    expect_surface(both(both(on, in), out), cube, partly_inside);
    // A whole surface without contact, in a cavity and in the material.
    Soup shell = soup_of_box({0, 0, 0}, {9, 9, 9});
    shell.add_box({2, 2, 2}, {7, 7, 7});
    expect_surface(soup_of_box({3, 3, 3}, {4, 4, 4}, 3), shell.mesh(), apart);
    expect_surface(soup_of_box({1, 1, 1}, {8, 8, 8}, 3), shell.mesh(), inside);
    expect_surface(soup_of_box({2, 2, 2}, {7, 7, 7}, 2), shell.mesh(), touching);
    expect_surface(soup_of_box({1, 3, 3}, {4, 4, 4}), shell.mesh(), partly_inside);
    expect_surface(octahedron({4.5, 4.5, 4.5}, 2.5), shell.mesh(), touching);  // its corners in the cavity's faces
    expect_surface(octahedron({0, 0, 0}, 1), box({-1, -1, -1}, {1, 1, 1}), inside);
}

TEST(Relation, SegmentsOfZeroArea) {
    expect_surface(segment({3, 3, 3}, {4, 4, 5}), cube, apart);
    expect_surface(segment({2, 2, 2}, {4, 4, 5}), cube, touching);
    expect_surface(segment({1, 1, 2}, {1, 1, 3}), cube, touching);
    expect_surface(segment({1, 1, 2}, {1, 1, 1}), cube, inside);
    expect_surface(segment({1, 1, 3}, {1, 1, 1}), cube, partly_inside);
    expect_surface(segment({1, 0.5, -1}, {1, 0.5, 3}), cube, partly_inside);
    expect_surface(segment({0, 0, 0}, {2, 2, 2}), cube, inside);
    expect_surface(segment({-1, -1, -1}, {3, 3, 3}), cube, partly_inside);  // through corners alone
    expect_surface(segment({0, 0, 0}, {3, 3, 3}), cube, partly_inside);
    expect_surface(segment({0, 0, 1}, {2, 2, 1}), cube, inside);           // from edge to edge
    expect_surface(segment({-1, -1, 1}, {3, 3, 1}), cube, partly_inside);  // through edges alone
    expect_surface(segment({-1, 1, 1}, {1, -1, 1}), cube, touching);       // past an edge
    expect_surface(segment({0, 0, -1}, {0, 0, 3}), cube, touching);        // along an edge
    expect_surface(segment({0, 0, 0.5}, {0, 0, 1}), cube, touching);       // inside an edge
    expect_surface(segment({-1, 1, 2}, {3, 1.5, 2}), cube, touching);      // across a face
    expect_surface(segment({0.5, 1, 2}, {1, 1.5, 2}), cube, touching);     // in a face
    expect_surface(segment({0.5, 0.5, 0.5}, {1, 1.5, 1}), cube, inside);
    expect_surface(segment({1, 1, 1}, {1, 1, 1}), cube, inside);  // points
    expect_surface(segment({2, 1, 1}, {2, 1, 1}), cube, touching);
    expect_surface(segment({2, 2, 1}, {2, 2, 1}), cube, touching);
    expect_surface(segment({3, 1, 1}, {3, 1, 1}), cube, apart);
    // From one of two boxes that share an edge to the other one, over that edge.
    Soup two = soup_of_box({0, 0, 0}, {2, 2, 2});
    two.add_box({2, 2, 0}, {4, 4, 2});
    expect_surface(segment({1, 1, 1}, {3, 3, 1}), two.mesh(), inside);
    expect_surface(segment({1, 3, 1}, {3, 1, 1}), two.mesh(), touching);
}

TEST(Relation, SingularPoses) {
    const MeshShape shape(octahedron({0, 0, 0}, 1).mesh());
    const Solid solid(box({-1, -1, -1}, {1, 1, 1}));
    QueryMemory memory;
    Pose flat;
    flat.R(2, 2) = 0;
    EXPECT_EQ(relation({shape, flat}, {solid, {}}, memory), inside);
    EXPECT_EQ(relation({shape, {}}, {solid, flat}, memory), touching);
    flat.t = Vec3(0, 0, 1);
    EXPECT_EQ(relation({shape, flat}, {solid, {}}, memory), touching);
    EXPECT_EQ(relation({shape, {}}, {solid, flat}, memory), touching);
    flat.t = Vec3(0, 0, 1 + 0x1p-52);
    EXPECT_EQ(relation({shape, flat}, {solid, {}}, memory), apart);
    EXPECT_EQ(relation({shape, {}}, {solid, flat}, memory), apart);
    flat.R.setZero();
    flat.t.setZero();
    EXPECT_EQ(relation({shape, flat}, {solid, {}}, memory), inside);
}

// A few triangles on a small lattice, where most contacts are of every kind at once.
TEST(Relation, SmallSurfacesAsTheOracle) {
    Soup two = soup_of_box({0, 0, 0}, {2, 2, 2});
    two.add_box({2, 2, 1}, {4, 4, 2});
    Soup hollow = soup_of_box({0, 0, 0}, {4, 4, 3});
    hollow.add_box({1, 1, 1}, {3, 2, 2});
    Soup beam = octahedron({2, 2, 1}, 2);
    const std::array<MeshPtr, 3> meshes{two.mesh(), hollow.mesh(), beam.mesh()};
    scenes::Random random(4);
    QueryMemory memory;
    std::map<Relation, int> counts;
    for (int i = 0; i < 600; ++i) {
        const auto coordinate = [&] { return static_cast<double>(random.below(6)) - 1; };
        Soup soup;
        for (std::uint64_t k = 0, count = 1 + random.below(2); k < count; ++k) {
            std::array<Vec3, 3> corners;
            for (Vec3& corner : corners) corner = Vec3(coordinate(), coordinate(), coordinate());
            if (random.below(3) == 0) corners[2] = random.below(2) == 0 ? corners[0] : 0.5 * (corners[0] + corners[1]);
            soup.add(corners[0], corners[1], corners[2]);
        }
        const MeshPtr mesh = soup.mesh();
        const MeshShape shape(mesh);
        const auto which = static_cast<std::size_t>(random.below(3));
        const Solid solid(meshes[which]);
        const Pose at, other{Mat3(-Mat3::Identity()), Vec3(4, 4, 2)};
        for (const Pose& pose : {at, other}) {
            const auto expected =
                oracle::surface_relation({mesh->vertices(), mesh->triangles(), at},
                                         {meshes[which]->vertices(), meshes[which]->triangles(), pose});
            ASSERT_EQ(relation({shape, at}, {solid, pose}, memory), expected) << i;
            ++counts[expected];
        }
    }
    EXPECT_EQ(counts.size(), 4U);
    for (const auto& [relation, count] : counts) EXPECT_GT(count, 15) << relation;
}

}  // namespace
}  // namespace ecods::surface_relation_test
