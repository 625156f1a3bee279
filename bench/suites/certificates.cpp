// What an answer with its proof costs beside the plain answer, and how long its text is.
#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "ecods/certificate.hpp"
#include "ecods/distance.hpp"
#include "ecods/hit.hpp"
#include "harness/statistics.hpp"
#include "harness/stopwatch.hpp"
#include "scenes/mesh_pairs.hpp"
#include "scenes/segment_workloads.hpp"
#include "scenes/shapes.hpp"
#include "scenes/ship.hpp"
#include "suites/comparison.hpp"
#include "suites/suite.hpp"

namespace ecods::bench {

namespace {

using Body = Posed<MeshShape>;

struct Question {
    const char* name;
    std::function<void(const Body& a, const Body& b, double d, QueryMemory& memory)> ask;
    std::function<Certificate(const Body& a, const Body& b, double d, QueryMemory& memory)> certify;
};

std::vector<Question> questions() {
    return {{"relation", [](const Body& a, const Body& b, double, QueryMemory& m) { (void)intersects(a, b, m); },
             [](const Body& a, const Body& b, double, QueryMemory& m) { return certify(a, b, m); }},
            {"distance", [](const Body& a, const Body& b, double, QueryMemory& m) { (void)distance(a, b, m); },
             [](const Body& a, const Body& b, double, QueryMemory& m) { return certify_distance(a, b, m); }},
            {"beyond half the distance",
             [](const Body& a, const Body& b, double d, QueryMemory& m) { (void)within(a, b, d / 2, m); },
             [](const Body& a, const Body& b, double d, QueryMemory& m) { return certify_within(a, b, d / 2, m); }}};
}

template <class Ask>
double microseconds(std::size_t repetitions, const Ask& ask) {
    std::vector<double> times;
    for (std::size_t k = 0; k < repetitions; ++k) {
        const Stopwatch watch;
        ask();
        times.push_back(1e-3 * watch.nanoseconds());
    }
    return median(times);
}

// One row: medians over the pairs of medians over the repetitions.
std::vector<std::string> measure(const Question& question, const scenes::MeshPairs& pairs, std::size_t repetitions) {
    const MeshShape shape(pairs.meshes.front().mesh);
    QueryMemory memory;
    std::vector<double> plain, proven, written, shares, bytes, steps;
    for (const scenes::MeshQuery& query : pairs.queries) {
        const Body a(shape, query.a.pose), b(shape, query.b.pose);
        const double d = distance(a, b, memory);
        if (d == 0) continue;
        std::string text = question.certify(a, b, d, memory).to_string();
        plain.push_back(microseconds(repetitions, [&] { question.ask(a, b, d, memory); }));
        proven.push_back(microseconds(repetitions, [&] { question.certify(a, b, d, memory); }));
        written.push_back(microseconds(repetitions, [&] { text = question.certify(a, b, d, memory).to_string(); }));
        shares.push_back(proven.back() / plain.back());
        bytes.push_back(static_cast<double>(text.size()));
        steps.push_back(static_cast<double>(question.certify(a, b, d, memory).step_count()));
    }
    return {pairs.name,
            question.name,
            fmt::format("{:.1f}", median(plain)),
            fmt::format("{:.1f}", median(proven)),
            fmt::format("{:.1f}", median(written)),
            fmt::format("{:.1f}", median(shares)),
            fmt::format("{:.0f}", median(steps)),
            fmt::format("{:.0f}", median(bytes))};
}

// One row: the segments of a workload of one body, medians as above; those that miss are asked, too.
std::vector<std::string> measure_hits(const scenes::SegmentWorkload& workload, std::size_t repetitions) {
    const MeshShape shape(workload.meshes.front().mesh);
    const Body body(shape, workload.bodies.front().pose);
    QueryMemory memory;
    std::vector<double> plain, proven, shares, bytes, steps;
    for (std::size_t k = 0; k < std::min<std::size_t>(workload.segments.size(), 200); ++k) {
        const Segment& segment = workload.segments[k];
        plain.push_back(microseconds(repetitions, [&] { (void)first_hit(segment, body, memory); }));
        proven.push_back(microseconds(repetitions, [&] { (void)certify_hit(segment, body, memory); }));
        shares.push_back(proven.back() / plain.back());
        const Certificate certificate = certify_hit(segment, body, memory);
        bytes.push_back(static_cast<double>(certificate.to_string().size()));
        steps.push_back(static_cast<double>(certificate.step_count()));
    }
    return {workload.name,
            fmt::format("{:.1f}", median(plain)),
            fmt::format("{:.1f}", median(proven)),
            fmt::format("{:.1f}", median(shares)),
            fmt::format("{:.0f}", median(steps)),
            fmt::format("{:.0f}", median(bytes))};
}

Table table_of_hits(const SuiteOptions& options) {
    Table table;
    table.title = "First hits of segments with their proof";
    table.text_columns = 1;
    table.header = {"segments", "plain us", "with proof us", "proof/plain", "steps", "bytes"};
    const auto size = options.is_quick() ? scenes::WorkloadSize::tiny : scenes::WorkloadSize::full;
    for (const scenes::SegmentWorkload& workload : scenes::segment_workloads(size)) {
        if (workload.bodies.size() == 1) table.rows.push_back(measure_hits(workload, 3 * options.repetition_count));
    }
    return table;
}

}  // namespace

SuiteResult run_certificates(const SuiteOptions& options) {
    Table table;
    table.title = "Answers with their proof, at a gap of 1e-4 radii";
    table.text_columns = 2;
    table.header = {"bodies", "question", "plain us", "with proof us", "and text us", "proof/plain", "steps", "bytes"};
    std::vector<scenes::MeshPairs> workloads = {
        scenes::gap_pairs("ship", scenes::ship(), 1e-4, options.is_quick() ? 4 : 100, 5),
        scenes::gap_pairs("torus 10k", scenes::torus(100, 50, 0.4), 1e-4, options.is_quick() ? 4 : 40, 5)};
    if (!options.is_quick())
        workloads.push_back(scenes::gap_pairs("torus 100k", scenes::torus(400, 125, 0.4), 1e-4, 20, 5));
    const std::size_t repetitions = 3 * options.repetition_count;
    for (const scenes::MeshPairs& pairs : workloads) {
        for (const Question& question : questions()) table.rows.push_back(measure(question, pairs, repetitions));
    }
    table.notes = {
        "Pairs that are apart; medians. Whether the proofs hold is for the checkers of verify/certificates."};
    print(table);
    const Table hits = table_of_hits(options);
    print(hits);
    SuiteResult result;
    result.sections.push_back({"Certificates", {"What a proof costs beside the plain answer."}, {table, hits}, {}});
    return result;
}

}  // namespace ecods::bench
