// ecods_fuzz_engine: how often collision libraries are wrong where it is hard to be right. `--help` lists the options.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "fuzz/engines/command.hpp"
#include "fuzz/engines/dump.hpp"
#include "fuzz/engines/engine_under_test.hpp"
#include "fuzz/engines/families.hpp"
#include "fuzz/engines/judge.hpp"
#include "process/progress.hpp"
#include "programs/command_line.hpp"

namespace {

using namespace ecods;
using namespace ecods::fuzz;

struct Options {
    std::vector<std::string> engines;
    std::vector<std::string> commands;
    std::filesystem::path dump;  // none when empty
    std::size_t pictures = 10;
    std::vector<std::string> families;
    std::uint32_t seed = 1;
    std::size_t runs = 200;
    int limit = 5;
    std::filesystem::path json;
    bool lists = false;
};

// What was asked for by name; everything, when nothing was.
template <class Thing>
std::vector<Thing> chosen(const std::vector<Thing>& all, const std::vector<std::string>& names, const char* what) {
    if (names.empty()) return all;
    std::vector<Thing> result;
    for (const std::string& name : names) {
        const auto found = std::ranges::find(all, name, [](const Thing& thing) { return thing.name; });
        if (found == all.end()) throw std::runtime_error(fmt::format("there is no {} '{}'; see --list", what, name));
        result.push_back(*found);
    }
    return result;
}

nlohmann::json to_json(const Verdicts& v) {
    return {{"queries", v.queries},
            {"hits", v.hits},
            {"answered", v.answered},
            {"false_negatives", v.false_negatives},
            {"false_positives", v.false_positives},
            {"differs_when_swapped", v.asymmetric},
            {"crashed", v.crashed},
            {"hung", v.hung},
            {"wrong_queries", v.wrong},
            {"first_failure", v.first_failure}};
}

// "false negatives/false positives", or "." for none of either; what is not about answers follows.
std::string to_cell(const Verdicts& v) {
    std::string text =
        v.false_negatives + v.false_positives == 0 ? "." : fmt::format("{}/{}", v.false_negatives, v.false_positives);
    if (v.asymmetric > 0) text += fmt::format(" ~{}", v.asymmetric);
    if (v.crashed > 0) text += fmt::format(" !{}", v.crashed);
    if (v.hung > 0) text += fmt::format(" ...{}", v.hung);
    return text;
}

void print_row(const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) fmt::print(fmt::runtime(i == 0 ? "{:<34}" : " {:>14}"), cells[i]);
    fmt::print("\n");
    std::fflush(stdout);
}

// Sums up what one engine did in all families.
struct Total {
    Verdicts sum;
    std::string first_wrong;  // the first wrong answer: query, family and truth
};

void add(Total& total, const Verdicts& more, const std::string& family, const std::vector<bool>& truth) {
    Verdicts& sum = total.sum;
    sum.queries += more.queries;
    sum.hits += more.hits;
    sum.answered += more.answered;
    sum.false_negatives += more.false_negatives;
    sum.false_positives += more.false_positives;
    sum.asymmetric += more.asymmetric;
    sum.crashed += more.crashed;
    sum.hung += more.hung;
    if (sum.first_failure.empty()) sum.first_failure = more.first_failure;
    if (total.first_wrong.empty() && !more.wrong.empty()) {
        const std::size_t query = more.wrong.front();
        total.first_wrong = fmt::format("query {} of '{}', of two that {}", query, family,
                                        truth[query] ? "share a point" : "are apart");
    }
}

void list(const std::vector<EngineMaker>& engines, const std::vector<EngineFamily>& families) {
    for (const EngineMaker& engine : engines) fmt::print("engine {:<10} {}\n", engine.name, engine.use);
    for (const EngineFamily& family : families) fmt::print("family '{}': {}\n", family.name, family.what);
}

// Those that are named, and commands; without either, all but the canary.
std::vector<EngineMaker> asked_engines(const Options& options) {
    std::vector<EngineMaker> all = engines_under_test();
    const bool has_canary = std::ranges::find(options.engines, "canary") != options.engines.end();
    if (has_canary) all.push_back(canary_engine());
    std::vector<EngineMaker> engines;
    if (!options.engines.empty() || options.commands.empty()) engines = chosen(all, options.engines, "engine");
    for (std::size_t i = 0; i < options.commands.size(); ++i)
        engines.push_back(command_engine(i == 0 ? "command" : fmt::format("command-{}", i + 1), options.commands[i]));
    return engines;
}

void dump_wrong(const Options& options, const std::string& engine, const std::string& family,
                const scenes::MeshPairs& pairs, const std::vector<bool>& truth, const Verdicts& verdicts,
                std::size_t& dumped) {
    if (options.dump.empty()) return;
    for (const std::size_t query : verdicts.wrong)
        dump({engine, family, query, truth[query]}, pairs, options.dump, dumped++ < options.pictures);
}

// Prints one line for each engine. A wrong answer says more about it than a time-out, which a busy machine may cause.
void print_verdict(const std::string& engine, const Total& total) {
    const Verdicts& sum = total.sum;
    const std::size_t wrong = sum.false_negatives + sum.false_positives;
    std::string text =
        fmt::format("{}: {} of {} answers wrong", engine, wrong == 0 ? "none" : fmt::format("{}", wrong), sum.answered);
    if (sum.asymmetric > 0) text += fmt::format(", {} differ when swapped", sum.asymmetric);
    if (sum.answered < sum.queries)
        text += fmt::format(", {} of {} queries without an answer", sum.queries - sum.answered, sum.queries);
    if (!total.first_wrong.empty())
        text += fmt::format("; the first wrong answer: {}", total.first_wrong);
    else if (!sum.first_failure.empty())
        text += fmt::format("; the first failure: {}", sum.first_failure);
    fmt::print("{}\n", text);
}

int run(const Options& options) {
    const auto engines = asked_engines(options);
    const auto families = chosen(engine_families(), options.families, "family");
    if (options.lists) {
        list(engines, families);
        return 0;
    }
    nlohmann::json results = nlohmann::json::array();
    std::vector<Total> totals(engines.size());
    std::size_t dumped = 0;
    process::Progress progress;
    bool is_right = true;
    fmt::print(
        "Wrong answers, false negatives/false positives, of so many queries, of which so many touch. ~: answers that "
        "differ when "
        "the two are\nswapped; !: crashes; ...: hangs.\n\n");
    std::vector<std::string> header = {"family", "queries (hits)"};
    for (const EngineMaker& engine : engines) header.push_back(engine.name);
    print_row(header);
    for (const EngineFamily& family : families) {
        progress.show(fmt::format("{}: the oracle", family.name));
        const scenes::MeshPairs pairs = family.make(options.runs, options.seed);
        const std::vector<bool> truth = ask_oracle(pairs);
        const auto hits = std::ranges::count(truth, true);
        std::vector<std::string> row = {family.name, fmt::format("{} ({})", truth.size(), hits)};
        for (std::size_t i = 0; i < engines.size(); ++i) {
            progress.show(fmt::format("{}: {}", family.name, engines[i].name));
            const Verdicts verdicts = judge(engines[i], pairs, truth, std::chrono::seconds(options.limit));
            is_right &= verdicts.is_right() || !engines[i].must_be_right;
            add(totals[i], verdicts, family.name, truth);
            dump_wrong(options, engines[i].name, family.name, pairs, truth, verdicts, dumped);
            row.push_back(to_cell(verdicts));
            auto& result = results.emplace_back(to_json(verdicts));
            result["engine"] = engines[i].name;
            result["family"] = family.name;
        }
        progress.wipe();
        print_row(row);
    }
    std::vector<std::string> last = {"all", fmt::format("{} ({})", totals[0].sum.queries, totals[0].sum.hits)};
    for (const Total& total : totals) last.push_back(to_cell(total.sum));
    print_row(last);
    fmt::print("\n");
    for (std::size_t i = 0; i < engines.size(); ++i) print_verdict(engines[i].name, totals[i]);
    if (dumped > 0) fmt::print("{} wrong answers as scene files in {}\n", dumped, options.dump.string());
    if (!options.json.empty()) {
        const nlohmann::json summary = {
            {"seed", options.seed}, {"runs", options.runs}, {"right", is_right}, {"results", results}};
        std::ofstream file(options.json);
        file << summary.dump(2) << "\n";
        if (!file) throw std::runtime_error("cannot write " + options.json.string());
    }
    return is_right ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App app{
        "Asks collision libraries whether two meshes touch, in scenes that are hard, and compares with an exact "
        "oracle.\n"
        "Each runs in a process of its own; what crashes or hangs is counted. Exit status: 0; 1 if ECoDS was wrong; 2 "
        "for an\nerror.",
        "ecods_fuzz_engine"};
    app.add_option("--engine", options.engines, "which (may be repeated; all but the canary if none is named)");
    app.add_option("--engine-command", options.commands,
                   "a program that is asked by lines of JSON, see fuzz/engines/README.md (may be repeated)")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    app.add_option("--dump", options.dump, "folder for the first wrong answers of each family, as scene files");
    app.add_option("--pictures", options.pictures, "of so many of them")->capture_default_str();
    app.add_option("--family", options.families, "which scenes (likewise)");
    app.add_option("--seed", options.seed, "of every family")->capture_default_str();
    app.add_option("--runs", options.runs, "queries of each family")->check(CLI::PositiveNumber)->capture_default_str();
    app.add_option("--limit", options.limit, "seconds after which a query hangs")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    app.add_option("--json", options.json, "where to write all figures, and which queries were wrong");
    app.add_flag("--list", options.lists, "name engines and families, and ask nothing");
    if (const auto status = ecods::programs::parse(app, argc, argv)) return *status;
    try {
        return run(options);
    } catch (const std::exception& error) {
        fmt::print(stderr, "ecods_fuzz_engine: {}\n", error.what());
        return 2;
    }
}
