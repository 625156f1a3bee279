// ECoDS alone on small workloads, without peers or oracle: what two builds of it are compared by.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace ecods::bench {

// One turn on one workload.
struct OwnSample {
    double ns = 0;                                // of processor time
    std::map<std::string, std::uint64_t> counts;  // of work: exact, the same in every turn
    std::string answers;                          // a hash of all of them
};

// Speaks over standard input and output until the input ends: first a line with the names of the workloads as a JSON
// array, then for each line with the index of a workload a line {"ns", "counts", "answers"}. Of a few queries and
// frames each when `is_quick`.
void serve_own_work(bool is_quick);

// Both directions of the protocol's lines. Throw std::runtime_error on a line of another form.
std::string to_line(const OwnSample& sample);
OwnSample parse_sample(const std::string& line);
std::vector<std::string> parse_names(const std::string& line);

}  // namespace ecods::bench
