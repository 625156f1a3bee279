// Lists beside the true ones.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace ecods::bench {

// Wrong answers. ECoDS must have none.
struct Errors {
    std::size_t false_negatives = 0;  // true, and not reported
    std::size_t false_positives = 0;  // reported without being true

    std::size_t count() const { return false_negatives + false_positives; }
    Errors& operator+=(const Errors& other) {
        false_negatives += other.false_negatives;
        false_positives += other.false_positives;
        return *this;
    }
};

template <class Item>
std::vector<Item> ascending(std::vector<Item> items) {
    std::sort(items.begin(), items.end());
    return items;
}

// Both lists are ascending. They are multisets: an item that is reported twice is a false positive once.
template <class Item>
Errors compare(const std::vector<Item>& reported, const std::vector<Item>& expected) {
    const auto count = [](const std::vector<Item>& from, const std::vector<Item>& what) {
        std::vector<Item> difference;
        std::set_difference(from.begin(), from.end(), what.begin(), what.end(), std::back_inserter(difference));
        return difference.size();
    };
    return {count(expected, reported), count(reported, expected)};
}

}  // namespace ecods::bench
