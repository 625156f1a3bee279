// An engine's answers beside the oracle's.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

#include "fuzz/engines/engine_under_test.hpp"

namespace ecods::fuzz {

// Of one engine and one family. Each query is asked in both orders.
struct Verdicts {
    std::size_t queries = 0;
    std::size_t hits = 0;             // of the oracle
    std::size_t answered = 0;         // queries; the rest crashed, hung, threw, or came after too many that did
    std::size_t false_negatives = 0;  // hits that the engine denies, in the first order
    std::size_t false_positives = 0;  // hits that are none, in the first order
    std::size_t asymmetric = 0;       // answers that differ between the orders
    std::size_t crashed = 0;          // or ended, or threw
    std::size_t hung = 0;
    std::string first_failure = {};
    std::vector<std::size_t> wrong = {};  // the first few queries with a wrong answer in either order

    bool is_right() const { return answered == queries && false_negatives + false_positives + asymmetric == 0; }
};

// Which queries touch.
std::vector<bool> ask_oracle(const scenes::MeshPairs& pairs);

// Runs the engine in a child process. A query that takes longer than the limit hangs. After eight failures no more
// queries are asked.
Verdicts judge(const EngineMaker& engine, const scenes::MeshPairs& pairs, const std::vector<bool>& truth,
               std::chrono::seconds limit);

}  // namespace ecods::fuzz
