// Keeps the pairs of solids that are not apart, up to date with the verdicts of collisions.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/bytes_of.hpp"
#include "ecods/world.hpp"
#include "world/bodies.hpp"
#include "world/changes.hpp"
#include "world/pair_verdicts.hpp"

namespace ecods {

// Returns the relation of the second solid to the first.
constexpr Relation mirrored(Relation relation) noexcept {
    return relation == Relation::inside     ? Relation::contains
           : relation == Relation::contains ? Relation::inside
                                            : relation;
}

// An update calls follow(), relates each of tests(), and calls prepare() and commit(). If one of these steps throws,
// the list stays as it was.
class SolidPairs {
  public:
    // Sets whether updates make the list, from the next one on.
    void set(bool are_wanted) noexcept { are_wanted_ = are_wanted; }
    bool are_wanted() const noexcept { return are_wanted_; }
    bool are_listed() const noexcept { return are_listed_; }

    // True if an update before which no body changed has nothing to do.
    bool is_up_to_date() const noexcept { return are_wanted_ == are_listed_; }

    // Finds the pairs of solids to be related: those that `collisions` tests in the same update; if the list is new,
    // all that are not filtered out and whose boxes overlap. Call it after collisions.collect().
    void follow(const Bodies& bodies, const PairVerdicts& collisions);
    std::span<SolidPair> tests() noexcept { return tests_; }

    void prepare(const Changes& changes);
    void commit() noexcept;

    const std::vector<SolidPair>& list() const noexcept { return list_; }

    std::size_t memory_bytes() const noexcept { return bytes_of(tests_, touched_, list_, next_); }

  private:
    bool are_wanted_ = false, are_listed_ = false;
    std::vector<SolidPair> tests_;
    BodyPairs touched_;            // pairs that the current update tested or filtered out, ascending
    std::vector<SolidPair> list_;  // ascending
    std::vector<SolidPair> next_;  // the list after the current update
};

}  // namespace ecods
