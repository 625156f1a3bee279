#include "world/sorted_pairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <set>

#include "scenes/random.hpp"

namespace ecods::sorted_pairs_test {
namespace {

BodyPairs random_pairs(std::uint32_t count, scenes::Random& random) {
    std::set<BodyPair> pairs;
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t a = 1 + random.below(6);
        pairs.insert(
            BodyPair{BodyId{a, static_cast<std::uint16_t>(random.below(2))}, BodyId{a + 1 + random.below(6), 0}});
    }
    return {pairs.begin(), pairs.end()};
}

TEST(SortedPairs, AreSetsChangedInPlace) {
    scenes::Random random(3);
    for (int i = 0; i < 2000; ++i) {
        const BodyPairs first = random_pairs(random.below(20), random);
        const BodyPairs second = random_pairs(random.below(8), random);
        BodyPairs only_first, only_second, both, all;
        std::ranges::set_difference(first, second, std::back_inserter(only_first));
        std::ranges::set_difference(second, first, std::back_inserter(only_second));
        std::ranges::set_intersection(first, second, std::back_inserter(both));
        std::ranges::set_union(first, second, std::back_inserter(all));

        BodyPairs list = first;
        remove_sorted(list, both);
        EXPECT_EQ(list, only_first);
        list = first;
        add_sorted(list, only_second);
        EXPECT_EQ(list, all);
        BodyPairs a = first, b = second;
        cancel_common(a, b);
        EXPECT_EQ(a, only_first);
        EXPECT_EQ(b, only_second);
    }
}

}  // namespace
}  // namespace ecods::sorted_pairs_test
