#include "base/short_list.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace ecods {
namespace {

using List = ShortList<int, 4>;

List list_of(int count) {
    List list;
    for (int i = 0; i < count; ++i) list.push_back(i);
    return list;
}

void expect_counting(const List& list, int count) {
    ASSERT_EQ(list.size(), static_cast<std::size_t>(count));
    EXPECT_EQ(list.empty(), count == 0);
    int expected = 0;
    for (const int x : list) EXPECT_EQ(x, expected++);
    for (int i = 0; i < count; ++i) EXPECT_EQ(list[static_cast<std::size_t>(i)], i);
}

// Around the number of values that are in the object, and far beyond it.
TEST(ShortList, KeepsItsValues) {
    for (const int count : {0, 1, 3, 4, 5, 8, 9, 100}) {
        List list = list_of(count);
        expect_counting(list, count);
        const List copy = list;
        expect_counting(copy, count);
        List moved = std::move(list);
        expect_counting(moved, count);
        for (const int other : {0, 4, 9}) {
            List assigned = list_of(other);
            assigned = copy;
            expect_counting(assigned, count);
            assigned = list_of(other);
            expect_counting(assigned, other);
        }
        moved.clear();
        EXPECT_TRUE(moved.empty());
        moved.push_back(0);
        expect_counting(moved, 1);
    }
}

TEST(ShortList, TakesItsOwnValues) {
    List list = list_of(4);
    list.push_back(list[3]);
    EXPECT_EQ(list[4], 3);
    list.assign(9, list[2]);
    ASSERT_EQ(list.size(), 9U);
    for (const int x : list) EXPECT_EQ(x, 2);
    const List& same = list;
    list = same;
    EXPECT_EQ(list.size(), 9U);
}

}  // namespace
}  // namespace ecods
