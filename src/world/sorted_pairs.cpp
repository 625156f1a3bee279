#include "world/sorted_pairs.hpp"

#include <algorithm>

namespace ecods {

// Moves the pairs of `list` between two removed pairs as one block, so that a few removals from a long list cost
// little.
void remove_sorted(BodyPairs& list, const BodyPairs& gone) noexcept {
    if (gone.empty()) return;
    auto read = std::lower_bound(list.begin(), list.end(), gone.front());
    auto write = read;
    for (const BodyPair& pair : gone) {
        const auto next = std::lower_bound(read, list.end(), pair);
        write = std::move(read, next, write);
        read = next + 1;
    }
    write = std::move(read, list.end(), write);
    list.erase(write, list.end());
}

// Merges the two lists from the back, so that `list` can be both a source and the destination.
void add_sorted(BodyPairs& list, const BodyPairs& more) {
    auto old_end = static_cast<std::ptrdiff_t>(list.size());
    list.resize(list.size() + more.size());
    auto write = list.end();
    for (auto pair = more.rbegin(); pair != more.rend(); ++pair) {
        const auto first = std::lower_bound(list.begin(), list.begin() + old_end, *pair);
        write = std::move_backward(first, list.begin() + old_end, write);
        old_end = first - list.begin();
        *--write = *pair;
    }
}

void cancel_common(BodyPairs& first, BodyPairs& second) noexcept {
    auto write_first = first.begin();
    auto write_second = second.begin();
    auto b = second.begin();
    for (auto a = first.begin(); a != first.end();) {
        if (b == second.end() || *a < *b) {
            *write_first++ = *a++;
        } else if (*b < *a) {
            *write_second++ = *b++;
        } else {
            ++a;
            ++b;
        }
    }
    write_second = std::move(b, second.end(), write_second);
    first.erase(write_first, first.end());
    second.erase(write_second, second.end());
}

}  // namespace ecods
