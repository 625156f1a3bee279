#include "base/lazy.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace ecods::test {
namespace {

TEST(Lazy, MakesItsValueOnceAndKeepsItsPlace) {
    Lazy<std::string> lazy;
    int count = 0;
    const auto make = [&] {
        ++count;
        return std::string("made");
    };
    const std::string& first = lazy.get(make);
    EXPECT_EQ(first, "made");
    EXPECT_EQ(&lazy.get(make), &first);
    EXPECT_EQ(count, 1);
}

TEST(Lazy, TriesAgainAfterAFailure) {
    Lazy<int> lazy;
    EXPECT_THROW(lazy.get([]() -> int { throw std::runtime_error("not now"); }), std::runtime_error);
    EXPECT_EQ(lazy.get([] { return 7; }), 7);
    EXPECT_EQ(lazy.get([]() -> int { throw std::runtime_error("never asked"); }), 7);
}

TEST(Lazy, ManyThreadsGetOneValue) {
    for (int round = 0; round < 200; ++round) {
        Lazy<std::vector<int>> lazy;
        std::atomic<int> count = 0;
        std::vector<const std::vector<int>*> seen(4);
        std::vector<std::thread> threads;
        for (const auto*& place : seen) {
            threads.emplace_back([&] {
                place = &lazy.get([&] {
                    ++count;
                    return std::vector<int>(100, round);
                });
                EXPECT_EQ(place->back(), round);
            });
        }
        for (std::thread& thread : threads) thread.join();
        EXPECT_EQ(count, 1);
        for (const auto* place : seen) EXPECT_EQ(place, seen.front());
    }
}

}  // namespace
}  // namespace ecods::test
