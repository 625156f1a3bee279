#include "tidy/include_rules.hpp"

#include <algorithm>
#include <functional>
#include <regex>
#include <set>
#include <sstream>

#include "tidy/text_rules.hpp"

namespace ecods::tidy {
namespace {

// The layers, from the bottom.
const std::map<std::string, int, std::less<>> layer_ranks = {
    {"base", 0}, {"geometry", 1}, {"exact", 2}, {"bounds", 3}, {"narrow_phase", 4}, {"broad_phase", 5}, {"world", 6},
};

// A public header belongs to the layer that implements it; ecods.hpp is all of them.
const std::map<std::string, int, std::less<>> header_ranks = {
    {"ids.hpp", 0},
    {"error.hpp", 0},
    {"version.hpp", 0},
    {"pose.hpp", 1},
    {"mesh.hpp", 1},
    {"predicates.hpp", 2},
    {"aabb.hpp", 3},
    {"shape.hpp", 4},
    {"intersection.hpp", 4},
    {"broad_phase.hpp", 5},
    {"collision_filter.hpp", 6},
    {"executor.hpp", 6},
    {"trace.hpp", 6},
    {"world.hpp", 6},
    {"replay.hpp", 6},
    {"ecods.hpp", 7},
};

// What the oracle may know of the library.
const std::set<std::string, std::less<>> plain_data = {"aabb.hpp", "error.hpp", "ids.hpp",
                                                       "mesh.hpp", "pose.hpp",  "predicates.hpp"};

template <class Ranks>
std::optional<int> find_rank(const Ranks& ranks, std::string_view name) {
    const auto at = ranks.find(name);
    if (at == ranks.end()) return std::nullopt;
    return at->second;
}

// The part of a path after a leading folder, or nothing when it does not lead there.
std::optional<std::string_view> below(std::string_view path, std::string_view folder) {
    if (!path.starts_with(folder)) return std::nullopt;
    return path.substr(folder.size());
}

std::string_view first_part(std::string_view path) {
    return path.substr(0, path.find('/'));
}

// Standard headers have neither a folder nor an ending: <vector>, <cmath>.
bool is_standard(std::string_view path) {
    return path.find_first_of("/.") == std::string_view::npos;
}

std::optional<std::string> check_third_party(std::string_view path, bool may_use_highway) {
    if (is_standard(path) || path.starts_with("Eigen/")) return std::nullopt;
    if (may_use_highway && path.starts_with("hwy/")) return std::nullopt;
    return "uses a third party that the installed library does not";
}

std::optional<std::string> check_public_header(int rank, const Include& include) {
    if (include.is_angled) return check_third_party(include.path, false);
    const auto header = below(include.path, "ecods/");
    if (!header) return "a public header includes public headers only";
    const auto other = find_rank(header_ranks, *header);
    if (!other) return "includes a public header without a rank";
    if (*other > rank) return "includes a higher layer";
    return std::nullopt;
}

std::optional<std::string> check_source(std::string_view layer, int rank, const Include& include) {
    if (include.is_angled) return check_third_party(include.path, true);
    if (const auto header = below(include.path, "ecods/")) {
        const auto other = find_rank(header_ranks, *header);
        if (!other) return "includes a public header without a rank";
        if (*other > rank) return "includes a higher layer";
        return std::nullopt;
    }
    const std::string_view other_layer = first_part(include.path);
    const auto other = find_rank(layer_ranks, other_layer);
    if (!other) return "includes what is neither a layer nor public (paths start at src)";
    if (*other > rank) return "includes a higher layer";
    if (*other == rank && other_layer != layer) return "includes another layer of its own rank";
    return std::nullopt;
}

std::optional<std::string> check_oracle(const Include& include) {
    const std::string_view path = include.path;
    if (const auto header = below(path, "ecods/")) {
        if (!plain_data.contains(*header)) return "the oracle uses public headers of plain data only";
    } else if (layer_ranks.contains(first_part(path)) || path.find("src/") != std::string_view::npos) {
        return "the oracle shares no code with src";
    }
    return std::nullopt;
}

}  // namespace

std::vector<Include> find_includes(std::string_view text) {
    static const std::regex directive(R"re(^\s*#\s*include\s*([<"])([^>"]+)[>"].*)re");
    std::vector<Include> includes;
    std::istringstream lines{without_comments(text)};
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        std::smatch match;
        if (std::regex_match(line, match, directive)) {
            includes.push_back({.path = match[2], .is_angled = match[1] == "<", .line = number});
        }
    }
    return includes;
}

std::optional<std::string> check_include(std::string_view file, const Include& include) {
    if (const auto header = below(file, "include/ecods/")) {
        return check_public_header(find_rank(header_ranks, *header).value_or(-1), include);
    }
    if (const auto source = below(file, "src/")) {
        const std::string_view layer = first_part(*source);
        return check_source(layer, find_rank(layer_ranks, layer).value_or(-1), include);
    }
    if (file.starts_with("verify/oracle/")) return check_oracle(include);
    return std::nullopt;
}

std::optional<std::string> check_place(std::string_view file) {
    if (!file.ends_with(".hpp") && !file.ends_with(".cpp")) return std::nullopt;
    if (const auto header = below(file, "include/")) {
        const auto name = below(*header, "ecods/");
        if (!name || !header_ranks.contains(*name)) return "is a public header without a rank";
    }
    if (const auto source = below(file, "src/")) {
        if (!layer_ranks.contains(first_part(*source))) return "is in no layer";
    }
    return std::nullopt;
}

std::vector<std::string> find_cycle(const std::map<std::string, std::vector<std::string>>& graph) {
    // Takes away files that include nothing that is left; what cannot be taken away lies on a cycle or leads to one.
    std::set<std::string> left;
    for (const auto& [file, includes] : graph) left.insert(file);
    const auto leads_on = [&](const std::string& file) {
        const auto& includes = graph.at(file);
        return std::any_of(includes.begin(), includes.end(), [&](const auto& other) { return left.contains(other); });
    };
    while (std::erase_if(left, [&](const std::string& file) { return !leads_on(file); }) > 0) {
    }
    if (left.empty()) return {};
    std::vector<std::string> path;
    std::string at = *left.begin();
    while (std::find(path.begin(), path.end(), at) == path.end()) {
        path.push_back(at);
        const auto& includes = graph.at(at);
        at = *std::find_if(includes.begin(), includes.end(), [&](const auto& other) { return left.contains(other); });
    }
    path.erase(path.begin(), std::find(path.begin(), path.end(), at));
    return path;
}

}  // namespace ecods::tidy
