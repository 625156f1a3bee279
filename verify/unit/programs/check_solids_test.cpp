// ecods_check takes bodies for solids.
#include <cmath>
#include <nlohmann/json.hpp>

#include "program_test.hpp"

namespace ecods::scenes::check_solids_test {
namespace {

using Json = nlohmann::json;

class CheckSolids : public ProgramTest {
  protected:
    ProgramResult run(const std::string& arguments) const { return run_program(ECODS_CHECK_PROGRAM, arguments); }
};

// Two solids of one shape, one in the other, and a mesh that bounds none; `more` bodies.
std::string corners(const std::string& more = {}) {
    return R"({
          "meshes": [ { "name": "corner", "vertices": [[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4]],
                        "triangles": [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]] },
                      { "name": "open", "vertices": [[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4]],
                        "triangles": [[0, 1, 2], [0, 1, 3], [0, 2, 3]] } ],
          "bodies": [ { "name": "large", "mesh": "corner" }, { "name": "bowl", "mesh": "open" },
                      { "name": "small", "mesh": "corner",
                        "pose": { "R": [[0.25, 0, 0], [0, 0.25, 0], [0, 0, 0.25]], "t": [0.5, 0.5, 0.5] } })" +
           more + "] }";
}

TEST_F(CheckSolids, SaysWhatIsInsideWhat) {
    const std::string file = write("scene.json", corners()).string();
    const ProgramResult text = run("--solids " + file);
    EXPECT_EQ(text.status, 0) << text.err;
    EXPECT_EQ(text.out,
              "solid  large\n"
              "no solid  bowl: triangle 0: its edge from vertex 1 at (4, 0, 0) to vertex 2 at (0, 4, 0) has no other "
              "half: the mesh is not closed\n"
              "solid  small\n"
              "frame 0: 3 bodies, 3 pairs with overlapping boxes, 2 colliding\n"
              "  touching  large | bowl  (12 triangle pairs)\n"
              "  contains  large | small  (0 triangle pairs)\n");
    const Json json = Json::parse(run("--solids --json " + file).out);
    EXPECT_EQ(json["solids"].size(), 3U);
    EXPECT_EQ(json["solids"][1]["is_solid"], false);
    EXPECT_EQ(json["frames"][0]["colliding"][1],
              Json::parse(R"({"a": "large", "b": "small", "relation": "contains", "triangle_pairs": 0})"));
    const ProgramResult judged = run("--solids --oracle " + file);
    EXPECT_EQ(judged.status, 0) << judged.out;
    EXPECT_TRUE(judged.out.ends_with("checked 3 body pairs, 0 touching triangle pairs, 3 boxes: no difference\n"));
    const Json asked = Json::parse(run("--solids --json --distance --ray 0.6 0.6 0.6 1 0 0 " + file).out)["frames"][0];
    EXPECT_EQ(asked["distances"][1]["kind"], "contained");
    EXPECT_TRUE(asked["distances"][1]["triangle_a"].is_null()) << "a point inside is on no triangle";
    EXPECT_TRUE(asked["hits"][0]["triangle"].is_null()) << "the ray begins inside";
    for (const std::string with : {"--certify c", "--oracle --distance", "--oracle --ray 0 0 0 1 0 0"})
        EXPECT_EQ(run("--solids " + with + " " + file).status, 2) << with;
}

// The way out of the corner is across one of its three edges at right angles, of which x + y, y + z or x + z is at most
// 2 in the small one; that is less than to any face. The first of the three edges is named.
TEST_F(CheckSolids, SaysHowDeepAndHowFar) {
    const std::string far = R"(, { "name": "far", "mesh": "corner",
                                   "pose": { "R": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "t": [8, 0, 0] } })",
                      file = write("scene.json", corners(far)).string();
    const ProgramResult text = run("--depth " + file);
    EXPECT_EQ(text.status, 0) << text.err;
    EXPECT_TRUE(text.out.ends_with("  gap 4  large | far\n  gap 6.5  small | far\n"));
    const Json frame = Json::parse(run("--depth --solids --json " + file).out)["frames"][0];
    ASSERT_EQ(frame["depths"].size(), 1U);
    const Json& depth = frame["depths"][0];
    EXPECT_EQ(depth["depth"], std::sqrt(2.0));
    EXPECT_EQ(depth["direction"], (Json{0.0, -std::sqrt(0.5), -std::sqrt(0.5)}));
    EXPECT_EQ(depth["feature_a"], "edge 0:0");
    EXPECT_EQ(depth["feature_b"], "edge 2:1");
    EXPECT_EQ(frame["gaps"].size(), 2U);
    EXPECT_EQ(frame["colliding"][1]["relation"], "contains") << "convex solids are solids";
}

}  // namespace
}  // namespace ecods::scenes::check_solids_test
