// The pairs of solids that are not apart, brought up to date with the verdicts of collisions.
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

// The relation of the second solid to the first.
constexpr SolidRelation mirrored(SolidRelation relation) noexcept {
    return relation == SolidRelation::inside     ? SolidRelation::contains
           : relation == SolidRelation::contains ? SolidRelation::inside
                                                 : relation;
}

// An update is follow(), a relation for each of tests(), prepare() and commit(): where one of them throws, the list
// stays as it was.
class SolidPairs {
  public:
    // From the next update on.
    void set(bool are_wanted) noexcept { are_wanted_ = are_wanted; }
    bool are_wanted() const noexcept { return are_wanted_; }
    bool are_listed() const noexcept { return are_listed_; }

    // Whether an update before which no body changed has nothing to do.
    bool is_up_to_date() const noexcept { return are_wanted_ == are_listed_; }

    // Finds the pairs to be related: those of solids that `collisions` tests in the same update; or if the list is new,
    // all whose boxes overlap. After collisions.collect().
    void follow(const Bodies& bodies, const PairVerdicts& collisions);
    std::span<SolidPair> tests() noexcept { return tests_; }

    void prepare(const Changes& changes);
    void commit() noexcept;

    const std::vector<SolidPair>& list() const noexcept { return list_; }

    std::size_t memory_bytes() const noexcept { return bytes_of(tests_, touched_, list_, next_); }

  private:
    bool are_wanted_ = false, are_listed_ = false;
    std::vector<SolidPair> tests_;
    BodyPairs touched_;            // all pairs that are tested, or filtered out, by the update under way; ascending
    std::vector<SolidPair> list_;  // ascending
    std::vector<SolidPair> next_;  // of the update under way
};

}  // namespace ecods
