// Turns in scene files.
#include <array>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "ecods/turn.hpp"
#include "file_test.hpp"
#include "scenes/io/scene_file.hpp"

namespace ecods::scenes {
namespace {

using Json = nlohmann::json;

class ReadTurn : public FileTest {
  protected:
    static Json scene() {
        return Json::parse(R"({
          "meshes": [ { "name": "flat", "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0]], "triangles": [[0, 1, 2]] } ],
          "bodies": [ { "name": "a", "mesh": "flat", "turn": { "q": [1, 0, 0, -1], "pivot": [1, 2, 3] } },
                      { "name": "b", "mesh": "flat", "pose": { "t": [0, 0, 2] } } ],
          "frames": [ { "moves": [ { "body": "b", "turn": { "axis": [0, 0, 2], "degrees": 30, "pivot": [1, 0, 0] } } ] },
                      { "moves": [ { "body": "b", "turn": { "axis": [1, 0, 0], "angle": 0.5, "pivot_to": [0, 0, 7] } },
                                   { "body": "a", "pose": {} } ] } ] })");
    }

    std::filesystem::path write_scene(const Json& json) const { return write("scene.json", json.dump(1)); }

    // With the turn of frames[0] in place of its own.
    void expect_bad_turn(const std::string& turn, const std::string& place, const std::string& text) const {
        Json json = scene();
        json[Json::json_pointer("/frames/0/moves/0/turn")] = Json::parse(turn);
        const auto file = write_scene(json);
        expect_error([&] { read_scene_file(file); }, file, "frames[0].moves[0].turn" + place, text);
    }
};

TEST_F(ReadTurn, ReadsAll) {
    const Scene s = read_scene_file(write_scene(scene()));
    EXPECT_EQ(s.bodies[0].turn, (Turn{{1, 0, 0, -1}, Vec3(1, 2, 3), Vec3(1, 2, 3)}));
    EXPECT_FALSE(s.bodies[1].turn);
    const Turn first = about({0, 0, 2}, 30.0 / 180 * std::numbers::pi, {1, 0, 0});
    Turn second = about({1, 0, 0}, 0.5, {0, 0, 0});
    second.pivot_to = {0, 0, 7};
    ASSERT_EQ(s.frames.size(), 2U);
    ASSERT_EQ(s.frames[1].moves.size(), 2U);
    EXPECT_EQ(s.frames[0].moves[0].turn, first);
    EXPECT_EQ(s.frames[1].moves[0].turn, second);
    EXPECT_FALSE(s.frames[1].moves[1].turn);
    const Pose start{Mat3::Identity(), Vec3(0, 0, 2)};
    const Pose after_first = pose_at(start, first, 1);
    EXPECT_EQ(s.frames[0].moves[0].pose, after_first);
    EXPECT_EQ(s.frames[1].moves[0].pose, pose_at(after_first, second, 1));
}

TEST_F(ReadTurn, StaysWithItsMoveWhenFilesAreJoined) {
    const auto file = write_scene(scene());
    const std::array files{file, file};
    const Scene s = read_files(files);
    ASSERT_EQ(s.frames[0].moves.size(), 2U);
    EXPECT_EQ(s.frames[0].moves[1].body_index, 3U);
    ASSERT_TRUE(s.frames[0].moves[1].turn);
    EXPECT_EQ(s.frames[0].moves[1].turn, s.frames[0].moves[0].turn);
    EXPECT_EQ(s.bodies[2].turn, s.bodies[0].turn);
}

TEST_F(ReadTurn, NamesThePlaceOfMistakes) {
    expect_bad_turn("{}", "", "\"axis\" is missing");
    expect_bad_turn("[1, 0, 0, 0]", "", "an object is expected");
    expect_bad_turn(R"({"q": [1, 0, 0]})", ".q", "a list of 4 is expected");
    expect_bad_turn(R"({"q": [1, 0, "x", 0]})", ".q[2]", "a number is expected");
    expect_bad_turn(R"({"q": [0, 0, 0, 0]})", "", "turn: the quaternion is zero");
    expect_bad_turn(R"({"q": [-1, 0, 0, 0]})", "", "turn: a whole turn has no axis; turn twice");
    expect_bad_turn(R"({"q": [1, 0, 0, 0], "axis": [0, 0, 1]})", "", "the key \"axis\" is unknown");
    expect_bad_turn(R"({"q": [1, 0, 0, 0], "degrees": 3})", "", "the key \"degrees\" is unknown");
    expect_bad_turn(R"({"axis": [0, 0, 1]})", "", "one of \"q\", \"degrees\" and \"angle\" is expected");
    expect_bad_turn(R"({"axis": [0, 0, 1], "angle": 1, "degrees": 3})", "",
                    "one of \"q\", \"degrees\" and \"angle\" is expected");
    expect_bad_turn(R"({"axis": [0, 0, 0], "degrees": 3})", "", "turn: axis is 0, which is not allowed");
    expect_bad_turn(R"({"axis": [0, 0, 1], "degrees": -450})", "", "turn: angle is -7.85398163397448");
    expect_bad_turn(R"({"axis": [0, 0, 1], "degrees": 3, "pivot": [0, 0]})", ".pivot", "a list of 3 is expected");
    expect_bad_turn(R"({"axis": [0, 0, 1], "degrees": 3, "pivot_to": 4})", ".pivot_to", "a list of 3 is expected");
    expect_bad_turn(R"({"axis": [0, 0, 1], "degrees": 3, "pivotto": 4})", "", "the key \"pivotto\" is unknown");
}

TEST_F(ReadTurn, ABodyMovesInOneWay) {
    Json both = scene();
    both["bodies"][0]["motion"] = {1, 0, 0};
    const auto file = write_scene(both);
    expect_error([&] { read_scene_file(file); }, file, "bodies[0]", "a body has a \"motion\" or a \"turn\", not both");
    Json two_ends = scene();
    two_ends["frames"][0]["moves"][0]["pose"] = Json::object();
    const auto other = write_scene(two_ends);
    expect_error([&] { read_scene_file(other); }, other, "frames[0].moves[0]",
                 "a move has a \"pose\" or a \"turn\", not both");
}

TEST_F(ReadTurn, EndsBeyondTheLargestDoubleAreRefused) {
    expect_bad_turn(R"({"axis": [0, 0, 1], "degrees": 180, "pivot": [1.5e308, 0, 0]})", "",
                    "the body ends where no double is: ");
    const auto large = write("scene.json", "{\"meshes\": [],\n\"bodies\": [{\"turn\": {\"q\": [1e999, 0, 0, 1]}}]}");
    expect_error([&] { read_scene_file(large); }, large, "line 2", "a number is beyond the largest double");
}

}  // namespace
}  // namespace ecods::scenes
