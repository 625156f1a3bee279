// Signs of a mesh's own vertices are those of the exact predicates, which tests of their own hold to the oracle.
#include "exact/sign/vertex_signs.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "ecods/primitives.hpp"
#include "environment/each_environment.hpp"
#include "scenes/random.hpp"

namespace ecods::exact::vertex_signs_test {
namespace {

// Points of a small lattice, most of whose fours are in planes across or along axes; of some, bits are moved.
std::vector<Vec3> lattice_points(scenes::Random& random, double step, bool is_moved) {
    std::vector<Vec3> points;
    for (int i = 0; i < 9; ++i) {
        const auto at = [&] { return step * (static_cast<double>(random.below(3)) - 1); };
        Vec3 point(at(), at(), at());
        for (double& x : point) {
            if (is_moved && random.below(8) == 0) x = std::nextafter(x, 2 * x + step);
            if (random.below(2) == 0 && x == 0) x = -x;
        }
        points.push_back(point);
    }
    return points;
}

TEST(VertexSigns, AreThoseOfThePredicates) {
    constexpr double least = std::numeric_limits<double>::denorm_min();
    scenes::Random random(23);
    for (int round = 0; round < 400; ++round) {
        constexpr std::array steps{1.0, 0.1, 1.0 / 3, 0x1p-600, 0x1p600, 1e-310, least};
        const std::vector<Vec3> points = lattice_points(random, steps[random.below(steps.size())], round % 2 == 1);
        std::array<std::uint32_t, 4> v;
        for (std::uint32_t& i : v) i = random.below(static_cast<std::uint32_t>(points.size()));
        const auto expected = static_cast<int>(orient3d(points[v[0]], points[v[1]], points[v[2]], points[v[3]]));
        environment::in_each_environment(
            [&] { return VertexSigns(points).orient3d(v[0], v[1], v[2], v[3]); },
            [&](int sign, const std::string& where) { EXPECT_EQ(sign, expected) << round << ", " << where; });
        for (int axis = 0; axis < 3; ++axis) {
            const auto shadow = [&](std::uint32_t i) {
                return Vec2(points[i][(axis + 1) % 3], points[i][(axis + 2) % 3]);
            };
            const auto turn = static_cast<int>(orient2d(shadow(v[0]), shadow(v[1]), shadow(v[2])));
            EXPECT_EQ(VertexSigns(points).orient2d(v[0], v[1], v[2], axis), turn) << round << ", " << axis;
        }
        if (HasFailure()) return;
    }
}

}  // namespace
}  // namespace ecods::exact::vertex_signs_test
