#include <sstream>

#include "fuzz/pairs/case_run.hpp"
#include "fuzz/pairs/contacts.hpp"
#include "fuzz/pairs/fewer_triangles.hpp"
#include "judge/hit_truth.hpp"
#include "scenes/hit_cases.hpp"

namespace ecods::fuzz {
namespace {

using judge::HitTruth;
using judge::Wrong;
using scenes::HitCase;
using scenes::Random;

std::string kind_of(const std::vector<Hit>& hits) {
    if (hits.empty()) return "nothing";
    std::ostringstream out;
    out << hits.front().kind;
    return out.str();
}

class Run : CaseRun {
  public:
    Run(std::uint32_t seed, Lie lie, HitCounts& counts) : CaseRun(seed, lie, counts.checks), counts_(counts) {}

    void check_one() {
        const auto families = scenes::hit_families();
        const scenes::HitFamily family = families[index_ % families.size()];
        family_ = scenes::name(family);
        const HitCase made = scenes::make_hit_case(family, random_);
        const MeshShape shape(made.mesh);
        const HitTruth truth(made.line, {shape, made.pose});
        ++counts_.lines;
        ++counts_.kinds[family_][kind_of(truth.hits())];
        if (made.known) require_recipe(made, truth);
        if (lie_ && !truth.hits().empty()) {
            fail({"first_hit", "nothing", judge::text(truth.hits().front())}, made, "a lie");
        }
        ++counts_.checks["every form"];
        if (const auto wrong = truth.ask(memory_, witness_)) shrink(*wrong, made);
        if (random_.below(4) == 0) require_in_environment(made, [&] { return truth.ask(memory_, witness_); });
        ++index_;
    }

  private:
    void require_recipe(const HitCase& made, const HitTruth& truth) const {
        const double promised = made.known->parameter + (has_wrong_recipe_ ? 1 : 0);
        const bool is_same = !truth.hits().empty() && truth.hits()[0].parameter == promised &&
                             truth.hits()[0].feature == made.known->feature;
        require_known(is_same, "parameter " + judge::text(promised), kind_of(truth.hits()), made);
    }

    [[noreturn]] void shrink(Wrong wrong, HitCase made) const {
        drop_triangles(made.mesh, [&] {
            QueryMemory memory;
            PairWitness witness;
            const MeshShape shape(made.mesh);
            const auto found = HitTruth(made.line, {shape, made.pose}).ask(memory, witness);
            if (found) wrong = *found;
            return found.has_value();
        });
        fail(wrong, made, "every form");
    }

    HitCounts& counts_;
    QueryMemory memory_;
    PairWitness witness_;
};

}  // namespace

void run_hits(std::uint32_t seed, Lie lie, HitCounts& counts) {
    Run run(seed, lie, counts);
    for (std::uint64_t i = 0; i < hits_per_run; ++i) run.check_one();
}

}  // namespace ecods::fuzz
