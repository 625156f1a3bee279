// Signs of integers say what each pair of features is to the closest points, whatever is guessed, in kernels of every
// width.

#include "exact/measure/distance/exact_features.hpp"

#include <gtest/gtest.h>

#include "exact/measure/distance/measure_pair.hpp"
#include "exact/point/integer_points.hpp"
#include "measured_pairs.hpp"
#include "oracle_pair.hpp"

namespace ecods::exact::exact_features_test {
namespace {

// Calls use(points, features) with a pair's points in the narrowest kernel.
template <class Use>
void with_features(const PosedPair& pair, Use&& use) {
    const PosedPoints<6> points{PointRef{&pair.pose_a, &pair.a[0]}, PointRef{&pair.pose_a, &pair.a[1]},
                                PointRef{&pair.pose_a, &pair.a[2]}, PointRef{&pair.pose_b, &pair.b[0]},
                                PointRef{&pair.pose_b, &pair.b[1]}, PointRef{&pair.pose_b, &pair.b[2]}};
    with_integers(points, [&]<class Kernel>(const IntegerPoints<Kernel, 6>& integers) {
        const auto limbs = to_limbs(integers);
        use(integers, ExactFeatures<Kernel::limb_count>(limbs));
    });
}

FeaturePair features_of(const oracle::ExactClosest& closest) {
    const bool is_turned = closest.a.dimension > closest.b.dimension;
    return {static_cast<FeatureKind>(closest.kind), static_cast<std::uint8_t>(is_turned),
            static_cast<std::uint8_t>(closest.a.corner), static_cast<std::uint8_t>(closest.b.corner)};
}

TEST(ExactFeatures, AreClosestOrNotWhateverIsGuessed) {
    std::array<int, 4> counts{};
    std::array<int, 3> widths{};
    for_each_pair(100, [&](const std::string& name, const PosedPair& pair) {
        const OraclePair truth(pair);
        const oracle::ExactClosest closest = truth->closest(0, 0);
        const bool is_apart = closest.kind != oracle::Closeness::intersecting;
        with_features(
            pair, [&]<class Kernel, int L>(const IntegerPoints<Kernel, 6>& points, const ExactFeatures<L>& features) {
                ++widths[L == 1 ? 0 : L == 2 ? 1 : 2];
                const double d = oracle::nearest(closest.distance);
                SquaredDistance square;
                square.exponent = points.unit;
                FeaturePair first{};
                bool is_found = false;
                for (const FeaturePair& f : feature_pairs) {
                    const Standing standing = features.standing(f);
                    ++counts[static_cast<std::size_t>(standing)];
                    if (standing == Standing::none) continue;
                    features.measure(f, square);
                    ASSERT_EQ(bits(round_root(square)), bits(d)) << name;
                    ASSERT_TRUE(standing != Standing::only || !is_apart || f == features_of(closest)) << name;
                    if (standing >= Standing::inside && !is_found) {
                        first = f;
                        is_found = true;
                    }
                    // A wrong guess finds the same.
                    const ClosestFeatures found = find_closest(points, features, {f, Standing::none});
                    ASSERT_TRUE(!is_apart || first_closest(features, found) == features_of(closest)) << name;
                }
                ASSERT_TRUE(!is_apart || (is_found && first == features_of(closest))) << name;
            });
    });
    for (const int count : counts) EXPECT_GT(count, 500);
    for (const int count : widths) EXPECT_GT(count, 50);
}

// The order of the rule, and every pair of features once.
TEST(FeaturePairs, AreAllInOrder) {
    const auto rank = [](const FeaturePair& f) { return std::array<int, 4>{int(f.kind), f.a, f.b, f.vertex_side}; };
    std::array<int, 4> counts{};
    for (std::size_t i = 0; i < feature_pairs.size(); ++i) {
        EXPECT_TRUE(i == 0 || rank(feature_pairs[i - 1]) < rank(feature_pairs[i])) << i;
        ++counts[static_cast<std::size_t>(feature_pairs[i].kind)];
    }
    EXPECT_EQ(counts, (std::array<int, 4>{9, 18, 6, 9}));
}

}  // namespace
}  // namespace ecods::exact::exact_features_test
