// glTF: skinned meshes, at rest.
#include "gltf_test.hpp"

namespace ecods::scenes {
namespace {

class ReadGltfSkin : public ReadGltf {
  protected:
    // Three vertices of two joints: of the first, of the second, and of both. The joints are turned by a quarter and
    // moved up, behind inverse bind matrices that move by (-1, 0, 0).
    Json skinned() const {
        Json json = model();
        json["accessors"][0]["count"] = 3;
        Json& attributes = json["meshes"][0]["primitives"][0]["attributes"];
        attributes["JOINTS_0"] =
            add_accessor(json, bytes_of<std::uint8_t>({1, 0, 0, 0, 0, 1, 0, 0, 0, 1, 9, 9}), joints_accessor());
        attributes["WEIGHTS_0"] =
            add_accessor(json, bytes_of<float>({0, 1, 0, 0, 0, 1, 0, 0, 0.25F, 0.75F, 0, 0}), weights_accessor());
        const std::string matrix = bytes_of<float>({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 1});
        const std::size_t matrices =
            add_accessor(json, matrix + matrix, {{"componentType", 5126}, {"count", 2}, {"type", "MAT4"}});
        json["skins"] = {{{"joints", {1, 2}}, {"inverseBindMatrices", matrices}}};
        json["nodes"] = {
            {{"mesh", 0}, {"skin", 0}, {"name", "part"}, {"translation", {100, 100, 100}}},
            {{"matrix", {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}, {"children", {2}}, {"name", "hip"}},
            {{"translation", {0, 0, 8}}}};
        json["scenes"][0]["nodes"] = {0, 1};
        return json;
    }
    static Json joints_accessor() { return {{"componentType", 5121}, {"count", 3}, {"type", "VEC4"}}; }
    static Json weights_accessor() { return {{"componentType", 5126}, {"count", 3}, {"type", "VEC4"}}; }

    std::vector<Vec3> vertices(const Json& json) {
        const Scene scene = read(json);
        const auto all = scene.meshes.at(0).mesh->vertices();
        return {all.begin(), all.end()};
    }
};

TEST_F(ReadGltfSkin, JointsPlaceVertices) {
    Json json = skinned();
    const Scene scene = read(json);
    ASSERT_EQ(scene.bodies.size(), 1U);
    EXPECT_TRUE(scene.bodies[0].pose == Pose{}) << "the node of a skinned mesh does not move it";
    EXPECT_EQ(scene.notes,
              std::vector{path("m.gltf").string() + ": at rest: 1 skinned node; vertices are rounded to doubles"});
    // (0, 0, 0), (1, 0, 0), (0, 1, 0) less (1, 0, 0), and (x, y, z) becomes (-y, x, z + 8 of the second joint).
    EXPECT_EQ(vertices(json), (std::vector<Vec3>{{0, -1, 0}, {0, 0, 8}, {-1, -1, 6}}));
    json["skins"][0].erase("inverseBindMatrices");
    EXPECT_EQ(vertices(json), (std::vector<Vec3>{{0, 0, 0}, {0, 1, 8}, {-1, 0, 6}}));
    json["nodes"][0].erase("skin");
    EXPECT_EQ(vertices(json), (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(read(json).bodies[0].pose.t, Vec3(100, 100, 100));
}

// A third of a unit in float and in 16 bits, three times, is not one.
TEST_F(ReadGltfSkin, WhereJointsAgreeWeightsDoNotMatter) {
    Json json = skinned();
    Json& attributes = json["meshes"][0]["primitives"][0]["attributes"];
    json["nodes"][2].erase("translation");
    json["skins"][0].erase("inverseBindMatrices");
    json["nodes"][1]["matrix"] = {0.1, 0, 0, 0, 0, 0.1, 0, 0, 0, 0, 0.1, 0, 0.7, 0, 0, 1};
    const std::vector<Vec3> expected{{0.7, 0, 0}, {0.1 + 0.7, 0, 0}, {0.7, 0.1, 0}};
    attributes["WEIGHTS_0"] =
        add_accessor(json, bytes_of<float>({0.3F, 0.3F, 0.3F, 0, 0.1F, 0.2F, 0, 0, 7, 0.3F, 0, 0}), weights_accessor());
    EXPECT_EQ(vertices(json), expected);
    Json shorts = weights_accessor();
    shorts["componentType"] = 5123;
    shorts["normalized"] = true;
    attributes["WEIGHTS_0"] =
        add_accessor(json, bytes_of<std::uint16_t>({21845, 21845, 21844, 0, 1, 2, 0, 0, 3, 0, 0, 0}), shorts);
    EXPECT_EQ(vertices(json), expected);
}

TEST_F(ReadGltfSkin, VerticesMayHaveMoreThanFourJoints) {
    Json json = skinned();
    json["skins"][0].erase("inverseBindMatrices");
    Json& attributes = json["meshes"][0]["primitives"][0]["attributes"];
    attributes["JOINTS_1"] = attributes["JOINTS_0"];
    attributes["WEIGHTS_1"] =
        add_accessor(json, bytes_of<float>({3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}), weights_accessor());
    EXPECT_EQ(vertices(json)[0], Vec3(0, 0, 6)) << "a quarter of the first joint, and three of the second";
    EXPECT_EQ(vertices(json)[2], Vec3(-1, 0, 6));
}

TEST_F(ReadGltfSkin, MeshesOfTwoSkinsAreTwo) {
    Json json = skinned();
    json["skins"].push_back({{"joints", {1, 1}}});
    json["nodes"].push_back({{"mesh", 0}, {"skin", 1}});
    json["nodes"].push_back({{"mesh", 0}, {"skin", 0}});
    json["nodes"].push_back({{"mesh", 0}});
    json["scenes"][0]["nodes"] = {0, 1, 3, 4, 5};
    const Scene scene = read(json);
    ASSERT_EQ(scene.bodies.size(), 4U);
    ASSERT_EQ(scene.meshes.size(), 3U);
    EXPECT_EQ(scene.bodies[2].mesh_index, scene.bodies[0].mesh_index);
    EXPECT_EQ(scene.meshes[1].mesh->vertices()[1], Vec3(0, 1, 0));
    EXPECT_EQ(scene.meshes[2].mesh->vertices()[1], Vec3(1, 0, 0));
}

TEST_F(ReadGltfSkin, BadSkinsAreNamed) {
    const std::string attributes = "meshes[0].primitives[0].attributes";
    const auto changed = [&](const char* pointer, const Json& value) {
        Json json = skinned();
        json[Json::json_pointer(pointer)] = value;
        return json;
    };
    expect_bad(changed("/nodes/0/skin", 3), "nodes[0].skin", "skins[3] does not exist");
    expect_bad(changed("/skins/0/joints/1", 7), "skins[0].joints[1]", "nodes[7] does not exist");
    expect_bad(changed("/skins/0/joints", {1}), attributes + ".JOINTS_0", "vertex 1: joint 1 does not exist");
    expect_bad(changed("/skins/0/joints", {1, 2, 1}), "skins[0].inverseBindMatrices", "more joints than matrices");
    expect_bad(changed("/scenes/0/nodes", {0}), "skins[0].joints[0]", "this joint is not in the default scene");
    expect_bad(changed("/accessors/2/count", 2), attributes + ".JOINTS_0", "there are 3 vertices, and fewer joints");
    const auto weighed = [&](const std::string& weights) {
        Json json = skinned();
        json["meshes"][0]["primitives"][0]["attributes"]["WEIGHTS_0"] = add_accessor(json, weights, weights_accessor());
        return json;
    };
    expect_bad(weighed(bytes_of<float>({0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0})), attributes,
               "vertex 1: all weights are zero");
    expect_bad(weighed(bytes_of<float>({0, 1, 0, 0, 0, 0.5F, 1, -0.5F, 0, 1, 0, 0})), attributes + ".WEIGHTS_0",
               "vertex 1: weight 3 is negative");
    Json json = skinned();
    json["meshes"][0]["primitives"][0]["attributes"].erase("WEIGHTS_0");
    expect_bad(json, attributes, "\"WEIGHTS_0\" is missing");
    json = skinned();
    const std::string matrix = bytes_of<float>({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 2});
    json["skins"][0]["inverseBindMatrices"] =
        add_accessor(json, matrix + matrix, {{"componentType", 5126}, {"count", 2}, {"type", "MAT4"}});
    expect_bad(json, "skins[0].inverseBindMatrices", "the last row is not 0 0 0 1");
    json["nodes"][1]["matrix"][0] = 1e300;
    json["nodes"][2]["matrix"] = {1e300, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 8, 1};
    json["nodes"][2].erase("translation");
    json["skins"][0].erase("inverseBindMatrices");
    expect_bad(json, attributes + ".POSITION", "vertex 1: a coordinate is not a finite number");
}

}  // namespace
}  // namespace ecods::scenes
