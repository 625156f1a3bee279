// Pairs of spheres, capsules and boxes: do they touch, how far are they, and where are they closest?
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "ecods/builders.hpp"
#include "ecods/rounded.hpp"
#include "engines/rounded_engine.hpp"
#include "oracle/rounded.hpp"
#include "scenes/random.hpp"
#include "suites/comparison.hpp"
#include "suites/query_suite.hpp"

namespace ecods::bench {

namespace {

std::shared_ptr<const Mesh> core_of(const RoundBody& body) {
    const Vec3 end(0, 0, body.size);
    if (body.kind == RoundKind::sphere) return sphere(1)->core().mesh_ptr();
    if (body.kind == RoundKind::capsule) return capsule(-end, end, 1)->core().mesh_ptr();
    return box(Vec3::Constant(2 * body.size))->mesh_ptr();
}

oracle::ExactClosest closest_cores(const RoundBody& a, const Pose& pose_a, const RoundBody& b, const Pose& pose_b) {
    const auto x = core_of(a), y = core_of(b);
    return oracle::MeshDistances({x->vertices(), x->triangles(), pose_a}, {y->vertices(), y->triangles(), pose_b})
        .closest();
}

RoundAnswer ask_oracle(const RoundWorkload& workload, const RoundQuery& query) {
    const RoundBody &a = workload.bodies[query.a.body_index], &b = workload.bodies[query.b.body_index];
    const oracle::RoundedDistance truth(closest_cores(a, query.a.pose, b, query.b.pose), a.radius, b.radius);
    switch (workload.question) {
        case RoundQuestion::intersects:
            return {truth.compare(0) <= 0 ? 1.0 : 0.0};
        case RoundQuestion::distance:
            return {truth.distance()};
        case RoundQuestion::signed_distance:
            return {truth.signed_distance()};
        default:
            const Vec3 x = truth.point(0), y = truth.point(1);
            return {truth.distance(), {x.x(), x.y(), x.z(), y.x(), y.y(), y.z()}};
    }
}

// Half of the pairs overlap a little, half are a little apart. Centers of spheres and axes are outside of boxes.
std::vector<RoundQuery> queries_of(const RoundWorkload& workload, std::size_t count, scenes::Random& random) {
    std::vector<RoundQuery> queries;
    while (queries.size() < count) {
        const auto half = static_cast<std::uint32_t>(workload.bodies.size() / 2);
        RoundQuery query{{random.below(half), random.turned()}, {half + random.below(half), random.turned()}};
        const double reach = workload.bodies[query.a.body_index].reach() + workload.bodies[query.b.body_index].reach();
        query.a.pose.t = random.direction() * random.uniform(0, 10);
        query.b.pose.t = query.a.pose.t + random.direction() * (reach * random.uniform(0.2, 1.2));
        const Posed<Rounded> point(sphere(0), Pose{Mat3::Identity(), query.a.pose.t});
        const RoundBody& b = workload.bodies[query.b.body_index];
        if (b.kind == RoundKind::box &&
            intersects(point, Posed<MeshShape>(box(Vec3::Constant(2 * b.size)), query.b.pose))) {
            continue;
        }
        queries.push_back(query);
    }
    return queries;
}

std::vector<RoundWorkload> round_workloads(bool is_quick) {
    struct Kinds {
        RoundKind a, b;
        const char* name;
    };
    struct NamedQuestion {
        RoundQuestion question;
        const char* name;
    };
    std::vector<RoundWorkload> workloads;
    for (const Kinds& kinds : {Kinds{RoundKind::sphere, RoundKind::sphere, "two spheres"},
                               Kinds{RoundKind::sphere, RoundKind::capsule, "sphere and capsule"},
                               Kinds{RoundKind::capsule, RoundKind::capsule, "two capsules"},
                               Kinds{RoundKind::sphere, RoundKind::box, "sphere and box"}}) {
        scenes::Random random(7);
        RoundWorkload workload;
        for (const RoundKind kind : {kinds.a, kinds.b}) {
            for (int i = 0; i < 8; ++i) {
                const double radius = kind == RoundKind::box ? 0 : random.uniform(0.2, 0.5);
                workload.bodies.push_back({kind, radius, kind == RoundKind::sphere ? 0 : random.uniform(0.3, 0.8)});
            }
        }
        workload.queries = queries_of(workload, is_quick ? 40 : 2000, random);
        for (const NamedQuestion& asked :
             {NamedQuestion{RoundQuestion::intersects, "touch"}, NamedQuestion{RoundQuestion::distance, "distance"},
              NamedQuestion{RoundQuestion::signed_distance, "signed distance"},
              NamedQuestion{RoundQuestion::closest, "closest points"}}) {
            workload.name = fmt::format("{}, {}", kinds.name, asked.name);
            workload.question = asked.question;
            workloads.push_back(workload);
        }
    }
    return workloads;
}

struct RoundErrors {
    std::size_t contradicted = 0;  // said to touch where apart, or the other way round
    std::vector<double> sizes;     // absolute errors of numbers
    std::size_t wrong = 0;         // whatever is not the true answer, rounded once
};

struct RoundSuite {
    using Question = Round;
    using Truth = RoundAnswer;
    using Errors = RoundErrors;

    static std::size_t judged_count(const RoundWorkload& /*workload*/, const SuiteOptions& options) {
        return options.is_quick() ? 10 : 200;
    }

    static Truths<RoundAnswer> find_truths(const RoundWorkload& workload, std::size_t judged_count) {
        const auto own = ecods_round().front().set_up(workload);
        return bench::find_truths<RoundAnswer>(
            workload.queries, judged_count, [&](const RoundQuery& query, std::size_t i) { return own->ask(query, i); },
            [&](const RoundQuery& query) { return ask_oracle(workload, query); });
    }

    static RoundErrors errors_of(const Run<Round>& run, const RoundWorkload& workload,
                                 const Truths<RoundAnswer>& truths) {
        RoundErrors errors;
        for (std::size_t i = 0; i < run.answers.size(); ++i) {
            const RoundAnswer &answer = run.answers[i], &exact = truths.answers[i];
            if (answer != exact) ++errors.wrong;
            if (workload.question == RoundQuestion::intersects) {
                errors.contradicted += answer.number != exact.number ? 1 : 0;
                continue;
            }
            // FCL says -1 where bodies overlap, unless it is asked for a sign.
            const bool has_sign = workload.question == RoundQuestion::signed_distance;
            const double number = has_sign ? answer.number : std::max(answer.number, 0.0);
            errors.contradicted += (number > 0) != (exact.number > 0) ? 1 : 0;
            errors.sizes.push_back(std::abs(number - exact.number));
        }
        return errors;
    }

    static std::vector<std::string> cells(const Measured<RoundSuite>& measured, std::size_t i) {
        const auto times = [&](const char* yardstick) {
            return ratio_text(times_as_fast(measured.runs[i].us, measured.us_of(yardstick)));
        };
        const auto errors = median_and_most(measured.errors[i].sizes, error_text);
        return {times(round_fcl),
                times(round_bullet),
                fmt::format("{}", measured.errors[i].contradicted),
                errors[0],
                errors[1],
                measured.wrong_text(i),
                fmt::format("{} / {}", measured.truths.judged_count, measured.truths.answers.size())};
    }

    static std::optional<double> error(const Measured<RoundSuite>& measured, std::size_t i) {
        return static_cast<double>(measured.errors[i].contradicted) /
               static_cast<double>(measured.truths.answers.size());
    }

    static Table table(std::size_t repetition_count) {
        return timed_table(
            "Spheres, capsules and boxes",
            {"times FCL", "times Bullet", "contradicted", "median error", "most error", "wrong", "judged"},
            repetition_count,
            {"Times FCL, times Bullet: how many times as fast as these, in the same repetition. Contradicted: said to "
             "touch where apart, or apart where they touch. Errors: absolute, of numbers; bodies are of a size of "
             "about "
             "1. Wrong: answers of ECoDS that are not the true numbers and points, rounded once. Judged: so many of "
             "the "
             "true answers are the oracle's; the others are those of ECoDS."});
    }
};

}  // namespace

SuiteResult run_rounded(const SuiteOptions& options) {
    const std::vector<RoundMaker> makers = options.wanted(round_engines());
    SuiteResult result;
    const std::vector<RoundWorkload> workloads = round_workloads(options.is_quick());
    Table table = RoundSuite::table(options.repetition_count);
    measure_all<RoundSuite>(
        workloads, makers, options, "rounded", [&](const RoundWorkload&) { return &table; }, result);
    print(table);
    result.sections.push_back({"Spheres, capsules and boxes",
                               {},
                               {table, use_table("How each engine is asked", makers, "Setting poses is timed.")},
                               {}});
    return result;
}

}  // namespace ecods::bench
