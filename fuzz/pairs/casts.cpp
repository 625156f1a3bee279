#include <sstream>

#include "fuzz/pairs/case_run.hpp"
#include "fuzz/pairs/contacts.hpp"
#include "fuzz/pairs/fewer_triangles.hpp"
#include "judge/cast_truth.hpp"
#include "scenes/cast_cases.hpp"

namespace ecods::fuzz {
namespace {

using judge::CastTruth;
using judge::Wrong;
using scenes::CastCase;
using scenes::MoveCase;
using scenes::Random;

CastTruth truth_of(const CastCase& made, const MeshShape& a, const MeshShape& b) {
    return {{a, made.pose_a}, made.motion, {b, made.pose_b}};
}
CastTruth truth_of(const MoveCase& made, const MeshShape& a, const MeshShape& b) {
    return {Moving<MeshShape>(a, made.from_a, made.to_a), Moving<MeshShape>(b, made.from_b, made.to_b)};
}

std::string kind_of(const std::optional<FirstContact>& contact) {
    if (!contact) return "nothing";
    std::ostringstream out;
    out << contact->kind;
    return out.str();
}

class Run : CaseRun {
  public:
    Run(std::uint32_t seed, Lie lie, CastCounts& counts) : CaseRun(seed, lie, counts.checks), counts_(counts) {}

    void check_one() {
        const auto casts = scenes::cast_families();
        const auto moves = scenes::move_families();
        const std::uint64_t which = index_ % (casts.size() + moves.size());
        if (which < casts.size()) {
            family_ = "cast, " + std::string(scenes::name(casts[which]));
            check(scenes::make_cast_case(casts[which], random_));
        } else {
            const scenes::MoveFamily family = moves[which - casts.size()];
            family_ = "move, " + std::string(scenes::name(family));
            check(scenes::make_move_case(family, random_));
        }
        ++index_;
    }

  private:
    template <class Case>
    void check(const Case& made) {
        const MeshShape a(made.a), b(made.b);
        const CastTruth truth = truth_of(made, a, b);
        ++counts_.casts;
        ++counts_.kinds[family_][kind_of(truth.contact())];
        if (made.time) require_recipe(made, truth);
        if (lie_ && truth.contact()) fail({"cast", "nothing", judge::text(truth.contact())}, made, "a lie");
        ++counts_.checks["every form"];
        if (const auto wrong = truth.ask(memory_, witness_)) shrink(*wrong, made);
        if (random_.below(4) == 0) require_in_environment(made, [&] { return truth.ask(memory_, witness_); });
    }

    template <class Case>
    void require_recipe(const Case& made, const CastTruth& truth) const {
        const double promised = *made.time + (has_wrong_recipe_ ? 1 : 0);
        require_known((truth.contact() ? truth.contact()->time : -1) == promised, "time " + judge::text(promised),
                      judge::text(truth.contact()), made);
    }

    template <class Case>
    [[noreturn]] void shrink(Wrong wrong, Case made) const {
        for (auto* mesh : {&made.a, &made.b}) {
            drop_triangles(*mesh, [&] {
                QueryMemory memory;
                PairWitness witness;
                const MeshShape a(made.a), b(made.b);
                const auto found = truth_of(made, a, b).ask(memory, witness);
                if (found) wrong = *found;
                return found.has_value();
            });
        }
        fail(wrong, made, "every form");
    }

    CastCounts& counts_;
    QueryMemory memory_;
    PairWitness witness_;
};

}  // namespace

void run_casts(std::uint32_t seed, Lie lie, CastCounts& counts) {
    Run run(seed, lie, counts);
    for (std::uint64_t i = 0; i < casts_per_run; ++i) run.check_one();
}

}  // namespace ecods::fuzz
