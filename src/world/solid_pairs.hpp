// Keeps the list of pairs of solids that are not apart up to date with the verdicts of collisions.
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

// Returns the relation of b to a, given the relation of a to b.
constexpr Relation mirrored(Relation relation) noexcept {
    return relation == Relation::inside     ? Relation::contains
           : relation == Relation::contains ? Relation::inside
                                            : relation;
}

// An update calls follow(), sets the relation of each of tests(), and then calls prepare() and commit(). If one of
// these steps throws, the list stays as it was.
class SolidPairs {
  public:
    // Sets whether the next updates make the list.
    void set(bool are_wanted) noexcept { are_wanted_ = are_wanted; }
    bool are_wanted() const noexcept { return are_wanted_; }
    bool are_listed() const noexcept { return are_listed_; }

    // True if list() is made exactly if it is wanted: if no body has changed either, an update has nothing to do.
    bool is_up_to_date() const noexcept { return are_wanted_ == are_listed_; }

    // Sets tests() to the pairs of solids that `collisions` tests in this update. If the last update made no list, sets
    // tests() to all pairs of solids that are not filtered out and whose boxes overlap. Call it after
    // collisions.collect().
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
    std::vector<SolidPair> next_;  // the list that commit() will publish
};

}  // namespace ecods
