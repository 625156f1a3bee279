// ecods_bench: runs ECoDS and its peers on the same bits, checks every answer of ECoDS with the oracle, and writes a
// report. Exit status: 0 when ECoDS was right throughout, 1 when it was not, 2 for an error; with --compare: 1 when
// answers or counts of work differ.
#include <fmt/core.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "programs/command_line.hpp"
#include "report/csv.hpp"
#include "report/draw_chart.hpp"
#include "report/environment.hpp"
#include "report/headline.hpp"
#include "report/instruction_set.hpp"
#include "report/json.hpp"
#include "report/page.hpp"
#include "report/read_page.hpp"
#include "suites/asked.hpp"
#include "suites/compare_builds.hpp"
#include "suites/comparison.hpp"
#include "suites/sign_maps.hpp"
#include "suites/suite.hpp"

namespace {

using namespace ecods::bench;

struct Arguments {
    SuiteOptions options;
    std::vector<std::string> suites;
    std::filesystem::path report = "build/report";
    std::filesystem::path json;  // these three: none when empty
    std::filesystem::path csv;
    std::filesystem::path results;
    std::filesystem::path from;    // a saved page, in place of a run
    std::filesystem::path sample;  // folder
    std::string instruction_set = "native";
    std::vector<std::string> builds;  // two to be compared, or none
    bool is_own = false;
    bool is_quick = false;
    bool has_report = true;
};

Page make_page(const std::string& command) {
    Page page;
    page.title = "ECoDS beside its peers";
    page.summary = {
        "Which of many moving triangle meshes touch? Every engine below was given the very same bits: meshes and poses "
        "are "
        "computed once. The oracle, CGAL's exact kernel on exactly transformed points, which shares no code with "
        "ECoDS, "
        "judges every pair of bodies in every frame. False negative (\"false -\"): a hit of the oracle that the engine "
        "does not report. False positive (\"false +\"): reported without being a hit.",
        "In the suites of two meshes, boxes and growing numbers of ships each engine runs in a process of its own, in "
        "turns with the others; times are processor times. For the rooms and the assembly below, times are "
        "milliseconds per frame: the mean over the frames after the first of the median over the repetitions, one "
        "thread, engines interleaved in one process. FCL runs in double precision, its meshes as BVHModel<OBBRSS>, "
        "with "
        "boolean queries. Candidate pairs are those given to the two-body test, or answered from the cache."};
    page.environment = environment(command);
    return page;
}

// All comparisons as one table.
Table join(const std::vector<Table>& comparisons) {
    Table all;
    all.title = scenes_title;
    all.text_columns = 2;
    all.header = comparisons.front().header;
    all.header.insert(all.header.begin(), "scene");
    for (const Table& table : comparisons) {
        for (std::vector<std::string> row : table.rows) {
            row.insert(row.begin(), table.title);
            all.rows.push_back(std::move(row));
        }
    }
    return all;
}

// The images that README shows.
void write_sample(const Page& page, const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    const auto chart = summary_chart(page);
    if (!chart) throw std::runtime_error("--sample: the page has no results of the suite narrow");
    write_svg(*chart, folder / "summary.svg");
    const std::filesystem::path parts =
        std::filesystem::temp_directory_path() / fmt::format("ecods_sample.{}", getpid());
    std::filesystem::create_directory(parts);
    const Picture map = draw_orient2d(map_orient2d(), parts, "sign-map");
    if (!map.failure.empty()) throw std::runtime_error("--sample: " + map.failure);
    std::filesystem::copy_file(map.file, folder / "sign-map.png", std::filesystem::copy_options::overwrite_existing);
    std::filesystem::remove_all(parts);
    fmt::print("sample: {}\n", folder.string());
}

// The page in all forms that were asked for.
void write_all(const Page& page, const Arguments& arguments) {
    if (!arguments.json.empty()) write_json(page, arguments.json);
    if (!arguments.csv.empty()) write_csv(page, arguments.csv);
    if (!arguments.results.empty()) write_csv(page, arguments.results / results_name(page));
    if (arguments.has_report) {
        const std::filesystem::path file = arguments.report / "index.html";
        write_page(page, file);
        fmt::print("report: {}\n", file.string());
    }
    if (!arguments.sample.empty()) write_sample(page, arguments.sample);
}

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

// Runs one suite. Lines on the error stream say when it begins and how long it took, also where that is no terminal.
SuiteResult run(const Suite& suite, const std::string& place, const SuiteOptions& options) {
    fmt::print(stderr, "suite {}: {} ...\n", place, suite.name);
    const Clock::time_point start = Clock::now();
    SuiteResult result = suite.run(options);
    if (options.is_main) print_summary(result);
    fmt::print(stderr, "suite {}: {}: {:.1f} s\n", place, suite.name, seconds_since(start));
    return result;
}

// Prints the rows of all scenes, or in the main job the ratios that follow from them.
void print_scenes(const Table& all, const SuiteOptions& options) {
    print(options.is_main ? ratio_table(all, "Many moving meshes: which collide?").value_or(all) : all);
}

bool run(const Arguments& arguments, const std::string& command) {
    const Clock::time_point start = Clock::now();
    const std::vector<Suite> suites =
        asked_suites(arguments.options.is_main ? main_suites() : all_suites(), arguments.suites, arguments.options);
    if (arguments.has_report) std::filesystem::create_directories(arguments.options.folder);
    Page page = make_page(command);
    bool is_right = true;
    std::vector<Table> comparisons;
    for (std::size_t i = 0; i < suites.size(); ++i) {
        SuiteResult result = run(suites[i], fmt::format("{} of {}", i + 1, suites.size()), arguments.options);
        is_right &= result.is_right;
        std::move(result.sections.begin(), result.sections.end(), std::back_inserter(page.sections));
        std::move(result.comparisons.begin(), result.comparisons.end(), std::back_inserter(comparisons));
    }
    if (!comparisons.empty()) {
        const Table all = join(comparisons);
        print_scenes(all, arguments.options);
        page.sections.insert(page.sections.begin(), Section{"Engines on all scenes", {}, {all}, {}});
    }
    const std::string words = verdict(suites, arguments.options, is_right);
    page.summary.insert(page.summary.begin(), words);
    page.environment.rows.push_back({"whole run", fmt::format("{:.0f} s", seconds_since(start))});
    fmt::print("{}\n", words);
    if (arguments.is_quick) fmt::print("A few frames, run once (--quick): no time in these tables is a speed.\n");
    write_all(page, arguments);
    return is_right;
}

bool compare(const Arguments& arguments) {
    std::vector<std::string> options;
    if (arguments.is_quick) options.push_back("--quick");
    // Not the default: a build from before there was this option can be compared, too.
    if (arguments.instruction_set != "native") options.push_back("--instruction-set=" + arguments.instruction_set);
    const BuildComparison result =
        compare_builds(arguments.builds.at(0), arguments.builds.at(1), arguments.options.repetition_count, options);
    print(result.table);
    if (!result.slowest.empty()) fmt::print("The largest new/old: {:.3f} ({})\n", result.ratio_max, result.slowest);
    fmt::print("{}\n", result.is_same ? "Answers and counts of work are equal."
                                      : "ANSWERS OR COUNTS OF WORK DIFFER: see the table.");
    return result.is_same;
}

std::string names_of_main_suites() {
    std::string names;
    for (const Suite& suite : main_suites()) names += (names.empty() ? "" : ", ") + suite.name;
    return names;
}

void add_options(CLI::App& app, Arguments& arguments) {
    SuiteOptions& options = arguments.options;
    for (const Suite& each : all_suites()) arguments.suites.push_back(each.name);
    CLI::Option* const suite = app.add_option("--suite", arguments.suites, "Which suites to run (default: all)")
                                   ->check(CLI::IsMember(arguments.suites));
    app.add_option("--frames", options.frame_count, "Frames of each room")
        ->check(CLI::Range(2, 100000))
        ->capture_default_str();
    app.add_option("--repetitions", options.repetition_count, "Runs of each engine (with --compare: 9 unless given)")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app.add_option("--report", arguments.report, "Folder of the report")->capture_default_str();
    app.add_option(
        "--engines", options.engines,
        "Engines of these names, or where none has the name, those whose name contains it (default: all); "
        "in the suites narrow, distance, casts, turn, convex, broad, system, memory and hard_cases. Of these, suites "
        "without one are left "
        "out");
    app.add_option("--sizes", options.sizes,
                   "Numbers of boxes (suite broad) and ships (suite system) to run, of those that the suite has");
    app.add_option("--json", arguments.json, "Also write the page to this file, for programs and for --from");
    app.add_option("--csv", arguments.csv, "Also write all figures to this file, one in a line");
    app.add_option("--results", arguments.results,
                   "As --csv, into this folder, to a file named after the processor and the day");
    app.add_option("--from", arguments.from,
                   "Run nothing: write the page of an earlier run again, from its --json (all of it) or --csv (the "
                   "tables)")
        ->check(CLI::ExistingFile);
    app.add_option("--sample", arguments.sample,
                   "Also write the summary chart and the map of signs into this folder, as images");
    app.add_option("--instruction-set", arguments.instruction_set,
                   "What ECoDS, Embree and the C library may use; the other engines are built for the baseline")
        ->check(CLI::IsMember({"native", "avx2", "baseline"}))
        ->capture_default_str();
    app.add_option("--compare", arguments.builds,
                   "Instead of all that: two builds of this program, OLD and NEW, in turns on small workloads, ECoDS "
                   "alone. Answers and counts of work are compared exactly, and the exit status is 1 when any "
                   "differ, better or worse; times by their ratios, which never enter the status")
        ->expected(2)
        ->check(CLI::ExistingFile);
    app.add_flag("--own", arguments.is_own, "What --compare starts the two builds with: one line out for each line in");
    CLI::Option* const is_long =
        app.add_flag("--long", options.is_long, "The largest sizes, more frames, and a mesh of ten million triangles");
    app.add_flag("--main", options.is_main,
                 "The main job, what ./bench/run runs: " + names_of_main_suites() +
                     ", with fewer engines and workloads, and a table or two of each on the terminal")
        ->excludes(suite, is_long);
    app.add_flag("--quick", arguments.is_quick,
                 "A few frames, once, without pictures, and without report unless --report is given: to see that all "
                 "of it works");
}

// What follows from the options together.
void settle(const CLI::App& app, Arguments& arguments) {
    SuiteOptions& options = arguments.options;
    if (!arguments.builds.empty() && app.count("--repetitions") == 0) options.repetition_count = 9;
    if (arguments.is_quick) {
        options.frame_count = std::min<std::size_t>(options.frame_count, 6);
        options.repetition_count = 1;
        options.has_pictures = false;
        arguments.has_report = app.count("--report") > 0;
    }
    options.folder = arguments.report / "parts";
}

}  // namespace

int main(int argc, char** argv) {
    Arguments arguments;
    CLI::App app(
        "Runs ECoDS and its peers on the same scenes, checks every answer of ECoDS, writes a report.\n"
        "Exit status: 0; 1 if ECoDS was wrong, or with --compare if answers or counts of work differ; 2 for an error.",
        "ecods_bench");
    add_options(app, arguments);
    if (const auto status = ecods::programs::parse(app, argc, argv)) return *status;
    settle(app, arguments);
    std::string command = std::filesystem::path(argv[0]).filename().string();
    for (int i = 1; i < argc; ++i) command += std::string(" ") + argv[i];
    try {
        use_instruction_set(arguments.instruction_set, argv);
        if (arguments.is_own) {
            serve_own_work(arguments.is_quick);
            return 0;
        }
        if (!arguments.from.empty()) {
            write_all(read_page(arguments.from), arguments);
            return 0;
        }
        if (!arguments.builds.empty()) return compare(arguments) ? 0 : 1;
        return run(arguments, command) ? 0 : 1;
    } catch (const std::exception& error) {
        fmt::print(stderr, "ecods_bench: {}\n", error.what());
        return 2;
    }
}
