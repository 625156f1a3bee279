// Asks the bounds inside the library, with any guess, whether the truth is within them.
//
// usage: guesses [--times N] [--seed S] [--case K] [CHECK...]
//   CHECK      one of distance, contact, near, far, swept, meeting, moving, overlap, axis_ray, hits, line, convex and
//              point; or all
//   --times N  N times as many cases as in the tests
//   --seed S   other cases
//   --case K   one of the cases alone, as a failure names it
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "process/progress.hpp"
#include "property/guesses/check.hpp"

namespace ecods::guesses {

std::span<const Check> checks() {
    static constexpr Check all[] = {
        {"distance", ask_distance, 400, 0.3}, {"contact", ask_contact, 300, 0.02}, {"near", ask_near, 200, 0.3},
        {"far", ask_far, 200, 0.1},           {"swept", ask_swept, 150, 0.1},      {"meeting", ask_meeting, 150, 0.1},
        {"moving", ask_moving, 200, 0.1},     {"overlap", ask_overlap, 300, 0.1},  {"axis_ray", ask_axis_ray, 200, 0.1},
        {"hits", ask_hits, 600, 0.05},        {"line", ask_line, 400, 0.1},        {"convex", ask_convex, 150, 0.1},
        {"point", ask_point, 300, 0.1},
    };
    return all;
}

namespace {

struct Options {
    std::uint32_t times = 1, seed = 1;
    long only = -1;
    std::vector<std::string> names;
};

bool is_named(const Options& options, const Check& check) {
    if (options.names.empty()) return true;
    for (const std::string& name : options.names) {
        if (name == check.name) return true;
    }
    return false;
}

bool run(const Check& check, const Options& options) {
    const std::uint32_t count = check.cases * options.times;
    process::Progress progress(std::string(check.name), count);
    Tally tally;
    for (std::uint32_t k = 0; k < count; ++k) {
        if (options.only >= 0 && k != static_cast<std::uint32_t>(options.only)) continue;
        Case c(options.seed * 1'000'003u + k, tally);
        check.ask(c);
        progress.step();
        if (!c.is_wrong()) continue;
        progress.wipe();
        std::printf("%s: mismatch: %s: --seed %u --case %u\n", check.name.data(), c.wrong.c_str(), options.seed, k);
        return false;
    }
    progress.wipe();
    std::printf("%-9s %7u cases, %10llu bounds asked, %10llu say something, 0 are wrong\n", check.name.data(), count,
                static_cast<unsigned long long>(tally.asked), static_cast<unsigned long long>(tally.telling));
    const bool tells = static_cast<double>(tally.telling) >= check.telling_min * static_cast<double>(tally.asked);
    if (!tells && options.only < 0) std::printf("%s: too few bounds say something\n", check.name.data());
    return tells || options.only >= 0;
}

int run(const Options& options) {
    bool all = true, any = false;
    for (const Check& check : checks()) {
        if (!is_named(options, check)) continue;
        any = true;
        all = run(check, options) && all;
    }
    if (!any) std::fprintf(stderr, "no such check\n");
    return !any ? 2 : all ? 0 : 1;
}

}  // namespace
}  // namespace ecods::guesses

int main(int argc, char** argv) {
    ecods::environment::limit_by_variable_or_exit();
    ecods::guesses::Options options;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        const auto number = [&] { return i + 1 < argc ? std::strtoul(argv[++i], nullptr, 10) : 0; };
        if (word == "--times") {
            options.times = static_cast<std::uint32_t>(number());
        } else if (word == "--seed") {
            options.seed = static_cast<std::uint32_t>(number());
        } else if (word == "--case") {
            options.only = static_cast<long>(number());
        } else {
            options.names.push_back(word);
        }
    }
    return ecods::guesses::run(options);
}
