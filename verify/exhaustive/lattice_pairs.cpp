// Every pair of triangles of the lattice {0, 1, 2}^3, proper and degenerate, against the oracle.
//
// The oracle is asked for one triangle of each orbit of the cube's 48 symmetries against all triangles; the library for
// every pair, whose answer must be that of its image.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "ecods/primitives.hpp"
#include "exhaustive/lattice.hpp"
#include "oracle/oracle.hpp"

namespace ecods {
namespace {

using lattice::Corners;
using lattice::positions;

// For each triangle, the smallest of its images and a symmetry that leads there.
struct Canonical {
    Corners corners;
    lattice::Symmetry symmetry;
};

Canonical canonical(const std::vector<lattice::Symmetry>& symmetries, const Corners& corners) {
    Canonical best{corners, symmetries.front()};
    for (const auto& symmetry : symmetries) {
        const Corners image = lattice::apply(symmetry, corners);
        if (image <= best.corners) best = {image, symmetry};
    }
    return best;
}

TEST(LatticePairs, AllOfThemAgreeWithTheOracle) {
    const auto triangles = lattice::all_triangles();
    ASSERT_EQ(triangles.size(), 3654u);
    const auto symmetries = lattice::all_symmetries();
    ASSERT_EQ(symmetries.size(), 48u);

    const Pose identity;
    std::map<Corners, std::size_t> index;
    for (std::size_t i = 0; i < triangles.size(); ++i) index[triangles[i]] = i;
    std::map<Corners, std::vector<Relation>> expected;  // of each representative with every triangle
    std::array<std::uint64_t, 3> counts{};
    std::uint64_t wrong_count = 0;
    for (const Corners& a : triangles) {
        const Canonical c = canonical(symmetries, a);
        auto& answers = expected[c.corners];
        if (answers.empty()) {
            for (const Corners& b : triangles) {
                answers.push_back(oracle::triangle_triangle(identity, positions(c.corners), identity, positions(b)));
            }
        }
        for (const Corners& b : triangles) {
            const Relation relation = triangle_triangle(positions(a), positions(b));
            ++counts[static_cast<std::size_t>(relation)];
            wrong_count += relation != answers[index.at(lattice::apply(c.symmetry, b))];
        }
    }
    EXPECT_EQ(wrong_count, 0u);
    RecordProperty("orbits", static_cast<int>(expected.size()));
    // That the three relations all occur in number is part of what the test means.
    for (const std::uint64_t count : counts) EXPECT_GT(count, 100000u);
    std::printf("%zu orbits; apart %llu, touching %llu, crossing %llu\n", expected.size(),
                static_cast<unsigned long long>(counts[0]), static_cast<unsigned long long>(counts[1]),
                static_cast<unsigned long long>(counts[2]));
}

// Every order of corners and arguments, on each representative triangle against every 7th triangle.
TEST(LatticePairs, OrderOfCornersAndArgumentsDoesNotMatter) {
    const auto triangles = lattice::all_triangles();
    const auto symmetries = lattice::all_symmetries();
    std::uint64_t asked = 0;
    for (const Corners& a : triangles) {
        if (canonical(symmetries, a).corners != a) continue;
        for (std::size_t i = 0; i < triangles.size(); i += 7) {
            const Relation relation = triangle_triangle(positions(a), positions(triangles[i]));
            Corners order_a{0, 1, 2};
            do {
                Corners order_b{0, 1, 2};
                do {
                    const auto pick = [](const Corners& t, const Corners& order) {
                        const auto at = [&](std::size_t k) { return t[static_cast<std::size_t>(order[k])]; };
                        return positions({at(0), at(1), at(2)});
                    };
                    const auto x = pick(a, order_a), y = pick(triangles[i], order_b);
                    ASSERT_EQ(triangle_triangle(x, y), relation);
                    ASSERT_EQ(triangle_triangle(y, x), relation);
                    asked += 2;
                } while (std::ranges::next_permutation(order_b).found);
            } while (std::ranges::next_permutation(order_a).found);
        }
    }
    EXPECT_GT(asked, 1000000u);
}

}  // namespace
}  // namespace ecods
