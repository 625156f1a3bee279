#include "suites/cast_measure.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <deque>
#include <utility>

#include "harness/turns.hpp"
#include "judge/cast_truth.hpp"
#include "process/contained.hpp"
#include "suites/timed_rows.hpp"

namespace ecods::bench {

namespace {

constexpr std::chrono::seconds turn_limit{300};

// A turn: the first one all motions once, untimed; a later one some of them, until the core is awake, then all in timed
// passes. Values: microseconds a pass, then the answers.
process::Contained::Run start_casts(const CastMaker& maker, const scenes::CastWorkload& workload) {
    std::shared_ptr<CastEngine> engine = maker.set_up(workload);
    return [engine, &workload, is_first = true]() mutable {
        std::vector<double> values(1 + workload.queries.size());
        const auto ask_all = [&] {
            for (std::size_t i = 0; i < workload.queries.size(); ++i) values[1 + i] = engine->ask(workload.queries[i]);
        };
        if (std::exchange(is_first, false)) {
            ask_all();
        } else {
            wake([&](std::size_t i) { engine->ask(workload.queries[i % workload.queries.size()]); });
            values[0] = microseconds_a_pass(ask_all);
        }
        return values;
    };
}

std::optional<FirstContact> first_contact(const scenes::CastWorkload& workload, const scenes::CastQuery& query,
                                          const std::deque<MeshShape>& shapes, QueryMemory& memory) {
    const MeshShape &a = shapes[query.a.mesh_index], &b = shapes[query.b.mesh_index];
    if (workload.is_translation) return cast({a, query.a.pose}, query.motion, {b, query.b.pose}, memory);
    return cast(Moving<MeshShape>(a, query.a.pose, query.a_end), Moving<MeshShape>(b, query.b.pose, query.b.pose),
                memory);
}

std::optional<oracle::ExactContact> ask_oracle(const scenes::CastWorkload& workload, const scenes::CastQuery& query) {
    const auto soup = [&](const scenes::MeshAt& at) {
        const Mesh& mesh = *workload.meshes[at.mesh_index].mesh;
        return oracle::Soup{mesh.vertices(), mesh.triangles(), at.pose};
    };
    if (workload.is_translation) return oracle::first_contact(soup(query.a), query.motion, soup(query.b));
    return oracle::first_contact({soup(query.a), query.a_end}, {soup(query.b), query.b.pose});
}

}  // namespace

CastTruth find_contacts(const scenes::CastWorkload& workload, std::size_t judged_count) {
    std::deque<MeshShape> shapes;
    for (const scenes::NamedMesh& named : workload.meshes) shapes.emplace_back(named.mesh);
    QueryMemory memory;
    CastTruth truth;
    const std::size_t count = workload.queries.size();
    for (std::size_t i = 0; i < count; ++i) {
        truth.contacts.push_back(first_contact(workload, workload.queries[i], shapes, memory));
        if (!is_chosen(i, count, std::min(judged_count, count))) continue;
        ++truth.judged_count;
        const auto exact = judge::to_first_contact(ask_oracle(workload, workload.queries[i]));
        if (!judge::is_same(truth.contacts.back(), exact)) ++truth.wrong_count;
    }
    return truth;
}

std::size_t CastTruth::contact_count() const {
    return static_cast<std::size_t>(
        std::count_if(contacts.begin(), contacts.end(), [](const auto& contact) { return contact.has_value(); }));
}

std::vector<CastRun> measure_casts(const scenes::CastWorkload& workload, std::span<const CastMaker> makers,
                                   std::size_t repetition_count) {
    std::vector<CastRun> runs;
    std::vector<process::Contained> children;
    children.reserve(makers.size());
    for (const CastMaker& maker : makers) {
        if (maker.is_for_hulls && !(workload.is_hull && workload.is_translation)) continue;
        if (triangle_count(workload.meshes) > maker.triangle_max) continue;
        runs.push_back({&maker, {}, {}, {}});
        children.emplace_back([&maker, &workload] { return start_casts(maker, workload); }, turn_limit);
    }
    take_turns(children, repetition_count, [&](std::size_t i, std::size_t repetition, const process::Outcome& outcome) {
        CastRun& run = runs[i];
        run.failure = outcome.failure;
        if (!outcome.is_right()) return;
        if (repetition > 0) run.us.push_back(outcome.values[0] / static_cast<double>(workload.queries.size()));
        run.answers.assign(outcome.values.begin() + 1, outcome.values.end());
    });
    return runs;
}

CastErrors errors_of(const CastRun& run, const CastTruth& truth) {
    CastErrors errors;
    if (run.maker->answer != CastAnswer::time) return errors;
    for (std::size_t i = 0; i < run.answers.size(); ++i) {
        const bool is_reported = !std::isnan(run.answers[i]);
        const auto& contact = truth.contacts[i];
        errors.false_positives += is_reported && !contact;
        errors.false_negatives += !is_reported && contact;
        errors.wrong += is_reported != contact.has_value() || (contact && run.answers[i] != contact->time);
        if (is_reported && contact) errors.time_errors.push_back(std::abs(run.answers[i] - contact->time));
    }
    return errors;
}

}  // namespace ecods::bench
