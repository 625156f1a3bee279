#include "fuzz/pairs/case_run.hpp"

namespace ecods::fuzz {
namespace {

class Run : CaseRun {
  public:
    using CaseRun::CaseRun;

    void check_one() {
        const auto& family = next_family(scenes::turn_families());
        scenes::TurnCase made = family.make(random_);
        if (has_wrong_recipe_ && made.time) ++*made.time;
        const judge::Judged<scenes::TurnCase> judged(made);
        take(made, judged.truth);
        if (random_.below(4) == 0 && made.a->triangles().size() * made.b->triangles().size() <= pairs_max) {
            ++counts_.checks["pieces of the time"];
            const auto contradiction = judged.truth.contradiction();
            require_promise(!contradiction, judge::text(judged.truth.contact()) + " by pieces of the time",
                            contradiction.value_or(""), made);
        }
        if (const auto& contact = judged.truth.contact(); lie_ && contact) {
            fail({"cast", "nothing", judge::text(contact)}, made, "a lie");
        }
        require_answers(made, judged, "every form");
        if (random_.below(4) == 0) require_answers_in_environment(made, judged);
        ++index_;
    }

  private:
    static constexpr std::size_t pairs_max = 16;  // of triangles
};

}  // namespace

void run_turns(std::uint32_t seed, Lie lie, CaseCounts& counts) {
    check_cases(seed, lie, counts, 26, &Run::check_one);
}

}  // namespace ecods::fuzz
