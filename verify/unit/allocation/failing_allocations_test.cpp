// The instrument itself: which allocations fail, and that a call that breaks its promise is found.
#include "allocation/failing_allocations.hpp"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <new>
#include <thread>
#include <vector>

#include "allocation/each_allocation.hpp"

namespace ecods::allocation::failing_allocations_test {
namespace {

bool fails() {
    try {
        ::operator delete(::operator new(8));  // which no compiler leaves out, as it may new and delete expressions
        return false;
    } catch (const std::bad_alloc&) {
        return true;
    }
}

TEST(FailingAllocation, OneFailsOrAllFromThereOn) {
    bool has_failed = false;
    std::vector<bool> once(5), lasting(5);
    {
        const FailingAllocation failing(2);
        for (auto each : {0, 1, 2, 3, 4}) once[each] = fails();
    }
    {
        const FailingAllocation failing(2, Shortage::lasting);
        for (auto each : {0, 1, 2, 3, 4}) lasting[each] = fails();
        has_failed = failing.has_failed();
    }
    EXPECT_TRUE(has_failed);
    EXPECT_EQ(once, (std::vector<bool>{false, false, true, false, false}));
    EXPECT_EQ(lasting, (std::vector<bool>{false, false, true, true, true}));
    EXPECT_FALSE(fails());
}

template <class Allocate>
bool fails(Allocate allocate) {
    try {
        return allocate() == nullptr;
    } catch (const std::bad_alloc&) {
        return true;
    }
}

TEST(FailingAllocation, EveryFormOfNew) {
    constexpr std::align_val_t line{64};
    std::array<bool, 8> failed{};
    {
        const FailingAllocation failing(0, Shortage::lasting);
        failed = {fails([] { return ::operator new(8); }),
                  fails([] { return ::operator new[](8); }),
                  fails([] { return ::operator new(8, line); }),
                  fails([] { return ::operator new[](8, line); }),
                  fails([] { return ::operator new(8, std::nothrow); }),
                  fails([] { return ::operator new[](8, std::nothrow); }),
                  fails([] { return ::operator new(8, line, std::nothrow); }),
                  fails([] { return ::operator new[](8, line, std::nothrow); })};
    }
    for (const bool each : failed) EXPECT_TRUE(each);
}

TEST(FailingAllocation, EveryThread) {
    std::atomic<bool> goes = false;
    bool has_failed = false;
    std::thread other([&] {
        while (!goes) std::this_thread::yield();
        has_failed = fails();
        goes = false;
    });
    {
        const FailingAllocation failing(0);
        goes = true;
        while (goes) std::this_thread::yield();
    }
    other.join();
    EXPECT_TRUE(has_failed);
}

// A list that promises to be as it was, and is not: its length grows before there is room.
struct Forgetful {
    std::vector<int> list;
    std::size_t length = 0;
    void add() {
        ++length;
        list.push_back(1);
    }
};

TEST(FailEachAllocation, FindsWhatIsNotTakenBack) {
    Trial<Forgetful> trial{
        .make = [] { return Forgetful(); },
        .call = [](Forgetful& list) { list.add(); },
        .difference = [](Forgetful& a, Forgetful& b) { return a.length == b.length ? "" : "the length"; }};
    Failures failures;
    fail_each_allocation(trial, failures);
    EXPECT_EQ(failures.allocations, 2u);
    EXPECT_GE(failures.defects, 2u);
    EXPECT_EQ(failures.first, "allocation 0: after the failure: the length");
}

}  // namespace
}  // namespace ecods::allocation::failing_allocations_test
