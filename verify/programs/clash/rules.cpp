#include "programs/clash/rules.hpp"

#include <algorithm>

namespace ecods::clash {
namespace {

bool is_of(std::string_view pattern, const Part& part) noexcept {
    return matches(pattern, part.name) || matches(pattern, part.file);
}

bool is_of(const std::vector<std::string>& patterns, const Part& part) noexcept {
    return std::any_of(patterns.begin(), patterns.end(), [&](const std::string& one) { return is_of(one, part); });
}

}  // namespace

bool matches(std::string_view pattern, std::string_view text) noexcept {
    constexpr std::size_t none = std::string_view::npos;
    std::size_t p = 0;
    std::size_t star = none;  // the newest '*', which takes the text up to `taken`
    std::size_t taken = 0;
    for (std::size_t t = 0; t < text.size();) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            taken = t;
        } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == text[t])) {
            ++p;
            ++t;
        } else if (star != none) {
            p = star + 1;
            t = ++taken;
        } else {
            return false;
        }
    }
    return pattern.find_first_not_of('*', p) == none;
}

void set_groups(std::vector<Part>& parts, const Rules& rules) {
    for (Part& part : parts) {
        part.group.clear();
        if (is_of(rules.a, part)) part.group += 'a';
        if (is_of(rules.b, part)) part.group += 'b';
    }
}

PairFilter::PairFilter(const std::vector<Part>& parts, const Rules& rules)
    : has_a_(!rules.a.empty()), has_b_(!rules.b.empty()), pattern_count_(2 * rules.ignored.size()) {
    for (const Part& part : parts) {
        in_a_.push_back(part.group.find('a') != std::string::npos);
        in_b_.push_back(part.group.find('b') != std::string::npos);
        for (const auto& [one, other] : rules.ignored) {
            matches_.push_back(is_of(one, part));
            matches_.push_back(is_of(other, part));
        }
    }
}

bool PairFilter::is_judged(std::size_t a, std::size_t b) const noexcept {
    const bool a_then_b = (!has_a_ || in_a_[a] != 0) && (!has_b_ || in_b_[b] != 0);
    const bool b_then_a = (!has_a_ || in_a_[b] != 0) && (!has_b_ || in_b_[a] != 0);
    if (!a_then_b && !b_then_a) return false;
    for (std::size_t rule = 0; rule < pattern_count_; rule += 2) {
        if (is_in(a, rule) && is_in(b, rule + 1)) return false;
        if (is_in(b, rule) && is_in(a, rule + 1)) return false;
    }
    return true;
}

}  // namespace ecods::clash
