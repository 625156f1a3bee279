// ecods_fuzz: random input, every answer checked. `ecods_fuzz --help` tells the options.
#include <CLI/CLI.hpp>

#include <string>

#include "fuzz/campaign.hpp"

int main(int argc, char** argv) {
    ecods::fuzz::CampaignOptions options;
    CLI::App app{
        "Random input; every answer is checked by an exact oracle. Exit status 1: a check failed.\n"
        "Profiles: motion (worlds in motion), pairs (pairs of posed triangles, 1000 a run)."};
    std::string profile = "motion";
    app.add_option("--profile", profile, "what to fuzz: motion or pairs")
        ->check(CLI::IsMember({"motion", "pairs"}))
        ->capture_default_str();
    app.add_option("--seed", options.seed, "of the first run; run i has seed + i")->capture_default_str();
    app.add_option("--runs", options.runs, "how many runs")->capture_default_str();
    app.add_option("--seconds", options.seconds, "how long, in place of --runs")->check(CLI::NonNegativeNumber);
    app.add_flag("--canary", options.canary, "lie about an answer: the campaign must fail");
    CLI11_PARSE(app, argc, argv);
    return profile == "pairs" ? ecods::fuzz::fuzz_pairs(options) : ecods::fuzz::fuzz_motion(options);
}
