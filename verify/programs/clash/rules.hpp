// Which pairs of parts are judged: groups and rules of name patterns.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "programs/clash/report.hpp"

namespace ecods::clash {

// Whether the whole text is of the pattern: '*' is any bytes, '?' any one byte, everything else itself. Cost: at most
// the product of the lengths.
bool matches(std::string_view pattern, std::string_view text) noexcept;

// A pattern is of a part if it matches its name or its file's path.
struct Rules {
    std::vector<std::string> a = {};  // group A, and group B: a part is in a group if one of its patterns matches
    std::vector<std::string> b = {};
    std::vector<std::pair<std::string, std::string>> ignored =
        {};  // pairs of parts of which one matches each, not judged
};

// Sets the groups of the parts.
void set_groups(std::vector<Part>& parts, const Rules& rules);

// The rules, matched once for each part. The parts must have their groups, and outlive this.
class PairFilter {
  public:
    PairFilter(const std::vector<Part>& parts, const Rules& rules);

    // Either order. Without groups, all pairs that are not ignored; with one, those with a part of it; with both, those
    // with a part of A and another of B.
    bool is_judged(std::size_t a, std::size_t b) const noexcept;

  private:
    bool is_in(std::size_t part, std::size_t pattern) const noexcept {
        return matches_[part * pattern_count_ + pattern] != 0;
    }

    bool has_a_, has_b_;
    std::size_t pattern_count_;
    std::vector<char> in_a_, in_b_;  // by part
    std::vector<char> matches_;      // by part, then by pattern: 2 i and 2 i + 1 are those of rule i
};

}  // namespace ecods::clash
