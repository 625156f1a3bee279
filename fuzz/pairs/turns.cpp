#include <string>

#include "ecods/error.hpp"
#include "fuzz/pairs/case_run.hpp"
#include "judge/both_turn_truth.hpp"
#include "judge/text.hpp"
#include "judge/turn_and_straight_truth.hpp"
#include "judge/turn_truth.hpp"
#include "judge/way_questions.hpp"

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
        if (random_.below(2) == 0) check_both(made);
        if (random_.below(2) == 0) check_straight(made);
        require_ways(made);
        ++index_;
    }

  private:
    // The turn as a way, and through another node and back; the points of contacts; and a gap at the end of the turn.
    void require_ways(const scenes::TurnCase& made) {
        if (made.a->triangles().size() * made.b->triangles().size() > way_pairs_max) return;
        const MeshShape a(made.a), b(made.b);
        const Turning<MeshShape> turning(a, made.pose_a, made.turn);
        const Posed<MeshShape> other(b, made.pose_b);
        const auto number = [&] { return static_cast<double>(random_.below(9)) - 4; };
        const WayNode between{{number(), number(), number(), 0.5}, made.turn.pivot_to};
        Pose to = pose_at(made.pose_a, made.turn, 1);
        if (random_.below(2) == 0) to.t += random_.uniform(0, 1) * (made.pose_b.t - to.t);
        try {
            require(judge::ask_about_turn_as_way(turning, between, other, {memory_, witness_}), made, "as a way");
            if (to.R.allFinite() && to.t.allFinite()) {
                require(judge::ask_about_settling(turning, to, other, {memory_, witness_}), made, "the gap at the end");
            }
        } catch (const NotSupported&) {
            ++counts_.checks["a way that is not supported"];
        } catch (const InvalidArgument&) {
            ++counts_.checks["a way with opposite nodes"];
        }
    }

    static constexpr std::size_t way_pairs_max = 64;
    static constexpr std::size_t pairs_max = 16;  // of triangles
    static constexpr std::size_t both_pairs_max = 36;

    // The other body goes straight to a pose; this one turns, or is translated.
    void check_straight(const scenes::TurnCase& made) {
        const std::size_t pairs = made.a->triangles().size() * made.b->triangles().size();
        if (pairs > both_pairs_max) return;
        const MeshShape a(made.a), b(made.b);
        const Pose to = scenes::pose_beside(random_, made);
        const Vec3 way = made.turn.pivot_to - made.turn.pivot_from;
        const bool turns = !way.allFinite() || random_.below(2) == 0;
        const judge::TurnAndStraightTruth truth({a, made.pose_a}, turns ? Motion(made.turn) : Translation{way},
                                                {b, made.pose_b, to});
        std::string how = (turns ? "a turns, b goes to " : "a is translated, b goes to ") + judge::text(to.t);
        for (int k = 0; k < 3; ++k) how += ", " + judge::text(Vec3(to.R.col(k)));
        ++counts_.checks["one goes straight"];
        if (const auto wrong = truth.ask(memory_, witness_)) fail(*wrong, made, how);
        if (pairs <= 4 && random_.below(4) == 0) {
            ++counts_.checks["one goes straight, pieces of the time"];
            const auto contradiction = truth.contradiction();
            require_promise(!contradiction, judge::text(truth.contact()) + " by pieces of the time",
                            contradiction.value_or("") + ", " + how, made);
        }
    }

    // The other body turns, too.
    void check_both(const scenes::TurnCase& made) {
        const std::size_t pairs = made.a->triangles().size() * made.b->triangles().size();
        if (pairs > both_pairs_max) return;
        const MeshShape a(made.a), b(made.b);
        const Turn second = scenes::turn_beside(random_, made);
        const judge::BothTurnTruth truth({a, made.pose_a, made.turn}, {b, made.pose_b, second});
        const std::string how = "both turn, b by " + judge::text(second);
        ++counts_.checks["both turn"];
        if (const auto wrong = truth.ask(memory_, witness_)) fail(*wrong, made, how);
        if (pairs <= 4 && random_.below(4) == 0) {
            ++counts_.checks["both turn, pieces of the time"];
            const auto contradiction = truth.contradiction();
            require_promise(!contradiction, judge::text(truth.contact()) + " by pieces of the time",
                            contradiction.value_or("") + ", " + how, made);
        }
    }
};

}  // namespace

void run_turns(std::uint32_t seed, Lie lie, CaseCounts& counts) {
    check_cases(seed, lie, counts, 26, &Run::check_one);
}

}  // namespace ecods::fuzz
