#include "tidy/text_rules.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <regex>
#include <span>
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

// The text with its comments, or with everything but these, replaced by spaces.
std::string blanked(std::string_view text, bool are_comments_blanked) {
    std::string result(text);
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = end_of_token(text, at);
        const bool is_comment = text.substr(at).starts_with("//") || text.substr(at).starts_with("/*");
        if (is_comment == are_comments_blanked) {
            for (std::size_t i = at; i < end; ++i) result[i] = result[i] == '\n' ? '\n' : ' ';
        }
        at = end;
    }
    return result;
}

// A word, as a regular expression, and what to write in its place.
struct PuzzlingWord {
    const char* word;
    const char* instead;
};

constexpr std::array prose_words = {
    PuzzlingWord{"horizons?", "lookahead"},
    PuzzlingWord{"habits?", "motion hint"},
    PuzzlingWord{"worn", "degraded"},
    PuzzlingWord{"newcomers?", "unsorted"},
    PuzzlingWord{"invented", "false positives"},
    PuzzlingWord{"missed", "false negatives"},
    PuzzlingWord{"lively", "dynamic"},
    PuzzlingWord{"rests|rested", "is at rest"},
    PuzzlingWord{"tells?|told|foretold", "say, show, apply"},
    PuzzlingWord{"anew", "again, from scratch"},
    PuzzlingWord{"mend(s|ed)?", "fix"},
    PuzzlingWord{"in sum", "together, summed"},
    PuzzlingWord{"centre[sd]?", "center"},
};
constexpr std::array source_words = {
    PuzzlingWord{"rooms?", "margin of a box, space in a list"},
    PuzzlingWord{"plant(s|ed)?", "build"},
    PuzzlingWord{"near_lanes", "overlap_mask"},
    PuzzlingWord{"tree_slabs", "slabs"},
    PuzzlingWord{"tree_frame", "local_frame"},
    PuzzlingWord{"outlines?", "support_table"},
    PuzzlingWord{"box_axes", "separating_axes"},
};

// Comments write these like calls, and they are none: the rounded value of a formula, and the word for clang-tidy.
constexpr std::array<std::string_view, 2> notations = {"fl", "NOLINTNEXTLINE"};

void find_words(std::string_view text, std::span<const PuzzlingWord> words, std::vector<Finding>& found) {
    for (const PuzzlingWord& each : words) {
        const std::regex pattern("(^|[^a-z])(" + std::string(each.word) + ")([^a-z]|$)", std::regex::icase);
        find_in_lines(std::string(text), pattern, each.instead, found);
    }
}

std::size_t indentation(std::string_view line) {
    return std::min(line.find_first_not_of(' '), line.size());
}

// Without comments, and without blanks at their ends.
std::vector<std::string> code_lines(std::string_view text) {
    std::vector<std::string> lines;
    std::istringstream in{without_comments(text)};
    for (std::string line; std::getline(in, line);) lines.push_back(line.substr(0, line.find_last_not_of(' ') + 1));
    return lines;
}

// The first line of what the line is a part of: a signature over some lines, without the template's parameters.
std::size_t begin_of_statement(std::span<const std::string> lines, std::size_t line) {
    const auto ends_before = [&](std::size_t i) {
        const std::string& before = lines[i - 1];
        return before.empty() || before[0] == '#' ||
               std::string_view(";{}:").find(before.back()) != std::string_view::npos;
    };
    std::size_t begin = line;
    while (begin > 0 && !ends_before(begin)) --begin;
    while (begin < line && std::string_view(lines[begin]).substr(indentation(lines[begin])).starts_with("template")) {
        while (begin < line && !lines[begin].ends_with('>')) ++begin;
        begin += begin < line;
    }
    return begin;
}

// The line with the closing brace of a block that is opened in the line `brace` of a statement which begins in the line
// `begin`; that line itself where what begins there is no block of lines.
std::size_t end_of_block(std::span<const std::string> lines, std::size_t begin, std::size_t brace) {
    const std::size_t outer = indentation(lines[begin]);
    for (std::size_t i = brace + 1; i < lines.size(); ++i) {
        if (lines[i].empty() || lines[i][0] == '#' || indentation(lines[i]) > outer) continue;
        return indentation(lines[i]) == outer && lines[i][outer] == '}' ? i : begin;
    }
    return begin;
}

}  // namespace

std::string without_comments(std::string_view text) {
    return blanked(text, true);
}

std::string comments_of(std::string_view text) {
    return blanked(text, false);
}

std::vector<Finding> find_tolerances(std::string_view text) {
    static const std::regex words("(^|[^a-z])(epsilon|slop|fudge|magic)s?([^a-z]|$)", std::regex::icase);
    static const std::regex decimals("(^|[^0-9a-zA-Z_.])[0-9]*\\.?[0-9]+\\.?e-[0-9]+", std::regex::icase);
    std::vector<Finding> found;
    find_in_lines(std::string(text), words, "a word that hides a decision", found);
    find_in_lines(without_comments(text), decimals, "a bare decimal tolerance", found);
    return found;
}

std::vector<Finding> find_puzzling_prose(std::string_view text) {
    std::vector<Finding> found;
    find_words(text, prose_words, found);
    return found;
}

std::vector<Finding> find_puzzling_words(std::string_view text) {
    // make_room is of memory.
    static const std::regex make_room("make_room");
    const std::string rest = std::regex_replace(std::string(text), make_room, "");
    static const std::regex elses("[,;:] else|or else");
    std::vector<Finding> found = find_puzzling_prose(rest);
    find_words(rest, source_words, found);
    find_in_lines(comments_of(text), elses, "otherwise", found);
    return found;
}

std::vector<Finding> find_vague_openings(std::string_view text) {
    static const std::regex comment("^ *// ?"), vague("^ *// (Of|What|Where|As|The same|Whether|That)\\b");
    static const std::regex denial("\\bnot (below|above)\\b");
    std::vector<Finding> found;
    std::istringstream lines{std::string(text)};
    bool was_comment = false;
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        const bool is_comment = std::regex_search(line, comment);
        std::smatch opening;
        if (is_comment && !was_comment && std::regex_search(line, opening, vague)) {
            found.push_back({number, "a subject and a verb: " + opening.str(1)});
        }
        was_comment = is_comment;
    }
    find_in_lines(comments_of(text), denial, "upper or lower bound", found);
    return found;
}

std::vector<Finding> find_long_functions(std::string_view text) {
    static const std::regex no_function("^ *(namespace|extern|class|struct|enum|union)\\b");
    const std::vector<std::string> lines = code_lines(text);
    std::vector<Finding> found;
    for (std::size_t brace = 0; brace < lines.size(); ++brace) {
        if (!lines[brace].ends_with('{') || lines[brace].ends_with("= {")) continue;
        const std::size_t begin = begin_of_statement(lines, brace);
        if (std::regex_search(lines[begin], no_function)) continue;
        const std::size_t end = end_of_block(lines, begin, brace);
        std::size_t count = 0;
        for (std::size_t i = begin; i <= end; ++i, ++count) {
            if (lines[i].ends_with("= {")) i = end_of_block(lines, i, i);
        }
        if (count <= function_lines_max) continue;
        found.push_back({static_cast<int>(begin + 1), std::to_string(count) + " lines"});
        brace = end;
    }
    return found;
}

std::set<std::string> find_names(std::string_view text) {
    const auto is_of_name = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
    const std::string code = without_comments(text);
    std::set<std::string> names;
    for (auto end = code.begin(); end != code.end();) {
        const auto begin = std::find_if(end, code.end(), is_of_name);
        end = std::find_if_not(begin, code.end(), is_of_name);
        if (begin != end && std::isdigit(static_cast<unsigned char>(*begin)) == 0) names.emplace(begin, end);
    }
    return names;
}

std::vector<Finding> find_called_in_comments(std::string_view text) {
    static const std::regex call("[A-Za-z_][A-Za-z_0-9]*(?=\\()");
    std::vector<Finding> found;
    std::istringstream lines{comments_of(text)};
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        for (std::sregex_iterator at(line.begin(), line.end(), call), end; at != end; ++at) {
            if (std::ranges::find(notations, at->str()) == notations.end()) found.push_back({number, at->str()});
        }
    }
    return found;
}

std::vector<Finding> find_vector_types(std::string_view text) {
    static const std::regex spelling(
        "\\b(__m(64|128|256|512)[a-z]*|__mmask[0-9]+|_mm[0-9]*_[a-z0-9_]+|_MM_[A-Z0-9_]+|_CMP_[A-Z]+_[A-Z]+|__builtin_"
        "ia32_[a-z0-9_]+|vector_size)\\b");
    std::vector<Finding> found;
    find_in_lines(without_comments(text), spelling, "a vector type or instruction", found);
    return found;
}

std::size_t count_lines(std::string_view text) {
    const auto ends = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
    return ends + (text.empty() || text.back() == '\n' ? 0 : 1);
}

}  // namespace ecods::tidy
