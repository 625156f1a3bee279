// Who may include whom.
#pragma once

#include <map>
#include <optional>
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

// What is wrong with a file of include/ecods, src or verify/oracle including another; nothing when all is well. Paths
// are relative to the repository's root. Files elsewhere may include what they like.
//
// * A file includes files of lower rank, files of its own layer, and public headers up to its own rank.
// * A public header includes public headers only.
// * The oracle shares no code with src, and of the public headers uses those of plain data.
// * Of third parties, include and src use Eigen; src also Highway (hwy).
std::optional<std::string> check_include(std::string_view file, const Include& include);

// What is wrong with the file itself: a folder of src or a public header that has no rank.
std::optional<std::string> check_place(std::string_view file);

// The files of a cycle of includes, or none. The graph maps each file to those that it includes.
std::vector<std::string> find_cycle(const std::map<std::string, std::vector<std::string>>& graph);

}  // namespace ecods::tidy
