// The rules on this repository.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "tidy/include_rules.hpp"
#include "tidy/text_rules.hpp"

namespace ecods::tidy {
namespace {

namespace fs = std::filesystem;

const fs::path root = ECODS_SOURCE_DIR;
const std::set<std::string> folders = {"bench", "fuzz", "include", "src", "verify"};
// Of the tools around the sources.
const std::set<std::string> other_folders = {".ci", ".git", "build"};

std::string read(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

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

TEST(Tree, FilesIncludeNoHigherLayer) {
    int count = 0;
    for (const auto& file : sources_in({"include", "src", "verify/oracle"})) {
        if (const auto wrong = check_place(file)) ADD_FAILURE() << file << " " << *wrong;
        for (const Include& include : find_includes(read(root / file))) {
            if (const auto wrong = check_include(file, include)) {
                ADD_FAILURE() << file << ":" << include.line << ": " << include.path << ": " << *wrong;
            }
            ++count;
        }
    }
    EXPECT_GT(count, 50) << "the files were not found";
}

TEST(Tree, IncludesMakeNoCycle) {
    std::map<std::string, std::vector<std::string>> graph;
    for (const auto& file : sources_in({"include", "src"})) {
        auto& includes = graph[file];
        for (const Include& include : find_includes(read(root / file))) {
            for (const std::string place : {"include/", "src/"}) {
                if (!include.is_angled && fs::exists(root / (place + include.path))) {
                    includes.push_back(place + include.path);
                }
            }
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

TEST(Tree, TheProductHasNoTolerances) {
    for (const auto& file : sources_in({"include", "src"})) {
        for (const Finding& finding : find_tolerances(read(root / file))) {
            ADD_FAILURE() << file << ":" << finding.line << ": " << finding.what;
        }
    }
}

}  // namespace
}  // namespace ecods::tidy
