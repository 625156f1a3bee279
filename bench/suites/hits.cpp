// Segments against a mesh, and against many bodies: times and errors of every engine of hits.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "ecods/hit.hpp"
#include "engines/hit_engine.hpp"
#include "engines/own_hits.hpp"
#include "judge/hit_truth.hpp"
#include "suites/comparison.hpp"
#include "suites/parts.hpp"
#include "suites/query_suite.hpp"

namespace ecods::bench {

namespace {

using scenes::SegmentWorkload;

struct HitErrors : Errors {                // nothing reported where something is hit, and the other way round
    std::size_t other_triangles = 0;       // a triangle that is none of those hit first
    std::vector<double> parameter_errors;  // absolute, of segments that are hit and reported so
    std::size_t wrong = 0;
};

// All hits of a segment by the library, of triangles that are numbered through: a world's where there are several
// bodies.
class OwnHits {
  public:
    explicit OwnHits(const SegmentWorkload& workload)
        : is_world_(workload.bodies.size() > 1), posed_(workload.meshes), body_(posed_(workload.bodies.front())) {
        if (is_world_) world_.emplace(workload);
    }

    std::vector<Hit> operator()(const Segment& segment) {
        if (!is_world_) return all_hits(segment, body_, memory_);
        std::vector<Hit> hits;
        for (const BodyHit& of_body : world_->world().all_hits(segment, {}, memory_)) {
            hits.push_back(of_body.hit);
            hits.back().feature.triangle = world_->triangle_of(of_body);
        }
        return hits;
    }

  private:
    bool is_world_;
    OwnShapes<MeshShape> posed_;
    Posed<MeshShape> body_;
    std::optional<SegmentWorld> world_;
    QueryMemory memory_;
};

// Whether they may meet: doubtful ones do.
bool is_near(const Segment& segment, const Vec3& middle, double radius) {
    const Vec3 arm = segment.b - segment.a, to = middle - segment.a;
    const double along = arm.squaredNorm() > 0 ? std::clamp(to.dot(arm) / arm.squaredNorm(), 0.0, 1.0) : 0;
    return (to - along * arm).norm() <= 1.01 * radius + 0.01;
}

// Farther from its origin no vertex of the mesh is.
double reach_of(const Mesh& mesh) {
    double reach = 0;
    for (const Vec3& v : mesh.vertices()) reach = std::max(reach, v.norm());
    return reach;
}

// All bodies are asked about, and the hits are as the library writes them.
std::vector<Hit> ask_oracle(const SegmentWorkload& workload, const OwnShapes<MeshShape>& posed,
                            const Segment& segment) {
    const std::vector<std::uint32_t> firsts = first_triangles(workload);
    std::vector<double> reaches;
    for (const scenes::NamedMesh& named : workload.meshes) reaches.push_back(reach_of(*named.mesh));
    std::vector<oracle::ExactHit> all;
    for (std::size_t i = 0; i < workload.bodies.size(); ++i) {
        const scenes::MeshAt& body = workload.bodies[i];
        if (!is_near(segment, body.pose.t, reaches[body.mesh_index])) continue;
        for (oracle::ExactHit& hit : judge::exact_hits(segment, posed(body))) {
            hit.feature.triangle += firsts[i];
            all.push_back(std::move(hit));
        }
    }
    std::ranges::stable_sort(all, {}, &oracle::ExactHit::enter);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const bool is_tie = i > 0 && all[i].enter == all[i - 1].enter;
        all[i].rank = i == 0 ? 0 : all[i - 1].rank + (is_tie ? 0 : 1);
    }
    return judge::to_hits(all);
}

struct HitSuite {
    using Question = FirstHits;
    using Truth = std::vector<Hit>;  // all hits
    using Errors = HitErrors;

    // The oracle looks at every triangle, by rationals.
    static std::size_t judged_count(const SegmentWorkload& workload, const SuiteOptions& options) {
        if (workload.bodies.size() > 1) return 4;
        const std::size_t triangles = triangle_count(workload.meshes);
        if (options.is_quick()) return 2;
        return triangles <= 2000 ? 50 : triangles <= 20000 ? 20 : triangles <= 200000 ? 4 : 1;
    }

    static Truths<Truth> find_truths(const SegmentWorkload& workload, std::size_t judged_count) {
        OwnHits own(workload);
        const OwnShapes<MeshShape> posed(workload.meshes);
        return bench::find_truths<Truth>(
            workload.queries, judged_count, [&](const Segment& segment, std::size_t) { return own(segment); },
            [&](const Segment& segment) { return ask_oracle(workload, posed, segment); },
            [](const Truth& x, const Truth& y) {
                return std::ranges::equal(x, y, [](const Hit& a, const Hit& b) { return judge::is_same(a, b); });
            });
    }

    static HitErrors errors_of(const Run<FirstHits>& run, const SegmentWorkload& /*workload*/,
                               const Truths<Truth>& truths) {
        HitErrors errors;
        for (std::size_t i = 0; i < run.answers.size(); ++i) {
            const HitAnswer& answer = run.answers[i];
            const std::vector<Hit>& list = truths.answers[i];
            const bool is_reported = !std::isnan(answer.parameter);
            if (list.empty() || !is_reported) {
                errors.false_positives += is_reported;
                errors.false_negatives += !list.empty();
                errors.wrong += is_reported || !list.empty();
                continue;
            }
            const Hit& first = list.front();
            errors.parameter_errors.push_back(std::abs(answer.parameter - first.parameter));
            errors.other_triangles += std::ranges::none_of(
                list, [&](const Hit& hit) { return hit.rank == 0 && hit.triangle() == answer.triangle; });
            errors.wrong += answer.parameter != first.parameter || answer.triangle != first.triangle();
        }
        return errors;
    }

    // Chords are those of the same mesh; their column is filled in where ECoDS's times for them are known.
    static std::vector<std::string> cells(const Measured<HitSuite>& measured, std::size_t i) {
        const Run<FirstHits>& run = measured.runs[i];
        const HitErrors& errors = measured.errors[i];
        const auto hit_count =
            std::ranges::count_if(measured.truths.answers, [](const Truth& list) { return !list.empty(); });
        const std::vector<double>& parameters = errors.parameter_errors;
        return {share_text(run.us, measured.us_of(hit_yardstick)),
                "",
                fmt::format("{} / {}", hit_count, measured.workload.queries.size()),
                fmt::format("{}", errors.false_negatives),
                fmt::format("{}", errors.false_positives),
                fmt::format("{}", errors.other_triangles),
                error_text(median(parameters)),
                error_text(parameters.empty() ? 0 : *std::ranges::max_element(parameters)),
                measured.wrong_text(i),
                fmt::format("{}", measured.truths.judged_count)};
    }

    static std::optional<double> error(const Measured<HitSuite>& measured, std::size_t i) {
        const Run<FirstHits>& run = measured.runs[i];
        if (run.maker->traits.is_for_paths) return std::nullopt;
        const std::size_t bad = measured.errors[i].count() + measured.errors[i].other_triangles;
        return static_cast<double>(bad) / static_cast<double>(run.answers.size());
    }

    static Table table(std::size_t repetition_count) {
        return timed_table(
            "Segments against a mesh: what is hit first?",
            {"of Embree", "of chords", "hit", "false -", "false +", "other triangle", "median error", "most error",
             "wrong", "judged"},
            repetition_count,
            {fmt::format(
                 "Of Embree: time over that of {}, in the same repetition, less is better. Of chords: over ECoDS's "
                 "for chords of the same mesh.",
                 hit_yardstick),
             "False -: nothing reported, though the segment hits the closed triangles at their exact places. False +: "
             "reported where it hits none. Other triangle: none of those that share the first point. Errors: of the "
             "parameter, from 0 to 1. Wrong: answers of ECoDS that are not the true parameter, rounded once, and the "
             "least triangle.",
             "Judged: so many of the lists of all hits are the oracle's; the others are those of ECoDS. Peers are "
             "given "
             "the posed vertices, rounded: those in float round once more. Of an Embree that answers sixteen segments "
             "in "
             "one call there is a row, as ECoDS takes one at a time; rtcIntersect1M() and a batch in many threads were "
             "not asked."});
    }
};

using HitMeasured = Measured<HitSuite>;

// Fills in the column of chords, which begins behind those of every timed table and "of Embree". `own_chords` are
// ECoDS's times for the first workload of each mesh.
void add_chords(Table& table, const std::vector<HitMeasured>& all) {
    constexpr std::size_t column = 5;
    std::map<const Mesh*, std::span<const double>> own_chords;
    std::size_t row = 0;
    for (const HitMeasured& measured : all) {
        const std::span<const double> own =
            measured.us_of(measured.workload.bodies.size() > 1 ? own_world_hits : own_hits);
        const auto chords = own_chords.try_emplace(measured.workload.meshes.front().mesh.get(), own).first->second;
        for (const Run<FirstHits>& run : measured.runs) {
            if (run.maker->is_ecods && run.failure.empty()) table.rows[row][column] = share_text(run.us, chords);
            ++row;
        }
    }
}

void add_list_rows(Table& table, const HitMeasured& measured, const std::vector<HitMaker>& makers,
                   std::size_t repetition_count, bool& is_right) {
    std::vector<std::vector<std::uint32_t>> truth;
    for (const std::vector<Hit>& hits : measured.truths.answers) {
        std::vector<std::uint32_t>& triangles = truth.emplace_back();
        for (const Hit& hit : hits) triangles.push_back(hit.triangle());
        std::ranges::sort(triangles);
    }
    const auto runs = measure_lists<FirstHits>(measured.workload, makers, truth, repetition_count);
    std::span<const double> yardstick;
    for (const ListRun<FirstHits>& run : runs)
        if (run.maker->name == hit_yardstick) yardstick = run.us;
    for (const ListRun<FirstHits>& run : runs) {
        is_right &= !run.maker->is_ecods || (run.failure.empty() && run.errors.count() == 0);
        add_row(table, {measured.workload.name, run.maker->name, run.us, run.failure}, [&] {
            const auto count = static_cast<double>(measured.workload.queries.size());
            return std::vector<std::string>{
                share_text(run.us, yardstick), fmt::format("{:.2f}", run.item_count / count),
                fmt::format("{}", run.errors.false_negatives), fmt::format("{}", run.errors.false_positives)};
        });
    }
}

}  // namespace

SuiteResult run_hits(const SuiteOptions& options) {
    const std::vector<HitMaker> makers = options.wanted(hit_engines());
    SuiteResult result;
    if (makers.empty()) return result;
    const std::vector<SegmentWorkload> workloads = scenes::segment_workloads(options.workload_size());
    Table table = HitSuite::table(options.repetition_count);
    const auto all = measure_all<HitSuite>(
        workloads, makers, options, "hits", [&](const SegmentWorkload&) { return &table; }, result);
    add_chords(table, all);
    print(table);
    Table lists = timed_table(
        "Segments against a mesh: all triangles that are hit", {"of Embree", "hits/segment", "false -", "false +"},
        options.repetition_count,
        {"False: triangles that are not listed, and that are listed and not hit, of all segments. ECoDS's lists have "
         "exact order, points and features, the others triangles alone."});
    for (const HitMeasured& measured : all)
        add_list_rows(lists, measured, makers, options.repetition_count, result.is_right);
    print(lists);
    if (options.has_pictures) {
        result.sections.push_back(
            {"Segments: speed against error",
             {"Each engine is a point for each workload: time per segment across; up the share of segments whose first "
              "hit is missed, is none, or is another triangle. The line at 0 is no error at all."},
             {},
             {},
             {error_chart("hit-errors", panels_of("us per segment", all),
                          "Speed against error of first hits. The better engine is lower and further left.")}});
    }
    result.sections.push_back({"Segments against one mesh",
                               {},
                               {table, lists,
                                use_table("How each engine is asked for hits", makers,
                                          "Building trees, and posing vertices for the peers, is outside the times.")},
                               {}});
    return result;
}

}  // namespace ecods::bench
