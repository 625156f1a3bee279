// NearestQueue is a priority queue of pairs of nodes. Its order is nearest first, up to a small relative error.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "bvh/walks/open_pair.hpp"

namespace ecods {

// Holds a pair of nodes or leaves, and a lower bound of its squared distance, which is finite and not negative.
struct NearPair {
    float square;
    NodePair nodes;
};

// NearestQueue is a bucket queue. Buckets are chosen by the leading bits of the square: there are 32 for each power of
// two, so distances in one bucket differ by about one part in 64. Within a bucket the pair that was pushed last is
// popped first, so that a walk goes deep. push() and pop() take constant time.
class NearestQueue {
  public:
    // Removes all pairs. Buckets cover squares from `limit` down to 2^-32 of it; all smaller squares share the first
    // bucket.
    void start(float limit) noexcept {
        base_ = bucket_bits(limit) - static_cast<std::int32_t>(bucket_count - 1);
        words_.fill(0);
        first_word_ = 0;
        links_.clear();
        free_ = none;
    }

    // Adds a pair to the queue. pair.square must be at most the limit that was passed to start().
    void push(const NearPair& pair) {
        const std::size_t bucket = bucket_of(pair.square);
        const std::size_t word = bucket / 64;
        const std::uint64_t bit = std::uint64_t{1} << bucket % 64;
        const std::uint32_t next = words_[word] & bit ? heads_[bucket] : none;
        std::uint32_t at = free_;
        if (at == none) {
            at = static_cast<std::uint32_t>(links_.size());
            links_.push_back({pair, next});
        } else {
            free_ = links_[at].next;
            links_[at] = {pair, next};
        }
        heads_[bucket] = at;
        words_[word] |= bit;
        first_word_ = std::min(first_word_, word);
    }

    // Sets `pair` to the next pair whose square is at most `limit`, removes it, and returns true. Drops the pairs with
    // larger squares that the queue has before `pair`. Returns false if there is no such pair.
    bool pop(float limit, NearPair& pair) noexcept {
        const std::size_t last = bucket_of(limit);
        for (; first_word_ < words_.size(); ++first_word_) {
            while (words_[first_word_] != 0) {
                const auto lowest = static_cast<std::size_t>(std::countr_zero(words_[first_word_]));
                const std::size_t bucket = 64 * first_word_ + lowest;
                if (bucket > last) return false;
                const std::uint32_t at = heads_[bucket];
                Link& link = links_[at];
                pair = link.pair;
                heads_[bucket] = link.next;
                if (link.next == none) words_[first_word_] &= words_[first_word_] - 1;
                link.next = free_;
                free_ = at;
                if (pair.square <= limit) return true;
            }
        }
        return false;
    }

  private:
    static constexpr std::size_t bucket_count = 1024;
    static constexpr int dropped_bits = 23 - 5;
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    struct Link {
        NearPair pair;
        std::uint32_t next;
    };

    // Returns the leading bits of the square. The bits have the same order as the floats, since the floats are not
    // negative.
    static std::int32_t bucket_bits(float square) noexcept {
        return std::bit_cast<std::int32_t>(square) >> dropped_bits;
    }
    std::size_t bucket_of(float square) const noexcept {
        const std::int32_t at = bucket_bits(square) - base_;
        return static_cast<std::size_t>(std::clamp(at, 0, static_cast<std::int32_t>(bucket_count - 1)));
    }

    std::int32_t base_ = 0;
    std::size_t first_word_ = 0;
    std::array<std::uint64_t, bucket_count / 64> words_{};  // bit i: bucket i has a pair
    std::array<std::uint32_t, bucket_count> heads_;         // first pair of each bucket that has one
    std::vector<Link> links_;
    std::uint32_t free_ = none;
};

}  // namespace ecods
