// An engine of things that move is set up once, and then its frames are run one by one.
#pragma once

#include <compare>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "ecods/world_options.hpp"

namespace ecods::bench {

// Two bodies by their indices in the scene, a < b.
struct IndexPair {
    std::size_t a = 0;
    std::size_t b = 0;

    friend constexpr auto operator<=>(const IndexPair&, const IndexPair&) = default;
};

inline IndexPair ordered(std::size_t i, std::size_t j) {
    return i < j ? IndexPair{i, j} : IndexPair{j, i};
}

template <class Move, class Pair>
class FrameEngine {
  public:
    virtual ~FrameEngine() = default;

    // Applies the moves and finds all pairs. This is what is timed.
    virtual void run_frame(std::span<const Move> moves) = 0;

    // The pairs of the last frame, in any order. Not timed.
    virtual std::vector<Pair> pairs() const = 0;

    // How many pairs were given to the two-body test in the last frame, or excused by a cache; 0 where unknown.
    virtual std::size_t candidate_count() const { return 0; }

    // An ECoDS world has counted this since it was made.
    virtual std::optional<Statistics> statistics() const { return std::nullopt; }
};

}  // namespace ecods::bench
