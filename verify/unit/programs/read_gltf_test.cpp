// glTF assemblies: poses, primitives, and each kind of bad input.
#include <cmath>
#include <cstring>
#include <numbers>
#include <random>

#include "ecods/turn.hpp"
#include "gltf_test.hpp"

namespace ecods::scenes {
namespace {

TEST_F(ReadGltf, ReadsANode) {
    Json json = model();
    const Scene scene = read(json);
    ASSERT_EQ(scene.bodies.size(), 1U);
    EXPECT_EQ(scene.bodies[0].name, "part");
    EXPECT_TRUE(scene.bodies[0].pose == Pose{});
    const Mesh& mesh = *scene.meshes.at(0).mesh;
    EXPECT_EQ(mesh.vertices().size(), 3U) << "the triangle uses three of five";
    EXPECT_EQ(mesh.triangles().size(), 1U);
    EXPECT_EQ(mesh.triangles()[0], (Triangle{0, 1, 2}));
    json["bufferViews"][1]["byteOffset"] = 62;
    json["bufferViews"][1]["byteLength"] = 3;
    const auto last = read(json).meshes.at(0).mesh;
    EXPECT_EQ(last->vertices()[1], Vec3(1, 1, static_cast<double>(0.1F))) << "vertex 3 of the file";
    EXPECT_EQ(last->triangles()[0], (Triangle{0, 1, 2}));
}

TEST_F(ReadGltf, ReadsTheMotionOfANode) {
    Json json = model();
    EXPECT_FALSE(read(json).bodies[0].motion);
    json["nodes"][0]["extras"] = {{"motion", {1, 0.5, -2}}};
    EXPECT_EQ(read(json).bodies[0].motion, Vec3(1, 0.5, -2));
    for (const Json& other : {Json(3), Json{{"motion", "fast"}}, Json{{"speed", {1, 2, 3}}}}) {
        json["nodes"][0]["extras"] = other;
        EXPECT_FALSE(read(json).bodies[0].motion) << "what is no array is somebody's own";
    }
    json["nodes"][0]["extras"] = {{"motion", {1, 2}}};
    EXPECT_THROW(read(json), ReadError);
}

TEST_F(ReadGltf, ReadsTheTurnOfANode) {
    Json json = model();
    json["nodes"][0]["extras"] = {{"turn", {{"axis", {0, 0, 2}}, {"degrees", 30}, {"pivot", {1, 0, 0}}}}};
    const SceneBody body = read(json).bodies[0];
    EXPECT_EQ(body.turn, about({0, 0, 2}, 30.0 / 180 * std::numbers::pi, {1, 0, 0}));
    EXPECT_FALSE(body.motion);
    json["nodes"][0]["extras"] = {{"turn", {{"q", {1, 0, 0, -1}}, {"pivot", {1, 2, 3}}, {"pivot_to", {1, 2, 4}}}}};
    EXPECT_EQ(read(json).bodies[0].turn, (Turn{{1, 0, 0, -1}, {1, 2, 3}, {1, 2, 4}}));
    for (const Json& other : {Json("left"), Json(3), Json{1, 2, 3}}) {
        json["nodes"][0]["extras"] = {{"turn", other}};
        EXPECT_FALSE(read(json).bodies[0].turn) << "what is no object is somebody's own";
    }
    const auto expect_bad = [&](const Json& extras, const std::string& place, const std::string& text) {
        json["nodes"][0]["extras"] = extras;
        const auto file = write("bad.gltf", json.dump());
        expect_error([&] { read_gltf_file(file); }, file, place, text);
    };
    expect_bad({{"turn", Json::object()}}, "nodes[0].extras.turn", "\"axis\" is missing");
    expect_bad({{"turn", {{"q", {1, 0, 0}}}}}, "nodes[0].extras.turn.q", "a list of 4 is expected");
    expect_bad({{"turn", {{"q", {0, 0, 0, 0}}}}}, "nodes[0].extras.turn", "turn: the quaternion is zero");
    expect_bad({{"turn", {{"q", {1, 0, 0, 1}}, {"speed", 3}}}}, "nodes[0].extras.turn", "the key \"speed\" is unknown");
    expect_bad({{"turn", {{"q", {1, 0, 0, 1}}}}, {"motion", {1, 2, 3}}}, "nodes[0].extras",
               "a body has a \"motion\" or a \"turn\", not both");
}

TEST_F(ReadGltf, ReadsBinaryFiles) {
    Json json = model();
    json["buffers"][0].erase("uri");
    const std::string bytes = binary(json, data());
    EXPECT_EQ(read_gltf_file(write("m.glb", bytes)).meshes.at(0).mesh->vertices().size(), 3U);
    for (std::size_t size = 0; size + 4 < bytes.size(); size += 3) {
        EXPECT_THROW(read_gltf_file(write("cut.glb", bytes.substr(0, size))), ReadError) << size;
    }
}

TEST_F(ReadGltf, AccumulatesPosesInDouble) {
    Json json = model();
    const double angle = 0.3;
    json["nodes"] = {{{"children", {1, 2}}, {"translation", {0.1, 0.2, 0.3}}, {"scale", {2, 2, 3}}},
                     {{"mesh", 0},
                      {"rotation", {0, 0, std::sin(angle / 2) * 7, std::cos(angle / 2) * 7}},
                      {"translation", {1, 0, 0}}},
                     {{"mesh", 0}, {"matrix", {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1}}, {"name", "node 1"}}};
    const Scene scene = read(json);
    ASSERT_EQ(scene.bodies.size(), 2U);
    ASSERT_EQ(scene.meshes.size(), 1U);
    EXPECT_EQ(scene.bodies[0].name, "m");
    EXPECT_EQ(scene.bodies[1].name, "node 1");
    Mat3 expected;
    expected << std::cos(angle), -std::sin(angle), 0, std::sin(angle), std::cos(angle), 0, 0, 0, 1;
    expected = Vec3(2, 2, 3).asDiagonal() * expected;
    EXPECT_LT((scene.bodies[0].pose.R - expected).cwiseAbs().maxCoeff(), 1e-15);
    EXPECT_EQ(scene.bodies[0].pose.t, Vec3(2 + 0.1, 0.2, 0.3));
    Mat3 turned;
    turned << 0, -2, 0, 2, 0, 0, 0, 0, 3;
    EXPECT_EQ(scene.bodies[1].pose.R, turned);
    EXPECT_EQ(scene.bodies[1].pose.t, Vec3(10 + 0.1, 12 + 0.2, 21 + 0.3));
}

TEST_F(ReadGltf, ReadsStripsFansAndSeveralPrimitives) {
    Json json = model();
    json["meshes"][0]["primitives"] = {{{"attributes", {{"POSITION", 0}}}, {"mode", 5}},
                                       {{"attributes", {{"POSITION", 0}}}, {"mode", 6}},
                                       {{"attributes", {{"POSITION", 0}}}, {"indices", 1}, {"mode", 4}}};
    const Scene scene = read(json);
    const Mesh& mesh = *scene.meshes.at(0).mesh;
    EXPECT_EQ(mesh.vertices().size(), 5U);
    const std::vector<Triangle> expected{{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 1, 2}};
    EXPECT_TRUE(std::equal(mesh.triangles().begin(), mesh.triangles().end(), expected.begin(), expected.end()));
}

TEST_F(ReadGltf, TakesOnlyTheDefaultScene) {
    Json json = model();
    json["nodes"] = {{{"mesh", 0}, {"name", "a"}}, {{"mesh", 0}, {"name", "b"}}};
    json["scenes"] = {{{"nodes", {0}}}, {{"nodes", {1}}}};
    json["scene"] = 1;
    const Scene scene = read(json);
    ASSERT_EQ(scene.bodies.size(), 1U);
    EXPECT_EQ(scene.bodies[0].name, "b");
    json.erase("scene");
    json.erase("scenes");
    EXPECT_EQ(read(json).bodies.size(), 2U);
}

TEST_F(ReadGltf, NamesThePlaceOfBadNodes) {
    Json json = model();
    json["nodes"] = {{{"children", {1}}}, {{"children", {0}}, {"mesh", 0}}};
    expect_bad(json, "nodes[0]", "reached twice");
    json = model();
    json["nodes"][0]["children"] = {7};
    expect_bad(json, "nodes[0].children[0]", "nodes[7] does not exist");
    json = model();
    json["nodes"][0]["mesh"] = 3;
    expect_bad(json, "nodes[0].mesh", "meshes[3] does not exist");
    json = model();
    json["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 2};
    expect_bad(json, "nodes[0].matrix", "the last row is not 0 0 0 1");
    json = model();
    json["nodes"][0]["matrix"] = {1, 0, 0};
    expect_bad(json, "nodes[0].matrix", "a list of 16 is expected");
    json = model();
    json["nodes"][0]["rotation"] = {0, 0, 0, 0};
    expect_bad(json, "nodes[0].rotation", "the quaternion is zero");
    json = model();
    json["nodes"][0]["scale"] = {1e300, 1, 1};
    json["nodes"].push_back({{"children", {0}}, {"scale", {1e300, 1, 1}}});
    json["scenes"][0]["nodes"] = {1};
    expect_bad(json, "nodes[0]", "");
    json = model();
    json["nodes"][0].erase("mesh");
    expect_bad(json, "", "no node of the scene has a mesh");
}

TEST_F(ReadGltf, NamesThePlaceOfBadGeometry) {
    const std::string primitive = "meshes[0].primitives[0]";
    Json json = model();
    json["accessors"][1]["count"] = 6;
    expect_bad(json, "accessors[1]", "reaches beyond its buffer view");
    json = model();
    json["accessors"][0]["count"] = 1000000000000LL;
    expect_bad(json, "accessors[0]", "reaches beyond its buffer view");
    json = model();
    json["accessors"][1]["count"] = 2;
    expect_bad(json, primitive, "no multiple of three");
    json = model();
    json["accessors"][0]["count"] = 2;
    expect_bad(json, primitive + ".indices", "index 2 is out of range: there are 2 vertices");
    json = model();
    json["bufferViews"][0]["byteLength"] = 70;
    expect_bad(json, "bufferViews[0]", "reaches beyond its buffer");
    json = model();
    json["bufferViews"][0]["buffer"] = 9;
    expect_bad(json, "bufferViews[0].buffer", "buffers[9] does not exist");
    json = model();
    json["accessors"][0]["componentType"] = 5123;
    expect_bad(json, primitive + ".attributes.POSITION", "VEC3 of componentType 5123 does not fit");
    json = model();
    json["meshes"][0]["primitives"][0]["mode"] = 7;
    expect_bad(json, primitive + ".mode", "there is no mode 7");
    json = model();
    json["meshes"][0]["primitives"][0]["attributes"] = {{"NORMAL", 0}};
    expect_bad(json, primitive + ".attributes", "\"POSITION\" is missing");
    json = model();
    json["extensionsUsed"] = {"KHR_draco_mesh_compression"};
    expect_bad(json, "extensionsUsed", "KHR_draco_mesh_compression is not supported");
}

TEST_F(ReadGltf, RefusesCoordinatesThatAreNotFinite) {
    Json json = model();
    std::string bytes = data();
    const float nan = std::nanf("");
    std::memcpy(bytes.data() + 16, &nan, sizeof nan);
    write("data.bin", bytes);
    const auto file = write("m.gltf", json.dump());
    expect_error([&] { read_gltf_file(file); }, file, "meshes[0].primitives[0].attributes.POSITION", "vertex 1");
}

TEST_F(ReadGltf, RefusesWhatIsNoGltf) {
    const auto missing = path("missing.glb");
    expect_error([&] { read_gltf_file(missing); }, missing, "", "no such file");
    for (const std::string& text :
         {std::string("{"), std::string("[]"), std::string(""), std::string("glTF"), std::string("{\"asset\": 3}")}) {
        const auto file = write("bad.gltf", text);
        EXPECT_THROW(read_gltf_file(file), ReadError) << text;
    }
    const auto deep = write("deep.gltf", "{\"extras\": " + std::string(999, '[') + std::string(999, ']') + "}");
    expect_error([&] { read_gltf_file(deep); }, deep, "", "there is no asset.version");
    const auto no_buffer = write("alone.gltf", model().dump());
    expect_error([&] { read_gltf_file(no_buffer); }, no_buffer, "buffers[0].uri", "data.bin: no such file");
}

TEST_F(ReadGltf, SurvivesDamage) {
    Json json = model();
    json["buffers"][0].erase("uri");
    const std::string bytes = binary(json, data());
    std::mt19937_64 random(3);
    int errors = 0;
    for (int i = 0; i < 1500; ++i) {
        std::string damaged = bytes;
        for (std::uint64_t k = 1 + random() % 3; k > 0; --k)
            damaged[random() % damaged.size()] = static_cast<char>(32 + random() % 95);
        try {
            read_gltf_file(write("m.glb", damaged));
        } catch (const ReadError&) {
            ++errors;
        }
    }
    EXPECT_GT(errors, 300);
}

}  // namespace
}  // namespace ecods::scenes
