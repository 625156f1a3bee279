#include "broad_phase/changes/proxy_table.hpp"

#include <gtest/gtest.h>

#include "ecods/error.hpp"
#include "unit/broad_phase/lockstep.hpp"

namespace ecods::test::proxy_table_test {
namespace {

using Proxies = std::vector<ProxyIndex>;

Proxies list_of(std::span<const ProxyIndex> proxies) {
    return {proxies.begin(), proxies.end()};
}

const Aabb a = make_cube(0, 0, 0), b = make_cube(1, 0, 0);

TEST(ProxyTable, TellsWhatChangedSinceItSettled) {
    ProxyTable table;
    for (const ProxyIndex proxy : {3u, 1u, 7u}) table.add(proxy, a);
    EXPECT_EQ(table.collect().added, (Proxies{3, 1, 7}));
    table.settle();
    EXPECT_TRUE(table.collect().empty());

    table.move(7, b);
    table.move(7, a);
    table.move(1, b);
    table.remove(3);
    table.add(2, b);
    const ProxyChanges& changes = table.collect();
    EXPECT_EQ(list_of(changes.moved), (Proxies{7, 1})) << "each once, in the order of the calls";
    EXPECT_EQ(changes.removed, (Proxies{3}));
    EXPECT_EQ(changes.added, (Proxies{2}));
    EXPECT_TRUE(table.is_removed(3));
    EXPECT_EQ(table.size(), 3u);
    EXPECT_EQ(table.end(), 8u);
    table.settle();
    EXPECT_FALSE(table.is_removed(3));
}

TEST(ProxyTable, WhatIsRemovedAndAddedAgainIsBoth) {
    ProxyTable table;
    table.add(0, a);
    table.collect();
    table.settle();
    table.move(0, b);
    table.remove(0);
    table.add(0, a);
    table.move(0, b);
    const ProxyChanges& changes = table.collect();
    EXPECT_EQ(changes.removed, (Proxies{0}));
    EXPECT_EQ(changes.added, (Proxies{0}));
    EXPECT_TRUE(changes.moved.empty());
    EXPECT_EQ(table.box(0), b);
}

TEST(ProxyTable, WhatCameAndWentIsNothing) {
    ProxyTable table;
    table.add(4, a);
    table.remove(4);
    EXPECT_TRUE(table.collect().empty());
    table.settle();
    table.add(4, a);
    EXPECT_EQ(table.collect().added, (Proxies{4}));
}

TEST(ProxyTable, OnlyAnotherBoxIsAMoveAndBitsTell) {
    ProxyTable table;
    table.add(0, make_box(0, 1, 0, 1, 0, 1));
    table.collect();
    table.settle();
    table.move(0, make_box(0, 1, 0, 1, 0, 1));
    EXPECT_TRUE(table.collect().empty());
    for (int k = 0; k < 6; ++k) {
        Aabb box = table.box(0);
        double& end = k < 3 ? box.min[k] : box.max[k - 3];
        end = k < 3 ? -0.0 : std::nextafter(end, 2);
        table.move(0, box);
        EXPECT_EQ(list_of(table.collect().moved), (Proxies{0})) << k;
        EXPECT_EQ(std::signbit(table.box(0).min[0]), true);
        table.settle();
    }
}

TEST(ProxyTable, ABoxOfTheTableItselfCanBeAdded) {
    ProxyTable table;
    table.add(0, b);
    for (ProxyIndex proxy = 1; proxy < 40; ++proxy) {
        table.add(proxy, table.box(proxy / 2));
        EXPECT_EQ(table.box(proxy), b) << proxy;
    }
}

TEST(ProxyTable, WrongNumbersAreErrorsAndChangeNothing) {
    ProxyTable table;
    table.add(5, a);
    EXPECT_THROW(table.add(5, b), Error);
    EXPECT_THROW(table.add(ProxyTable::limit, b), Error);
    for (const ProxyIndex proxy : {4u, 6u, ~0u}) {
        EXPECT_THROW(table.move(proxy, b), Error);
        EXPECT_THROW(table.remove(proxy), Error);
        EXPECT_THROW(table.box(proxy), Error);
    }
    EXPECT_EQ(table.box(5), a);
    EXPECT_EQ(table.size(), 1u);
    EXPECT_EQ(table.collect().added, (Proxies{5}));
}

}  // namespace
}  // namespace ecods::test::proxy_table_test
