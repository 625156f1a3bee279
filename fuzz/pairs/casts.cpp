#include "fuzz/pairs/case_run.hpp"

namespace ecods::fuzz {
namespace {

class Run : CaseRun {
  public:
    using CaseRun::CaseRun;

    // Translations and motions between poses take turns with their families.
    void check_one() {
        const auto casts = scenes::cast_families();
        const auto moves = scenes::move_families();
        const std::uint64_t which = index_ % (casts.size() + moves.size());
        which < casts.size() ? check("cast, ", casts[which]) : check("move, ", moves[which - casts.size()]);
        ++index_;
    }

  private:
    template <class Case>
    void check(const std::string& kind, const scenes::Family<Case>& family) {
        family_ = kind + std::string(family.name);
        Case made = family.make(random_);
        if (has_wrong_recipe_ && made.time) ++*made.time;
        const judge::Judged<Case> judged(made);
        take(made, judged.truth);
        if (const auto& contact = judged.truth.contact(); lie_ && contact) {
            fail({"cast", "nothing", judge::text(contact)}, made, "a lie");
        }
        require_answers(made, judged, "every form");
        if (random_.below(4) == 0) require_answers_in_environment(made, judged);
    }
};

}  // namespace

void run_casts(std::uint32_t seed, Lie lie, CaseCounts& counts) {
    check_cases(seed, lie, counts, 250, &Run::check_one);
}

}  // namespace ecods::fuzz
