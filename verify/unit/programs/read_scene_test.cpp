// Scene files, and several files in one scene.
#include <nlohmann/json.hpp>
#include <vector>

#include "file_test.hpp"
#include "scenes/io/scene_file.hpp"

namespace ecods::scenes {
namespace {

using Json = nlohmann::json;

class ReadScene : public FileTest {
  protected:
    static Json scene() {
        return Json::parse(R"({
          "_comment": "two triangles",
          "meshes": [ { "name": "file", "file": "sub/t.obj" },
                      { "name": "inline", "vertices": [[0, 0, 0], [0.1, 0, 0], [0, 1e-300, 0]],
                        "triangles": [[0, 1, 2]] } ],
          "bodies": [ { "name": "a", "mesh": "inline" },
                      { "name": "b", "mesh": "file",
                        "pose": { "R": [[0, -1, 0], [1, 0, 0], [0, 0, 1]], "t": [1, 2, 0.1] },
                        "motion": [0, -2.5, 0.1] } ],
          "frames": [ { "moves": [ { "body": "b", "pose": { "t": [0, 0, 3] } } ] }, { "moves": [] } ] })");
    }

    std::filesystem::path write_scene(const Json& json) {
        std::filesystem::create_directories(path("sub"));
        write("sub/t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        return write("scene.json", json.dump(1));
    }

    void expect_bad(const Json& json, const std::string& place, const std::string& text) {
        const auto file = write_scene(json);
        expect_error([&] { read_scene_file(file); }, file, place, text);
    }
};

TEST_F(ReadScene, ReadsAll) {
    const Scene s = read_scene_file(write_scene(scene()));
    ASSERT_EQ(s.meshes.size(), 2U);
    EXPECT_EQ(s.meshes[1].mesh->vertices()[1][0], 0.1);
    EXPECT_EQ(s.meshes[1].mesh->vertices()[2][1], 1e-300);
    ASSERT_EQ(s.bodies.size(), 2U);
    EXPECT_EQ(s.bodies[0].name, "a");
    EXPECT_EQ(s.bodies[0].mesh_index, 1U);
    EXPECT_TRUE(s.bodies[0].pose == Pose{});
    Mat3 turned;
    turned << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    EXPECT_TRUE(s.bodies[1].pose == (Pose{turned, Vec3(1, 2, 0.1)}));
    EXPECT_FALSE(s.bodies[0].motion);
    EXPECT_EQ(s.bodies[1].motion, Vec3(0, -2.5, 0.1));
    ASSERT_EQ(s.frames.size(), 2U);
    ASSERT_EQ(s.frames[0].moves.size(), 1U);
    EXPECT_EQ(s.frames[0].moves[0].body_index, 1U);
    EXPECT_TRUE(s.frames[0].moves[0].pose == (Pose{Mat3::Identity(), Vec3(0, 0, 3)}));
    EXPECT_TRUE(s.frames[1].moves.empty());
}

TEST_F(ReadScene, FramesAreOptional) {
    Json json = scene();
    json.erase("frames");
    EXPECT_TRUE(read_scene_file(write_scene(json)).frames.empty());
}

TEST_F(ReadScene, NamesThePlaceOfMistakes) {
    const auto changed = [](const char* pointer, const Json& value) {
        Json json = scene();
        json[Json::json_pointer(pointer)] = value;
        return json;
    };
    expect_bad(changed("/frames/0/moves/0/body", "c"), "frames[0].moves[0].body", "there is no body \"c\"");
    expect_bad(changed("/bodies/0/mesh", "c"), "bodies[0].mesh", "there is no mesh \"c\"");
    expect_bad(changed("/bodies/1/name", "a"), "bodies[1].name", "the name \"a\" is taken");
    expect_bad(changed("/meshes/1/name", "file"), "meshes[1].name", "the name \"file\" is taken");
    expect_bad(changed("/bodies/0/posse", 1), "bodies[0]", "the key \"posse\" is unknown");
    expect_bad(changed("/frame", 1), "", "the key \"frame\" is unknown");
    expect_bad(changed("/bodies/1/pose/r", 1), "bodies[1].pose", "the key \"r\" is unknown");
    expect_bad(changed("/bodies/1/pose/R", Json::parse("[[1, 0, 0], [0, 1, 0]]")), "bodies[1].pose.R",
               "a list of 3 is expected");
    expect_bad(changed("/bodies/1/pose/R/1/2", "x"), "bodies[1].pose.R[1][2]", "a number is expected");
    expect_bad(changed("/bodies/1/motion", {1, 2}), "bodies[1].motion", "a list of 3 is expected");
    expect_bad(changed("/bodies/1/pose/t", nullptr), "bodies[1].pose.t", "a list of 3 is expected");
    expect_bad(changed("/meshes/1/triangles/0/2", 3), "meshes[1].triangles[0][2]",
               "index 3 is out of range: there are 3 vertices");
    expect_bad(changed("/meshes/1/triangles/0/2", -1), "meshes[1].triangles[0][2]", "an index is expected");
    expect_bad(changed("/meshes/1/triangles", Json::array()), "meshes[1]", "there is no triangle: the mesh is empty");
    expect_bad(changed("/meshes/1/vertices", 3), "meshes[1].vertices", "a list is expected");
    expect_bad(changed("/meshes/0/vertices", 3), "meshes[0]", "the key \"vertices\" is unknown");
    expect_bad(changed("/frames/1", Json::object()), "frames[1]", "\"moves\" is missing");
    expect_bad(changed("/frames/0/moves/1", {{"body", "b"}, {"pose", Json::object()}}), "frames[0].moves[1]",
               "moved twice");
    expect_bad(Json::array(), "", "an object is expected");
}

TEST_F(ReadScene, NamesTheLineOfWhatIsNotJson) {
    const auto file = write("scene.json", "{\n\"meshes\": [],\n\"bodies\": [nan]\n}\n");
    expect_error([&] { read_scene_file(file); }, file, "line 3", "this is not JSON");
    const auto large = write("scene.json", "{\"meshes\": [1e999]}");
    expect_error([&] { read_scene_file(large); }, large, "line 1", "a number is beyond the largest double");
    const auto missing = path("missing.json");
    expect_error([&] { read_scene_file(missing); }, missing, "", "no such file");
    const auto deep = write("deep.json", "{\n\"meshes\":\n" + std::string(1000, '['));
    expect_error([&] { read_scene_file(deep); }, deep, "line 3", "more than 1000 lists and objects are open");
}

TEST_F(ReadScene, KeysAreGivenOnce) {
    const auto expect_twice = [&](const std::string& text, const std::string& line, const std::string& key) {
        const auto file = write("scene.json", text);
        expect_error([&] { read_scene_file(file); }, file, line, "the key \"" + key + "\" is given twice");
    };
    expect_twice("{\n\"meshes\": [],\n\"bodies\": [],\n\"meshes\"\n: []\n}\n", "line 4", "meshes");
    expect_twice("{\"meshes\": [{\"name\": 1, \"file\": {},\n\n\"n\\u0061me\": 2}]}", "line 3", "name");
    expect_twice("{\"a\": {\"b\": 1}, \"b\": [{\"a\": 1}, {\"a\": 2}],\n\"b\": 1}", "line 2", "b");
    const auto good = write("good.json", R"({"_a": {"_a": [{"_a": 1}, {"_a": 2}]}, "meshes": [], "bodies": []})");
    EXPECT_TRUE(read_scene_file(good).bodies.empty());
    const auto behind = write("scene.json", std::string("{\"meshes\": [], \"bodies\": []}\n\0{}", 33));
    expect_error([&] { read_scene_file(behind); }, behind, "line 2", "this is not JSON");
}

TEST_F(ReadScene, ErrorsOfAMeshFileNameThatFile) {
    const auto file = write_scene(scene());
    const auto mesh = write("sub/t.obj", "v 0 0 nan\n");
    expect_error([&] { read_scene_file(file); }, mesh, "line 1", "'nan'");
}

TEST_F(ReadScene, JoinsFiles) {
    const auto file = write_scene(scene());
    const auto mesh = write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const std::vector<std::filesystem::path> files{mesh, file, file};
    const Scene s = read_files(files);
    ASSERT_EQ(s.bodies.size(), 5U);
    EXPECT_EQ(s.bodies[0].name, mesh.string());
    EXPECT_EQ(s.bodies[1].name, file.string() + ": a");
    EXPECT_EQ(s.bodies[2].name, "b");
    EXPECT_EQ(s.bodies[3].name, file.string() + ": a (2)");
    EXPECT_EQ(s.bodies[4].name, "b (2)");
    EXPECT_EQ(s.bodies[3].mesh_index, 4U);
    ASSERT_EQ(s.frames.size(), 2U);
    ASSERT_EQ(s.frames[0].moves.size(), 2U);
    EXPECT_EQ(s.frames[0].moves[1].body_index, 4U);
}

}  // namespace
}  // namespace ecods::scenes
