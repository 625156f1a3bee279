// ecods_fuzz: random worlds in motion, every answer checked. `ecods_fuzz --help` tells the options.
#include <fmt/format.h>
#include <unistd.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <optional>

#include "fuzz/run.hpp"

namespace {

using namespace ecods::fuzz;
using Clock = std::chrono::steady_clock;

struct Options {
    std::uint32_t seed = 1;
    std::uint32_t runs = 100;
    double seconds = 0;
    CheckOptions checks;
};

class Progress {
  public:
    void show(std::uint32_t runs, std::uint64_t frames) {
        if (!is_terminal_ || Clock::now() - shown_ < std::chrono::milliseconds(200)) return;
        shown_ = Clock::now();
        fmt::print(stderr, "\r{} runs, {} frames", runs, frames);
    }
    ~Progress() {
        if (is_terminal_) fmt::print(stderr, "\r\x1b[K");
    }

  private:
    bool is_terminal_ = isatty(STDERR_FILENO) == 1;
    Clock::time_point shown_ = {};
};

// Prints the summary; the exit status.
int fuzz(const Options& options) {
    Counters counters;
    std::uint32_t runs = 0;
    std::optional<Failure> failure;
    const auto start = Clock::now();
    const auto goes_on = [&] {
        if (options.seconds <= 0) return runs < options.runs;
        return Clock::now() - start < std::chrono::duration<double>(options.seconds);
    };
    {
        Progress progress;
        while (!failure && goes_on()) {
            try {
                run(options.seed + runs, options.checks, counters);
            } catch (const Failure& found) {
                failure = found;
            }
            ++runs;
            progress.show(runs, counters["frames"]);
        }
    }
    nlohmann::json summary = {{"seed", options.seed}, {"runs", runs}, {"counts", counters}, {"failure", nullptr}};
    if (failure) {
        summary["failure"] = {
            {"seed", failure->seed}, {"frame", failure->frame}, {"check", failure->check}, {"detail", failure->detail}};
        fmt::print(stderr, "ecods_fuzz: seed {}, frame {}: {}: {}\nto see it again: ecods_fuzz --seed {} --runs 1\n",
                   failure->seed, failure->frame, failure->check, failure->detail, failure->seed);
    }
    fmt::print("{}\n", summary.dump(2));
    return failure ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App app{"Random worlds in motion; every answer is checked by an exact oracle. Exit status 1: a check failed."};
    app.add_option("--seed", options.seed, "of the first run; run i has seed + i")->capture_default_str();
    app.add_option("--runs", options.runs, "how many runs")->capture_default_str();
    app.add_option("--seconds", options.seconds, "how long, in place of --runs")->check(CLI::NonNegativeNumber);
    app.add_flag("--canary", options.checks.canary, "lie about a verdict: the run must fail");
    CLI11_PARSE(app, argc, argv);
    return fuzz(options);
}
