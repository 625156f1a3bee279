// ecods_fuzz: random input, every answer checked. `ecods_fuzz --help` lists the options.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "fuzz/base/recipe.hpp"
#include "fuzz/campaign.hpp"
#include "fuzz/motion/profile.hpp"
#include "fuzz/pairs/campaigns.hpp"
#include "fuzz/record.hpp"
#include "process/program.hpp"
#include "programs/command_line.hpp"

namespace ecods::fuzz {
namespace {

constexpr int exit_held = 0;
constexpr int exit_failed = 1;
constexpr int exit_unusable = 2;

struct Options {
    CampaignOptions campaign;
    RecordOptions record{.folder = "ecods_fuzz_failures"};
    std::vector<std::string> replays;
    bool renews = false;
    bool lists_profiles = false;
    std::string json_file;
};

void list_profiles() {
    for (const Profile& profile : profiles()) fmt::print("{:<10} {}\n", profile.name, profile.about);
    for (const CaseCampaign& campaign : case_campaigns()) {
        fmt::print("{:<10} {}\n", campaign.profile, campaign.about);
    }
    fmt::print("motion     all kinds of worlds in motion, in turns\nall        all of them, in turns\n");
}

void print(const RunFailure& failure) {
    fmt::print(stderr, "ecods_fuzz: {}: seed {}, {}: {}: expected {}, got {}\n{}", failure.profile, failure.seed,
               failure.where, failure.check, failure.expected, failure.got, failure.text);
    if (failure.check == recipe_check)
        fmt::print(stderr, "The recipe of the case is wrong, by the oracle; the library was not asked about it.\n");
    fmt::print(stderr, "to see it again: ecods_fuzz --profile {} --seed {} --runs 1\n", failure.profile, failure.seed);
}

// The last line, on the error stream: the output is JSON.
void print_verdict(const CampaignOptions& campaign, const CampaignReport& report) {
    const auto updates = report.counters.find("frames");
    const std::string asked = updates == report.counters.end() ? "" : fmt::format(", {} updates", updates->second);
    const std::string outcome =
        report.failures.empty() ? "every check held" : fmt::format("{} FAILED", report.failures.size());
    fmt::print(stderr, "ecods_fuzz: {}: {} runs from seed {}{}, {:.1f} s: {}\n", campaign.profile, report.runs,
               campaign.seed, asked, report.seconds, outcome);
}

int run_campaign(Options& options) {
    options.campaign.play.certificates.folder = options.record.folder;
    options.record.play = options.campaign.play;
    options.record.run_seconds = options.campaign.seconds_max;
    CampaignReport report = run_campaign(options.campaign);
    for (RunFailure& failure : report.failures) record(failure, options.record);
    const std::string json = to_json(options.campaign, report);
    if (options.json_file.empty()) {
        fmt::print("{}\n", json);
    } else if (std::ofstream out(options.json_file); !(out << json << "\n")) {
        fmt::print(stderr, "ecods_fuzz: {}: cannot be written\n", options.json_file);
        return exit_unusable;
    }
    for (const RunFailure& failure : report.failures) print(failure);
    if (const auto made = report.counters.find("certificates: made");
        options.campaign.play.certificates.checker.empty() && made != report.counters.end())
        fmt::print(stderr, "ecods_fuzz: {} certificates, not checked: there is no --checker\n", made->second);
    print_verdict(options.campaign, report);
    return report.failures.empty() ? exit_held : exit_failed;
}

int replay(const Options& options) {
    Counters counters;
    PlayOptions play = options.campaign.play;
    play.certificates.folder = options.record.folder / "replay.certificates";
    int failed_count = 0;
    for (const std::string& file : options.replays) {
        const auto failure = replay_trace(file, {.play = play, .compares_digests = !options.renews}, counters);
        if (!failure && options.renews) renew_trace(file);
        if (!failure) continue;
        ++failed_count;
        fmt::print("{}: update {}: {}: expected {}, got {}\n", file, failure->update, failure->check, failure->expected,
                   failure->got);
    }
    fmt::print("{} traces, {} updates, {} failed\n", options.replays.size(), counters["frames"], failed_count);
    return failed_count == 0 ? exit_held : exit_failed;
}

// Other engines are asked by a program of its own, which has them linked: all options are for it.
bool is_for_engines(int argc, char** argv) {
    return std::any_of(argv + 1, argv + argc, [](std::string_view option) { return option.starts_with("--engine"); });
}
std::filesystem::path own_folder() {
    return std::filesystem::read_symlink("/proc/self/exe").parent_path();
}
int run_engines(char** argv) {
    std::string program = own_folder() / "engines/ecods_fuzz_engine";
    argv[0] = program.data();
    execv(program.c_str(), argv);
    fmt::print(stderr, "ecods_fuzz: {}: {}\n", program, std::strerror(errno));
    return exit_unusable;
}

// Beside this program, or where it is built. None: empty.
std::filesystem::path find_checker() {
    for (const char* place : {"ecods_check_certificate", "../verify/certificates/checker/ecods_check_certificate"}) {
        if (auto program = own_folder() / place; exists(program)) return program;
    }
    return {};
}

// "none" is none. Throws std::runtime_error where the program cannot be started: no run would have failed by the
// library.
void settle_checker(std::filesystem::path& checker) {
    if (checker == "none") checker.clear();
    if (!checker.empty() && process::run_program({checker}).status == 127)
        throw std::runtime_error(fmt::format("--checker {}: cannot be started", checker.string()));
}

int run_program(int argc, char** argv) {
    if (is_for_engines(argc, argv)) return run_engines(argv);
    Options options;
    CampaignOptions& campaign = options.campaign;
    campaign.play.certificates.checker = find_checker();
    CLI::App app(
        "Random input; every answer is checked by an exact oracle, and by what does not share its code. The same seed "
        "is\n"
        "the same run on every machine. Exit status: 0 if all held; 1 if a check failed, or a run crashed or hung, or "
        "a\n"
        "case is not what its recipe promises (check \"recipe\": by the oracle, before the library is asked); 2 if "
        "the\n"
        "command makes no sense.\n"
        "--engine NAME has another library answer hard questions: see ecods_fuzz_engine --help.",
        "ecods_fuzz");
    app.add_option("--profile", campaign.profile, "What to fuzz: see --list-profiles")->capture_default_str();
    app.add_flag("--list-profiles", options.lists_profiles, "Print the profiles, and end");
    app.add_option("--seed", campaign.seed, "Of the first run; run i has seed + i")->capture_default_str();
    app.add_option("--runs", campaign.runs, "How many runs")->capture_default_str();
    app.add_option("--seconds", campaign.seconds, "How long, in place of --runs")->check(CLI::NonNegativeNumber);
    app.add_option("--jobs", campaign.jobs, "Processes at once")->check(CLI::Range(1, 256))->capture_default_str();
    app.add_option("--run-seconds", campaign.seconds_max, "Processor time after which a run hangs")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    app.add_option("--failures", campaign.failures_max, "After so many failures no run begins")->capture_default_str();
    app.add_option("--json", options.json_file, "Write the summary to this file, in place of the output");
    app.add_option("--replay", options.replays, "Play traces with all checks, in place of a campaign");
    app.add_flag("--renew", options.renews, "Write traces that were played again, with the digests of this build");
    app.add_option("--folder", options.record.folder, "Where traces and pictures of failures go")
        ->capture_default_str();
    app.add_option("--shrink-seconds", options.record.shrink_seconds, "How long a failure is shrunk; 0: not at all")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    app.add_option("--checker", campaign.play.certificates.checker,
                   "What checks certificates of a sample of the answers; none: only their claims are compared")
        ->default_str("ecods_check_certificate, where it is built or installed");
    const std::map<std::string, Canary> canaries{{"answer", Canary::answer},
                                                 {"crash", Canary::crash},
                                                 {"hang", Canary::hang},
                                                 {"proof", Canary::proof},
                                                 {"recipe", Canary::recipe}};
    programs::add_choice(app, "--canary", campaign.play.canary, canaries,
                         "Go wrong on purpose, where a collision is (proof: in a certificate; recipe: in a case of a "
                         "pair, not of worlds "
                         "in motion); answer, if nothing is named")
        ->expected(0, 1)
        ->default_str("answer");
    if (const auto status = programs::parse(app, argc, argv)) return *status;
    if (options.lists_profiles) {
        list_profiles();
        return exit_held;
    }
    settle_checker(campaign.play.certificates.checker);
    if (!options.replays.empty()) return replay(options);
    if (profiles_of(campaign.profile).empty()) {
        fmt::print(stderr, "ecods_fuzz: there is no profile {}: see --list-profiles\n", campaign.profile);
        return exit_unusable;
    }
    return run_campaign(options);
}

}  // namespace
}  // namespace ecods::fuzz

int main(int argc, char** argv) {
    try {
        return ecods::fuzz::run_program(argc, argv);
    } catch (const std::exception& error) {
        fmt::print(stderr, "ecods_fuzz: {}\n", error.what());
        return ecods::fuzz::exit_unusable;
    }
}
