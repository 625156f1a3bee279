// Who may include whom.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace ecods::tidy {

struct Include {
    std::string path;
    bool is_angled = false;  // <path>, not "path"
    int line = 0;            // from 1
};

// The include directives of a source text, in order. Those in comments do not count.
std::vector<Include> find_includes(std::string_view text);

// All source files of the repository, by their path from its root.
using Files = std::set<std::string, std::less<>>;

// The file that an include of `file` names: one of its own folder, or a path from the root, src, include, verify or
// bench. Nothing: none of `files`.
std::optional<std::string> resolve(const Files& files, std::string_view file, const Include& include);

// What is wrong with a file including another, or nothing. Files include their own room and the rooms that edges.cpp
// allows; include and src use no third party but Eigen, and src/simd the compiler's header of intrinsics; the other
// third parties have the places that include_rules.cpp lists.
std::optional<std::string> check_include(const Files& files, std::string_view file, const Include& include);

// What is wrong with the place of the file itself: it is in no room.
std::optional<std::string> check_place(std::string_view file);

// What is wrong with the table of rooms, or nothing: a row that names itself, a row below it, or a room that there is
// not.
std::optional<std::string> check_rooms();

// The files of a cycle of includes, or none. The graph maps each file to those that it includes.
std::vector<std::string> find_cycle(const std::map<std::string, std::vector<std::string>>& graph);

}  // namespace ecods::tidy
