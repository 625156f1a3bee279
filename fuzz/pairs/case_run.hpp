// What the campaigns of cases have in common: where a case is from, what is asked about each, and what is thrown where
// an answer is wrong.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "environment/float_mode.hpp"
#include "environment/instruction_sets.hpp"
#include "fuzz/pairs/campaigns.hpp"
#include "fuzz/pairs/smaller_case.hpp"
#include "fuzz/pairs/text.hpp"
#include "judge/case_truth.hpp"
#include "judge/whether_solid.hpp"
#include "judge/wrong.hpp"
#include "scenes/families.hpp"
#include "scenes/random.hpp"

namespace ecods::fuzz {

class CaseRun {
  public:
    CaseRun(std::uint32_t seed, Lie lie, CaseCounts& counts)
        : random_(seed),
          lie_(lie == Lie::answer),
          has_wrong_recipe_(lie == Lie::recipe),
          counts_(counts),
          seed_(seed) {}

  protected:
    // Throws Disagreement. `how` says how it was asked.
    template <class Case>
    [[noreturn]] void fail(const judge::Wrong& wrong, const Case& made, const std::string& how) const {
        throw Disagreement{.seed = seed_,
                           .index = index_,
                           .family = family_,
                           .path = how.empty() ? wrong.question : wrong.question + ", " + how,
                           .expected = wrong.expected,
                           .got = wrong.got,
                           .text = to_text(made)};
    }

    // Counts a check, and fails unless its answer was right.
    template <class Case>
    void require(const std::optional<judge::Wrong>& wrong, const Case& made, const std::string& how) const {
        ++counts_.checks[how];
        if (wrong) fail(*wrong, made, how);
    }

    // Fails unless a promise of the case's recipe is kept. The oracle has seen that, not the library, which has not
    // been asked yet; `found` says what the oracle found.
    template <class Case>
    void require_promise(bool is_kept, const std::string& promised, const std::string& found, const Case& made) const {
        if (!is_kept) fail({recipe_check, promised, found}, made, "");
    }

    // Fails unless the mesh bounds a solid, as the recipe promises. Returns what the oracle knows of it.
    template <class Case>
    judge::WhetherSolid require_solid(const std::string& body, const Mesh& mesh, const Case& made) const {
        judge::WhetherSolid whether(mesh);
        require_promise(whether.is_solid(), body + " bounds a solid", whether.words(), made);
        return whether;
    }

    // Counts the case, what is so of it, and what its recipe promises, which must be kept.
    template <class Case, class Truth>
    void take(const Case& made, const Truth& truth) {
        ++counts_.cases;
        ++counts_.kinds[family_][judge::kind_of(truth)];
        for (const judge::Promise& promise : judge::promises_of(made, truth)) {
            ++counts_.checks["known by its recipe"];
            require_promise(promise.is_kept, promise.promised, promise.found, made);
        }
    }

    // Asks every question, with a memory that others have used and a witness of other bodies. A case that fails is made
    // smaller.
    template <class Case>
    void require_answers(Case made, const judge::Judged<Case>& judged, const std::string& how) {
        ++counts_.checks[how];
        auto wrong = judge::ask(judged.truth, memory_, witness_);
        if (!wrong) return;
        const auto fails = [&] {
            QueryMemory memory;
            PairWitness witness;
            auto found = judge::ask(judge::Judged<Case>(made).truth, memory, witness);
            if (found) wrong = std::move(found);
            return found.has_value();
        };
        make_smaller(made, fails);
        fail(*wrong, made, how);
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
    template <class Case>
    void require_answers_in_environment(const Case& made, const judge::Judged<Case>& judged) {
        require_in_environment(made, [&] { return judge::ask(judged.truth, memory_, witness_); });
    }

    // The family of the next case: they take turns.
    template <class Case>
    const scenes::Family<Case>& next_family(scenes::Families<Case> families) {
        const scenes::Family<Case>& family = families[index_ % families.size()];
        family_ = family.name;
        return family;
    }

    scenes::Random random_;
    bool lie_;                 // of an answer
    bool has_wrong_recipe_;    // on purpose
    std::uint64_t index_ = 0;  // of the case
    std::string family_;
    CaseCounts& counts_;
    QueryMemory memory_;
    PairWitness witness_;

  private:
    std::uint32_t seed_;
};

// A run of so many cases.
template <class Run>
void check_cases(std::uint32_t seed, Lie lie, CaseCounts& counts, std::uint64_t count, void (Run::*check)()) {
    Run run(seed, lie, counts);
    for (std::uint64_t i = 0; i < count; ++i) (run.*check)();
}

}  // namespace ecods::fuzz
