// glTF: what primitives name: points and lines, sparse and quantised accessors, accessors that are shared.
#include "gltf_test.hpp"

namespace ecods::scenes {
namespace {

class ReadGltfAccessor : public ReadGltf {
  protected:
    const std::string position = "meshes[0].primitives[0].attributes.POSITION";

    static Json& primitives(Json& json) { return json["meshes"][0]["primitives"]; }

    // The vertices of the only mesh.
    std::vector<Vec3> vertices(const Json& json) {
        const Scene scene = read(json);
        EXPECT_EQ(scene.meshes.size(), 1U);
        const auto all = scene.meshes.at(0).mesh->vertices();
        return {all.begin(), all.end()};
    }
};

TEST_F(ReadGltfAccessor, PointsAndLinesAreLeftOutAndCounted) {
    Json json = model();
    for (const int mode : {0, 1, 2, 3}) primitives(json).push_back({{"attributes", {{"POSITION", 0}}}, {"mode", mode}});
    json["meshes"].push_back({{"primitives", {{{"attributes", Json::object()}, {"mode", 1}}}}});
    json["nodes"].push_back({{"mesh", 1}});
    json["nodes"].push_back({{"mesh", 1}});
    json["scenes"][0]["nodes"] = {0, 1, 2};
    const Scene scene = read(json);
    EXPECT_EQ(scene.bodies.size(), 1U) << "nothing but lines is no body";
    EXPECT_EQ(scene.meshes.at(0).mesh->triangles().size(), 1U);
    EXPECT_EQ(scene.notes, std::vector{path("m.gltf").string() + ": left out: 5 primitives of points or lines"});
    json["scenes"][0]["nodes"] = {1};
    expect_bad(json, "", "there are only points and lines");
}

TEST_F(ReadGltfAccessor, SparseAccessorsReplaceElements) {
    Json json = model();
    const std::size_t indices = add_accessor(json, bytes_of<std::uint16_t>({1, 2}), Json::object());
    const std::size_t values = add_accessor(json, bytes_of<float>({7, 8, 9, -1, -2, -3}), Json::object());
    Json& accessor = json["accessors"][0];
    accessor["sparse"] = {
        {"count", 2},
        {"indices", {{"bufferView", json["accessors"][indices]["bufferView"]}, {"componentType", 5123}}},
        {"values", {{"bufferView", json["accessors"][values]["bufferView"]}}}};
    EXPECT_EQ(vertices(json), (std::vector<Vec3>{{0, 0, 0}, {7, 8, 9}, {-1, -2, -3}}));
    accessor.erase("bufferView");
    accessor["sparse"]["count"] = 1;
    EXPECT_EQ(vertices(json), (std::vector<Vec3>{{0, 0, 0}, {7, 8, 9}, {0, 0, 0}})) << "without a view, all are zero";
    accessor["sparse"]["count"] = 3;
    expect_bad(json, "accessors[0].sparse.indices", "reaches beyond its buffer view");
    accessor["sparse"]["count"] = 2;
    accessor["count"] = 2;
    expect_bad(json, "accessors[0].sparse.indices", "index 2 is not above the one before and below 2");
    accessor["count"] = 5;
    accessor["sparse"]["indices"]["componentType"] = 5121;
    expect_bad(json, "accessors[0].sparse.indices", "index 0 is not above the one before");
    accessor["sparse"]["indices"]["componentType"] = 5126;
    expect_bad(json, "accessors[0].sparse.indices", "componentType is none of an index");
    accessor["sparse"].erase("values");
    expect_bad(json, "accessors[0].sparse.indices", "componentType is none of an index");
    accessor["sparse"]["indices"]["componentType"] = 5123;
    expect_bad(json, "accessors[0].sparse", "\"values\" is missing");
}

TEST_F(ReadGltfAccessor, SparseIndicesOfTriangles) {
    Json json = model();
    const std::size_t indices = add_accessor(json, bytes_of<std::uint8_t>({1}), Json::object());
    const std::size_t values = add_accessor(json, bytes_of<std::uint8_t>({4}), Json::object());
    json["accessors"][1]["sparse"] = {
        {"count", 1},
        {"indices", {{"bufferView", json["accessors"][indices]["bufferView"]}, {"componentType", 5121}}},
        {"values", {{"bufferView", json["accessors"][values]["bufferView"]}}}};
    EXPECT_EQ(vertices(json), (std::vector<Vec3>{{0, 0, 0}, {0, 1, 0}, {2, 2, 2}}));
}

TEST_F(ReadGltfAccessor, QuantizedPositionsAreRoundedOnce) {
    Json json = model();
    const auto use = [&](const std::string& bytes, int type, bool is_normalized) {
        const Json accessor{{"componentType", type}, {"count", 3}, {"type", "VEC3"}, {"normalized", is_normalized}};
        primitives(json)[0]["attributes"]["POSITION"] = add_accessor(json, bytes, accessor);
    };
    const std::string shorts = bytes_of<std::int16_t>({32767, -32767, -32768, 1, 16384, 0, 3, 0, 0});
    use(shorts, 5122, true);
    expect_bad(json, position, "VEC3 of componentType 5122 does not fit here");
    json["extensionsUsed"] = json["extensionsRequired"] = {"KHR_mesh_quantization"};
    EXPECT_EQ(vertices(json), (std::vector<Vec3>{{1, -1, -1}, {1 / 32767., 16384 / 32767., 0}, {3 / 32767., 0, 0}}));
    use(shorts, 5122, false);
    EXPECT_EQ(vertices(json), (std::vector<Vec3>{{32767, -32767, -32768}, {1, 16384, 0}, {3, 0, 0}}));
    const std::string ushorts = bytes_of<std::uint16_t>({65535, 0, 1, 1, 1, 1, 2, 0, 0});
    use(ushorts, 5123, true);
    EXPECT_EQ(vertices(json)[0], Vec3(1, 0, 1 / 65535.));
    use(ushorts, 5123, false);
    EXPECT_EQ(vertices(json)[0], Vec3(65535, 0, 1));
    const std::string bytes = bytes_of<std::int8_t>({127, -127, -128, 1, 1, 1, 33, 0, 0});
    use(bytes, 5120, true);
    EXPECT_EQ(vertices(json)[0], Vec3(1, -1, -1));
    use(bytes, 5120, false);
    EXPECT_EQ(vertices(json)[0], Vec3(127, -127, -128));
    use(bytes, 5121, true);
    EXPECT_EQ(vertices(json)[0], Vec3(127 / 255., 129 / 255., 128 / 255.));
    EXPECT_EQ(vertices(json)[2], Vec3(33 / 255., 0, 0)) << "33 times 1 / 255 is rounded twice";
    use(bytes, 5121, false);
    EXPECT_EQ(vertices(json)[0], Vec3(127, 129, 128));
    use(bytes_of<std::uint32_t>({1, 0, 0, 0, 1, 0, 0, 0, 1}), 5125, false);
    expect_bad(json, position, "VEC3 of componentType 5125 does not fit here");
}

TEST_F(ReadGltfAccessor, UnknownExtensionsAreRefusedIfTheyAreRequired) {
    for (const char* name : {"EXT_meshopt_compression", "KHR_draco_mesh_compression", "EXT_mesh_gpu_instancing"}) {
        Json json = model();
        json["extensionsRequired"] = {name};
        expect_bad(json, "extensionsRequired", std::string(name) + " is not supported");
    }
    Json json = model();
    json["extensionsUsed"] = {"XY_shape"};
    EXPECT_EQ(read(json).bodies.size(), 1U);
    json["extensionsRequired"] = {"KHR_materials_unlit", "KHR_texture_transform", "KHR_technique_webgl"};
    EXPECT_EQ(read(json).bodies.size(), 1U);
    json["extensionsRequired"] = {"KHR_materials_unlit", "XY_shape"};
    expect_bad(json, "extensionsRequired", "XY_shape is not supported");
}

// Each triangle has three corners of a hundred vertices: with a copy of all of them for each primitive or mesh, memory
// grew with the square of the file.
TEST_F(ReadGltfAccessor, AMeshHasTheVerticesThatItsTrianglesUse) {
    Json json = model();
    std::string positions, indices;
    for (int i = 0; i < 100; ++i) positions += bytes_of<float>({static_cast<float>(i), static_cast<float>(i * i), 1});
    for (std::uint8_t i = 0; i < 97; ++i) indices += bytes_of<std::uint8_t>({i, static_cast<std::uint8_t>(i + 1), 99});
    const std::size_t points =
        add_accessor(json, positions, {{"componentType", 5126}, {"count", 100}, {"type", "VEC3"}});
    const std::size_t index = add_accessor(json, indices, {{"componentType", 5121}, {"count", 3}, {"type", "SCALAR"}});
    Json all = Json::array();
    for (std::size_t i = 0; i < 97; ++i) {
        Json part = json["accessors"][index];
        part["byteOffset"] = 3 * i;
        json["accessors"].push_back(part);
        all.push_back({{"attributes", {{"POSITION", points}}}, {"indices", json["accessors"].size() - 1}});
    }
    primitives(json) = all;
    const Scene one = read(json);
    EXPECT_EQ(one.meshes.at(0).mesh->vertices().size(), 99U) << "98 is not used";
    EXPECT_EQ(one.meshes.at(0).mesh->triangles().size(), 97U);
    EXPECT_EQ(one.meshes.at(0).mesh->triangles()[96], (Triangle{96, 97, 98}));
    json["nodes"] = Json::array();
    json["scenes"][0]["nodes"] = Json::array();
    for (std::size_t i = 0; i < all.size(); ++i) {
        json["meshes"][i]["primitives"] = {all[i]};
        json["scenes"][0]["nodes"].push_back(json["nodes"].size());
        json["nodes"].push_back({{"mesh", i}});
    }
    const Scene many = read(json);
    ASSERT_EQ(many.meshes.size(), 97U);
    for (const NamedMesh& mesh : many.meshes) EXPECT_EQ(mesh.mesh->vertices().size(), 3U);
    EXPECT_EQ(many.meshes[7].mesh->vertices()[2], Vec3(99, 99 * 99, 1));
}

TEST_F(ReadGltfAccessor, MeshesThatNameTheSameAreOne) {
    Json json = model();
    json["meshes"].push_back(json["meshes"][0]);
    json["meshes"][1]["name"] = "n";
    json["meshes"][1]["primitives"][0]["material"] = 0;
    json["meshes"].push_back(json["meshes"][0]);
    json["meshes"][2]["primitives"][0]["mode"] = 6;
    json["nodes"] = {{{"mesh", 0}}, {{"mesh", 1}}, {{"mesh", 2}, {"name", "fan"}}};
    json["scenes"][0]["nodes"] = {0, 1, 2};
    const Scene scene = read(json);
    EXPECT_EQ(scene.meshes.size(), 2U);
    EXPECT_EQ(scene.bodies.at(0).mesh_index, 0U);
    EXPECT_EQ(scene.bodies.at(1).mesh_index, 0U);
    EXPECT_EQ(scene.bodies.at(1).name, "n");
    EXPECT_EQ(scene.bodies.at(2).mesh_index, 1U);
}

// Nine primitives of a third of a million corners, of a file without a buffer that is as large.
TEST_F(ReadGltfAccessor, AccessorsAreNotReadOverAndOver) {
    Json json = model();
    json["accessors"].push_back({{"componentType", 5126}, {"count", 300000}, {"type", "VEC3"}});
    const auto add = [&] { primitives(json).push_back({{"attributes", {{"POSITION", 2}}}}); };
    for (int i = 0; i < 3; ++i) add();
    EXPECT_EQ(read(json).meshes.at(0).mesh->triangles().size(), 300001U);
    add();
    expect_bad(json, "meshes[0].primitives[4]", "elements of accessors would be read");
    json["accessors"][2]["count"] = std::uint64_t{1} << 40;
    expect_bad(json, "meshes[0].primitives[1]", "too many vertices");
}

TEST_F(ReadGltfAccessor, ABufferFileIsReadForEachBufferThatNamesIt) {
    Json json = model();
    json["buffers"].push_back({{"uri", "./data.bin"}, {"byteLength", 65}});
    json["bufferViews"][1]["buffer"] = 1;
    EXPECT_EQ(vertices(json).size(), 3U);
    json["buffers"][1]["byteLength"] = 64;
    expect_bad(json, "buffers[1]", "there are 65 bytes, and byteLength is 64");
}

}  // namespace
}  // namespace ecods::scenes
