// Casts of a mesh that turns: times and errors of every engine, beside the cast of the straight motion.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "engines/own_turns.hpp"
#include "engines/turn_engine.hpp"
#include "judge/cast_truth.hpp"
#include "suites/comparison.hpp"
#include "suites/query_suite.hpp"
#include "suites/turn_judge.hpp"

namespace ecods::bench {

namespace {

using scenes::TurnQuery;
using scenes::TurnWorkload;

struct TurnErrors : Errors {           // no contact reported where there is one, and the other way round
    std::size_t early = 0, late = 0;   // of those reported where there is one
    std::vector<double> share_errors;  // of the same, as shares of the angle
    std::size_t wrong = 0;
    QueryCounts counts;  // of ECoDS
};

struct TurnSuite {
    using Question = Turns;
    using Truth = std::optional<FirstContact>;
    using Errors = TurnErrors;

    // All but the largest meshes.
    static std::size_t judged_count(const TurnWorkload& workload, const SuiteOptions& options) {
        return options.is_quick() ? 1 : triangle_count(workload.meshes) <= 5000 ? workload.queries.size() : 0;
    }

    static Truths<Truth> find_truths(const TurnWorkload& workload, std::size_t judged_count) {
        OwnTurns own(workload);
        return bench::find_truths<Truth>(
            workload.queries, judged_count, [&](const TurnQuery& query, std::size_t) { return own.turn(query); },
            [&](const TurnQuery& query) {
                const Truth claimed = own.turn(query);
                return true_contact(own.turning(query), own.resting(query),
                                    claimed ? std::optional(claimed->time) : std::nullopt);
            },
            [](const Truth& x, const Truth& y) { return judge::is_same(x, y); });
    }

    static TurnErrors errors_of(const Run<Turns>& run, const TurnWorkload& workload, const Truths<Truth>& truths) {
        TurnErrors errors;
        const TurnAnswer kind = run.maker->traits.answer;
        if (run.maker->is_ecods) errors.counts = counts_of(workload, kind);
        if (kind == TurnAnswer::straight) return errors;
        for (std::size_t i = 0; i < run.answers.size(); ++i) {
            const bool is_reported = !std::isnan(run.answers[i]);
            const Truth& contact = truths.answers[i];
            errors.false_positives += is_reported && !contact;
            errors.false_negatives += !is_reported && contact;
            errors.wrong += is_reported != contact.has_value() || (contact && run.answers[i] != contact->time);
            if (!is_reported || !contact) continue;
            const Turn& turn = workload.queries[i].turn;
            const double truth =
                kind == TurnAnswer::time ? contact->time : angle_at(turn, contact->time) / angle_at(turn, 1);
            errors.early += run.answers[i] < truth;
            errors.late += run.answers[i] > truth;
            errors.share_errors.push_back(std::abs(run.answers[i] - truth));
        }
        return errors;
    }

    static std::vector<std::string> cells(const Measured<TurnSuite>& measured, std::size_t i) {
        const Run<Turns>& run = measured.runs[i];
        const TurnErrors& errors = measured.errors[i];
        const auto contact_count = std::ranges::count_if(measured.truths.answers, &Truth::has_value);
        std::vector<std::string> cells = {share_text(run.us, measured.us_of(own_straight_cast)),
                                          ratio_text(times_as_fast(run.us, measured.us_of(turn_yardstick)))};
        if (run.maker->traits.answer == TurnAnswer::straight) {
            cells.insert(cells.end(), 7, "");
        } else {
            const auto of_shares = median_and_most(errors.share_errors, error_text);
            cells.insert(cells.end(),
                         {fmt::format("{} / {}", contact_count, run.answers.size()),
                          fmt::format("{}", errors.false_negatives), fmt::format("{}", errors.false_positives),
                          fmt::format("{}", errors.early), fmt::format("{}", errors.late), of_shares[0], of_shares[1]});
        }
        if (!run.maker->is_ecods) return cells;
        const auto each = [&](std::uint64_t count) {
            return fmt::format("{:.1f}", static_cast<double>(count) / static_cast<double>(run.answers.size()));
        };
        cells.insert(cells.end(), {each(errors.counts.box_tests), each(errors.counts.casts.enclosures),
                                   each(errors.counts.casts.exact)});
        if (run.maker->traits.answer == TurnAnswer::straight) return cells;
        cells.insert(cells.end(), {measured.wrong_text(i), fmt::format("{}", measured.truths.judged_count)});
        return cells;
    }

    static std::optional<double> error(const Measured<TurnSuite>& measured, std::size_t i) {
        const Run<Turns>& run = measured.runs[i];
        if (run.maker->traits.answer == TurnAnswer::straight) return std::nullopt;
        return static_cast<double>(measured.errors[i].count()) / static_cast<double>(run.answers.size());
    }

  private:
    static QueryCounts counts_of(const TurnWorkload& workload, TurnAnswer kind) {
        OwnTurns own(workload);
        QueryCounts counts;
        for (const TurnQuery& query : workload.queries) {
            (void)(kind == TurnAnswer::straight ? own.go_straight(query, &counts) : own.turn(query, &counts));
        }
        return counts;
    }
};

Table rigid_turn_table(std::size_t repetition_count) {
    return timed_table(
        "One mesh turns rigidly: when does it first meet the other?",
        {"of straight", "times FCL", "contacts", "false -", "false +", "early", "late", "median error", "most error",
         "node tests", "candidates", "exact", "wrong", "judged"},
        repetition_count,
        {fmt::format("Of straight: time over that of {}, whose points go straight to the same end. Times FCL: how many "
                     "times as fast as {}, in the same repetition.",
                     own_straight_cast, turn_yardstick),
         "False: no contact reported, though the bodies meet on the way, and a contact reported where they do not. "
         "Early, late: contacts reported before the true time, and after it, when one is in the other. Errors: of the "
         "time, as a share of the angle. FCL's advancement is not asked of 100,000 triangles, for the time.",
         "Of each query of ECoDS: tests of two tree nodes, pairs of triangles whose times were bounded in doubles, and "
         "those that were decided in integers. Wrong: answers of ECoDS that are not the true time, rounded once. "
         "Judged: so many of the first contacts, features included, are the oracle's; the others are those of ECoDS."});
}

}  // namespace

SuiteResult run_turns(const SuiteOptions& options) {
    const std::vector<TurnMaker> makers = options.wanted(turn_engines());
    SuiteResult result;
    if (makers.empty()) return result;
    const std::vector<TurnWorkload> workloads = scenes::turn_workloads(options.workload_size());
    Table table = rigid_turn_table(options.repetition_count);
    measure_all<TurnSuite>(
        workloads, makers, options, "turns", [&](const TurnWorkload&) { return &table; }, result);
    print(table);
    result.sections.push_back({"Casts of turning meshes",
                               {},
                               {table, use_table("How each engine is asked for turns", makers, poses_are_timed)},
                               {}});
    return result;
}

}  // namespace ecods::bench
