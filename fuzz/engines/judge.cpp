#include "fuzz/engines/judge.hpp"

#include <cstdio>
#include <memory>
#include <stdexcept>

#include "oracle/oracle.hpp"
#include "process/contained.hpp"

namespace ecods::fuzz {
namespace {

constexpr std::size_t failures_max = 8;
constexpr std::size_t examples_max = 3;

// Asks one query a turn, from `first` on. In the child.
std::function<process::Contained::Run()> asker(const EngineMaker& engine, const scenes::MeshPairs& pairs,
                                               std::size_t first) {
    return [&engine, &pairs, first]() -> process::Contained::Run {
        // Engines complain there about what they were asked.
        if (!engine.shows_errors && std::freopen("/dev/null", "w", stderr) == nullptr)
            throw std::runtime_error("no /dev/null");
        const std::shared_ptr<EngineUnderTest> made = engine.make(pairs.meshes);
        return [made, &pairs, next = first]() mutable -> std::vector<double> {
            const scenes::MeshQuery& query = pairs.queries[next++];
            const bool forward = made->intersects(query);
            return {static_cast<double>(forward), static_cast<double>(made->intersects({query.b, query.a}))};
        };
    };
}

void note_answer(Verdicts& verdicts, std::size_t query, bool forward, bool backward, bool truth) {
    ++verdicts.answered;
    verdicts.false_negatives += truth && !forward;
    verdicts.false_positives += !truth && forward;
    verdicts.asymmetric += forward != backward;
    if ((forward != truth || backward != truth) && verdicts.wrong.size() < examples_max) {
        verdicts.wrong.push_back(query);
    }
}

void note_failure(Verdicts& verdicts, const process::Outcome& outcome) {
    ++(outcome.end == process::End::hung ? verdicts.hung : verdicts.crashed);
    if (verdicts.first_failure.empty()) verdicts.first_failure = outcome.failure;
}

}  // namespace

std::vector<bool> ask_oracle(const scenes::MeshPairs& pairs) {
    std::vector<bool> truth;
    for (const scenes::MeshQuery& query : pairs.queries) {
        const auto posed = [&](const scenes::MeshAt& at) {
            return oracle::OracleMesh(pairs.meshes[at.mesh_index].mesh, at.pose);
        };
        truth.push_back(oracle::intersects(posed(query.a), posed(query.b)));
    }
    return truth;
}

Verdicts judge(const EngineMaker& engine, const scenes::MeshPairs& pairs, const std::vector<bool>& truth,
               std::chrono::seconds limit) {
    Verdicts verdicts{.queries = truth.size()};
    for (const bool hit : truth) verdicts.hits += hit;
    std::unique_ptr<process::Contained> child;
    for (std::size_t query = 0; query < truth.size() && verdicts.crashed + verdicts.hung < failures_max; ++query) {
        if (!child) child = std::make_unique<process::Contained>(asker(engine, pairs, query), limit);
        const process::Outcome outcome = child->run();
        if (outcome.is_right()) {
            note_answer(verdicts, query, outcome.values[0] != 0, outcome.values[1] != 0, truth[query]);
        } else {
            note_failure(verdicts, outcome);
            child.reset();
        }
    }
    return verdicts;
}

}  // namespace ecods::fuzz
