// ecods_check about bodies that turn.
#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numbers>
#include <regex>
#include <string>

#include "ecods/turn.hpp"
#include "program_test.hpp"
#include "programs/check_oracle.hpp"
#include "scenes/io/scene_file.hpp"

namespace ecods::check {
namespace {

using Json = nlohmann::json;
using scenes::ProgramResult;

class CheckTurns : public scenes::ProgramTest {
  protected:
    ProgramResult run(const std::string& arguments) const { return run_program(ECODS_CHECK_PROGRAM, arguments); }

    static std::string door() { return std::string(ECODS_CHECK_SAMPLES) + "/door.json"; }

    static std::string text_of(const std::string& file) {
        std::ifstream in(file, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }

    // The door, a leaf that is fixed to it, and a cart; in frame 1 the given moves.
    std::string scene(const Json& moves) const {
        Json json = Json::parse(text_of(door()));
        json["bodies"][0].erase("turn");
        json["bodies"].push_back({{"name", "leaf"}, {"mesh", "stick"}, {"pose", {{"t", {0.5, 0, 0}}}}});
        json["bodies"].push_back({{"name", "cart"}, {"mesh", "stick"}, {"pose", {{"t", {0.355, 0.355, 0}}}}});
        json["frames"] = {{{"moves", moves}}};
        return write("scene.json", json.dump()).string();
    }

    static Json turn(const char* body, double degrees) {
        return {{"body", body}, {"turn", {{"axis", {0, 0, 1}}, {"degrees", degrees}}}};
    }
};

TEST_F(CheckTurns, SaysAtWhichTimeAndAngleBodiesMeet) {
    const ProgramResult result = run("--moves --casts --oracle " + door());
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(
        result.out,
        "frame 0: 2 bodies, 0 pairs with overlapping boxes, 0 colliding\n"
        "frame 1: 2 bodies, 0 pairs with overlapping boxes, 0 colliding\n"
        "  met at 0.4292377294746294 after 38.2902 degrees  door | post  (vertex and edge, triangles 0 and 0)\n"
        "  cast meets at 0.5619667650239684 after 50.8774 degrees  door | post  (vertex and edge, triangles 0 and "
        "0)\n"
        "frame 2: 2 bodies, 0 pairs with overlapping boxes, 0 colliding\n"
        "oracle: checked 3 body pairs, 0 touching triangle pairs, 4 boxes, 5 moves and casts: no difference\n");
    const Json json = Json::parse(run("--moves --casts --json --oracle " + door()).out);
    const Json met = json["frames"][1]["met"];
    ASSERT_EQ(met.size(), 1U);
    const Turn quarter = about({0, 0, 1}, 90.0 / 180 * std::numbers::pi, {0, 0, 0});
    EXPECT_EQ(met[0]["angle"], angle_at(quarter, met[0]["time"]));
    EXPECT_NEAR(met[0]["degrees"].get<double>(), 38.2902, 1e-4);
    EXPECT_EQ(met[0]["a"], "door");
    EXPECT_EQ(json["frames"][1]["casts"][0]["b"], "post");
    EXPECT_FALSE(json["frames"][2].contains("met")) << "straight, the door goes past the post";
    EXPECT_EQ(json["oracle"]["differing"], 0);
    EXPECT_EQ(json["oracle"]["moves_and_casts"], 5);
}

TEST_F(CheckTurns, LinesMayEndInAnyWay) {
    const std::string with_returns = std::regex_replace(text_of(door()), std::regex("\n"), "\r\n");
    const std::string file = write("returns.json", with_returns).string();
    EXPECT_EQ(run("--moves --casts " + file).out, run("--moves --casts " + door()).out);
}

// What is fixed to a body that turns stays where it is on it.
TEST_F(CheckTurns, BodiesMayMakeTheSameTurn) {
    const ProgramResult result =
        run("--moves --oracle " +
            scene({turn("leaf", 90), turn("door", 90), {{"body", "post"}, {"pose", {{"t", {0.75, 0.6, 0}}}}}}));
    EXPECT_EQ(result.status, 0) << result.err << result.out;
    EXPECT_NE(result.out.find("  met at 0 after 0 degrees  door | leaf  (intersecting, triangles 0 and 0)\n"
                              "  met at 0.4"),
              std::string::npos)
        << result.out;
    EXPECT_NE(result.out.find(" door | cart  "), std::string::npos) << result.out;
    EXPECT_NE(result.out.find(" leaf | cart  "), std::string::npos) << result.out;
    EXPECT_EQ(result.out.find("leaf | post"), std::string::npos) << result.out;
}

// Bodies turn beside each other, each about its own axis.
TEST_F(CheckTurns, BodiesMayMakeTurnsOfTheirOwn) {
    Json other = turn("cart", -90);
    other["turn"]["pivot"] = {0.7, 0.7, 0};
    const ProgramResult result = run("--moves --oracle " + scene({turn("door", 90), other}));
    EXPECT_EQ(result.status, 0) << result.err << result.out;
    EXPECT_NE(result.out.find(" door | cart  "), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("no difference"), std::string::npos) << result.out;
}

// The cart comes towards the hinge, or goes away before the door is there.
TEST_F(CheckTurns, BodiesMayGoStraightBesideATurn) {
    const auto slide = [](double x, double y) { return Json{{"body", "cart"}, {"pose", {{"t", {x, y, 0}}}}}; };
    for (const bool is_turn_first : {false, true}) {
        const Json comes =
            is_turn_first ? Json{turn("door", 90), slide(0.25, 0.25)} : Json{slide(0.25, 0.25), turn("door", 90)};
        const ProgramResult result = run("--moves --oracle " + scene(comes));
        EXPECT_EQ(result.status, 0) << result.err << result.out;
        EXPECT_NE(result.out.find(" door | cart  "), std::string::npos) << result.out;
        EXPECT_NE(result.out.find("no difference"), std::string::npos) << result.out;
    }
    const ProgramResult away = run("--moves --oracle " + scene({turn("door", 90), slide(-9, 9)}));
    EXPECT_EQ(away.status, 0) << away.err << away.out;
    EXPECT_EQ(away.out.find(" door | cart  "), std::string::npos) << away.out;
    EXPECT_EQ(run("--moves " + scene(Json::array({slide(0, 3)}))).status, 0);
    EXPECT_EQ(run("--moves " + scene({turn("door", 90), turn("leaf", 90)})).status, 0);
}

TEST_F(CheckTurns, WhatTheLibraryRefusesIsNamedWithItsBodies) {
    const Json tiny{{"body", "door"}, {"turn", {{"q", {1, 0, 0, 1e-300}}}}};
    const ProgramResult result = run("--moves " + scene(Json::array({tiny})));
    EXPECT_EQ(result.status, 2) << result.out;
    EXPECT_EQ(
        result.err,
        "ecods_check: frame 1: \"door\" and \"post\": the turn's quaternion has parts below 2^-500 or above 2^500\n");
}

TEST_F(CheckTurns, MistakesInTurnsAreStatus2) {
    const Json none{{"body", "door"}, {"turn", {{"q", {0, 0, 0, 0}}}}};
    const std::string file = scene(Json::array({none}));
    const ProgramResult result = run("--moves " + file);
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err, "ecods_check: " + file + ": frames[0].moves[0].turn: turn: the quaternion is zero\n");
}

TEST_F(CheckTurns, SolidsTurn) {
    Json json = Json::parse(text_of(door()));
    json["bodies"].push_back({{"name", "inner"},
                              {"mesh", "stick"},
                              {"pose", {{"R", {{0.1, 0, 0}, {0, 0.1, 0}, {0, 0, 0.1}}}, {"t", {0.752, 0.602, 0.1}}}}});
    json["bodies"][2]["turn"] = {{"axis", {0, 0, 1}}, {"degrees", 90}};
    const ProgramResult result = run("--casts --solids " + write("solids.json", json.dump()).string());
    EXPECT_NE(result.out.find("  cast meets at 0 after 0 degrees  inner | post  (contained, "), std::string::npos)
        << result.out;
}

TEST_F(CheckTurns, TheOracleNoticesWrongContacts) {
    const scenes::Scene scene = scenes::read_scene_file(door());
    const auto difference_count = [&](const std::function<void(FrameAnswer&)>& change) {
        SceneWorld world(scene, BroadPhaseKind::brute_force, {.has_moves = true, .has_casts = true});
        OracleJudge judge(scene);
        for (int frame = 0; frame < 2; ++frame) {
            EXPECT_TRUE(world.next_frame());
            FrameAnswer answer = world.answer();
            EXPECT_EQ(answer.casts.size(), static_cast<std::size_t>(frame));
            EXPECT_EQ(answer.meetings.size(), static_cast<std::size_t>(frame));
            if (frame == 1) change(answer);
            judge.check_frame(world, answer);
        }
        return judge.report().differences.size();
    };
    const auto late = [](MeetingAnswer& pair) { pair.contact.time = std::nextafter(pair.contact.time, 1); };
    EXPECT_EQ(difference_count([](FrameAnswer&) {}), 0U);
    EXPECT_EQ(difference_count([&](FrameAnswer& answer) { late(answer.meetings[0]); }), 1U);
    EXPECT_EQ(difference_count([](FrameAnswer& answer) { answer.meetings[0].contact.a.triangle = 1; }), 1U);
    EXPECT_EQ(difference_count([](FrameAnswer& answer) { answer.meetings.clear(); }), 1U);
    EXPECT_EQ(difference_count([&](FrameAnswer& answer) { late(answer.casts[0]); }), 1U);
    EXPECT_EQ(difference_count([](FrameAnswer& answer) { answer.casts.clear(); }), 1U);
}

}  // namespace
}  // namespace ecods::check
