// Runs the engines of a question on one workload: they take turns, each in a process of its own. The first turn of each
// is not timed.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "engines/engine.hpp"
#include "harness/differences.hpp"
#include "harness/turns.hpp"
#include "process/contained.hpp"

namespace ecods::bench {

template <class Q>
struct Run {
    const Maker<Q>* maker = nullptr;
    std::vector<double> us = {};                   // per query, one for each repetition
    std::vector<typename Q::Answer> answers = {};  // one for each query
    std::optional<Work> work = {};                 // of all queries, by an engine that counts it
    std::string failure = {};                      // when it crashed, hung or threw: nothing above is there
};

template <class Q>
struct ListRun {
    const Maker<Q>* maker = nullptr;
    std::vector<double> us = {};
    double item_count = 0;  // listed, of all queries
    Errors errors = {};     // of items
    std::string failure = {};
};

// Asks all queries once, untimed, and then for their work; in later turns until the engine is awake, and then in timed
// passes. Values: microseconds a pass; whether work was counted, box tests, triangle tests; the answers.
template <class Q>
class QueryTurn {
  public:
    using Answer = typename Q::Answer;
    static_assert(std::is_trivially_copyable_v<Answer> && alignof(Answer) == alignof(double) &&
                  sizeof(Answer) % sizeof(double) == 0);

    QueryTurn(const Maker<Q>& maker, const typename Q::Workload& workload)
        : engine_(maker.set_up(workload)), workload_(&workload), answers_(workload.queries.size()) {}

    std::vector<double> operator()() {
        const auto ask_all = [&] { engine_->ask_all(workload_->queries, answers_); };
        double us = 0;
        std::optional<Work> work;
        if (std::exchange(is_first_, false)) {
            ask_all();
            work = count_work();
        } else {
            wake(answers_.size(), [&](std::size_t i) { engine_->ask(workload_->queries[i], i); });
            us = microseconds_a_pass(ask_all);
        }
        const auto [box_tests, triangle_tests] = work.value_or(Work{});
        std::vector<double> values = {us, work ? 1.0 : 0.0, static_cast<double>(box_tests),
                                      static_cast<double>(triangle_tests)};
        values.resize(head_size + answers_.size() * sizeof(Answer) / sizeof(double));
        std::ranges::copy(std::as_bytes(std::span(answers_)),
                          std::as_writable_bytes(std::span(values).subspan(head_size)).data());
        return values;
    }

    // Reads the values of a first turn.
    static void read(const std::vector<double>& values, Run<Q>& run) {
        if (values[1] != 0) run.work = {static_cast<std::uint64_t>(values[2]), static_cast<std::uint64_t>(values[3])};
        run.answers.resize((values.size() - head_size) * sizeof(double) / sizeof(Answer));
        const auto numbers = std::as_bytes(std::span(values).subspan(head_size));
        std::ranges::copy(numbers, std::as_writable_bytes(std::span(run.answers)).data());
    }

  private:
    static constexpr std::size_t head_size = 4;

    std::optional<Work> count_work() {
        auto* const counting = dynamic_cast<CountsWork<typename Q::Engine::Query>*>(engine_.get());
        if (counting == nullptr) return std::nullopt;
        Work all;
        for (const auto& query : workload_->queries) {
            const Work work = counting->work(query);
            all.box_tests += work.box_tests;
            all.triangle_tests += work.triangle_tests;
        }
        return all;
    }

    std::shared_ptr<typename Q::Engine> engine_;
    const typename Q::Workload* workload_;
    std::vector<Answer> answers_;
    bool is_first_ = true;
};

// Lists all items once, and compares them; in later turns again in timed passes. Values: microseconds a pass, items,
// false negatives, false positives.
template <class Q>
class ListTurn {
  public:
    using Item = typename Q::Item;

    ListTurn(const Maker<Q>& maker, const typename Q::Workload& workload, const std::vector<std::vector<Item>>& truth)
        : engine_(maker.set_up(workload)), workload_(&workload), truth_(&truth) {}

    std::vector<double> operator()() {
        auto& lists = dynamic_cast<Lists<typename Q::Engine::Query, Item>&>(*engine_);
        std::vector<Item> list;
        double us = 0, item_count = 0;
        Errors errors;
        for (std::size_t i = 0; i < truth_->size(); ++i) {
            lists.list(workload_->queries[i], list);
            item_count += static_cast<double>(list.size());
            errors += compare(ascending(list), (*truth_)[i]);
        }
        if (!std::exchange(is_first_, false)) {
            us = microseconds_a_pass([&] {
                for (const auto& query : workload_->queries) lists.list(query, list);
            });
        }
        return {us, item_count, static_cast<double>(errors.false_negatives),
                static_cast<double>(errors.false_positives)};
    }

    static void read(const std::vector<double>& values, ListRun<Q>& run) {
        run.item_count = values[1];
        run.errors = {static_cast<std::size_t>(values[2]), static_cast<std::size_t>(values[3])};
    }

  private:
    std::shared_ptr<typename Q::Engine> engine_;
    const typename Q::Workload* workload_;
    const std::vector<std::vector<Item>>* truth_;
    bool is_first_ = true;
};

template <class Q>
bool is_asked(const Maker<Q>& maker, const typename Q::Workload& workload) {
    if constexpr (requires { Q::is_asked(maker.traits, workload); }) return Q::is_asked(maker.traits, workload);
    return true;
}

// The runs of these makers; `start` makes a turn of one, which is called in each of its turns.
template <class R, class Turn, class Q, class Start>
std::vector<R> take_turns(const std::vector<const Maker<Q>*>& makers, std::size_t query_count,
                          std::size_t repetition_count, const Start& start) {
    std::vector<R> runs;
    std::vector<process::Contained> children;
    children.reserve(makers.size());
    for (const Maker<Q>* const maker : makers) {
        runs.push_back({.maker = maker});
        children.emplace_back([&start, maker] { return process::Contained::Run(start(*maker)); }, turn_limit);
    }
    // In each repetition all have a turn, so that a change of the machine's pace meets all of them.
    for (std::size_t repetition = 0; repetition <= repetition_count; ++repetition) {
        for (std::size_t i = 0; i < runs.size(); ++i) {
            if (makers[i]->is_slow && repetition > 1) continue;
            const process::Outcome outcome = children[i].run();
            runs[i].failure = outcome.failure;
            if (!outcome.is_right()) continue;
            if (repetition == 0) Turn::read(outcome.values, runs[i]);
            if (repetition > 0) runs[i].us.push_back(outcome.values[0] / static_cast<double>(query_count));
        }
    }
    return runs;
}

// Runs the engines that are asked about the workload.
template <class Q>
std::vector<Run<Q>> measure(const typename Q::Workload& workload, const std::vector<Maker<Q>>& makers,
                            std::size_t repetition_count) {
    std::vector<const Maker<Q>*> asked;
    for (const Maker<Q>& maker : makers)
        if (is_asked(maker, workload)) asked.push_back(&maker);
    return take_turns<Run<Q>, QueryTurn<Q>>(asked, workload.queries.size(), repetition_count,
                                            [&](const Maker<Q>& maker) { return QueryTurn<Q>(maker, workload); });
}

// Runs those that have lists; `truth` has the items of each query, ascending.
template <class Q>
std::vector<ListRun<Q>> measure_lists(const typename Q::Workload& workload, const std::vector<Maker<Q>>& makers,
                                      const std::vector<std::vector<typename Q::Item>>& truth,
                                      std::size_t repetition_count) {
    std::vector<const Maker<Q>*> asked;
    for (const Maker<Q>& maker : makers)
        if (maker.has_lists && is_asked(maker, workload)) asked.push_back(&maker);
    return take_turns<ListRun<Q>, ListTurn<Q>>(
        asked, workload.queries.size(), repetition_count,
        [&](const Maker<Q>& maker) { return ListTurn<Q>(maker, workload, truth); });
}

}  // namespace ecods::bench
