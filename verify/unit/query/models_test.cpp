// The meshes of Debian's assimp-testmodels: which bound a solid, and why others do not, as in models.txt; small ones
// beside the oracle.
//
// After a change that is right: models_tests > /dev/null, with ECODS_MODELS naming the file that is to be written.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "ecods/error.hpp"
#include "judge/solid_truth.hpp"
#include "scenes/io/gltf_file.hpp"
#include "scenes/io/mesh_file.hpp"

namespace ecods {
namespace {

namespace fs = std::filesystem;

const fs::path folder = "/usr/share/assimp/models";
constexpr std::size_t oracle_triangles_max = 1500;

std::string describe(const Mesh& mesh) {
    const std::vector<TrianglePair> pairs = self_intersections(mesh);
    const std::string crossings = pairs.empty() ? ""
                                                : fmt::format("; {} pairs of triangles intersect, {} and {} first",
                                                              pairs.size(), pairs[0].a, pairs[0].b);
    try {
        check_solid(mesh);
    } catch (const NotSolid& error) {
        if (error.reason == NotSolid::Reason::open_edge) {
            return fmt::format("open at edge {} of triangle {}{}", error.corner, error.triangle, crossings);
        }
        EXPECT_EQ(error.reason, NotSolid::Reason::self_intersection);
        EXPECT_EQ(error.triangles, pairs.front());
        return "closed" + crossings;
    }
    EXPECT_TRUE(pairs.empty());
    return "solid";
}

std::vector<scenes::NamedMesh> meshes_of(const fs::path& file) {
    try {
        if (scenes::is_gltf_file(file)) return scenes::read_gltf_file(file).meshes;
        if (scenes::is_mesh_file(file)) return {{"", scenes::read_mesh_file(file)}};
    } catch (const std::exception&) {  // some are broken on purpose, others have points or lines alone
    }
    return {};
}

std::string describe_all() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) files.push_back(entry.path());
    }
    std::ranges::sort(files);
    std::string text;
    for (const fs::path& file : files) {
        std::size_t number = 0;
        for (const auto& [name, mesh] : meshes_of(file)) {
            const std::size_t count = mesh->triangles().size();
            text += fmt::format("{} {}: {} triangles: {}\n", fs::relative(file, folder).string(), number++, count,
                                describe(*mesh));
            if (count > oracle_triangles_max) continue;
            const auto wrong = judge::ask_whether_solid(*mesh);
            EXPECT_FALSE(wrong) << file << ": " << wrong->question << ": expected " << wrong->expected << ", got "
                                << wrong->got;
        }
    }
    return text;
}

TEST(Models, EachIsASolidOrNot) {
    if (!fs::exists(folder)) GTEST_SKIP() << "assimp-testmodels is not installed";
    const std::string text = describe_all();
    if (const char* file = std::getenv("ECODS_MODELS")) {
        std::ofstream(file) << text;
        return;
    }
    std::ifstream known(ECODS_MODELS_FILE);
    std::ostringstream expected;
    expected << known.rdbuf();
    std::istringstream lines(text), known_lines(expected.str());
    for (std::string line, known_line; std::getline(lines, line) && std::getline(known_lines, known_line);) {
        EXPECT_EQ(line, known_line);
    }
    EXPECT_EQ(text.size(), expected.str().size());
}

}  // namespace
}  // namespace ecods
