// Readers of files: whatever the bytes are, they are read or refused by an error of the promised type.
//
// The first byte chooses the format; what follows is the file.
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include "ecods/error.hpp"
#include "ecods/trace.hpp"
#include "fuzz/targets/require.hpp"
#include "scenes/io/read_error.hpp"
#include "scenes/io/scene_file.hpp"

namespace {

using namespace ecods;

constexpr std::array endings = {".obj", ".off", ".ply", ".stl", ".json", ".gltf", ".glb", ".trace"};

// A folder of its own, which goes with the process.
class Folder {
  public:
    Folder() : path_(std::filesystem::temp_directory_path() / ("ecods_fuzz_files_" + std::to_string(getpid()))) {
        std::filesystem::create_directories(path_);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

void read_trace(const std::string& text) {
    std::istringstream in(text);
    try {
        const ReplayReport report = replay(in, {.checks_invariants = true});
        ecods::fuzz::require(report.update_count <= report.call_count, "updates are calls");
    } catch (const InvalidTrace& error) {
        ecods::fuzz::require(error.line > 0, "an error names a line");
    } catch (const NotSupported&) {
    }
}

std::set<std::string> names_of(const scenes::Scene& scene) {
    std::set<std::string> names;
    for (const scenes::SceneBody& body : scene.bodies) names.insert(body.name);
    return names;
}

void read_scene(const std::string& text, const char* ending) {
    static const Folder folder;
    const std::filesystem::path file = folder.path() / (std::string("input") + ending);
    std::ofstream(file, std::ios::binary) << text;
    try {
        (void)scenes::read_files(std::array{file}, scenes::NamedFiles::in_folder);
    } catch (const scenes::ReadErrors& errors) {
        ecods::fuzz::require(errors.errors[0].text != "out of memory", "memory is bounded by the file");
    }
    try {
        const scenes::Scene scene = scenes::read_files(std::array{file});
        for (const scenes::SceneBody& body : scene.bodies) {
            ecods::fuzz::require(body.mesh_index < scene.meshes.size(), "a body has a mesh");
        }
        for (const scenes::Frame& frame : scene.frames) {
            for (const scenes::Move& move : frame.moves) {
                ecods::fuzz::require(move.body_index < scene.bodies.size(), "a move is of a body");
            }
        }
        ecods::fuzz::require(names_of(scene).size() == scene.bodies.size(), "no two bodies have one name");
    } catch (const scenes::ReadErrors& errors) {
        ecods::fuzz::require(errors.errors.size() == 1, "an error for the file that cannot be read");
        ecods::fuzz::require(!errors.errors[0].text.empty(), "an error says what is wrong");
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const char* ending = endings[data[0] % endings.size()];
    const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
    if (ending == endings.back()) {
        read_trace(text);
    } else {
        read_scene(text, ending);
    }
    return 0;
}
