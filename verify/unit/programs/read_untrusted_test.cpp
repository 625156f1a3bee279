// Files from strangers: which other files they may name.
#include <nlohmann/json.hpp>

#include "gltf_test.hpp"
#include "scenes/io/scene_file.hpp"

namespace ecods::scenes {
namespace {

namespace fs = std::filesystem;

class ReadUntrusted : public ReadGltf {
  protected:
    ReadUntrusted() {
        fs::create_directories(path("in/sub"));
        write("in/sub/data.bin", data());
        write("data.bin", data());
        write("in/sub/t.obj", triangle);
        write("t.obj", triangle);
    }

    static Json gltf(const std::string& uri) {
        Json json = model();
        json["buffers"][0]["uri"] = uri;
        return json;
    }
    static Json scene(const std::string& mesh) {
        return {{"meshes", {{{"name", "m"}, {"file", mesh}}}}, {"bodies", {{{"name", "b"}, {"mesh", "m"}}}}};
    }

    // Both kinds of files that name others, each with the name behind it: a buffer, or a mesh.
    void expect_read(const std::string& buffer, const std::string& mesh) {
        for (const NamedFiles allowed : {NamedFiles::anywhere, NamedFiles::in_folder}) {
            EXPECT_EQ(read_file(write("in/m.gltf", gltf(buffer).dump()), allowed).bodies.size(), 1U) << buffer;
            EXPECT_EQ(read_file(write("in/s.json", scene(mesh).dump()), allowed).bodies.size(), 1U) << mesh;
        }
    }
    void expect_refused(const std::string& buffer, const std::string& mesh) {
        const auto gltf_file = write("in/m.gltf", gltf(buffer).dump());
        expect_error([&] { read_file(gltf_file, NamedFiles::in_folder); }, gltf_file, "buffers[0].uri",
                     "names " + buffer + ", which is outside of the folder of m.gltf; --untrusted");
        const auto scene_file = write("in/s.json", scene(mesh).dump());
        expect_error([&] { read_file(scene_file, NamedFiles::in_folder); }, scene_file, "meshes[0].file",
                     "names " + mesh + ", which is outside of the folder of s.json; --untrusted");
    }

    static constexpr const char* triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
};

TEST_F(ReadUntrusted, FilesInTheFolderAndBelowAreRead) {
    expect_read("sub/data.bin", "sub/t.obj");
    expect_read("sub/../sub/./data.bin", "sub/../sub/./t.obj");
    expect_read("../in/sub/data.bin", "../in/sub/t.obj");
    expect_read(path("in/sub/data.bin").string(), path("in/sub/t.obj").string());
    fs::create_symlink("sub", path("in/link"));
    expect_read("link/data.bin", "link/t.obj");
    expect_read("../in/link/../sub/data.bin", "../in/link/../sub/t.obj");
}

TEST_F(ReadUntrusted, FilesElsewhereAreRefused) {
    expect_refused("../data.bin", "../t.obj");
    expect_refused("sub/../../data.bin", "sub/../../t.obj");
    expect_refused(path("data.bin").string(), path("t.obj").string());
    expect_refused("../in2/data.bin", "../in2/t.obj");
    fs::create_symlink("..", path("in/up"));
    expect_refused("up/data.bin", "up/t.obj");
    fs::create_symlink("../data.bin", path("in/linked.bin"));
    fs::create_symlink("../t.obj", path("in/linked.obj"));
    expect_refused("linked.bin", "linked.obj");
    fs::create_symlink("loop", path("in/loop"));
    expect_refused("loop", "loop");
    EXPECT_EQ(read_file(write("in/m.gltf", gltf("../data.bin").dump())).bodies.size(), 1U);
    EXPECT_EQ(read_file(write("in/s.json", scene("linked.obj").dump())).bodies.size(), 1U);
    const fs::path before = fs::current_path();
    fs::current_path(path("in"));
    expect_error([&] { read_file("m.gltf", NamedFiles::in_folder); }, "m.gltf", "buffers[0].uri", "--untrusted");
    write("in/m.gltf", gltf("sub/data.bin").dump());
    EXPECT_EQ(read_file("m.gltf", NamedFiles::in_folder).bodies.size(), 1U) << "the folder has no name";
    fs::current_path(before);
}

// The names of files elsewhere may be guesses.
TEST_F(ReadUntrusted, ErrorsTellNothingAboutFilesElsewhere) {
    const auto error_of = [&](const std::string& name) -> std::string {
        try {
            read_file(write("in/m.gltf", gltf(name).dump()), NamedFiles::in_folder);
        } catch (const ReadError& error) {
            return error.text;
        }
        return "";
    };
    const std::string of_none = error_of("../none");
    const auto expect_alike = [&] { EXPECT_EQ(error_of("../some").replace(6, 7, "../none"), of_none); };
    expect_alike();
    write("some", "seven b");
    expect_alike();
    fs::remove(path("some"));
    fs::create_directory(path("some"));
    expect_alike();
    EXPECT_EQ(of_none.find("byte"), std::string::npos);
}

TEST_F(ReadUntrusted, AZeroByteEndsNoPath) {
    const auto file = write("in/m.gltf", gltf("sub/data.bin%00/../../../data.bin").dump());
    expect_error([&] { read_file(file, NamedFiles::in_folder); }, file, "buffers[0].uri", "no such file");
    const auto data_uri = gltf("data:application/octet-stream;base64," + std::string(88, 'A'));
    const auto embedded = write("in/d.gltf", data_uri.dump());
    expect_error([&] { read_file(embedded, NamedFiles::in_folder); }, embedded, "buffers[0]", "there are 66 bytes");
}

// A scene names a thousand meshes, which are one file.
TEST_F(ReadUntrusted, AMeshFileIsReadOnce) {
    Json json = scene("sub/t.obj");
    json["meshes"].push_back({{"name", "n"}, {"file", "sub/./t.obj"}});
    const Scene read = read_file(write("in/s.json", json.dump()));
    ASSERT_EQ(read.meshes.size(), 2U);
    EXPECT_EQ(read.meshes[0].mesh, read.meshes[1].mesh);
}

}  // namespace
}  // namespace ecods::scenes
