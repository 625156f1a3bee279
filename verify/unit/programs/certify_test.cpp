// --certify of ecods_check and ecods_replay: where the files are, and what the checker says about them.
#include <algorithm>
#include <fstream>
#include <iterator>

#include "program_test.hpp"
#include "trace_of_cubes.hpp"

namespace ecods::scenes {
namespace {

class Certify : public ProgramTest {
  protected:
    static std::string text(const std::filesystem::path& file) {
        std::ifstream in(file, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }

    // `command` with --certify `place`: `file` and `mesh_count` meshes beside it are all there is in its folder, and
    // the checker says this about them.
    void expect_certified(const std::string& command, const std::string& place, const std::filesystem::path& file,
                          std::ptrdiff_t mesh_count, const std::string& verdicts) const {
        SCOPED_TRACE(command + " --certify " + place);
        const ProgramResult made = run_program(command, "--certify " + place);
        EXPECT_EQ(made.status, 0) << made.err;
        ASSERT_TRUE(std::filesystem::is_regular_file(file));
        const std::filesystem::directory_iterator files(file.parent_path());
        const std::ptrdiff_t others = std::count_if(begin(files), end(files), [&](const auto& each) {
            return each.path() != file && each.path().extension() == ".mesh";
        });
        EXPECT_EQ(others, mesh_count);
        const ProgramResult checked =
            run_program(ECODS_CERTIFICATE_CHECKER, file.string() + " " + file.parent_path().string() + "/*.mesh");
        EXPECT_EQ(checked.status, 0);
        EXPECT_EQ(checked.out, verdicts);
    }

    // A file in a folder that is not there yet, a folder that is there, and one that is not.
    void expect_certified(const std::string& command, std::ptrdiff_t mesh_count, const std::string& verdicts) const {
        std::filesystem::create_directory(path("here"));
        const auto in = [&](const std::string& folder) { return path(folder) / "certificates.txt"; };
        expect_certified(command, path("new/proofs").string(), path("new/proofs"), mesh_count, verdicts);
        expect_certified(command, path("here").string(), in("here"), mesh_count, verdicts);
        expect_certified(command, path("there").string() + "/", in("there"), mesh_count, verdicts);
        EXPECT_EQ(text(in("here")), text(path("new/proofs")));
        EXPECT_EQ(text(in("there")), text(path("new/proofs")));
        // What was in the file is gone.
        expect_certified(command, path("new/proofs").string(), path("new/proofs"), mesh_count, verdicts);
    }
};

TEST_F(Certify, FramesOfAScene) {
    const auto scene = write("scene.json", R"({
      "meshes": [ { "name": "flat", "vertices": [[0, 0, 0], [4, 0, 0], [0, 4, 0]], "triangles": [[0, 1, 2]] },
                  { "name": "upright", "vertices": [[1, 1, 0], [1, 1, 1], [2, 1, 1]], "triangles": [[0, 1, 2]] } ],
      "bodies": [ { "name": "ground", "mesh": "flat" }, { "name": "blade", "mesh": "upright" } ],
      "frames": [ { "moves": [ { "body": "blade", "pose": { "t": [0, 0, 1] } } ] } ] })");
    const std::string command = ECODS_CHECK_PROGRAM " " + scene.string();
    expect_certified(command, 2,
                     "accepted: world of 2 bodies, 1 colliding, 0 pairs not judged\n"
                     "accepted: world of 2 bodies, 0 colliding, 0 pairs not judged\n");
    expect_certified(command + " --distance", 2,
                     "accepted: world of 2 bodies, 1 colliding, 0 pairs not judged\n"
                     "accepted: distance 0x0p+0 0 0\n"
                     "accepted: world of 2 bodies, 0 colliding, 0 pairs not judged\n"
                     "accepted: distance 0x1p+0 f 0 v 0 0\n");
}

TEST_F(Certify, UpdatesOfATrace) {
    const std::string command = ECODS_REPLAY_PROGRAM " " + write("trace.txt", trace_of_cubes()).string();
    expect_certified(command, 1,
                     "accepted: world of 2 bodies, 1 colliding, 0 pairs not judged\n"
                     "accepted: world of 2 bodies, 1 colliding, 0 pairs not judged\n"
                     "accepted: world of 2 bodies, 0 colliding, 0 pairs not judged\n");
}

TEST_F(Certify, AFileThatCannotBeWrittenIsStatus2) {
    const std::string mesh = write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").string();
    const ProgramResult result = run_program(ECODS_CHECK_PROGRAM, mesh + " --certify " + mesh + "/proofs");
    EXPECT_EQ(result.status, 2);
    EXPECT_NE(result.err, "");
}

}  // namespace
}  // namespace ecods::scenes
