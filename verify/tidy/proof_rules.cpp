#include "tidy/proof_rules.hpp"

#include <regex>
#include <sstream>
#include <string>

namespace ecods::tidy {
namespace {

// Adds the first match of each line: its group number `group`.
void find_in_lines(const std::string& text, const std::regex& pattern, std::size_t group, std::vector<Finding>& found) {
    std::istringstream lines{text};
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        std::smatch match;
        if (std::regex_search(line, match, pattern)) found.push_back({number, match.str(group)});
    }
}

}  // namespace

std::vector<Finding> find_derivations(std::string_view text) {
    static const std::regex in_comments("\\bu'|\\bDerivation\\b|\\bBound[.,:]|\\bv = 2\\^-23");
    static const std::regex in_code("\\b(double|float|auto|Double4|Floats) [a-z0-9_]*_bound(\\(| =)");
    std::vector<Finding> found;
    find_in_lines(comments_of(text), in_comments, 0, found);
    find_in_lines(without_comments(text), in_code, 0, found);
    return found;
}

std::vector<Finding> find_claims(std::string_view text) {
    static const std::regex claim("^ *// Claim: verify/proofs/([a-z0-9_]+\\.(g|py|md))$");
    std::vector<Finding> found;
    find_in_lines(comments_of(text), claim, 1, found);
    return found;
}

}  // namespace ecods::tidy
