#include "fuzz/pairs/case_run.hpp"

namespace ecods::fuzz {
namespace {

class Run : CaseRun {
  public:
    using CaseRun::CaseRun;

    void check_one() {
        scenes::HitCase made = next_family(scenes::hit_families()).make(random_);
        if (has_wrong_recipe_ && made.known) ++made.known->parameter;
        const judge::Judged<scenes::HitCase> judged(made);
        take(made, judged.truth);
        if (const auto& hits = judged.truth.hits(); lie_ && !hits.empty()) {
            fail({"first_hit", "nothing", judge::text(hits.front())}, made, "a lie");
        }
        require_answers(made, judged, "every form");
        if (random_.below(4) == 0) require_answers_in_environment(made, judged);
        ++index_;
    }
};

}  // namespace

void run_hits(std::uint32_t seed, Lie lie, CaseCounts& counts) {
    check_cases(seed, lie, counts, 2000, &Run::check_one);
}

}  // namespace ecods::fuzz
