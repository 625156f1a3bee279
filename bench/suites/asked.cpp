#include "suites/asked.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>

namespace ecods::bench {

namespace {

// Engines are found as SuiteOptions finds them: every name contains itself.
void require_known(std::span<const Suite> suites, const std::string& text) {
    std::set<std::string> known;
    for (const Suite& suite : suites)
        for (const EngineName& engine : suite.engines) known.insert(engine.name);
    if (std::any_of(known.begin(), known.end(),
                    [&](const std::string& name) { return name.find(text) != std::string::npos; }))
        return;
    if (known.empty())
        throw std::runtime_error(fmt::format("--engines {}: the suites that are asked for choose no engines", text));
    throw std::runtime_error(
        fmt::format("--engines {}: there is no such engine in the suites that are asked for; they "
                    "have: {}",
                    text, fmt::join(known, "; ")));
}

}  // namespace

std::vector<Suite> asked_suites(std::span<const Suite> all, std::span<const std::string> names,
                                const SuiteOptions& options) {
    std::vector<Suite> asked;
    for (const Suite& suite : all)
        if (std::find(names.begin(), names.end(), suite.name) != names.end()) asked.push_back(suite);
    for (const std::string& text : options.engines) require_known(asked, text);
    std::erase_if(asked,
                  [&](const Suite& suite) { return !suite.engines.empty() && options.wanted(suite.engines).empty(); });
    return asked;
}

bool asks_ecods(const Suite& suite, const SuiteOptions& options) {
    if (!suite.is_judged) return false;
    if (suite.engines.empty()) return true;
    const std::vector<EngineName> wanted = options.wanted(suite.engines);
    return std::any_of(wanted.begin(), wanted.end(), [](const EngineName& engine) { return engine.is_ecods; });
}

std::string verdict(std::span<const Suite> suites, const SuiteOptions& options, bool is_right) {
    if (!is_right) return "ECoDS ANSWERED WRONGLY: see the tables.";
    std::vector<std::string> with, without;
    for (const Suite& suite : suites)
        if (suite.is_judged) (asks_ecods(suite, options) ? with : without).push_back(suite.name);
    if (with.empty()) return "ECoDS was not asked: no answer of it was judged.";
    std::string text = "Every answer of ECoDS is the oracle's: 0 false negatives, 0 false positives.";
    if (!without.empty()) text += fmt::format(" It was not asked in: {}.", fmt::join(without, ", "));
    return text;
}

}  // namespace ecods::bench
