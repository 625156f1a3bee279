// Keeps the relation of each colliding pair, up to date with the verdicts of collisions.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "base/bytes_of.hpp"
#include "ecods/world.hpp"
#include "world/bodies.hpp"
#include "world/changes.hpp"
#include "world/pair_verdicts.hpp"

namespace ecods {

// An update calls follow(), relates each of tests(), and calls prepare() and commit(). If one of these steps throws,
// the list stays as it was.
class PairRelations {
  public:
    // Sets whether updates list the relations, from the next update on.
    void set(bool are_wanted) noexcept { are_wanted_ = are_wanted; }
    bool are_wanted() const noexcept { return are_wanted_; }
    bool are_listed() const noexcept { return are_listed_; }

    // Lists what version 1 of traces listed: pairs of solids alone, whether or not their surfaces share a point.
    void list_solids_alone() noexcept { is_of_solids_ = true; }
    bool is_of_solids() const noexcept { return is_of_solids_; }

    // Returns the question that every test must answer; nullopt if no list is wanted.
    std::optional<Question> question() const noexcept {
        return are_wanted_ ? std::optional(Question::relation) : std::nullopt;
    }

    // Returns true if an update before which no body changed has nothing to do.
    bool is_up_to_date() const noexcept { return are_wanted_ == are_listed_; }

    // Finds the pairs whose relation must be computed: the pairs that `collisions` tested in the same update and that
    // collide; if the list is new, all pairs that collide. Call it after the tests have answers.
    void follow(const Bodies& bodies, const PairVerdicts& collisions);
    std::span<PairRelation> tests() noexcept { return tests_; }

    void prepare(const Changes& changes);
    void commit() noexcept;

    const std::vector<PairRelation>& list() const noexcept { return list_; }

    std::size_t memory_bytes() const noexcept { return bytes_of(tests_, touched_, list_, next_); }

  private:
    void add_test(const Verdict& verdict, bool collides, const Bodies& bodies);
    void add_untouched(const Bodies& bodies, const VerdictCache& verdicts);

    bool are_wanted_ = false, are_listed_ = false, is_of_solids_ = false;
    std::vector<PairRelation> tests_;
    BodyPairs touched_;               // pairs that the current update tested or filtered out, ascending
    std::vector<PairRelation> list_;  // ascending
    std::vector<PairRelation> next_;  // the list after the current update
};

}  // namespace ecods
