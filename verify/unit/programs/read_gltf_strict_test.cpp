// glTF: what is malformed or left out is said, and never read in another way; and names.
#include <sys/stat.h>

#include "gltf_test.hpp"

namespace ecods::scenes {
namespace {

class ReadGltfStrict : public ReadGltf {
  protected:
    void expect_bad_at(const char* pointer, const Json& value, const std::string& place, const std::string& text) {
        Json json = model();
        json[Json::json_pointer(pointer)] = value;
        expect_bad(json, place, text);
    }

    // Two nodes of one mesh, without names.
    static Json twins() {
        Json json = model();
        json["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}}};
        json["scenes"][0]["nodes"] = {0, 1};
        return json;
    }
};

TEST_F(ReadGltfStrict, IndicesAreNotCutTo32Bits) {
    constexpr std::uint64_t wrap = 1ULL << 32;  // of which 32 bits are index 0
    const std::string primitive = "meshes[0].primitives[0]";
    expect_bad_at("/nodes/0/mesh", wrap, "nodes[0].mesh", "4294967296 is beyond 32 bits");
    expect_bad_at("/scene", wrap, "scene", "is beyond 32 bits");
    expect_bad_at("/scenes/0/nodes/0", wrap, "scenes[0].nodes[0]", "is beyond 32 bits");
    expect_bad_at("/nodes/0/children", {wrap}, "nodes[0].children[0]", "is beyond 32 bits");
    expect_bad_at("/meshes/0/primitives/0/attributes/POSITION", wrap, primitive + ".attributes.POSITION", "32 bits");
    expect_bad_at("/meshes/0/primitives/0/indices", wrap + 1, primitive + ".indices", "is beyond 32 bits");
    expect_bad_at("/meshes/0/primitives/0/mode", wrap + 4, primitive + ".mode", "is beyond 32 bits");
    expect_bad_at("/accessors/0/bufferView", wrap, "accessors[0].bufferView", "is beyond 32 bits");
    expect_bad_at("/accessors/0/componentType", wrap + 5126, "accessors[0].componentType", "is beyond 32 bits");
    expect_bad_at("/accessors/0/byteOffset", 1ULL << 53, "accessors[0].byteOffset", "is beyond 53 bits");
    expect_bad_at("/bufferViews/0/buffer", wrap, "bufferViews[0].buffer", "is beyond 32 bits");
    expect_bad_at("/bufferViews/0/byteStride", wrap + 12, "bufferViews[0].byteStride", "is beyond 32 bits");
}

TEST_F(ReadGltfStrict, AnIndexIsAWholeNumber) {
    for (const Json& value : {Json(-1), Json(0.5), Json("0"), Json(nullptr), Json::array()}) {
        expect_bad_at("/nodes/0/mesh", value, "nodes[0].mesh", "an index is expected");
        expect_bad_at("/scene", value, "scene", "an index is expected");
        expect_bad_at("/meshes/0/primitives/0/indices", value, "meshes[0].primitives[0].indices",
                      "an index is expected");
    }
    expect_bad_at("/accessors/0/count", "5", "accessors[0].count", "a whole number is expected");
    expect_bad_at("/nodes/0/translation", {0, 0, "1"}, "nodes[0].translation[2]", "a number is expected");
    expect_bad_at("/nodes/0/name", 7, "nodes[0].name", "a text is expected");
    Json json = model();
    json["nodes"][0]["translation"] = {1, 2, 3};
    json["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    expect_bad(json, "nodes[0]", "exclude another");
    expect_bad_at("/nodes/0/rotation", {1e300, 0, 0, 1e300}, "nodes[0].rotation", "too large");
}

TEST_F(ReadGltfStrict, CyclesAreSaidWithoutAScene) {
    Json json = model();
    json.erase("scene");
    json.erase("scenes");
    json["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}, {"children", {2}}}, {{"mesh", 0}, {"children", {1}}}};
    expect_bad(json, "nodes[1]", "this node is below itself");
    json["scenes"] = Json::array();
    expect_bad(json, "nodes[1]", "this node is below itself");
    json["nodes"] = {{{"mesh", 0}, {"children", {0}}}};
    expect_bad(json, "nodes[0]", "this node is below itself");
    json["nodes"] = {{{"mesh", 0}, {"children", {2}}}, {{"children", {2}}}, {{"mesh", 0}}};
    expect_bad(json, "nodes[2]", "reached twice");
}

// Nobody writes to the pipe: opening it would wait for ever.
TEST_F(ReadGltfStrict, BuffersAreRegularFiles) {
    const auto file = write("m.gltf", model().dump());
    ASSERT_EQ(mkfifo(path("data.bin").c_str(), 0600), 0);
    expect_error([&] { read_gltf_file(file); }, file, "buffers[0].uri", "data.bin: not a regular file");
    std::filesystem::remove(path("data.bin"));
    std::filesystem::create_directory(path("data.bin"));
    expect_error([&] { read_gltf_file(file); }, file, "buffers[0].uri", "data.bin: is a folder");
    std::filesystem::remove(path("data.bin"));
    write("data.bin", data() + "1");
    expect_error([&] { read_gltf_file(file); }, file, "buffers[0]", "there are 66 bytes, and byteLength is 65");
}

TEST_F(ReadGltfStrict, UrisArePathsOrData) {
    Json json = model();
    std::filesystem::create_directories(path("sub"));
    write("a b.bin", data());
    json["buffers"][0]["uri"] = "../a%20b.bin";
    EXPECT_EQ(read_gltf_file(write("sub/m.gltf", json.dump())).bodies.size(), 1U);
    json["buffers"][0]["uri"] = path("a b.bin").string();
    EXPECT_EQ(read_gltf_file(write("sub/m.gltf", json.dump())).bodies.size(), 1U);
    expect_bad_at("/buffers/0/uri", "file:///a.bin", "buffers[0].uri", "neither the path of a file nor data");
    expect_bad_at("/buffers/0/uri", "a%2.bin", "buffers[0].uri", "two hexadecimal digits");
    expect_bad_at("/buffers/0/uri", "data.bin%00.txt", "buffers[0].uri", "no such file");
    expect_bad_at("/buffers/0/uri", "data:text/plain,abc", "buffers[0].uri", "neither the path of a file nor data");
    expect_bad_at("/buffers/0/uri", "data:a/b;base64,AAAA", "buffers[0]", "there are 3 bytes");
    expect_bad_at("/buffers/0/uri", "data:a/b;base64,AA-A", "buffers[0].uri", "character 2 of the base64");
    expect_bad_at("/buffers/0/uri", "data:a/b;base64,AAAAA", "buffers[0].uri", "cut off");
}

TEST_F(ReadGltfStrict, DataInBase64IsRead) {
    Json json = model();
    // 0 0 0, 1 0 0, 0 1 0 as floats, and two bytes more than the 36.
    json["buffers"][0] = {{"uri",
                           "data:application/octet-stream;base64,"
                           "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA+/8="},
                          {"byteLength", 38}};
    json["bufferViews"] = {{{"buffer", 0}, {"byteLength", 36}}};
    json["accessors"] = {{{"bufferView", 0}, {"componentType", 5126}, {"count", 3}, {"type", "VEC3"}}};
    json["meshes"][0]["primitives"][0].erase("indices");
    const Scene scene = read(json);
    EXPECT_EQ(scene.meshes.at(0).mesh->vertices()[1], Vec3(1, 0, 0));
    EXPECT_EQ(scene.meshes.at(0).mesh->vertices()[2], Vec3(0, 1, 0));
}

TEST_F(ReadGltfStrict, GltfOneIsNamed) {
    expect_bad_at("/asset/version", "1.0", "asset.version", "glTF 1.0 is not supported");
    expect_bad_at("/asset/version", 1, "asset.version", "glTF 1 is not supported");
    expect_bad_at("/asset/version", "20.0", "asset.version", "glTF 20.0 is not supported");
    Json json = model();
    json.erase("asset");
    expect_bad(json, "", "perhaps glTF 1.0, which is not supported");
    std::string bytes = binary(model(), data());
    bytes[4] = 1;
    const auto file = write("m.glb", bytes);
    expect_error([&] { read_gltf_file(file); }, file, "", "glTF 1 (binary) is not supported");
}

TEST_F(ReadGltfStrict, BinaryFilesEndWithTheirLastChunk) {
    Json json = model();
    json["buffers"][0].erase("uri");
    const std::string bytes = binary(json, data());
    EXPECT_EQ(read_gltf_file(write("m.glb", bytes)).bodies.size(), 1U);
    const auto file = write("m.glb", bytes + "more");
    expect_error([&] { read_gltf_file(file); }, file, "", "the header promises");
}

TEST_F(ReadGltfStrict, KeysAreGivenOnce) {
    const auto file =
        write("m.gltf", "{\n\"asset\": {\"version\": \"2.0\"},\n\"nodes\": [{\"mesh\": 0,\n\"mesh\": 1}]}");
    expect_error([&] { read_gltf_file(file); }, file, "line 4", "the key \"mesh\" is given twice");
}

TEST_F(ReadGltfStrict, BodiesWithoutANameAreNamedAfterTheirMesh) {
    Json json = model();
    json["nodes"][0].erase("name");
    EXPECT_EQ(read(json).bodies.at(0).name, "m");
    json["nodes"][0]["name"] = "";
    EXPECT_EQ(read(json).bodies.at(0).name, "m");
    json["meshes"][0].erase("name");
    EXPECT_EQ(read(json).bodies.at(0).name, "node 0");
    json = twins();
    EXPECT_EQ(read(json).bodies.at(0).name, "m (node 0)");
    EXPECT_EQ(read(json).bodies.at(1).name, "m (node 1)");
    json["nodes"].push_back({{"mesh", 0}, {"name", "m (node 1)"}});
    json["scenes"][0]["nodes"] = {2, 1, 0};
    const Scene scene = read(json);
    EXPECT_EQ(scene.bodies.at(0).name, "m (node 0)");
    EXPECT_EQ(scene.bodies.at(1).name, "m (node 1) (node 1)");
    EXPECT_EQ(scene.bodies.at(2).name, "m (node 1)");
}

TEST_F(ReadGltfStrict, WhatIsLeftOutIsSaid) {
    EXPECT_TRUE(read(model()).notes.empty());
    Json json = twins();
    json["scenes"][0]["nodes"] = {0};
    json["animations"] = {{{"channels", Json::array()}}, {{"channels", Json::array()}}};
    json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", 0}}};
    json["meshes"][0]["weights"] = {0, 0};
    const Scene scene = read(json);
    const std::string file = path("m.gltf").string();
    const std::vector<std::string> notes{file + ": left out: 2 animations; bodies are where their nodes rest",
                                         file + ": left out: morph targets of 1 mesh; their weights are zero at rest",
                                         file + ": left out: 1 node with a mesh, not in the default scene"};
    EXPECT_EQ(scene.notes, notes);
    json["meshes"][0]["weights"] = {0, 0.5};
    expect_bad(json, "meshes[0].weights[1]", "morph targets are not supported");
    json["nodes"][0]["weights"] = {0, 0};
    EXPECT_EQ(read(json).notes, notes) << "the weights of the node count";
    json["meshes"][0].erase("weights");
    json["nodes"][0]["weights"] = {1};
    expect_bad(json, "nodes[0].weights[0]", "morph targets are not supported");
}

}  // namespace
}  // namespace ecods::scenes
