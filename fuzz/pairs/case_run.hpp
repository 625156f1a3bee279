// What the campaigns of cases have in common: where a case is from, and what is thrown where an answer about it is
// wrong.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "environment/float_mode.hpp"
#include "environment/instruction_sets.hpp"
#include "fuzz/base/counters.hpp"
#include "fuzz/base/recipe.hpp"
#include "fuzz/pairs/run.hpp"
#include "fuzz/pairs/text.hpp"
#include "judge/whether_solid.hpp"
#include "judge/wrong.hpp"
#include "scenes/random.hpp"

namespace ecods::fuzz {

class CaseRun {
  protected:
    CaseRun(std::uint32_t seed, Lie lie, Counters& checks)
        : random_(seed),
          lie_(lie == Lie::answer),
          has_wrong_recipe_(lie == Lie::recipe),
          seed_(seed),
          checks_(checks) {}

    // Throws Disagreement. `how` says how it was asked.
    template <class Case>
    [[noreturn]] void fail(const judge::Wrong& wrong, const Case& made, const std::string& how) const {
        throw Disagreement{.seed = seed_,
                           .pair = index_,
                           .family = family_,
                           .path = how.empty() ? wrong.question : wrong.question + ", " + how,
                           .expected = wrong.expected,
                           .got = wrong.got,
                           .text = to_text(made)};
    }

    // Counts a check, and fails unless its answer was right.
    template <class Case>
    void require(const std::optional<judge::Wrong>& wrong, const Case& made, const std::string& how) const {
        ++checks_[how];
        if (wrong) fail(*wrong, made, how);
    }

    // Fails unless a promise of the case's recipe is kept. The oracle has seen that, not the library, which has not
    // been asked yet; `found` says what the oracle found.
    template <class Case>
    void require_promise(bool is_kept, const std::string& promised, const std::string& found, const Case& made) const {
        if (!is_kept) fail({recipe_check, promised, found}, made, "");
    }

    // Fails unless the recipe knows the true answer. This is counted.
    template <class Case>
    void require_known(bool is_known, const std::string& known, const std::string& found, const Case& made) const {
        ++checks_["known by its recipe"];
        require_promise(is_known, known, found, made);
    }

    // Fails unless the mesh bounds a solid, as the recipe promises. Returns what the oracle knows of it.
    template <class Case>
    judge::WhetherSolid require_solid(const std::string& body, const Mesh& mesh, const Case& made) const {
        judge::WhetherSolid whether(mesh);
        require_promise(whether.is_solid(), body + " bounds a solid", whether.words(), made);
        return whether;
    }

    // The same for what `ask` answers with an instruction set and in a floating-point environment drawn at random.
    template <class Case, class Ask>
    void require_in_environment(const Case& made, const Ask& ask) {
        const auto& mode = environment::float_modes[random_.below(environment::float_modes.size())];
        const auto sets = environment::supported_instruction_sets();
        const InstructionSet set = sets[random_.below(static_cast<std::uint32_t>(sets.size()))];
        const auto wrong = [&] {
            const environment::InstructionSetLimit limit(set);
            const environment::InFloatMode in_mode(mode);
            return ask();
        }();
        require(wrong, made, std::string(mode.name) + ", " + environment::name(set));
    }

    scenes::Random random_;
    bool lie_;                 // of an answer
    bool has_wrong_recipe_;    // on purpose
    std::uint64_t index_ = 0;  // of the case
    std::string family_;

  private:
    std::uint32_t seed_;
    Counters& checks_;
};

}  // namespace ecods::fuzz
