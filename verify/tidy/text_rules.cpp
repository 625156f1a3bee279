#include "tidy/text_rules.hpp"

#include <algorithm>
#include <regex>
#include <sstream>

namespace ecods::tidy {
namespace {

void find_in_lines(const std::string& text, const std::regex& pattern, const char* what, std::vector<Finding>& found) {
    std::istringstream lines{text};
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        std::smatch match;
        if (std::regex_search(line, match, pattern)) found.push_back({number, what + (": " + match.str())});
    }
}

// The end of what starts at `at`: a comment, a literal, or one character.
std::size_t end_of_token(std::string_view text, std::size_t at) {
    const auto after = [&](std::string_view end, std::size_t from) {
        const std::size_t found = text.find(end, from);
        return found == std::string_view::npos ? text.size() : found + end.size();
    };
    const std::string_view rest = text.substr(at);
    if (rest.starts_with("//")) return std::min(text.find('\n', at), text.size());
    if (rest.starts_with("/*")) return after("*/", at + 2);
    if (rest.starts_with("R\"")) {
        const std::size_t open = text.find('(', at);
        if (open == std::string_view::npos) return text.size();
        std::string close(1, ')');
        close.append(text.substr(at + 2, open - at - 2)).push_back('"');
        return after(close, open);
    }
    const bool is_separator = at > 0 && text[at] == '\'' && std::isalnum(static_cast<unsigned char>(text[at - 1]));
    if ((text[at] == '"' || text[at] == '\'') && !is_separator) {
        std::size_t end = at + 1;
        while (end < text.size() && text[end] != text[at] && text[end] != '\n') end += text[end] == '\\' ? 2 : 1;
        return std::min(end + 1, text.size());
    }
    return at + 1;
}

}  // namespace

std::string without_comments(std::string_view text) {
    std::string result(text);
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = end_of_token(text, at);
        if (text.substr(at).starts_with("//") || text.substr(at).starts_with("/*")) {
            for (std::size_t i = at; i < end; ++i) result[i] = result[i] == '\n' ? '\n' : ' ';
        }
        at = end;
    }
    return result;
}

std::vector<Finding> find_tolerances(std::string_view text) {
    static const std::regex words("(^|[^a-z])(epsilon|slop|fudge|magic)s?([^a-z]|$)", std::regex::icase);
    static const std::regex decimals("(^|[^0-9a-zA-Z_.])[0-9]*\\.?[0-9]+\\.?e-[0-9]+", std::regex::icase);
    std::vector<Finding> found;
    find_in_lines(std::string(text), words, "a word that hides a decision", found);
    find_in_lines(without_comments(text), decimals, "a bare decimal tolerance", found);
    return found;
}

std::size_t count_lines(std::string_view text) {
    const auto ends = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
    return ends + (text.empty() || text.back() == '\n' ? 0 : 1);
}

}  // namespace ecods::tidy
