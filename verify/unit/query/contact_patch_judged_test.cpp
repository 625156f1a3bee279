// Contact patches beside the oracle: of lattice hulls, prisms and boxes, at poses that turn, shear, scale and mirror.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "ecods/contact.hpp"
#include "ecods/rounded.hpp"
#include "environment/each_environment.hpp"
#include "judge/distance_truth.hpp"
#include "judge/text.hpp"
#include "oracle/convex.hpp"
#include "oracle/convex_patch.hpp"
#include "scenes/lattice_hull.hpp"
#include "scenes/pose_at.hpp"
#include "scenes/random.hpp"
#include "unit/query/solid_soup.hpp"

namespace ecods {
namespace {

using scenes::Random;

Feature to_feature(const oracle::NamedFeature& f) {
    return {static_cast<Feature::Kind>(f.dimension), f.triangle, f.corner};
}

struct Pair {
    std::array<std::shared_ptr<const ConvexSolid>, 2> solids;
    std::array<Pose, 2> poses;

    Pair turned() const { return {{solids[1], solids[0]}, {poses[1], poses[0]}}; }
};

// Expected says what a patch must be, for bodies with radii and some limits.
class Expected {
  public:
    explicit Expected(const Pair& pair) : pair_(pair) {
        const oracle::ConvexPair exact(pair.solids[0]->mesh(), pair.poses[0], pair.solids[1]->mesh(), pair.poses[1]);
        normal_ = exact.share_a_point() ? exact.depth()->normal : *exact.direction();
    }

    ContactPatch patch(const PatchLimits& limits, const std::array<double, 2>& radii) const {
        const std::array<const Mesh*, 2> meshes{&pair_.solids[0]->mesh(), &pair_.solids[1]->mesh()};
        const oracle::ConvexPatch exact(meshes, pair_.poses, normal_.v, limits.min_cos_squared);
        ContactPatch patch;
        patch.distance = exact.gap(exact.corners()[0], radii);
        patch.normal = normal_.nearest();
        std::vector<oracle::ConvexPatch::Corner> corners;
        for (const auto& corner : exact.corners()) {
            if (std::isinf(limits.max_gap) || exact.sign_of_gap(corner, radii, limits.max_gap) <= 0)
                corners.push_back(corner);
        }
        patch.corner_count = static_cast<std::uint32_t>(corners.size());
        std::vector<std::size_t> kept(corners.size());
        for (std::size_t i = 0; i < kept.size(); ++i) kept[i] = i;
        if (limits.max_corners > 0 && corners.size() > limits.max_corners)
            kept = exact.chosen(corners, limits.max_corners);
        for (const std::size_t i : kept) {
            const auto& c = corners[i];
            patch.corners.push_back({exact.point(c, 0, radii), exact.point(c, 1, radii), exact.middle(c, radii),
                                     exact.gap(c, radii), to_feature(c.a), to_feature(c.b)});
        }
        return patch;
    }

  private:
    const Pair& pair_;
    oracle::ExactDirection normal_;
};

std::string in_words(const ContactPatch& patch) {
    std::string all = judge::text(patch.distance) + " along " + judge::text(patch.normal);
    for (const PatchCorner& c : patch.corners) {
        all += "\n" + judge::text(c.a) + ", " + judge::text(c.b) + ": " + judge::text(c.point_a) + " " +
               judge::text(c.point_b) + " " + judge::text(c.middle) + " " + judge::text(c.gap);
    }
    return all;
}

bool are_same(const ContactPatch& x, const ContactPatch& y) {
    return x == y && in_words(x) == in_words(y);  // a zero is +0 in both
}

ContactPatch ask(const Pair& pair, const PatchLimits& limits, const std::array<double, 2>& radii) {
    std::array<std::shared_ptr<const Shape>, 2> shapes;
    for (const std::size_t i : {0U, 1U}) {
        shapes[i] = pair.solids[i];
        if (radii[i] > 0) shapes[i] = rounded(pair.solids[i], radii[i]);
    }
    return contact_patch({shapes[0], pair.poses[0]}, {shapes[1], pair.poses[1]}, limits);
}

void expect_right(const Pair& pair, const PatchLimits& limits = {}, const std::array<double, 2>& radii = {}) {
    const ContactPatch expected = Expected(pair).patch(limits, radii), found = ask(pair, limits, radii);
    ASSERT_TRUE(are_same(expected, found)) << "expected " << in_words(expected) << "\nfound " << in_words(found);
}

Mat3 shear(Random& random, int size) {
    Mat3 R;
    do {
        for (double& x : R.reshaped()) x = static_cast<double>(random.below(2 * size + 1)) - size;
    } while (R.determinant() == 0);
    return R;
}

std::shared_ptr<const ConvexSolid> hull(Random& random) {
    const auto mesh = [&] {
        switch (random.below(4)) {
            case 0:
                return scenes::box({-1, -2, -1}, {2, 1, 2});
            case 1:
                return scenes::prism(static_cast<int>(3 + random.below(5)), 4, 3);
            case 2:
                return scenes::refined(scenes::random_lattice_hull(1, 6, random));
            default:
                return scenes::random_lattice_hull(2, static_cast<int>(5 + random.below(6)), random);
        }
    };
    return std::make_shared<const ConvexSolid>(scenes::to_mesh(mesh(), 1));
}

// Two hulls, near each other: mostly with faces across a common axis, so that patches have many corners.
Pair random_pair(Random& random) {
    Pair pair{{hull(random), hull(random)}, {}};
    for (Pose& pose : pair.poses) {
        const std::uint32_t kind = random.below(8);
        if (kind == 0) pose = random.turned();
        if (kind == 1) pose.R = shear(random, 1);
        if (kind == 2) pose.R = Vec3(-1, 1, 1).asDiagonal();
        if (kind == 3) pose.R = Vec3(1, 1, 0.25).asDiagonal();
        if (kind == 4) pose.R << 3, -4, 0, 4, 3, 0, 0, 0, 5;
        if (kind == 5) pose.R(2, 0) = std::ldexp(1.0, -static_cast<int>(random.below(30)));
    }
    for (double& x : pair.poses[1].t) x = (static_cast<double>(random.below(29)) - 14) / 2;
    return pair;
}

PatchLimits random_limits(Random& random) {
    PatchLimits limits;
    if (random.below(2) == 0) limits.max_corners = 1 + random.below(5);
    if (random.below(2) == 0) limits.min_cos_squared = std::array{0.9999, 0.5, 0.25, 0x1p-20}[random.below(4)];
    if (random.below(3) == 0) limits.max_gap = (static_cast<double>(random.below(9)) - 4) / 4;
    return limits;
}

TEST(ContactPatchJudged, AsTheOracle) {
    Random random(41);
    std::map<std::size_t, int> counts;
    for (int i = 0; i < 300; ++i) {
        SCOPED_TRACE(i);
        const Pair pair = random_pair(random);
        expect_right(pair);
        expect_right(pair.turned());
        ++counts[ask(pair, {}, {}).corners.size()];
        if (HasFatalFailure()) return;
    }
    for (std::size_t count = 1; count <= 4; ++count) EXPECT_GE(counts[count], 4) << count;
}

TEST(ContactPatchJudged, WithLimitsAndRadii) {
    Random random(42);
    std::map<std::size_t, int> counts;
    for (int i = 0; i < 300; ++i) {
        SCOPED_TRACE(i);
        const Pair pair = random_pair(random);
        const PatchLimits limits = random_limits(random);
        std::array<double, 2> radii{};
        if (random.below(2) == 0) radii = {0.25 * random.below(3), random.below(2) == 0 ? 0x1p-60 : 0.75};
        expect_right(pair, limits, radii);
        expect_right(pair.turned(), limits, radii);
        ++counts[ask(pair, limits, radii).corners.size()];
        if (HasFatalFailure()) return;
    }
    for (std::size_t count = 0; count <= 5; ++count) EXPECT_GE(counts[count], 3) << count;
}

// All boxes at the places of a lattice, to both sides: vertices on vertices, on edges and in faces, edges along and
// across edges; and places next to these, where doubles are as near to that as they can be.
TEST(ContactPatchJudged, OfAllBoxesOnALattice) {
    const auto solid = [](const Vec3& half) { return std::make_shared<const ConvexSolid>(box(-half, half)); };
    const auto table = solid({2, 2, 1}), brick = solid({1, 2, 1});
    Random random(45);
    for (int x = 0; x <= 3; ++x) {
        for (int y = 0; y <= 4; ++y) {
            for (int z = 0; z <= 3; ++z) {
                SCOPED_TRACE(16 * x + 4 * y + z);
                Pair pair{{table, brick}, {}};
                pair.poses[1].t = Vec3(x, y, z);
                expect_right(pair);
                expect_right(pair.turned());
                pair.poses[1].t[static_cast<int>(random.below(3))] += random.below(2) == 0 ? 0x1p-52 : -0x1p-52;
                expect_right(pair);
                pair.poses[0].t =
                    Vec3(0.1, -0.7, 1e3);  // sums of translations and points are often between two doubles
                pair.poses[1].t = Vec3(0.1 + x, -0.7 + y, 1e3 + z);
                expect_right(pair, {}, {0, random.below(2) == 0 ? 0 : 0.3});
                if (HasFatalFailure()) return;
            }
        }
    }
}

// An octagon, of which many choices have exactly one area: doubles, rounded at a pose that both bodies have, do not
// decide among them.
TEST(ContactPatchJudged, OfCornersWithEqualAreas) {
    const auto square = std::make_shared<const ConvexSolid>(box({-0.75, -0.75, -0.5}, {0.75, 0.75, 0.5}));
    std::vector<Vec3> points;
    for (const double z : {0.375, 1.375}) points.insert(points.end(), {{1, 0, z}, {0, 1, z}, {-1, 0, z}, {0, -1, z}});
    const auto diamond = std::make_shared<const ConvexSolid>(points);
    Random random(46);
    for (int i = 0; i < 4; ++i) {
        SCOPED_TRACE(i);
        const Pose pose = random.turned();
        const Pair pair{{square, diamond}, {pose, pose}};
        for (const std::uint32_t count : {2U, 3U, 4U, 5U, 7U}) {
            expect_right(pair, {.max_corners = count});
            expect_right(pair.turned(), {.max_corners = count});
        }
        if (HasFatalFailure()) return;
    }
}

// Far from one, where exact numbers are long, and subnormal.
TEST(ContactPatchJudged, OfAllSizes) {
    Random random(43);
    for (const int exponent : {-1074, -1000, -300, 300, 900}) {
        for (int i = 0; i < 8; ++i) {
            SCOPED_TRACE(exponent);
            Pair pair = random_pair(random);
            for (Pose& pose : pair.poses) {
                for (double& x : pose.R.reshaped()) x = std::ldexp(x, exponent);
                for (double& x : pose.t) x = std::ldexp(x, exponent);
            }
            if (exponent < -900 && (pair.poses[0].R.determinant() == 0 || pair.poses[1].R.determinant() == 0)) continue;
            expect_right(pair, random_limits(random));
            if (HasFatalFailure()) return;
        }
    }
}

TEST(ContactPatchJudged, InEachEnvironment) {
    Random random(44);
    for (int i = 0; i < 12; ++i) {
        const Pair pair = random_pair(random);
        const PatchLimits limits = random_limits(random);
        const std::array<double, 2> radii{0.25 * random.below(2), 0.5 * random.below(2)};
        const ContactPatch expected = Expected(pair).patch(limits, radii);
        environment::in_each_environment([&] { return ask(pair, limits, radii); },
                                         [&](const ContactPatch& found, const std::string& where) {
                                             EXPECT_TRUE(are_same(expected, found)) << where;
                                         });
    }
}

}  // namespace
}  // namespace ecods
