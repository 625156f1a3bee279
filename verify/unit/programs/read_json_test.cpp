// JSON: the work grows with the text, and errors say where.
#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>
#include <string>

#include "scenes/io/json_file.hpp"
#include "scenes/io/json_place.hpp"

namespace ecods::scenes {
namespace {

std::string list_of(std::size_t count, const std::string& element) {
    std::string text = "[" + element;
    for (std::size_t i = 1; i < count; ++i) text += ", " + element;
    return text + "]";
}

// Processor time, the least of three.
double cost_of(const std::string& text) {
    double least = 1e9;
    for (int i = 0; i < 3; ++i) {
        const std::clock_t begin = std::clock();
        EXPECT_TRUE((*parse_json("a.json", text)).is_array());
        least = std::min(least, static_cast<double>(std::clock() - begin));
    }
    return std::max(least, 1.0);
}

// The text is 32 times as long. The parser with a callback, which looks through the list at the end of each object,
// took 900 times as long; a limit of four times 32 leaves room for caches and for a loaded machine.
TEST(ReadJson, TimeGrowsWithTheText) {
    for (const char* element : {R"({"a": 1})", "[]"}) {
        const double ratio = cost_of(list_of(64000, element)) / cost_of(list_of(2000, element));
        EXPECT_LT(ratio, 128) << element;
    }
}

TEST(ReadJson, KeepsEveryKindOfValue) {
    const std::string text =
        R"({"a": [null, true, false, -3, 18446744073709551615, 0.1, "x\u00e9"], "b": {"c": {}, "d": []}, "": 1})";
    EXPECT_EQ(*parse_json("a.json", text), nlohmann::json::parse(text));
    for (const char* value : {"null", "7", "-7", "1e-3", "\"\"", "[]", "{}", "[[], [[]], {}, {\"a\": [1]}, 2]"})
        EXPECT_EQ(*parse_json("a.json", value), nlohmann::json::parse(value)) << value;
    EXPECT_TRUE((*parse_json("a.json", "18446744073709551615")).is_number_unsigned());
    EXPECT_TRUE((*parse_json("a.json", "-1")).is_number_integer());
}

TEST(ReadJson, DepthIsLimited) {
    const auto nested = [](std::size_t depth, const std::string& open, const std::string& close) {
        std::string text;
        for (std::size_t i = 0; i < depth; ++i) text += open;
        text += "0";
        for (std::size_t i = 0; i < depth; ++i) text += close;
        return text;
    };
    for (const auto& [open, close] : {std::pair("[", "]"), std::pair("{\"a\": ", "}")}) {
        EXPECT_NO_THROW(parse_json("a.json", nested(json_depth_max, open, close)));
        try {
            parse_json("a.json", "\n\n" + nested(json_depth_max + 1, open, close));
            ADD_FAILURE();
        } catch (const ReadError& error) {
            EXPECT_EQ(error.place, "line 3");
            EXPECT_EQ(error.text, "more than 1000 lists and objects are open");
        }
    }
}

TEST(ReadJson, APlaceKnowsItsPath) {
    const std::filesystem::path file = "a.json";
    const JsonDocument document = parse_json(file, R"({"a": [1, [{"b c": {}}, 2]], "": {"d": 3}})");
    const JsonPlace root(file, *document);
    const auto path = [](const JsonPlace& place) {
        try {
            place.fail("here");
        } catch (const ReadError& error) {
            return error.place;
        }
    };
    EXPECT_EQ(path(root), "");
    EXPECT_EQ(path(root.at("a")), "a");
    EXPECT_EQ(path(root.at("a").element(1).element(0).at("b c")), "a[1][0].b c");
    EXPECT_EQ(path(root.at("a").element(1).elements()[1]), "a[1][1]");
    EXPECT_EQ(path(root.at("").at("d")), ".d");
    const JsonDocument list = parse_json(file, "[[], [7]]");
    EXPECT_EQ(path(JsonPlace(file, *list).element(1).element(0)), "[1][0]");
}

}  // namespace
}  // namespace ecods::scenes
