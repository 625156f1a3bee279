// Enclosures contain the distance, in every floating-point environment, whatever features are guessed; they are narrow
// where the guess is right.

#include "exact/measure/distance/enclose_distance.hpp"

#include <gtest/gtest.h>

#include <map>

#include "ecods/primitives.hpp"
#include "exact/measure/distance/guess_features.hpp"
#include "measured_pairs.hpp"
#include "oracle_pair.hpp"
#include "query/distance/triangle_distances.hpp"

namespace ecods::exact::enclose_distance_test {
namespace {

bool contains(const Enclosure& enclosure, const oracle::ExactRoot& root) {
    return enclosure.lower >= 0 && oracle::compare(root, enclosure.lower) >= 0 &&
           oracle::compare(root, enclosure.upper) <= 0;
}

// What the oracle calls the features that it chooses.
bool are_features(const FeaturePair& f, const oracle::ExactClosest& closest) {
    const int greater = f.kind == FeatureKind::vertex_face ? 2 : f.kind == FeatureKind::vertex_vertex ? 0 : 1;
    const int lesser = f.kind == FeatureKind::edge_edge ? 1 : 0;
    const bool is_turned = f.vertex_side == 1;
    return closest.a == oracle::NamedFeature{is_turned ? greater : lesser, 0, f.a} &&
           closest.b == oracle::NamedFeature{is_turned ? lesser : greater, 0, f.b};
}

IntegerPair integers(IntegerFrame& points, const OnePair& meshes) {
    points.bind_pair(meshes.a(), meshes.b());
    return integer_pair(points, {0, 1, 2}, {0, 1, 2});
}

// With the guess, and with every other pair of features in its place.
TEST(EncloseDistance, ContainsTheDistanceWhateverIsGuessed) {
    IntegerFrame points;
    int certain_count = 0;
    for_each_pair(60, [&](const std::string& name, const PosedPair& pair) {
        const OnePair meshes(pair);
        const OraclePair truth(pair);
        const oracle::ExactClosest closest = truth->closest(0, 0);
        for (const int environment : environments) {
            for (const FeaturePair& features : feature_pairs) {
                const Enclosure e =
                    in_environment(environment, [&] { return enclose_distance(integers(points, meshes), features); });
                ASSERT_TRUE(contains(e, closest.distance)) << name << " " << e.lower << " " << e.upper;
                ASSERT_TRUE(!e.is_certain || are_features(features, closest)) << name;
                certain_count += e.is_certain;
            }
        }
    });
    EXPECT_GT(certain_count, 3000);
}

// Of triangles that are apart by at least 2^-27 of their size, far from where coordinates run out of digits.
TEST(EncloseDistance, IsNarrow) {
    Random random(18);
    IntegerFrame points;
    int apart_count = 0, certain_count = 0, narrow_count = 0;
    for (int i = 0; i < 4000; ++i) {
        const int exponent = i % 4 == 0 ? static_cast<int>(random.below(1201)) - 600 : 0;
        const PosedPair pair = scaled_by(at_gap(random, random_pair(random), 0x1p-27), exponent);
        if (triangle_triangle({pair.pose_a, pair.a}, {pair.pose_b, pair.b}) != Relation::apart) continue;
        const OnePair meshes(pair);
        const IntegerPair six = integers(points, meshes);
        const Enclosure e = enclose_distance(six, guess_features(six));
        ++apart_count;
        certain_count += e.is_certain;
        narrow_count += e.lower > 0.9999 * e.upper;
    }
    EXPECT_GT(narrow_count, apart_count * 9 / 10);
    EXPECT_GT(certain_count, apart_count * 7 / 10);
}

}  // namespace
}  // namespace ecods::exact::enclose_distance_test
