// Mesh files as programs in the field write them, which other readers read.
#include <cstring>

#include "ecods/solid.hpp"
#include "scenes/io/scene_file.hpp"
#include "unit/programs/mesh_file_test.hpp"

namespace ecods::scenes::read_field_test {
namespace {

const std::string mark = "\xef\xbb\xbf";  // of byte order, in UTF-8

class ReadField : public MeshFileTest {
  protected:
    // The triangle 0 0 0, 1 0 0, 0 1 0.
    void expect_triangle(const std::string& name, const std::string& bytes) {
        const auto mesh = read_mesh_file(write(name, bytes));
        ASSERT_EQ(mesh->triangles().size(), 1U) << bytes;
        ASSERT_EQ(mesh->vertices().size(), 3U) << bytes;
        EXPECT_EQ(mesh->triangles()[0], (Triangle{0, 1, 2}));
        EXPECT_EQ(mesh->vertices()[1], Vec3(1, 0, 0));
        EXPECT_EQ(mesh->vertices()[2], Vec3(0, 1, 0));
    }

    const std::string ply_header_ =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty char x\nproperty char y\nproperty char z\n"
        "element face 1\nproperty list uchar uchar vertex_indices\nend_header\n";
    const std::string ply_ = ply_header_ + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
};

TEST_F(ReadField, ByteOrderMarksArePassedOver) {
    expect_triangle("m.obj", mark + obj_);
    expect_triangle("m.obj", mark + "# comment\n" + obj_);
    expect_triangle("m.off", mark + off_);
    expect_triangle("m.ply", mark + ply_);
    expect_triangle("m.ply", mark + replaced(ply_header_, "ascii", "binary_little_endian") +
                                 std::string("\0\0\0\1\0\0\0\1\0\3\0\1\2", 13));
    expect_triangle("m.stl", mark + stl_);
    // Once, and at the beginning; lines are counted as before.
    expect_bad("m.obj", mark + mark + obj_, "line 1", "does not begin a line of an OBJ file");
    expect_bad("m.obj", obj_ + mark + "v 0 0 0\n", "line 5", "does not begin a line of an OBJ file");
    expect_bad("m.off", mark + replaced(off_, "1 0 0", "1 x 0"), "line 4", "'x' is not a finite number");
    for (const char* name : {"m.obj", "m.off", "m.ply"}) {
        expect_bad(name, std::string("\xff\xfev\0 \0", 6), "line 1", "the text is UTF-16");
        expect_bad(name, std::string("\xfe\xff\0v\0 ", 6), "line 1", "the text is UTF-16");
    }
}

TEST_F(ReadField, OffNumbersMayGoOverLines) {
    expect_triangle("m.off", replaced(off_, "3 0 1 2", "3 0\n1\n\n2"));
    expect_triangle("m.off", replaced(off_, "3 0 1 2", "3 # corners\n0 1 2"));
    expect_triangle("m.off", replaced(off_, "3 0 1 2", "3 0\n1\n2 255 0 0"));
    expect_triangle("m.off", replaced(off_, "1 0 0\n", "1\n0 0\n"));
    expect_triangle("m.off", replaced(off_, "0 0 0\n1 0 0\n", "0 0 0 1 0 0 "));
    expect_triangle("m.off", replaced(off_, "3 1 0\n", "3\n1 0\n"));
    expect_triangle("m.off", "COFF\n3 1 0\n0 0\n0 1 1 1\n1 0 0 1 1 nan 1\n0 1\n0 1 1 1\n3 0 1 2\n");
    expect_bad("m.off", replaced(off_, "3 0 1 2", "4 0 1 2"), "line 6", "the file ends where the rest of face 0");
    expect_bad("m.off", replaced(off_, "3 0 1 2", "3 0 1\n3"), "line 7", "index 3 is out of range");
    expect_bad("m.off", replaced(off_, "1 0 0", "1 0 0 7"), "line 4", "'7' is one word too many");
    // Behind a face, what is left of its line is a colour.
    expect_bad("m.off", replaced(replaced(off_, "3 1 0", "3 2 0"), "3 0 1 2", "3 0 1 2 3 0 1 2"), "line 6",
               "the file ends where face 1 should be");
}

TEST_F(ReadField, OffWordsMayBeGluedToCountsAndComments) {
    expect_triangle("m.off", replaced(off_, "OFF\n3 1 0", "OFF3 1 0"));
    expect_triangle("m.off", replaced(off_, "3 0 1 2", "3 0 1 2#red"));
    expect_triangle("m.off", replaced(off_, "1 0 0", "1 0 0#red"));
    expect_bad("m.off", replaced(off_, "OFF\n3 1 0", "OFF3x 1 0"), "line 1", "does not begin with OFF");
    expect_bad("m.off", replaced(off_, "OFF\n3 1 0", "OFF-3 1 0"), "line 1", "negative");
}

TEST_F(ReadField, ColoursNeedNotBeFinite) {
    for (const std::string colour : {" nan nan nan", " inf -inf 0", " -nan 0.5 NaN"}) {
        expect_triangle("m.obj", replaced(obj_, "v 1 0 0", "v 1 0 0" + colour));
        expect_triangle("m.off", replaced(off_, "3 0 1 2", "3 0 1 2" + colour));
    }
    expect_bad("m.obj", replaced(obj_, "v 1 0 0", "v 1 0 nan"), "line 2", "'nan' is not a finite number");
    expect_bad("m.obj", replaced(obj_, "v 1 0 0", "v 1 0 0 nan"), "line 2", "'nan' is not a finite number");
    expect_bad("m.obj", replaced(obj_, "v 1 0 0", "v 1 0 0 nan nan red"), "line 2", "'red' is not a number");
}

TEST_F(ReadField, StlWordsArePartedByBlanksOfAnyKind) {
    expect_triangle("m.stl", replaced(stl_, "loop\nvertex", "loop vertex"));
    expect_triangle("m.stl", replaced(stl_, "vertex 1 0 0", "vertex\n1 0\n0"));
    expect_triangle("m.stl", replaced(stl_, "facet normal 0 0 1", "facet\nnormal 0\n0 1"));
    std::string line = stl_;
    for (char& c : line) c = c == '\n' ? ' ' : c;
    expect_triangle("m.stl", line);
    EXPECT_EQ(read_mesh_parts(write("m.stl", line))[0].name, "s");
    EXPECT_EQ(read_mesh_parts(write("m.stl", replaced(stl_, "solid s", "solid facet of s")))[0].name, "facet of s");
    // An end that is followed by another solid on its line would swallow it.
    expect_bad("m.stl", line + line, "line 1", "facet is out of place");
}

TEST_F(ReadField, StlSaysBothSizes) {
    std::string bytes(84 + 50, '\0');
    bytes[80] = 1;
    for (const std::string start : {"binary", "solid, though binary"}) {
        std::memcpy(bytes.data(), start.data(), start.size());
        EXPECT_EQ(read_mesh_file(write("m.stl", bytes))->triangles().size(), 1U);
        expect_bad("m.stl", bytes + std::string(16, '\0'), "",
                   "the file has 150 bytes, and its count of 1 triangles asks for 134: 16 bytes too many");
        expect_bad("m.stl", bytes.substr(0, 100), "",
                   "has 100 bytes, and its count of 1 triangles asks for 134: 34 bytes too few");
    }
}

TEST_F(ReadField, ObjLinesOfOtherProgramsAreNamed) {
    expect_bad("m.obj", "3 1\n" + obj_, "line 1", "'3' does not begin a line of an OBJ file");
}

// ---- polygons

// A prism on an L, and a box in its notch. The caps begin at this corner of six.
std::string notch(int first) {
    std::string text = "o L\n";
    for (const int z : {0, 1}) {
        for (const auto& [x, y] : {std::pair{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {0, 1}})
            text += "v " + std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
    }
    std::string lower = "f", upper = "f";
    for (int k = 0; k < 6; ++k) {
        lower += " " + std::to_string(6 - (first + k) % 6);
        upper += " " + std::to_string(7 + (first + k) % 6);
    }
    text += lower + "\n" + upper + "\n";
    for (int k = 0; k < 6; ++k) {
        const int next = (k + 1) % 6;
        text += "f " + std::to_string(k + 1) + " " + std::to_string(next + 1) + " " + std::to_string(next + 7) + " " +
                std::to_string(k + 7) + "\n";
    }
    return text;
}

TEST_F(ReadField, ConcaveCapsBoundASolidWhereverTheyBegin) {
    for (int first = 0; first < 6; ++first) {
        PolygonCounts counts;
        const Solid solid(read_mesh_file(write("m.obj", notch(first)), &counts));
        QueryMemory memory;
        const auto place_of = [&](const Vec3& point) { return locate(point, Posed<Solid>(solid, {}), memory).side; };
        EXPECT_EQ(place_of({1, 2, 0.5}), Side::outside) << first;
        EXPECT_EQ(place_of({1, 0.5, 0.5}), Side::inside) << first;
        EXPECT_EQ(place_of({2.5, 2.5, 0.5}), Side::inside) << first;
        EXPECT_EQ(counts.polygons, 8U);
        EXPECT_EQ(counts.ears + counts.crossing, first == 1 || first == 4 ? 0U : 2U);
        EXPECT_EQ(counts.crossing + counts.in_no_plane, 0U);
    }
}

TEST_F(ReadField, EachFormatCutsPolygons) {
    const std::string obj = "v 0 0 0\nv 4 0 0\nv 1 1 0\nv 0 4 0\nf 1 2 3 4\nf 2 3 4 1\n";
    const std::string off = "OFF\n4 2 0\n0 0 0\n4 0 0\n1 1 0\n0 4 0\n4 0 1 2 3\n4 1 2 3 0\n";
    const std::string ply = replaced(replaced(ply_header_, "vertex 3", "vertex 4"), "face 1", "face 2") +
                            "0 0 0\n4 0 0\n1 1 0\n0 4 0\n4 0 1 2 3\n4 1 2 3 0\n";
    for (const auto& [name, text] : {std::pair{"m.obj", obj}, {"m.off", off}, {"m.ply", ply}}) {
        PolygonCounts counts;
        const auto mesh = read_mesh_file(write(name, text), &counts);
        ASSERT_EQ(mesh->triangles().size(), 4U);
        EXPECT_EQ(mesh->triangles()[0], (Triangle{0, 1, 2}));
        for (const Triangle& t : mesh->triangles())
            EXPECT_TRUE(std::count(t.begin(), t.end(), 0U) == 1 && std::count(t.begin(), t.end(), 2U) == 1) << name;
        EXPECT_EQ(counts.polygons, 2U);
        EXPECT_EQ(counts.ears, 1U);
    }
}

TEST_F(ReadField, ScenesSayHowPolygonsWereCut) {
    const std::string vertices = "v 0 0 0\nv 4 0 0\nv 1 1 0\nv 0 4 0\nv 4 4 0\nv 4 4 1\n";
    const auto convex = write("convex.obj", vertices + "f 1 2 5 4\n");
    const auto bent = write("bent.obj", vertices + "f 1 2 6 4\n");
    const auto dent = write("dent.obj", vertices + "f 1 2 5 4\nf 2 3 4 1\n");
    const auto cross = write("cross.obj", vertices + "f 1 2 5 4\nf 1 5 2 4\nf 1 2 4 5\n");
    const auto scene = write("scene.json", R"({"meshes": [{"name": "m", "file": "cross.obj"}], "bodies": []})");
    EXPECT_TRUE(read_file(convex).polygons.empty());
    // Corners that are in no plane are counted, and mentioned where the cut is not the fan.
    EXPECT_TRUE(read_file(bent).notes.empty());
    ASSERT_EQ(read_file(bent).polygons.size(), 1U);
    EXPECT_EQ(read_file(bent).polygons[0].counts.in_no_plane, 1U);
    EXPECT_EQ(read_file(dent).notes,
              std::vector{dent.string() + ": 1 of 2 polygons cut by ears, as no fan covers a dent"});
    const std::string text =
        ": the outlines of 2 of 3 polygons cross themselves, the first at line 8: cut into fans, which may be anything";
    EXPECT_EQ(read_file(cross).notes, std::vector{cross.string() + text});
    EXPECT_EQ(read_file(scene).notes, std::vector{cross.string() + text});
    const Scene both = read_files(std::vector{dent, cross});
    EXPECT_EQ(both.notes.size(), 2U);
    ASSERT_EQ(both.polygons.size(), 2U);
    EXPECT_EQ(both.polygons[1].file, cross.string());
    EXPECT_EQ(both.polygons[1].counts.first_crossing, "line 8");
}

}  // namespace
}  // namespace ecods::scenes::read_field_test
