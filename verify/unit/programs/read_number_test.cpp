// Decimals, whatever the locale.
#include <cmath>
#include <cstdlib>
#include <limits>

#include "comma_locale.hpp"
#include "file_test.hpp"
#include "scenes/io/mesh_file.hpp"
#include "scenes/io/parse_number.hpp"
#include "scenes/io/scene_file.hpp"

namespace ecods::scenes {
namespace {

double parsed(const std::string& word) {
    double value = 7;
    EXPECT_TRUE(parse_number(word, value)) << word;
    return value;
}

void expect_numbers() {
    EXPECT_EQ(parsed("0.1"), 0.1);
    EXPECT_EQ(parsed("+1.5e3"), 1500);
    double value = 0;
    for (const char* word : {"", "+", "+-1", "1,5", "1.5,", "1.234.567", "0x10", "1e", "e5", "1.5 "}) {
        EXPECT_FALSE(parse_number(word, value)) << word;
    }
}

// Beyond the range, from_chars gives no value. With a comma, strtod reads 1.5e-400 as 1.
void expect_numbers_beyond_range() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const char* word : {"1.5e-400", "0.00001e-330", "+9.99e-99999999999999999999", "2e-324"}) {
        EXPECT_EQ(parsed(word), 0) << word;
        EXPECT_FALSE(std::signbit(parsed(word))) << word;
    }
    EXPECT_TRUE(std::signbit(parsed("-1.5e-400")));
    EXPECT_EQ(parsed("0." + std::string(400, '0') + "1"), 0);
    EXPECT_EQ(parsed("1" + std::string(400, '0') + "e-800"), 0);
    EXPECT_EQ(parsed("3e-324"), std::numeric_limits<double>::denorm_min());
    for (const char* word : {"1.5e400", "1e309", "1.7976931348623159e308", "0.001e9999999999999999999", "1E+400"}) {
        EXPECT_EQ(parsed(word), infinity) << word;
    }
    EXPECT_EQ(parsed("-1.5e400"), -infinity);
    EXPECT_EQ(parsed("1" + std::string(400, '0')), infinity);
    EXPECT_EQ(parsed("0." + std::string(400, '0') + "1e800"), infinity);
    EXPECT_EQ(parsed("0e99999999999999999999"), 0);
    EXPECT_EQ(parsed("0." + std::string(400, '0') + "1e402"), 10);
}

TEST(ReadNumber, IsTheNearestDouble) {
    expect_numbers();
    expect_numbers_beyond_range();
}

class ReadNumberInLocale : public FileTest {};

TEST_F(ReadNumberInLocale, KnowsNoDecimalComma) {
    const CommaLocale comma(path("."));
    EXPECT_EQ(std::strtod("1,5", nullptr), comma.is_set_in_c() ? 1.5 : 1);
    expect_numbers();
    expect_numbers_beyond_range();
}

TEST_F(ReadNumberInLocale, FilesHaveNoDecimalComma) {
    const auto obj = write("m.obj", "v 1.5e-400 0.25 0\nv 1234.5 0 0\nv 0 1.5 0\nf 1 2 3\n");
    const auto json =
        write("m.json", R"({"meshes": [{"name": "m", "vertices": [[0.25, 1234.5, 0], [1, 0, 0], [0, 1, 0]],
        "triangles": [[0, 1, 2]]}], "bodies": [{"name": "b", "mesh": "m", "pose": {"t": [0, 0, 1.5]}}]})");
    const CommaLocale comma(path("."));
    EXPECT_EQ(read_mesh_file(obj)->vertices()[0], Vec3(0, 0.25, 0));
    EXPECT_EQ(read_mesh_file(obj)->vertices()[1], Vec3(1234.5, 0, 0));
    const Scene scene = read_scene_file(json);
    EXPECT_EQ(scene.meshes[0].mesh->vertices()[0], Vec3(0.25, 1234.5, 0));
    EXPECT_EQ(scene.bodies[0].pose.t, Vec3(0, 0, 1.5));
    const auto bad = write("bad.off", "OFF\n1234567 1 0\n0 0 0\n");
    expect_error([&] { read_mesh_file(bad); }, bad, "line 3", "the file ends where vertex 1 should be");
}

}  // namespace
}  // namespace ecods::scenes
