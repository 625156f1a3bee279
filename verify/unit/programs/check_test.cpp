// ecods_check as its users run it.
#include <nlohmann/json.hpp>

#include "program_test.hpp"

namespace ecods::scenes {
namespace {

using Json = nlohmann::json;

using Result = ProgramResult;

class Check : public ProgramTest {
  protected:
    Result run(const std::string& arguments) const { return run_program(ECODS_CHECK_PROGRAM, arguments); }

    // Three triangles; the second moves through the first, and then away.
    std::string scene() const {
        return write("scene.json", R"({
          "meshes": [ { "name": "flat", "vertices": [[0, 0, 0], [4, 0, 0], [0, 4, 0]], "triangles": [[0, 1, 2]] },
                      { "name": "upright", "vertices": [[1, 1, 0], [1, 1, 1], [2, 1, 1]], "triangles": [[0, 1, 2]] } ],
          "bodies": [ { "name": "ground", "mesh": "flat" }, { "name": "blade", "mesh": "upright" },
                      { "name": "far", "mesh": "flat", "pose": { "t": [0, 0, 9] }, "motion": [0, 0, -16] } ],
          "frames": [ { "moves": [ { "body": "blade", "pose": { "t": [0, 0, -0.5] } } ] },
                      { "moves": [ { "body": "blade", "pose": { "t": [0, 0, 1] } } ] } ] })")
            .string();
    }

    // The first triangle pair with what is said to be true of it.
    std::string cases(bool intersects, int pairs) const {
        const Json pose{{"R", {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {"t", {0, 0, 0}}};
        const Json triangle{{"vertices", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {"triangles", {{0, 1, 2}}}};
        const Json known{{"surfaces_intersect_exact_affine", intersects}, {"n_pairs_exact_affine", pairs}};
        const Json geometric{{"id", "same"},
                             {"shapes", {{"A", triangle}, {"B", triangle}}},
                             {"transforms", {{"A", pose}, {"B", pose}}},
                             {"expected_true_answer", known}};
        const Json sequence{{"id", "moves"}, {"shapes", {{"objects", {"a box"}}}}};
        return write("cases.json", Json{{"cases", {geometric, sequence}}}.dump()).string();
    }
};

TEST_F(Check, PrintsEachFrame) {
    for (const std::string& option :
         {std::string(), std::string("--broad-phase brute_force "), std::string("--broad-phase sweep_and_prune ")}) {
        const Result result = run(option + scene());
        EXPECT_EQ(result.status, 0);
        EXPECT_EQ(result.err, "");
        EXPECT_EQ(result.out,
                  "frame 0: 3 bodies, 1 pair with overlapping boxes, 1 colliding\n"
                  "  touching  ground | blade  (1 triangle pair)\n"
                  "frame 1: 3 bodies, 1 pair with overlapping boxes, 1 colliding\n"
                  "  crossing  ground | blade  (1 triangle pair)\n"
                  "frame 2: 3 bodies, 0 pairs with overlapping boxes, 0 colliding\n");
    }
}

TEST_F(Check, SaysWhoMeetsOnTheWay) {
    const Result text = run("--moves --casts --oracle " + scene());
    EXPECT_EQ(text.status, 0) << text.err;
    EXPECT_EQ(text.out.substr(0, text.out.find("oracle")),
              "frame 0: 3 bodies, 1 pair with overlapping boxes, 1 colliding\n"
              "  touching  ground | blade  (1 triangle pair)\n"
              "  cast meets at 0.5  far | blade  (vertex and face, triangles 0 and 0)\n"
              "frame 1: 3 bodies, 1 pair with overlapping boxes, 1 colliding\n"
              "  crossing  ground | blade  (1 triangle pair)\n"
              "  met at 0  ground | blade  (intersecting, triangles 0 and 0)\n"
              "  cast meets at 0.53125  far | blade  (vertex and face, triangles 0 and 0)\n"
              "frame 2: 3 bodies, 0 pairs with overlapping boxes, 0 colliding\n"
              "  met at 0  ground | blade  (intersecting, triangles 0 and 0)\n"
              "  cast meets at 0.4375  far | blade  (vertex and face, triangles 0 and 0)\n");
    EXPECT_NE(text.out.find(" 9 moves and casts: no difference"), std::string::npos) << text.out;
    const Result json = run("--moves --casts --json --oracle " + scene());
    const Json frame = Json::parse(json.out)["frames"][1];
    ASSERT_EQ(frame["met"].size(), 1U);
    EXPECT_EQ(frame["met"][0], Json({{"a", "ground"},
                                     {"b", "blade"},
                                     {"time", 0},
                                     {"kind", "intersecting"},
                                     {"triangle_a", 0},
                                     {"triangle_b", 0}}));
    ASSERT_EQ(frame["casts"].size(), 1U);
    EXPECT_EQ(frame["casts"][0]["time"], 0.53125);
    EXPECT_EQ(Json::parse(json.out)["oracle"]["moves_and_casts"], 9);
    EXPECT_FALSE(Json::parse(run("--json " + scene()).out)["frames"][1].contains("met"));
    for (const std::string option : {"--moves", "--casts", "--solids", "--depth"})
        EXPECT_EQ(run(option + " --cases " + cases(true, 1)).status, 2) << option;
}

TEST_F(Check, SaysWhatRaysHit) {
    const Result text = run("--ray 1 1 -3 0 0 2 --ray -1 0 9 0.5 0 0 --oracle " + scene());
    EXPECT_EQ(text.status, 0) << text.err;
    EXPECT_EQ(text.out.substr(0, text.out.find("frame 1")),
              "frame 0: 3 bodies, 1 pair with overlapping boxes, 1 colliding\n"
              "  touching  ground | blade  (1 triangle pair)\n"
              "  ray 0 hits at 1.5  ground  (back, triangle 0: (1, 1, 0))\n"
              "  ray 0 hits at 1.5  blade  (along, triangle 0: (1, 1, 0) to (1, 1, 1) at 2)\n"
              "  ray 0 hits at 6  far  (back, triangle 0: (1, 1, 9))\n"
              "  ray 1 hits at 2  far  (along, triangle 0: (0, 0, 9) to (4, 0, 9) at 10)\n");
    EXPECT_NE(text.out.find(" 6 rays: no difference"), std::string::npos) << text.out;
    const Json json = Json::parse(run("--json --oracle --ray 1 1 -3 0 0 2 " + scene()).out);
    const Json& hits = json["frames"][0]["hits"];
    ASSERT_EQ(hits.size(), 3U);
    EXPECT_EQ(hits[0], Json({{"ray", 0},
                             {"body", "ground"},
                             {"parameter", 1.5},
                             {"rank", 0},
                             {"kind", "back"},
                             {"triangle", 0},
                             {"point", {1, 1, 0}}}));
    EXPECT_EQ(hits[1]["leave_parameter"], 2);
    EXPECT_EQ(hits[1]["leave_point"], Json({1, 1, 1}));
    EXPECT_EQ(hits[2]["rank"], 1);
    EXPECT_EQ(json["oracle"]["rays"], 3);
    EXPECT_FALSE(Json::parse(run("--json " + scene()).out)["frames"][0].contains("hits"));
}

TEST_F(Check, RaysThatAreNoneAreRefused) {
    for (const std::string bad : {"0 0 0 0 0 0", "0 0 0 inf 0 0", "nan 0 0 1 0 0", "0 0 0 1 0", "0 0 0 1 0 x"}) {
        const Result result = run("--ray " + bad + " " + scene());
        EXPECT_EQ(result.status, 2) << bad;
        EXPECT_EQ(result.out, "") << bad;
        EXPECT_NE(result.err.find("--ray"), std::string::npos) << result.err;
    }
    EXPECT_EQ(run("--ray 0 0 0 1 0 0 --cases " + cases(true, 1)).status, 2);
}

TEST_F(Check, SaysHowFarBodiesAreFromEachOther) {
    const Result text = run("--distance --oracle " + scene());
    EXPECT_EQ(text.status, 0) << text.err;
    EXPECT_NE(text.out.find("  distance 9  ground | far  (vertex and vertex: (0, 0, 0), (0, 0, 9))\n"),
              std::string::npos)
        << text.out;
    EXPECT_NE(text.out.find("  distance 0  ground | blade  (intersecting: "), std::string::npos) << text.out;
    EXPECT_NE(text.out.find(" 9 distances: no difference"), std::string::npos) << text.out;
    const Result json = run("--distance --json --oracle " + scene());
    const Json frame = Json::parse(json.out)["frames"][2];
    ASSERT_EQ(frame["distances"].size(), 3U);
    const Json& moved = frame["distances"][0];
    EXPECT_EQ(moved["a"], "ground");
    EXPECT_EQ(moved["b"], "blade");
    EXPECT_EQ(moved["distance"], 1);
    EXPECT_EQ(moved["kind"], "vertex and face");
    EXPECT_EQ(moved["point_a"], Json({1, 1, 0}));
    EXPECT_EQ(moved["point_b"], Json({1, 1, 1}));
    EXPECT_EQ(Json::parse(json.out)["oracle"]["distances"], 9);
    EXPECT_FALSE(Json::parse(run("--json " + scene()).out)["frames"][0].contains("distances"));
    EXPECT_EQ(run("--distance --cases " + cases(true, 1)).status, 2);
}

TEST_F(Check, ListsThePairsWithinAClearance) {
    const Result text = run("--clearance 1 --oracle " + scene());
    EXPECT_EQ(text.status, 0) << text.err;
    EXPECT_NE(text.out.find("  close 1  ground | blade  (vertex and face: (1, 1, 0), (1, 1, 1))\n"), std::string::npos)
        << text.out;
    EXPECT_EQ(text.out.find("far"), std::string::npos) << text.out;
    EXPECT_NE(text.out.find(", 9 clearances: no difference"), std::string::npos) << text.out;
    const Json json = Json::parse(run("--clearance 0.999 --json --oracle " + scene()).out);
    EXPECT_EQ(json["frames"][0]["close"].size(), 1U);
    EXPECT_EQ(json["frames"][2]["close"], Json::array());
    EXPECT_EQ(json["oracle"]["clearances"], 9);
    EXPECT_FALSE(Json::parse(run("--json " + scene()).out)["frames"][0].contains("close"));
    const Result bad = run("--clearance -1 " + scene());
    EXPECT_EQ(bad.status, 2);
    EXPECT_NE(bad.err.find("-1"), std::string::npos) << bad.err;
}

TEST_F(Check, WithoutTheOracleItIsRefusedAndNothingElseIs) {
    const std::string program = ECODS_CHECK_WITHOUT_ORACLE;
    EXPECT_EQ(run_program(program, scene()).out, run(scene()).out);
    EXPECT_EQ(run_program(program, "--cases " + cases(true, 1)).status, 0);
    for (const std::string& arguments : {scene(), "--cases " + cases(true, 1)}) {
        const Result result = run_program(program, "--oracle " + arguments);
        EXPECT_EQ(result.status, 2);
        EXPECT_EQ(result.out, "");
        EXPECT_EQ(result.err,
                  "ecods_check: --oracle: this program was built without the oracle (CMake's ECODS_ORACLE, which needs "
                  "CGAL)\n");
    }
}

// However close: how many boxes overlap is not promised, but the answer is.
TEST_F(Check, AnswersExactly) {
    const std::string a = write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").string();
    const std::string b = write("b.obj", "v 0 0 1e-300\nv 1 0 1e-300\nv 0 1 1e-300\nf 1 2 3\n").string();
    const Result result = run("--json --oracle " + a + " " + b);
    EXPECT_EQ(result.status, 0);
    EXPECT_TRUE(Json::parse(result.out)["frames"][0]["colliding"].empty()) << result.out;
}

TEST_F(Check, OracleSaysHowMuchItChecked) {
    const Result result = run("--oracle " + scene());
    EXPECT_EQ(result.status, 0);
    EXPECT_NE(result.out.find("oracle: checked 9 body pairs, 2 touching triangle pairs, 5 boxes: no difference\n"),
              std::string::npos)
        << result.out;
}

TEST_F(Check, WritesJson) {
    const Result result = run("--json --oracle " + scene());
    EXPECT_EQ(result.status, 0);
    const Json json = Json::parse(result.out);
    EXPECT_EQ(json["bodies"], Json({"ground", "blade", "far"}));
    ASSERT_EQ(json["frames"].size(), 3U);
    const Json expected{
        {"frame", 1},
        {"overlapping", 1},
        {"colliding", {{{"a", "ground"}, {"b", "blade"}, {"relation", "crossing"}, {"triangle_pairs", 1}}}}};
    EXPECT_EQ(json["frames"][1], expected);
    EXPECT_EQ(json["oracle"]["body_pairs"], 9);
    EXPECT_EQ(json["oracle"]["differing"], 0);
    EXPECT_FALSE(Json::parse(run("--json " + scene()).out).contains("oracle"));
}

TEST_F(Check, ReadsMeshesAsBodies) {
    const std::string a = write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").string();
    const std::string b = write("b.off", "OFF\n3 1 0\n0 0 0\n-1 0 0\n0 -1 0\n3 0 1 2\n").string();
    const Result result = run("--oracle " + a + " " + b);
    EXPECT_EQ(result.status, 0);
    EXPECT_NE(result.out.find("touching  a | b  (1 triangle pair)"), std::string::npos) << result.out;
}

TEST_F(Check, UnreadableInputIsStatus2) {
    const std::string bad = write("bad.obj", "v 0 0 0\nv 1 0 nan\n").string();
    const Result result = run(bad);
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err, "ecods_check: " + bad + ": line 2: 'nan' is not a finite number\n");
    EXPECT_EQ(run(path("missing.obj").string()).status, 2);
    EXPECT_EQ(run("--cases " + path("missing.json").string()).status, 2);
    EXPECT_EQ(run("--cases " + bad).status, 2);
}

TEST_F(Check, EveryFileThatCannotBeReadIsNamed) {
    const std::string one = path("one.obj").string();
    const std::string two = path("two.stl").string();
    const Result result = run(one + " " + scene() + " " + two);
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err, "ecods_check: " + one + ": no such file\necods_check: " + two + ": no such file\n");
}

TEST_F(Check, SaysWhatItLeavesOut) {
    const std::string models = "/usr/share/assimp/models/glTF2/";
    const std::string cube = models + "glTF-Sample-Models/AnimatedMorphCube-glTF/AnimatedMorphCube.gltf";
    const Result result = run(cube);
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(result.out, "frame 0: 1 body, 0 pairs with overlapping boxes, 0 colliding\n");
    EXPECT_EQ(result.err, "ecods_check: " + cube + ": left out: 1 animation; bodies are where their nodes rest\n" +
                              "ecods_check: " + cube +
                              ": left out: morph targets of 1 mesh; their weights are zero at rest\n");
}

TEST_F(Check, ReadsObjectsAsBodies) {
    const std::string file =
        write("two.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 -1\nv 1 1 1\no base\nf 1 2 3\no blade\nf 1 4 5\n").string();
    EXPECT_NE(run(file).out.find("crossing  base | blade  (1 triangle pair)"), std::string::npos) << run(file).out;
}

TEST_F(Check, MisuseIsStatus2) {
    EXPECT_EQ(run("").status, 2);
    EXPECT_EQ(run("--unknown " + scene()).status, 2);
    EXPECT_EQ(run("--broad-phase octree " + scene()).status, 2);
    EXPECT_EQ(run("--cases " + cases(true, 1) + " " + scene()).status, 2);
    const Result help = run("--help");
    EXPECT_EQ(help.status, 0);
    EXPECT_NE(help.out.find("--oracle"), std::string::npos);
}

TEST_F(Check, HelpAndVersion) {
    expect_help_and_version(ECODS_CHECK_PROGRAM);
    const std::string help = run("--help").out;
    EXPECT_NE(help.find("{automatic,brute_force,kept_candidates,sweep_and_prune}"), std::string::npos) << help;
    for (const char* bytes : {"1", "$(printf '\\001')"}) {
        EXPECT_EQ(run("--broad-phase " + std::string(bytes) + " " + scene()).status, 2) << "names alone are taken";
    }
}

TEST_F(Check, KnownCases) {
    const Result good = run("--cases " + cases(true, 1));
    EXPECT_EQ(good.status, 0);
    EXPECT_EQ(good.out, "same  intersects  1 triangle pair  ok\n1 case, 0 mismatches, 1 skipped (not two meshes)\n");
    EXPECT_EQ(run("--oracle --cases " + cases(true, 1)).status, 0);
    const Result few = run("--cases " + cases(true, 2));
    EXPECT_EQ(few.status, 1);
    EXPECT_NE(few.out.find("same  intersects  1 triangle pair  MISMATCH"), std::string::npos) << few.out;
    EXPECT_EQ(run("--cases " + cases(false, 1)).status, 1);
    const Json json = Json::parse(run("--json --cases " + cases(false, 1)).out);
    EXPECT_EQ(json["mismatches"], 1);
    EXPECT_EQ(json["skipped"], 1);
    EXPECT_EQ(json["cases"][0]["ok"], false);
}

}  // namespace
}  // namespace ecods::scenes
