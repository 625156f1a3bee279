#include "tidy/include_rules.hpp"

#include <algorithm>
#include <regex>
#include <sstream>

#include "tidy/edges.hpp"
#include "tidy/text_rules.hpp"

namespace ecods::tidy {
namespace {

// Where third parties may be used, by how their headers begin. Those that are not here may be used by everything but
// the library.
const std::vector<std::pair<std::string_view, std::vector<std::string_view>>> third_party_places = {
    {"CGAL/", {"verify/oracle", "verify/scenes/plane", "verify/unit", "bench/engines", "bench/suites"}},
    {"ccd/", {"bench/engines"}},
    {"fcl/", {"bench/engines", "bench/report", "bench/suites", "fuzz/engines", "verify/examples/coming_from"}},
    {"tbb/", {"verify/examples/thread_pool"}},
    {"gmp", {"verify/certificates/checker", "verify/oracle", "verify/unit", "fuzz/targets"}},
    {"BulletCollision/", {"bench/engines"}},
    {"bt", {"bench/engines"}},
    {"ode/", {"bench/engines"}},
    {"embree3/", {"bench/engines"}},
    {"pybind11/", {"src/python"}},
};

bool is_below(std::string_view file, std::string_view folder) {
    return file.starts_with(folder) && file.size() > folder.size() && file[folder.size()] == '/';
}

bool is_library(std::string_view file) {
    return is_below(file, "src") || is_below(file, "include");
}

// Standard headers have neither a folder nor an ending: <vector>, <cmath>.
bool is_standard(std::string_view path) {
    return path.find_first_of("/.") == std::string_view::npos;
}

std::optional<std::string> check_third_party(std::string_view file, std::string_view path) {
    // The compiler's own, of a processor's instructions.
    if (path == "immintrin.h") {
        if (is_below(file, "src/simd")) return std::nullopt;
        return "uses instructions of a processor outside src/simd";
    }
    // The module is built on the library, and is no part of it.
    if (is_library(file) && !is_below(file, "src/python")) {
        if (is_standard(path) || path.starts_with("Eigen/")) return std::nullopt;
        return "uses a third party that the installed library does not";
    }
    for (const auto& [beginning, places] : third_party_places) {
        if (!path.starts_with(beginning)) continue;
        const bool is_place =
            std::ranges::any_of(places, [&](std::string_view place) { return is_below(file, place); });
        if (!is_place) return "uses a third party outside its places";
    }
    return std::nullopt;
}

bool may_include(const Room& room, std::string_view target) {
    const Room* other = find_room(target);
    if (other == &room) return true;
    const bool is_public = is_below(target, "include");
    return std::ranges::any_of(room.below, [&](std::string_view name) {
        if (name == "include") return is_public;
        if (name == "include/plain") return is_plain_header(target);
        return other != nullptr && other->folder == name;
    });
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

std::optional<std::string> resolve(const Files& files, std::string_view file, const Include& include) {
    const std::string own_folder(file.substr(0, file.rfind('/') + 1));
    for (const std::string& place : {own_folder, std::string("src/"), std::string("include/"), std::string("verify/"),
                                     std::string(), std::string("bench/")}) {
        const bool is_own_of_library = is_library(file) && place == own_folder;
        const auto found = files.find(place + include.path);
        if (found != files.end() && !is_own_of_library) return *found;
    }
    return std::nullopt;
}

std::optional<std::string> check_include(const Files& files, std::string_view file, const Include& include) {
    const Room* room = find_room(file);
    if (room == nullptr) return "is in no room";
    if (include.is_angled && !include.path.starts_with("ecods/")) return check_third_party(file, include.path);
    const auto target = resolve(files, file, include);
    if (!target) return "includes a file that there is not (paths start at a root)";
    if (is_below(file, "include") && !is_below(*target, "include"))
        return "a public header includes public headers only";
    if (!may_include(*room, *target)) {
        return "includes a room that the table does not allow to " + std::string(room->folder);
    }
    return std::nullopt;
}

std::optional<std::string> check_place(std::string_view file) {
    if (find_room(file) == nullptr) return "is in no room of the table";
    return std::nullopt;
}

std::optional<std::string> check_rooms() {
    std::set<std::string_view> known = {"include/plain"};
    for (const Room& room : rooms()) {
        for (const std::string_view below : room.below) {
            if (!known.contains(below)) return std::string(room.folder) + " names " + std::string(below);
        }
        if (!known.insert(room.folder).second) return std::string(room.folder) + " is there twice";
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
