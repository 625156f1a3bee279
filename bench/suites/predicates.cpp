// The exact layer on its own: its price against plain double, its distance to CGAL's exact kernel, and what decided.
#include <fmt/core.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>

#include "harness/statistics.hpp"
#include "harness/stopwatch.hpp"
#include "oracle/oracle.hpp"
#include "process/progress.hpp"
#include "scenes/shapes.hpp"
#include "suites/comparison.hpp"
#include "suites/suite.hpp"
#include "suites/triangle_engines.hpp"

namespace ecods::bench {
namespace {

struct Timed {
    Answers answers;
    double ns = 0;  // per pair
};

template <class Decide>
Timed timed(const PredicateScene& scene, Decide&& decide) {
    const Stopwatch stopwatch;
    Timed result{decide(scene), 0};
    result.ns = stopwatch.nanoseconds() / static_cast<double>(result.answers.size());
    return result;
}

std::size_t count_differences(const Answers& answers, const Answers& right) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < right.size(); ++i) count += answers[i] != right[i];
    return count;
}

// The two whose ratio counts, one after the other in each repetition, so that a change of the machine's pace meets
// both.
struct Price {
    Answers plain, exact;
    std::vector<double> plain_ns = {}, exact_ns = {};
    std::vector<double> exact_ratio = {};  // to plain double of the same repetition
    StageCounts counts = {};               // of one pass
};

Price find_price(const PredicateScene& scene, std::size_t repetition_count) {
    Price price;
    price.plain = decide_plainly(scene);  // these passes also warm up
    price.exact = decide_exactly(scene, &price.counts);
    for (std::size_t i = 0; i < repetition_count; ++i) {
        price.plain_ns.push_back(timed(scene, decide_plainly).ns);
        price.exact_ns.push_back(timed(scene, [](const PredicateScene& s) { return decide_exactly(s); }).ns);
        price.exact_ratio.push_back(price.exact_ns.back() / price.plain_ns.back());
    }
    return price;
}

struct EpeckPrice {
    Answers answers;
    double ns = 0;
    double ratio = 0;  // to ECoDS
};

// Each pass right after one of ECoDS. Slow scenes have one pass only: it takes seconds, and the factor is in the
// hundreds.
EpeckPrice find_epeck_price(const PredicateScene& scene, std::size_t repetition_count) {
    EpeckPrice price;
    std::vector<double> times, ratios;
    double seconds = 0;
    while (times.empty() || (times.size() < repetition_count && seconds < 1)) {
        const Timed exact = timed(scene, [](const PredicateScene& s) { return decide_exactly(s); });
        Timed epeck = timed(scene, decide_by_epeck);
        times.push_back(epeck.ns);
        ratios.push_back(epeck.ns / exact.ns);
        seconds += epeck.ns * 1e-9 * static_cast<double>(epeck.answers.size());
        price.answers = std::move(epeck.answers);
    }
    price.ns = median(times);
    price.ratio = median(ratios);
    return price;
}

// Differences from the oracle on pairs spread evenly over the scene.
struct Check {
    std::size_t pair_count = 0;
    std::size_t wrong = 0;
};

Check check(const PredicateScene& scene, const Answers& answers, std::size_t pair_count) {
    const std::size_t step = std::max<std::size_t>(1, answers.size() / pair_count);
    Check result;
    std::size_t index = 0;
    for (const PredicateTask& task : scene.tasks) {
        const PredicateBody &a = scene.bodies[task.a], &b = scene.bodies[task.b];
        const auto corners = [](const Mesh& mesh, std::uint32_t triangle) {
            const Triangle& t = mesh.triangles()[triangle];
            return std::array<Vec3, 3>{mesh.vertices()[t[0]], mesh.vertices()[t[1]], mesh.vertices()[t[2]]};
        };
        for (const TrianglePair pair : task.pairs) {
            if (index++ % step != 0) continue;
            const Relation truth =
                oracle::triangle_triangle(a.pose, corners(*a.mesh, pair.a), b.pose, corners(*b.mesh, pair.b));
            ++result.pair_count;
            result.wrong += (truth != Relation::apart) != (answers[index - 1] != 0);
        }
    }
    return result;
}

// Two bodies of which every triangle is asked about with every one of the other: most points come from the caches.
PredicateScene all_against_all(std::uint32_t detail) {
    PredicateScene scene{"two spheres, every triangle with every other", 0, 0, {}, {}};
    const auto sphere = scenes::sphere(2 * detail, detail + 1);
    scene.bodies = {{sphere, {}}, {sphere, {}}};
    scene.bodies[1].pose.R = Eigen::Quaterniond(0.5, 0.1, 0.7, -0.3).normalized().toRotationMatrix();
    scene.bodies[1].pose.t = Vec3(0.7, 0.2, 0.1);
    PredicateTask task{0, 1, {}};
    const auto count = static_cast<std::uint32_t>(sphere->triangles().size());
    for (std::uint32_t a = 0; a < count; ++a) {
        for (std::uint32_t b = 0; b < count; ++b) task.pairs.push_back({a, b});
    }
    scene.tasks.push_back(std::move(task));
    return scene;
}

std::string percent(double part, double whole) {
    return fmt::format("{:.1f}", 100 * part / whole);
}
std::string ns(double value) {
    return fmt::format("{:.1f}", value);
}

struct Tables {
    Table times, ratios, wrong, stages, all_pairs;
};

Tables empty_tables(std::size_t repetition_count) {
    Tables tables;
    tables.times.title = "Triangle pairs, nanoseconds each, vertex transforms included";
    tables.times.header = {"scene", "pairs", "hits %", "plain double", "ECoDS", "Epick", "Epeck"};
    tables.times.notes = {
        "Pairs are those whose boxes overlap, few for each body. Plain double: the same code, its signs at face value.",
        "Epick: CGAL's filtered kernel on rounded vertices, so it answers another question. Epeck: its exact kernel on "
        "exactly transformed points."};
    tables.ratios.title = "What exactness costs: ratios of these times";
    tables.ratios.header = {"scene", "ECoDS/plain", "quartiles", "must", "aim", "reached", "Epeck/ECoDS", "10 times"};
    tables.ratios.notes = {fmt::format("Of processor times: {} after a warm-up.", medians_of(repetition_count))};
    tables.wrong.title = "Wrong answers on these pairs";
    tables.wrong.header = {"scene", "pairs", "plain double",        "%",          "Epick",
                           "%",     "Epeck", "asked of the oracle", "ECoDS wrong"};
    tables.wrong.notes = {"Counted against ECoDS, which is itself checked with the oracle on pairs spread evenly."};
    tables.stages.title = "Which stage decided, percent of the pairs";
    tables.stages.header = {"scene"};
    for (const Stage& stage : stages) tables.stages.header.emplace_back(stage.name);
    tables.all_pairs.title = "Every triangle of a sphere with every one of another: most points come from the caches";
    tables.all_pairs.header = {"way", "ns per pair", "to plain double"};
    return tables;
}

void add_rows(Tables& tables, const PredicateScene& scene, const Price& price, const Timed& epick,
              const EpeckPrice& epeck, const Check& checked) {
    const std::size_t count = price.exact.size();
    const auto all = static_cast<double>(count);
    const auto hits = static_cast<double>(std::count(price.exact.begin(), price.exact.end(), 1));
    tables.times.rows.push_back({scene.name, fmt::format("{}", count), percent(hits, all), ns(median(price.plain_ns)),
                                 ns(median(price.exact_ns)), ns(epick.ns), ns(epeck.ns)});
    const double ratio = median(price.exact_ratio);
    tables.ratios.rows.push_back(
        {scene.name, fmt::format("{:.2f}", ratio),
         fmt::format("{:.2f}-{:.2f}", quantile(price.exact_ratio, 0.25), quantile(price.exact_ratio, 0.75)),
         fmt::format("{:.2f}", scene.must), fmt::format("{:.2f}", scene.aim),
         ratio <= scene.aim    ? "aim"
         : ratio <= scene.must ? "must"
                               : "no",
         fmt::format("{:.1f}", epeck.ratio), epeck.ratio >= 10 ? "yes" : "no"});
    const std::size_t plain_wrong = count_differences(price.plain, price.exact);
    const std::size_t epick_wrong = count_differences(epick.answers, price.exact);
    tables.wrong.rows.push_back({scene.name, fmt::format("{}", count), fmt::format("{}", plain_wrong),
                                 percent(static_cast<double>(plain_wrong), all), fmt::format("{}", epick_wrong),
                                 percent(static_cast<double>(epick_wrong), all),
                                 fmt::format("{}", count_differences(epeck.answers, price.exact)),
                                 fmt::format("{}", checked.pair_count), fmt::format("{}", checked.wrong)});
    std::vector<std::string> row{scene.name};
    for (const Stage& stage : stages) {
        const auto tests = static_cast<double>(price.counts.triangle_tests);
        row.push_back(percent(static_cast<double>(price.counts.*stage.count), tests));
    }
    tables.stages.rows.push_back(std::move(row));
}

void add_all_pairs_rows(Table& table, const PredicateScene& scene, std::size_t repetition_count) {
    const Price price = find_price(scene, repetition_count);
    const auto add = [&](const char* name, const std::vector<double>& times, double ratio) {
        table.rows.push_back({name, fmt::format("{:.2f}", median(times)), fmt::format("{:.2f}", ratio)});
    };
    add("plain double", price.plain_ns, 1);
    add("ECoDS", price.exact_ns, median(price.exact_ratio));
    const auto hits = std::count(price.exact.begin(), price.exact.end(), 1);
    table.notes = {fmt::format("{} pairs of triangles, {} of which meet.", price.exact.size(), hits)};
}

}  // namespace

SuiteResult run_predicates(const SuiteOptions& options) {
    const std::size_t repetition_count = options.is_quick() ? 1 : 15;
    const std::vector<PredicateScene> scenes = predicate_scenes(options.is_quick() ? 80 : 300);
    SuiteResult result;
    Tables tables = empty_tables(repetition_count);
    {
        process::Progress progress("predicates", scenes.size() + 1);
        for (const PredicateScene& scene : scenes) {
            const Price price = find_price(scene, repetition_count);
            const Timed epick = timed(scene, decide_by_epick);
            const EpeckPrice epeck = find_epeck_price(scene, repetition_count);
            const Check checked = check(scene, price.exact, options.is_quick() ? 300 : 3000);
            add_rows(tables, scene, price, epick, epeck, checked);
            result.is_right &= checked.wrong == 0 && count_differences(epeck.answers, price.exact) == 0;
            progress.step();
        }
        const PredicateScene spheres = all_against_all(options.is_quick() ? 6 : 16);
        add_all_pairs_rows(tables.all_pairs, spheres, repetition_count);
        progress.step();
    }
    for (const Table* table : {&tables.times, &tables.ratios, &tables.wrong, &tables.stages, &tables.all_pairs})
        print(*table);
    result.sections.push_back(
        {"The price of exactness",
         {"Each pair of triangles is decided for the real points R v + t. The same code without filter and exact "
          "stage, "
          "plain "
          "double taken at face value, is the yardstick: ECoDS/plain is what exactness costs. In the generic scenes "
          "the "
          "filter "
          "decides; in the others nearly all pairs are degenerate, contacts by construction, and the integers do.",
          "The factor over Epeck is what the same answers cost with CGAL's exact kernel. The scenes are small on "
          "purpose: "
          "nothing but triangle pairs is timed, no tree and no broad phase."},
         {tables.times, tables.ratios, tables.wrong, tables.stages, tables.all_pairs},
         {}});
    return result;
}

}  // namespace ecods::bench
