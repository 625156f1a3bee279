// Truths of the queries of a workload are the answers of ECoDS, some of which are judged by the oracle.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "harness/turns.hpp"

namespace ecods::bench {

template <class Answer>
struct Truths {
    std::vector<Answer> answers;
    std::size_t judged_count = 0;
    std::size_t wrong_count = 0;  // of these, ECoDS answered otherwise than the oracle, whose answer stands above
};

// `own(query, i)` asks ECoDS, `judge(query)` the oracle; so many queries, spread evenly, are judged.
template <class Answer, class Query, class Own, class Judge, class IsSame = std::equal_to<>>
Truths<Answer> find_truths(const std::vector<Query>& queries, std::size_t judged_count, const Own& own,
                           const Judge& judge, const IsSame& is_same = {}) {
    Truths<Answer> truths;
    for (std::size_t i = 0; i < queries.size(); ++i) {
        truths.answers.push_back(own(queries[i], i));
        if (!is_chosen(i, queries.size(), std::min(judged_count, queries.size()))) continue;
        ++truths.judged_count;
        Answer exact = judge(queries[i]);
        if (!is_same(truths.answers.back(), exact)) ++truths.wrong_count;
        truths.answers.back() = std::move(exact);
    }
    return truths;
}

}  // namespace ecods::bench
