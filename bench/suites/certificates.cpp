// What an answer with its proof costs beside the plain answer, and how long its text is.
#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "ecods/certificate.hpp"
#include "ecods/distance.hpp"
#include "ecods/hit.hpp"
#include "ecods/intersection.hpp"
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
    std::function<void(const Body& a, const Body& b, double d, const Ask& ask)> answer;
    std::function<Certificate(const Body& a, const Body& b, double d, const Ask& ask)> certify;
};

std::vector<Question> questions() {
    return {{"relation", [](const Body& a, const Body& b, double, const Ask& ask) { (void)intersects(a, b, ask); },
             [](const Body& a, const Body& b, double, const Ask& ask) { return certify(a, b, ask); }},
            {"distance", [](const Body& a, const Body& b, double, const Ask& ask) { (void)distance(a, b, ask); },
             [](const Body& a, const Body& b, double, const Ask& ask) { return certify_distance(a, b, ask); }},
            {"beyond half the distance",
             [](const Body& a, const Body& b, double d, const Ask& ask) { (void)within(a, b, d / 2, ask); },
             [](const Body& a, const Body& b, double d, const Ask& ask) { return certify_within(a, b, d / 2, ask); }}};
}

template <class Call>
double microseconds(std::size_t repetitions, const Call& call) {
    std::vector<double> times;
    for (std::size_t k = 0; k < repetitions; ++k) {
        const Stopwatch watch;
        call();
        times.push_back(1e-3 * watch.nanoseconds());
    }
    return median(times);
}

// What an answer costs with its proof beside the plain one: of each question asked, medians over the repetitions.
class Costs {
  public:
    explicit Costs(std::size_t repetitions) : repetitions_(repetitions) {}

    void add(const std::function<void()>& ask, const std::function<Certificate()>& certify) {
        const Certificate certificate = certify();
        std::string text = certificate.to_string();
        plain_.push_back(microseconds(repetitions_, ask));
        proven_.push_back(microseconds(repetitions_, [&] { (void)certify(); }));
        written_.push_back(microseconds(repetitions_, [&] { text = certify().to_string(); }));
        shares_.push_back(proven_.back() / plain_.back());
        bytes_.push_back(static_cast<double>(text.size()));
        steps_.push_back(static_cast<double>(certificate.step_count()));
    }

    // Medians over all that was asked, behind these names.
    std::vector<std::string> row(std::vector<std::string> names, bool has_text) const {
        const auto add = [&](const std::vector<double>& values, int digits) {
            names.push_back(fmt::format("{:.{}f}", median(values), digits));
        };
        add(plain_, 1);
        add(proven_, 1);
        if (has_text) add(written_, 1);
        add(shares_, 1);
        add(steps_, 0);
        add(bytes_, 0);
        return names;
    }

  private:
    std::size_t repetitions_;
    std::vector<double> plain_, proven_, written_, shares_, bytes_, steps_;
};

std::vector<std::string> measure_pairs(const Question& question, const scenes::MeshPairs& pairs,
                                       std::size_t repetitions) {
    const MeshShape shape(pairs.meshes.front().mesh);
    QueryMemory memory;
    Costs costs(repetitions);
    for (const scenes::MeshQuery& query : pairs.queries) {
        const Body a(shape, query.a.pose), b(shape, query.b.pose);
        const double d = distance(a, b, memory);
        if (d == 0) continue;
        costs.add([&] { question.answer(a, b, d, memory); }, [&] { return question.certify(a, b, d, memory); });
    }
    return costs.row({pairs.name, question.name}, true);
}

// The segments of a workload of one body; those that miss are asked, too.
std::vector<std::string> measure_hits(const scenes::SegmentWorkload& workload, std::size_t repetitions) {
    const MeshShape shape(workload.meshes.front().mesh);
    const Body body(shape, workload.bodies.front().pose);
    QueryMemory memory;
    Costs costs(repetitions);
    for (const Segment& segment :
         std::span(workload.queries).first(std::min<std::size_t>(workload.queries.size(), 200)))
        costs.add([&] { (void)first_hit(segment, body, memory); }, [&] { return certify_hit(segment, body, memory); });
    return costs.row({workload.name}, false);
}

Table table_of_hits(const SuiteOptions& options) {
    Table table{.title = "First hits of segments with their proof",
                .header = {"segments", "plain us", "with proof us", "proof/plain", "steps", "bytes"}};
    for (const scenes::SegmentWorkload& workload : scenes::segment_workloads(options.workload_size())) {
        if (workload.bodies.size() == 1) table.rows.push_back(measure_hits(workload, 3 * options.repetition_count));
    }
    return table;
}

}  // namespace

SuiteResult run_certificates(const SuiteOptions& options) {
    Table table{
        .title = "Answers with their proof, at a gap of 1e-4 radii",
        .header = {"bodies", "question", "plain us", "with proof us", "and text us", "proof/plain", "steps", "bytes"},
        .text_columns = 2,
        .notes = {
            "Pairs that are apart; medians. Whether the proofs hold is for the checkers of verify/certificates."}};
    std::vector<scenes::MeshPairs> workloads = {
        scenes::gap_pairs("ship", scenes::ship(), 1e-4, options.is_quick() ? 4 : 100, 5),
        scenes::gap_pairs("torus 10k", scenes::torus(100, 50, 0.4), 1e-4, options.is_quick() ? 4 : 40, 5)};
    if (!options.is_quick())
        workloads.push_back(scenes::gap_pairs("torus 100k", scenes::torus(400, 125, 0.4), 1e-4, 20, 5));
    const std::size_t repetitions = 3 * options.repetition_count;
    for (const scenes::MeshPairs& pairs : workloads) {
        for (const Question& question : questions()) table.rows.push_back(measure_pairs(question, pairs, repetitions));
    }
    print(table);
    const Table hits = table_of_hits(options);
    print(hits);
    SuiteResult result;
    result.sections.push_back({"Certificates", {"What a proof costs beside the plain answer."}, {table, hits}, {}});
    return result;
}

}  // namespace ecods::bench
