// Numerical stability: how often each way to test two triangles is wrong where it is hard to be right, at what price.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "ecods/primitives.hpp"
#include "harness/statistics.hpp"
#include "harness/stopwatch.hpp"
#include "oracle/oracle.hpp"
#include "process/progress.hpp"
#include "suites/comparison.hpp"
#include "suites/sign_maps.hpp"
#include "suites/stability_families.hpp"
#include "suites/suite.hpp"
#include "suites/triangle_engines.hpp"

namespace ecods::bench {
namespace {

using scenes::PosedPair;

struct TriangleEngine {
    std::string name;
    Answers (*answer)(std::span<const PosedPair>);
};

const std::vector<TriangleEngine>& engines() {
    static const std::vector<TriangleEngine> all{{"float", answer_in_float},
                                                 {"double", answer_in_double},
                                                 {"FCL", answer_by_fcl},
                                                 {"Epick", answer_by_epick},
                                                 {"ECoDS", answer_by_ecods}};
    return all;
}

struct Measured {
    double hit_percent = 0;
    std::vector<double> wrong_percent;  // [engine]
    std::vector<double> ns;             // [engine], median
    std::size_t checked = 0;            // pairs asked of the oracle, or of which the recipe knows the answer
    std::size_t ecods_wrong = 0;        // of these
};

std::vector<Answers> time_engines(std::span<const PosedPair> pairs, std::size_t repetition_count, Measured& measured) {
    std::vector<Answers> answers(engines().size());
    std::vector<std::vector<double>> times(engines().size());
    for (std::size_t repetition = 0; repetition < repetition_count; ++repetition) {
        for (std::size_t e = 0; e < engines().size(); ++e) {
            const Stopwatch stopwatch;
            answers[e] = engines()[e].answer(pairs);
            times[e].push_back(stopwatch.nanoseconds() / static_cast<double>(pairs.size()));
        }
    }
    for (const std::vector<double>& of_engine : times) measured.ns.push_back(median(of_engine));
    return answers;
}

Measured measure_family(const StabilityFamily& family, std::size_t repetition_count, std::size_t oracle_count) {
    Measured measured;
    const std::vector<Answers> answers = time_engines(family.pairs, repetition_count, measured);
    const Answers& right = answers.back();
    const auto pair_count = static_cast<double>(right.size());
    for (const Answers& of_engine : answers) {
        std::size_t wrong = 0;
        for (std::size_t i = 0; i < right.size(); ++i) wrong += of_engine[i] != right[i];
        measured.wrong_percent.push_back(100 * static_cast<double>(wrong) / pair_count);
    }
    measured.hit_percent = 100 * static_cast<double>(std::count(right.begin(), right.end(), 1)) / pair_count;

    const std::size_t step = std::max<std::size_t>(1, right.size() / oracle_count);
    for (std::size_t i = 0; i < right.size(); ++i) {
        const PosedPair& pair = family.pairs[i];
        if (i % step == 0) {
            const bool truth = oracle::triangle_triangle(pair.pose_a, pair.a, pair.pose_b, pair.b) != Relation::apart;
            measured.ecods_wrong += truth != (right[i] != 0);
        } else if (pair.intersects) {
            measured.ecods_wrong += *pair.intersects != (right[i] != 0);
        } else {
            continue;
        }
        ++measured.checked;
    }
    return measured;
}

std::string percent(double value) {
    if (value == 0) return "0";
    return value < 0.01 ? "<0.01" : fmt::format("{:.2f}", value);
}

Table make_table(std::span<const StabilityFamily> families, std::span<const Measured> measured) {
    Table table{.title = "Wrong booleans in percent, and nanoseconds per pair", .header = {"family", "hits %"}};
    for (const TriangleEngine& engine : engines()) {
        table.header.push_back(engine.name + " %");
        table.header.push_back("ns");
    }
    table.header.insert(table.header.end(), {"checked", "wrong"});
    for (std::size_t f = 0; f < families.size(); ++f) {
        const Measured& m = measured[f];
        std::vector<std::string> row{families[f].name, fmt::format("{:.1f}", m.hit_percent)};
        for (std::size_t e = 0; e < engines().size(); ++e) {
            row.push_back(percent(m.wrong_percent[e]));
            row.push_back(fmt::format("{:.0f}", m.ns[e]));
        }
        row.push_back(fmt::format("{}", m.checked));
        row.push_back(fmt::format("{}", m.ecods_wrong));
        table.rows.push_back(std::move(row));
    }
    table.notes = {
        fmt::format("{} pairs in each row; times are medians of processor time, transforms included. Wrong: not the "
                    "answer of ECoDS, whose answers were checked as often as the last columns say, by the oracle and "
                    "where a recipe knows the answer.",
                    families.front().pairs.size()),
        "Double: world vertices rounded, then the code of ECoDS without filter and exact stage; float: the same, all "
        "in float. FCL 0.7: its triangle test, and Epick: CGAL's, both on the same rounded world vertices. Where Epick "
        "refuses, it counts as wrong. Each pair is asked once, by itself: ECoDS caches nothing here."};
    return table;
}

// Bars lie, so that the families' names can be read: each family is a line, each engine a mark on it.
Panel family_panel(std::span<const StabilityFamily> families, std::span<const Measured> measured) {
    Panel panel{.title = "",
                .x = {.title = "wrong answers, percent", .low = -2, .high = 102},
                .y = {.title = ""},
                .curves = {}};
    for (const TriangleEngine& engine : engines()) panel.curves.push_back({engine.name, {}});
    for (std::size_t f = 0; f < families.size(); ++f) {
        if (families[f].parameter != Parameter::none) continue;
        const double row = -static_cast<double>(panel.y.tics.size());
        panel.y.tics.emplace_back(families[f].name, row);
        for (std::size_t e = 0; e < engines().size(); ++e) {
            const double wrong = measured[f].wrong_percent[e];
            panel.curves[e].points.push_back(
                {wrong, row, fmt::format("{}, {}: {} % wrong", engines()[e].name, families[f].name, percent(wrong))});
        }
    }
    panel.y.low = 0.5 - static_cast<double>(panel.y.tics.size());
    panel.y.high = 0.5;
    return panel;
}

Panel curve_panel(Parameter parameter, const std::string& title, std::span<const StabilityFamily> families,
                  std::span<const Measured> measured) {
    const bool is_distance = parameter == Parameter::distance;
    Panel panel{.title = "",
                .x = {.title = is_distance ? title : title + ", power of 2", .is_logarithmic = is_distance},
                .y = {.title = "wrong answers, percent", .low = -3, .high = 103},
                .curves = {},
                .has_lines = true};
    if (is_distance) panel.x.tics = {{"1", 1}, {"10³", 1e3}, {"10⁶", 1e6}, {"10⁹", 1e9}, {"10¹²", 1e12}};
    for (std::size_t f = 0; f < families.size() && !is_distance; ++f) {
        if (families[f].parameter != parameter) continue;
        panel.x.tics.emplace_back(fmt::format("{:.0f}", families[f].value), families[f].value);
    }
    for (std::size_t e = 0; e < engines().size(); ++e) {
        Curve& curve = panel.curves.emplace_back();
        curve.name = engines()[e].name;
        for (std::size_t f = 0; f < families.size(); ++f) {
            if (families[f].parameter != parameter) continue;
            const double wrong = measured[f].wrong_percent[e];
            curve.points.push_back({families[f].value, wrong,
                                    fmt::format("{}, {}: {} % wrong", curve.name, families[f].name, percent(wrong))});
        }
    }
    return panel;
}

void add_pictures(Section& section, std::span<const StabilityFamily> families, std::span<const Measured> measured,
                  const SignMaps& flat, const SignMaps& posed, const std::filesystem::path& folder) {
    section.charts.push_back({"stability-families",
                              {family_panel(families, measured)},
                              "Wrong answers by family. ECoDS has none anywhere."});
    section.charts.push_back(
        {"stability-curves",
         {curve_panel(Parameter::distance, "distance from the origin", families, measured),
          curve_panel(Parameter::thickness_exponent, "thickness of slivers", families, measured),
          curve_panel(Parameter::scale_exponent, "scale", families, measured)},
         "The same pairs of triangles, moved away, made thin, and scaled. In float, coordinates overflow or vanish at "
         "the outer scales."});
    section.pictures.push_back(draw_orient2d(flat, folder, "sign-map"));
    section.pictures.push_back(draw_posed_orient3d(posed, folder, "sign-map-posed"));
}

}  // namespace

SuiteResult run_stability(const SuiteOptions& options) {
    const std::vector<StabilityFamily> families = stability_families(options.is_quick() ? 200 : 20000);
    SuiteResult result;
    std::vector<Measured> measured;
    {
        process::Progress progress("stability", families.size());
        for (const StabilityFamily& family : families) {
            measured.push_back(measure_family(family, options.is_quick() ? 1 : 5, options.is_quick() ? 100 : 2000));
            result.is_right &= measured.back().ecods_wrong == 0;
            progress.step();
        }
    }
    const SignMaps flat = map_orient2d(), posed = map_posed_orient3d();
    result.is_right &= flat.exact_wrong == 0 && posed.exact_wrong == 0;

    Section section{
        "Numerical stability",
        {"Pairs of triangles that touch by construction, or miss that by a unit in the last place: how often "
         "is each way to test them wrong? A row is a family of such pairs, and the generic one is the "
         "control. Engines that round the posed vertices first answer another question, however exact "
         "they are after that: see Epick.",
         "ECoDS is asked for the real points R v + t, and its answers are the yardstick because the oracle, "
         "CGAL's exact kernel on exactly transformed points, confirms them; the run fails where it does "
         "not."},
        {make_table(families, measured)},
        {}};
    print(section.tables.front());
    fmt::print("  signs around a line, wrong of {}: plain double {}, ECoDS {}; under a pose: {} and {}\n\n",
               sign_map_size * sign_map_size, flat.plain_wrong, flat.exact_wrong, posed.plain_wrong, posed.exact_wrong);
    if (!options.is_quick()) add_pictures(section, families, measured, flat, posed, options.folder);
    result.sections.push_back(std::move(section));
    return result;
}

}  // namespace ecods::bench
