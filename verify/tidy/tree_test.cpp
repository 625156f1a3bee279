// The rules on this repository.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>

#include "tidy/edges.hpp"
#include "tidy/include_rules.hpp"
#include "tidy/repository.hpp"
#include "tidy/text_rules.hpp"

namespace ecods::tidy {
namespace {

const std::set<std::string> folders = {"bench", "fuzz", "include", "src", "verify"};
// Of the tools around the sources.
const std::set<std::string> other_folders = {".github", ".ci", ".git", "build"};

bool is_source(const fs::path& file) {
    const auto ending = file.extension();
    return ending == ".cpp" || ending == ".hpp";
}

// The files of a folder, by their path from the root, in order.
std::vector<std::string> files_in(const std::string& folder) {
    std::vector<std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
        if (entry.is_regular_file()) files.push_back(fs::relative(entry.path(), root).generic_string());
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::vector<std::string> sources_in(const std::set<std::string>& places) {
    std::vector<std::string> files;
    for (const auto& place : places) {
        for (auto& file : files_in(place)) {
            if (is_source(file)) files.push_back(std::move(file));
        }
    }
    return files;
}

TEST(Tree, TopLevelFoldersAreTheAgreedOnes) {
    for (const auto& entry : fs::directory_iterator(root)) {
        const std::string name = entry.path().filename().string();
        if (!entry.is_directory()) continue;
        EXPECT_TRUE(folders.contains(name) || other_folders.contains(name)) << name;
    }
    for (const auto& folder : folders) EXPECT_TRUE(fs::is_directory(root / folder)) << folder;
}

Files all_files() {
    const auto files = sources_in(folders);
    return {files.begin(), files.end()};
}

TEST(Tree, RoomsAreInOrder) {
    EXPECT_EQ(check_rooms().value_or(""), "");
}

TEST(Tree, FilesIncludeOnlyRoomsThatTheTableAllows) {
    const Files files = all_files();
    int count = 0;
    for (const auto& file : files) {
        if (const auto wrong = check_place(file)) ADD_FAILURE() << file << " " << *wrong;
        for (const Include& include : find_includes(read(root / file))) {
            if (const auto wrong = check_include(files, file, include)) {
                ADD_FAILURE() << file << ":" << include.line << ": " << include.path << ": " << *wrong;
            }
            ++count;
        }
    }
    EXPECT_GT(count, 1000) << "the files were not found";
}

TEST(Tree, EveryRoomIsUsed) {
    const Files files = all_files();
    for (const Room& room : rooms()) {
        const bool has_file = std::ranges::any_of(files, [&](const auto& file) { return find_room(file) == &room; });
        EXPECT_TRUE(has_file) << room.folder;
    }
}

TEST(Tree, IncludesMakeNoCycle) {
    const Files files = all_files();
    std::map<std::string, std::vector<std::string>> graph;
    for (const auto& file : files) {
        auto& includes = graph[file];
        for (const Include& include : find_includes(read(root / file))) {
            if (auto target = resolve(files, file, include)) includes.push_back(std::move(*target));
        }
    }
    std::string cycle;
    for (const auto& file : find_cycle(graph)) cycle += file + " ";
    EXPECT_EQ(cycle, "");
}

TEST(Tree, NoFileIsLong) {
    for (const auto& file : sources_in(folders)) {
        EXPECT_LE(count_lines(read(root / file)), lines_max) << file;
    }
}

TEST(Tree, NoFunctionIsLong) {
    for (const auto& file : sources_in(folders)) {
        for (const Finding& finding : find_long_functions(read(root / file))) {
            ADD_FAILURE() << file << ":" << finding.line << ": " << finding.what;
        }
    }
}

TEST(Tree, TheProductSpeaksPlainly) {
    for (const auto& file : sources_in({"include", "src"})) {
        for (const Finding& finding : find_puzzling_words(read(root / file))) {
            ADD_FAILURE() << file << ":" << finding.line << ": in place of " << finding.what;
        }
    }
    for (const char* file :
         {"README.md", "bench/README.md", "fuzz/README.md", "src/README.md", "src/CHANGELOG.md", "src/cmake/README.md",
          "src/python/README.md", "verify/README.md", "verify/programs/README.md"}) {
        for (const Finding& finding : find_puzzling_prose(read(root / file))) {
            ADD_FAILURE() << file << ":" << finding.line << ": in place of " << finding.what;
        }
    }
}

TEST(Tree, CommentsBeginWithWhatTheySay) {
    for (const auto& file : sources_in({"include", "src"})) {
        for (const Finding& finding : find_vague_openings(read(root / file))) {
            ADD_FAILURE() << file << ":" << finding.line << ": in place of " << finding.what;
        }
    }
}

// The examples are built, run and compared with what they should print.
TEST(Tree, EachHeaderHasAnExample) {
    const std::string program = read(root / "verify/examples/how_do_i/main.cpp");
    const std::regex example("// Example: verify/examples/(own_shape|how_do_i, (\\w+)\\(\\))\\.\n");
    for (const auto& file : sources_in({"include"})) {
        if (file.ends_with("/ecods.hpp") || file.ends_with("/export.hpp")) continue;
        const std::string text = read(root / file);
        std::smatch named;
        ASSERT_TRUE(std::regex_search(text, named, example)) << file;
        if (named[2].matched) {
            EXPECT_NE(program.find("    " + named.str(2) + "();"), std::string::npos) << file;
        }
    }
}

TEST(Tree, VectorTypesAreSpelledInOneRoom) {
    for (const auto& file : sources_in({"include", "src"})) {
        if (file.starts_with("src/simd/")) continue;
        for (const Finding& finding : find_vector_types(read(root / file))) {
            ADD_FAILURE() << file << ":" << finding.line << ": " << finding.what;
        }
    }
    // Checks set the processor's rounding by its instructions, and the checker of certificates has two doubles of its
    // own.
    for (const auto& file : sources_in({"bench", "fuzz", "verify"})) {
        if (file.starts_with("verify/tidy/")) continue;
        EXPECT_EQ(without_comments(read(root / file)).find("vector_size"), std::string::npos) << file;
    }
}

TEST(Tree, CallsInCommentsAreOfCode) {
    std::map<std::string, std::string> texts;
    std::set<std::string> names;
    for (const auto& file : sources_in(folders)) names.merge(find_names(texts[file] = read(root / file)));
    for (const auto& [file, text] : texts) {
        if (file.starts_with("verify/tidy/")) continue;  // made-up text
        for (const Finding& finding : find_called_in_comments(text)) {
            EXPECT_TRUE(names.contains(finding.what))
                << file << ":" << finding.line << ": there is no " << finding.what;
        }
    }
}

TEST(Tree, TheProductHasNoTolerances) {
    for (const auto& file : sources_in({"include", "src"})) {
        for (const Finding& finding : find_tolerances(read(root / file))) {
            ADD_FAILURE() << file << ":" << finding.line << ": " << finding.what;
        }
    }
}

}  // namespace
}  // namespace ecods::tidy
