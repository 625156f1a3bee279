// Numerical stability: how often each way to test two triangles is wrong where it is hard to be right, at what price.
#include <fmt/core.h>
#include <gsl/gsl_statistics_double.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

#include "ecods/predicates.hpp"
#include "exact/point/point.hpp"
#include "exact/sign/plain_signs.hpp"
#include "harness/stopwatch.hpp"
#include "oracle/oracle.hpp"
#include "process/progress.hpp"
#include "suites/comparison.hpp"
#include "suites/stability_engines.hpp"
#include "suites/stability_families.hpp"
#include "suites/stability_plots.hpp"
#include "suites/suite.hpp"

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
    for (std::vector<double>& of_engine : times) {
        measured.ns.push_back(gsl_stats_median(of_engine.data(), 1, of_engine.size()));
    }
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
            const bool truth =
                oracle::triangle_triangle(pair.pose_a, pair.a, pair.pose_b, pair.b) != Relation::disjoint;
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

// Two to the power of -53: neighbours of 0.5 are so far apart.
constexpr double step = 0x1p-53;
constexpr std::size_t map_size = 256;

template <class SignOf>
SignMap make_map(std::string title, SignOf&& sign_of) {
    SignMap map{std::move(title), map_size, {}};
    map.signs.reserve(map_size * map_size);
    for (std::size_t j = 0; j < map_size; ++j) {
        for (std::size_t i = 0; i < map_size; ++i) {
            map.signs.push_back(sign_of(0.5 + static_cast<double>(i) * step, 0.5 + static_cast<double>(j) * step));
        }
    }
    return map;
}

struct MapPair {
    SignMap plain, exact;
    std::size_t plain_wrong = 0, exact_wrong = 0;
};

// The true sign depends on which of x and y is larger alone.
MapPair judge(SignMap plain, SignMap exact, int sign_below_diagonal) {
    MapPair maps{std::move(plain), std::move(exact)};
    for (std::size_t j = 0; j < map_size; ++j) {
        for (std::size_t i = 0; i < map_size; ++i) {
            const int truth = i == j ? 0 : i > j ? sign_below_diagonal : -sign_below_diagonal;
            maps.plain_wrong += maps.plain.signs[j * map_size + i] != truth;
            maps.exact_wrong += maps.exact.signs[j * map_size + i] != truth;
        }
    }
    return maps;
}

// Kettner, Mehlhorn, Pion, Schirra, Yap, Classroom Examples of Robustness Problems in Geometric Computations, 2008: the
// side of the line through (12, 12) and (24, 24) on which points near (0.5, 0.5) are.
MapPair map_orient2d() {
    const Vec2 q(12, 12), r(24, 24);
    SignMap plain = make_map("plain double", [&](double x, double y) {
        return exact::sign_of((q[0] - x) * (r[1] - y) - (q[1] - y) * (r[0] - x));
    });
    SignMap exact = make_map("ECoDS", [&](double x, double y) { return static_cast<int>(orient2d(Vec2(x, y), q, r)); });
    return judge(std::move(plain), std::move(exact), -1);
}

// The same under a pose: the side of the plane x = y, rotated and moved, on which the posed points are.
MapPair map_posed_orient3d() {
    Pose pose;
    pose.R = Eigen::Quaterniond(0.6, 0.3, -0.5, 0.55).normalized().toRotationMatrix();
    pose.t = Vec3(0.7, -1.3, 0.4);
    const Vec3 a(12, 12, 0), b(24, 24, 1), c(12, 12, 7);
    SignMap plain = make_map("plain double, from rounded posed points", [&](double x, double y) {
        const auto at = [&](const Vec3& v) { return exact::pose_point(pose.R, v, pose.t); };
        return exact::sign_of(exact::plain_orient3d(at(a), at(b), at(c), at(Vec3(x, y, 0.5))));
    });
    SignMap exact = make_map("ECoDS", [&](double x, double y) {
        return static_cast<int>(
            orient3d(PosedPoint{pose, a}, PosedPoint{pose, b}, PosedPoint{pose, c}, PosedPoint{pose, Vec3(x, y, 0.5)}));
    });
    return judge(std::move(plain), std::move(exact), 1);
}

std::string wrong_share(std::size_t wrong) {
    return fmt::format("{:.1f} %", 100 * static_cast<double>(wrong) / (map_size * map_size));
}

std::string percent(double value) {
    if (value == 0) return "0";
    return value < 0.01 ? "<0.01" : fmt::format("{:.2f}", value);
}

Table make_table(std::span<const StabilityFamily> families, std::span<const Measured> measured) {
    Table table;
    table.title = "Wrong booleans in percent, and nanoseconds per pair";
    table.header = {"family", "hits %"};
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

void add_pictures(Section& section, std::span<const StabilityFamily> families, std::span<const Measured> measured,
                  const MapPair& flat, const MapPair& posed, const std::filesystem::path& folder) {
    std::vector<std::string> names;
    for (const TriangleEngine& engine : engines()) names.push_back(engine.name);

    std::vector<std::string> groups;
    std::vector<std::vector<double>> bars(names.size());
    WrongCurves far{"distance from the origin", true, {}, std::vector<std::vector<double>>(names.size())};
    WrongCurves thin{"thickness of slivers", false, {}, std::vector<std::vector<double>>(names.size())};
    WrongCurves scale{"scale", false, {}, std::vector<std::vector<double>>(names.size())};
    for (std::size_t f = 0; f < families.size(); ++f) {
        WrongCurves* curves = nullptr;
        switch (families[f].parameter) {
            case Parameter::none:
                groups.push_back(families[f].name);
                break;
            case Parameter::distance:
                curves = &far;
                break;
            case Parameter::thickness_exponent:
                curves = &thin;
                break;
            case Parameter::scale_exponent:
                curves = &scale;
                break;
        }
        if (curves != nullptr) curves->x.push_back(families[f].value);
        for (std::size_t e = 0; e < names.size(); ++e) {
            (curves != nullptr ? curves->percent[e] : bars[e]).push_back(measured[f].wrong_percent[e]);
        }
    }
    section.pictures.push_back(plot_wrong_bars(groups, names, bars, folder, "stability-families",
                                               "Wrong answers by family. ECoDS has none anywhere, hence no bar."));
    section.pictures.push_back(
        plot_wrong_curves(std::vector{far, thin, scale}, names, folder, "stability-curves",
                          "The same pairs of triangles, moved away, made thin, and scaled. All three axes are "
                          "logarithmic; in float, coordinates overflow or vanish at the outer scales."));
    section.pictures.push_back(plot_sign_maps(
        std::vector{flat.plain, flat.exact}, folder, "sign-map",
        fmt::format("Which side of the line through (12, 12) and (24, 24)? Each cell is one of 256 x 256 neighbouring "
                    "points (0.5 + i u, 0.5 + j u), u = 2^-53; orient2d is negative (dark), zero (white: on the line) "
                    "or positive (grey). The line is the diagonal. Wrong signs: plain double {}, ECoDS {}.",
                    wrong_share(flat.plain_wrong), wrong_share(flat.exact_wrong))));
    section.pictures.push_back(plot_sign_maps(
        std::vector{posed.plain, posed.exact}, folder, "sign-map-posed",
        fmt::format(
            "The same in space, under a pose: which side of the plane x = y of a rotated body? Each cell is one "
            "of 256 x 256 neighbouring points of the body. Rounding the posed points breaks the plane into steps. "
            "Wrong signs: plain double {}, ECoDS {}.",
            wrong_share(posed.plain_wrong), wrong_share(posed.exact_wrong))));
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
    const MapPair flat = map_orient2d(), posed = map_posed_orient3d();
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
               map_size * map_size, flat.plain_wrong, flat.exact_wrong, posed.plain_wrong, posed.exact_wrong);
    if (!options.is_quick()) add_pictures(section, families, measured, flat, posed, options.folder);
    result.sections.push_back(std::move(section));
    return result;
}

}  // namespace ecods::bench
