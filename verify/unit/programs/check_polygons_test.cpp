// ecods_check says how polygons were cut.
#include <nlohmann/json.hpp>

#include "program_test.hpp"

namespace ecods::scenes::check_polygons_test {
namespace {

using Json = nlohmann::json;

class CheckPolygons : public ProgramTest {};

TEST_F(CheckPolygons, SaysHowPolygonsWereCut) {
    const std::string vertices = "v 0 0 0\nv 4 0 0\nv 1 1 0\nv 0 4 0\nv 4 4 0\n";
    const std::string dent = write("dent.obj", vertices + "f 2 3 4 1\nf 1 5 2 4\n").string();
    const std::string plain = write("plain.obj", vertices + "f 1 2 3 4\n").string();
    const ProgramResult result = run_program(ECODS_CHECK_PROGRAM, "--json " + dent + " " + plain);
    EXPECT_EQ(result.status, 0);
    EXPECT_NE(result.err.find("dent.obj: 1 of 2 polygons cut by ears"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("dent.obj: the outlines of 1 of 2 polygons cross themselves"), std::string::npos);
    const Json of_dent{{"file", dent},  {"polygons", 2},    {"ears", 1},
                       {"crossing", 1}, {"in_no_plane", 0}, {"first_crossing", "line 7"}};
    EXPECT_EQ(Json::parse(result.out)["polygons"], Json::array({of_dent}));
    const ProgramResult quiet = run_program(ECODS_CHECK_PROGRAM, "--json " + plain);
    EXPECT_EQ(quiet.err, "");
    EXPECT_FALSE(Json::parse(quiet.out).contains("polygons"));
}

}  // namespace
}  // namespace ecods::scenes::check_polygons_test
