// Pairs for a sieve, of which the model knows the real numbers. Only the keys of their bounds tell these apart.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "environment/float_mode.hpp"
#include "query/search/sieve.hpp"

namespace ecods::sieve_model {

// The real number 2 k is the double of key k, and 2 k + 1 lies between that and the next one. These doubles are
// subnormal: where denormals are zero, a comparison of doubles takes all of them for equal.
using Real = int;
inline constexpr int infinite = 1000;  // the key of infinity, in the model

inline double double_at(int key) {
    return key >= infinite ? std::numeric_limits<double>::infinity() : double_of(key);
}
inline int key_at(double x) {
    return static_cast<int>(std::min<std::int64_t>(key_of(x), infinite));
}
inline int key_below(Real r) {
    return r / 2;
}
inline int key_above(Real r) {
    return (r + 1) / 2;
}

struct Interval {
    double lower = 0;
    double upper = std::numeric_limits<double>::infinity();
    bool is_certain = false;
    int a = 0, b = 0;
};
struct Value {
    double number;
    int rank;
};
using TestSieve = Sieve<Interval, Value>;
using Open = TestSieve::Open;

enum class Known { tight, wide, from_below, rounded };
inline constexpr std::array all_known{Known::tight, Known::wide, Known::from_below, Known::rounded};

struct Item {
    Real real;
    Known known;
    int rank = 0;
    TrianglePair triangles = {};

    int lower() const { return known == Known::rounded ? key_above(real) : key_below(real) - (known == Known::wide); }
    int upper() const { return known == Known::from_below ? infinite : key_above(real) + (known == Known::wide); }
    Value value() const { return {double_at(key_above(real)), rank}; }
    Open open() const {
        Open open{{double_at(lower()), double_at(upper())}, triangles};
        if (known == Known::rounded) open.value = value();
        return open;
    }
};
using Items = std::vector<Item>;

inline constexpr Real real_min = 2, real_end = 7;
inline constexpr int key_end = 4;  // of the doubles around them

// Calls use(items) with all sequences of `count` items, in the usual environment and in one that takes every subnormal
// for zero and rounds up. Items have triangles in descending order, and ranks in no order.
template <class Use>
void with_all(std::size_t count, const Use& use) {
    std::vector<Item> kinds;
    for (Real real = real_min; real < real_end; ++real) {
        for (const Known known : all_known) kinds.push_back({real, known});
    }
    for (const environment::FloatMode& mode : {environment::float_modes[0], environment::float_modes[5]}) {
        const environment::InFloatMode in_mode(mode);
        Items items(count);
        std::size_t total = 1;
        for (std::size_t i = 0; i < count; ++i) total *= kinds.size();
        for (std::size_t number = 0; number < total && !testing::Test::HasFailure(); ++number) {
            std::size_t rest = number;
            for (std::size_t i = 0; i < count; ++i, rest /= kinds.size()) {
                items[i] = kinds[rest % kinds.size()];
                items[i].rank = static_cast<int>(i * i % 3);
                items[i].triangles = {static_cast<std::uint32_t>(count - i), 0};
            }
            use(items);
        }
    }
}
inline std::string text_of(const Items& items) {
    std::string text;
    for (const Item& item : items) {
        text += " " + std::to_string(item.real) + " in [" + std::to_string(item.lower()) + ", " +
                std::to_string(item.upper()) + "]";
    }
    return text;
}

// Offers items one after the other, as a search does.
inline void offer(TestSieve& sieve, const Items& items) {
    for (const Item& item : items) {
        const Open open = item.open();
        if (!sieve.counts(open.interval.lower)) continue;
        sieve.take_upper(open.interval.upper, open.triangles);
        sieve.add(open);
    }
    sieve.drop();
}
inline TestSieve sieved(const Items& items, const SearchGoal& goal = {}) {
    TestSieve sieve;
    sieve.start(goal);
    offer(sieve, items);
    return sieve;
}
inline std::vector<TrianglePair> triangles_of(const std::vector<Open>& open) {
    std::vector<TrianglePair> result;
    for (const Open& each : open) result.push_back(each.triangles);
    return result;
}
inline const Item& item_of(const Items& items, const TrianglePair& triangles) {
    return *std::ranges::find(items, triangles, &Item::triangles);
}

}  // namespace ecods::sieve_model
