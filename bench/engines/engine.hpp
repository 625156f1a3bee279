// An engine is made ready once for a workload, and then asked. A question says what it is asked.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace ecods::bench {

// An engine of a question about the single queries of a workload. An answer consists of doubles alone, because it comes
// from a process of the engine's own.
template <class Q>
class QueryEngine {
  public:
    using Query = typename decltype(Q::Workload::queries)::value_type;
    using Answer = typename Q::Answer;

    virtual ~QueryEngine() = default;

    // Answers one query. Timed, with everything that a change of pose demands. `index` is the query's in the workload:
    // some engines keep something for each.
    virtual Answer ask(const Query& query, std::size_t index) = 0;

    // Answers all queries of the workload in their order. Timed; for engines that answer several together.
    virtual void ask_all(std::span<const Query> queries, std::span<Answer> answers) {
        for (std::size_t i = 0; i < queries.size(); ++i) answers[i] = ask(queries[i], i);
    }
};

// An engine that also lists everything that a query meets, as items in any order. Timed.
template <class Query, class Item>
class Lists {
  public:
    virtual ~Lists() = default;
    virtual void list(const Query& query, std::vector<Item>& items) = 0;
};

// The work behind a query, by an engine that counts it.
struct Work {
    std::uint64_t box_tests = 0;
    std::uint64_t triangle_tests = 0;
};
template <class Query>
class CountsWork {
  public:
    virtual ~CountsWork() = default;
    virtual Work work(const Query& query) = 0;  // asks the query again; not timed
};

// An engine of the comparison: its name, how it is used, and how it is made ready for a workload.
template <class Q>
struct Maker {
    using Engine = typename Q::Engine;

    std::string name;
    std::string use = {};            // how it is used, and what its precision is: for the page
    bool is_ecods = false;           // its answers must be the oracle's
    bool has_lists = false;          // it is asked for lists, too
    bool is_slow = false;            // timed once, however many repetitions the others have
    typename Q::Traits traits = {};  // what else the question has to know
    // Not timed, but where builds are measured. The workload outlives the engine.
    std::function<std::unique_ptr<Engine>(const typename Q::Workload& workload)> set_up = {};
};

// Makes engines of this class, from the workload and what is given here.
template <class Engine, class... Given>
auto makes(Given... given) {
    return [given...](const auto& workload) { return std::make_unique<Engine>(workload, given...); };
}

// The makers of several libraries, in the order in which tables show them.
template <class Maker, class... More>
std::vector<Maker> joined(std::vector<Maker> makers, const More&... more) {
    (makers.insert(makers.end(), more.begin(), more.end()), ...);
    return makers;
}

}  // namespace ecods::bench
