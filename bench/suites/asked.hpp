// Which suites and engines a command asks for, and in words whose answers were judged.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "suites/suite.hpp"

namespace ecods::bench {

// Of the suites of these names, those that have an engine that is wanted, in their own order. Suites that choose no
// engines always run. Throws std::runtime_error for a wanted engine that none of the suites of these names has.
std::vector<Suite> asked_suites(std::span<const Suite> all, std::span<const std::string> names,
                                const SuiteOptions& options);

// Whether answers of ECoDS are judged in this suite: not where other engines alone are wanted.
bool asks_ecods(const Suite& suite, const SuiteOptions& options);

// The run in one sentence or two. Says so where ECoDS was not asked.
std::string verdict(std::span<const Suite> suites, const SuiteOptions& options, bool is_right);

}  // namespace ecods::bench
