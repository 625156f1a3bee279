// What prove_star proves is so, by the search that it replaces and by the oracle; and what it is for, it proves.
#include "query/solid/star_proof.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <numbers>
#include <vector>

#include "environment/each_environment.hpp"
#include "oracle/solid.hpp"
#include "query/solid/self_contacts.hpp"
#include "query/solid/shells.hpp"
#include "unit/query/solid_soup.hpp"

namespace ecods {
namespace {

// The outsides that the proof found are those of rays.
void expect_shells_of_rays(const ProperMesh& proper, const MeshShape& shape) {
    const MeshEdges edges(proper);
    const Shells found = shells_of_star(proper, prove_star(proper, edges));
    const Shells expected = find_shells(proper, edges, MeshShapeAccess::tree(shape));
    EXPECT_EQ(found.first, expected.first);
    EXPECT_EQ(found.of_triangle, expected.of_triangle);
    EXPECT_EQ(found.faces_in, expected.faces_in);
}

bool is_proven(const MeshPtr& mesh) {
    const ProperMesh proper = find_proper(mesh);
    return !prove_star(proper, MeshEdges(proper)).empty();
}

// Whether it is proven, of a mesh of which it may be.
bool is_rightly_proven(const MeshPtr& mesh, bool asks_oracle) {
    if (!is_proven(mesh)) return false;
    const MeshShape shape(mesh);
    const ProperMesh proper = find_proper(mesh);
    std::vector<EdgeOverlap> overlaps;
    EXPECT_FALSE(least_self_contact(proper, MeshShapeAccess::tree(shape), overlaps).has_value());
    EXPECT_TRUE(overlaps.empty());
    expect_shells_of_rays(proper, shape);
    if (asks_oracle) {
        EXPECT_TRUE(oracle::self_intersections(*mesh).empty());
        EXPECT_FALSE(oracle::open_edge(*mesh).has_value());
    }
    return true;
}

// Over a polygon of so many corners, of which each is joined to the one `step` further: from the middle, its triangles
// are passed `step` times.
Soup bipyramid(int corners, int step) {
    const auto at = [&](int i) {
        const double angle = 2 * std::numbers::pi * i / corners;
        return Vec3(std::cos(angle), std::sin(angle), 0);
    };
    Soup soup;
    for (int i = 0; i < corners; ++i) {
        for (const double height : {-1.0, 1.0}) soup.add(at(i), at((i + step) % corners), Vec3(0, 0, height));
    }
    return soup;
}

Soup prism(int corners) {
    Soup soup;
    for (int i = 0; i < corners; ++i) {
        const auto at = [&](int k, double z) {
            const double angle = 2 * std::numbers::pi * (k % corners) / corners;
            return Vec3(std::cos(angle), std::sin(angle), z);
        };
        soup.add(at(i, 0), at(i + 1, 0), at(i + 1, 5), at(i, 5));
        if (i > 1) {
            soup.add(at(0, 0), at(i - 1, 0), at(i, 0));
            soup.add(at(0, 5), at(i - 1, 5), at(i, 5));
        }
    }
    return soup;
}

TEST(StarProof, ConvexBodiesAreSeen) {
    const std::vector<std::pair<const char*, Soup>> bodies{{"box", soup_of_box({0, 0, 0}, {1, 1, 1})},
                                                           {"box of parts", soup_of_box({-3, 1, 2}, {7, 2, 2.5}, 3)},
                                                           {"thin", soup_of_box({0, 0, 0}, {1000, 1000, 0.001})},
                                                           {"far", soup_of_box({1e6, 0, -1e6}, {1e6 + 1, 1, -999999})},
                                                           {"octahedron", octahedron({1, 2, 3}, 2)},
                                                           {"prism", prism(24)},
                                                           {"bipyramid", bipyramid(7, 1)}};
    for (const auto& [name, soup] : bodies) {
        environment::in_each_environment([&, &body = soup] { return is_proven(body.mesh()); },
                                         [&, label = name](bool answer, const std::string& where) {
                                             EXPECT_TRUE(answer) << label << ", " << where;
                                         });
        EXPECT_TRUE(is_rightly_proven(soup.mesh(), true)) << name;
    }
}

TEST(StarProof, DentsThatTheMiddleSeesAreNoMatter) {
    Soup soup = octahedron({0, 0, 0}, 8);
    for (Vec3& v : soup.vertices) {
        if (v.x() > 0) v.x() = 1;
    }
    EXPECT_TRUE(is_rightly_proven(soup.mesh(), true));
}

TEST(StarProof, WhatIsNoStarIsNotProven) {
    EXPECT_FALSE(is_proven(bipyramid(5, 2).mesh()));  // passed twice, and closed, and each plane is beside the middle
    EXPECT_FALSE(is_proven(bipyramid(7, 3).mesh()));
    Soup two = soup_of_box({0, 0, 0}, {1, 1, 1});
    two.add_box({3, 0, 0}, {4, 1, 1});
    EXPECT_FALSE(is_proven(two.mesh()));
    Soup nested = soup_of_box({0, 0, 0}, {4, 4, 4});
    nested.add_box({1, 1, 1}, {3, 3, 3});
    EXPECT_FALSE(is_proven(nested.mesh()));
    Soup open = soup_of_box({0, 0, 0}, {1, 1, 1});
    open.triangles.pop_back();
    EXPECT_FALSE(is_proven(open.mesh()));
    Soup empty;
    empty.add({0, 0, 0}, {1, 0, 0}, {2, 0, 0});
    EXPECT_FALSE(is_proven(empty.mesh()));
    const Soup immense = octahedron({0, 0, 0}, 1e308);
    EXPECT_FALSE(is_proven(immense.mesh()));
    check_solid(*immense.mesh());
}

// Triangles of six points, by the bits of a set: sums modulo two of the surfaces of tetrahedra with the corner 0, which
// are all closed sets.
class ClosedSets {
  public:
    ClosedSets() {
        for (std::uint32_t i = 0; i < 6; ++i) {
            for (std::uint32_t j = i + 1; j < 6; ++j) {
                for (std::uint32_t k = j + 1; k < 6; ++k) triangles_.push_back({i, j, k});
            }
        }
        for (const Triangle& t : triangles_) {
            if (t[0] == 0) continue;
            std::uint32_t border = 0;
            for (std::size_t i = 0; i < triangles_.size(); ++i) {
                int shared = 0;
                for (const std::uint32_t corner : triangles_[i])
                    shared += corner == 0 || corner == t[0] || corner == t[1] || corner == t[2] ? 1 : 0;
                if (shared == 3) border |= 1u << i;
            }
            tetrahedra_.push_back(border);
        }
    }
    std::uint32_t count() const { return 1u << tetrahedra_.size(); }
    std::vector<Triangle> at(std::uint32_t index) const {
        std::uint32_t set = 0;
        for (std::size_t i = 0; i < tetrahedra_.size(); ++i) set ^= (index >> i & 1) != 0 ? tetrahedra_[i] : 0;
        std::vector<Triangle> result;
        for (; set != 0; set &= set - 1) result.push_back(triangles_[static_cast<std::size_t>(std::countr_zero(set))]);
        return result;
    }

  private:
    std::vector<Triangle> triangles_;
    std::vector<std::uint32_t> tetrahedra_;
};

TEST(StarProof, AllClosedSetsOnSixLatticePoints) {
    const ClosedSets sets;
    ASSERT_EQ(sets.count(), 1024u);
    scenes::Random random(20);
    std::size_t proven = 0;
    for (int round = 0; round < 150; ++round) {
        std::vector<Vec3> points;
        const auto size = static_cast<std::uint32_t>(2 + round % 3);
        while (points.size() < 6) {
            const auto x = random.below(size), y = random.below(size), z = random.below(size);
            const Vec3 point(x, y, z);
            if (std::ranges::find(points, point) == points.end()) points.push_back(point);
        }
        for (std::uint32_t index = 1; index < sets.count(); ++index) {
            SCOPED_TRACE(testing::Message() << round << ", " << index);
            proven += is_rightly_proven(Mesh::create(points, sets.at(index)), proven % 16 == 0) ? 1 : 0;
            if (HasFailure()) return;
        }
    }
    EXPECT_GT(proven, 1000u);
}

// Polyhedra whose vertices were moved along half-lines from about the middle, by little or through it, and by single
// bits.
TEST(StarProof, NeighboursOfDegenerateStars) {
    scenes::Random random(21);
    std::size_t proven = 0;
    constexpr int count = 4000;
    for (int i = 0; i < count; ++i) {
        Soup soup = i % 2 == 0 ? octahedron({0, 0, 0}, 1) : soup_of_box({-1, -1, -1}, {1, 1, 1}, 2);
        const std::vector<Vec3> before = soup.vertices;
        for (int move = 0; move < 2; ++move) {
            const Vec3 from = before[random.below(static_cast<std::uint32_t>(before.size()))];
            constexpr std::array factors{0.0, 0x1p-50, -0x1p-50, 0.1, -0.1, 1.5, -0.01, 0x1p-20};
            const double factor = factors[random.below(factors.size())];
            Vec3 to = from * factor;
            for (int k = 0; k < 3; ++k) {
                const auto bits = random.below(3);
                if (bits != 0) to[k] = std::nextafter(to[k], bits == 1 ? 2.0 : -2.0);
            }
            for (std::size_t v = 0; v < before.size(); ++v) {
                if (before[v] == from) soup.vertices[v] = to;
            }
        }
        SCOPED_TRACE(i);
        proven += is_rightly_proven(soup.mesh(), proven % 16 == 0) ? 1 : 0;
        if (HasFailure()) return;
    }
    EXPECT_GT(proven, count / 20);
    EXPECT_LT(proven, count - count / 20);
}

// Two tents over one tilted triangle whose tops are single bits from its plane, on one side or both: on which side of
// planes the middle is, rounding decides, and about one pair in three crosses.
TEST(StarProof, TentsAsThinAsRoundingAreNotSeen) {
    scenes::Random random(22);
    std::size_t crossing = 0;
    for (int i = 0; i < 4000; ++i) {
        const auto coordinate = [&] { return 1 + random.below(1000) / 1000.0; };
        const auto point = [&] { return Vec3(coordinate(), coordinate(), coordinate()); };
        const std::array rim{point(), point(), point()};
        Soup soup;
        for (int tent = 0; tent < 2; ++tent) {
            const double share = 0.2 + 0.1 * random.below(4);
            Vec3 top = share * rim[0] + 0.3 * rim[1] + (0.7 - share) * rim[2];
            for (double& x : top) x = std::nextafter(x, random.below(2) == 0 ? 0.0 : 3.0);
            for (std::size_t k = 0; k < 3; ++k) soup.add(rim[k], rim[(k + 1) % 3], top);
        }
        SCOPED_TRACE(i);
        is_rightly_proven(soup.mesh(), false);
        crossing += self_intersections(*soup.mesh()).empty() ? 0 : 1;
        if (HasFailure()) return;
    }
    EXPECT_GT(crossing, 400u);
}

}  // namespace
}  // namespace ecods
