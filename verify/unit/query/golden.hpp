// The work of a workload, exactly: who changes a tree, a bound or the order of a search sees here what it costs.
#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace ecods {

struct Golden {
    std::string workload;
    std::vector<std::uint64_t> counts;

    friend bool operator==(const Golden&, const Golden&) = default;
    // As it stands in a list of them.
    friend std::ostream& operator<<(std::ostream& out, const Golden& golden) {
        out << "{\"" << golden.workload << "\", {";
        for (const std::uint64_t count : golden.counts) out << (&count == golden.counts.data() ? "" : ", ") << count;
        return out << "}}";
    }
};

}  // namespace ecods
