// The vertices that triangles use.
#pragma once

#include <cstdint>
#include <vector>

namespace ecods::scenes {

// Gives the vertices that corners name new numbers 0, 1, 2, ... in the order of the old ones. Time and memory are
// proportional to the number of corners (at most times its logarithm), however many vertices there are.
class UsedVertices {
  public:
    // Old numbers, in any order and repeated.
    explicit UsedVertices(std::vector<std::uint32_t> corners);

    const std::vector<std::uint32_t>& old_numbers() const noexcept { return old_numbers_; }  // ascending

    // The new number of a vertex that is used.
    std::uint32_t new_number(std::uint32_t old_number) const;

  private:
    std::vector<std::uint32_t> old_numbers_;
    std::vector<std::uint32_t> table_;  // new numbers, from the first used vertex on; empty if it would be too long
};

}  // namespace ecods::scenes
