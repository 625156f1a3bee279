// The families of hard pairs: known answers, and the oracle's.

#include "scenes/hard_pairs.hpp"

#include <gtest/gtest.h>

#include "ecods/primitives.hpp"
#include "oracle/oracle.hpp"

namespace ecods::hard_pairs_test {
namespace {

class HardPairs : public testing::TestWithParam<scenes::Family<scenes::PosedPair>> {};

INSTANTIATE_TEST_SUITE_P(Families, HardPairs,
                         testing::ValuesIn(scenes::hard_families().begin(), scenes::hard_families().end()),
                         [](const auto& tested) {
                             std::string text(tested.param.name);
                             std::erase_if(text, [](char c) { return c == ',' || c == ' '; });
                             return text;
                         });

TEST_P(HardPairs, RelationIsTheOraclesAndSymmetric) {
    scenes::Random random(7);
    std::array<int, 3> counts{};
    for (int i = 0; i < 2000; ++i) {
        const scenes::PosedPair pair = GetParam().make(random);
        const PosedTriangle a{pair.pose_a, pair.a}, b{pair.pose_b, pair.b};
        const Relation relation = triangle_triangle(a, b);
        ASSERT_EQ(triangle_triangle(b, a), relation);
        ASSERT_EQ(oracle::triangle_triangle(pair.pose_a, pair.a, pair.pose_b, pair.b), relation) << i;
        if (pair.intersects) {
            ASSERT_EQ(relation != Relation::apart, *pair.intersects) << i;
        }
        ++counts[static_cast<std::size_t>(relation)];
    }
    RecordProperty("apart", counts[0]);
    RecordProperty("touching", counts[1]);
    RecordProperty("crossing", counts[2]);
}

}  // namespace
}  // namespace ecods::hard_pairs_test
