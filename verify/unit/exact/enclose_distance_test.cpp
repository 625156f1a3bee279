// Enclosures contain the distance, in every floating-point environment, whatever features are guessed; they are narrow
// where the guess is right.

#include "exact/measure/enclose_distance.hpp"

#include <gtest/gtest.h>

#include <map>

#include "measured_pairs.hpp"
#include "query/distance/triangle_distances.hpp"
#include "rational_distance.hpp"

namespace ecods::exact {
namespace {

// One square against another; the upper end may be infinity.
bool contains(double lower, double upper, const mpq_class& square) {
    const mpq_class low(lower);
    if (lower < 0 || low * low > square) return false;
    if (upper == std::numeric_limits<double>::infinity()) return true;
    const mpq_class high(upper);
    return high * high >= square;
}

TEST(EncloseDistance, ContainsTheDistance) {
    TriangleDistances bodies;
    std::map<std::string, std::array<int, 4>> counts;
    for_each_pair(300, [&](const std::string& name, const PosedPair& pair) {
        const RationalDistance truth = RationalTriangles(pair).distance();
        const OnePair meshes(pair);
        for (const int environment : environments) {
            const DistanceInterval i = in_environment(environment, [&] {
                bodies.bind(meshes.a(), meshes.b());
                return bodies.enclose(0, 0);
            });
            ASSERT_TRUE(contains(i.lower, i.upper, truth.square)) << name << " " << i.lower << " " << i.upper;
            auto& count = counts[name];
            if (truth.square == 0) {
                ASSERT_FALSE(i.is_certain) << name;
                continue;
            }
            ++count[0];
            count[1] += i.lower > 0;
            count[2] += i.lower > 0.999 * i.upper;
            count[3] += i.is_certain;
            ASSERT_TRUE(!i.is_certain || truth.closest.size() == 1) << name;
        }
    });
    for (const auto& [name, c] : counts) {
        std::printf("%-26s apart %5d  positive %5d  narrow %5d  certain %5d\n", name.c_str(), c[0], c[1], c[2], c[3]);
    }
}

}  // namespace
}  // namespace ecods::exact
