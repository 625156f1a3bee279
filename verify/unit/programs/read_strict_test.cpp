// Mesh files with something too much, or something that could be read in two ways: an error with its line.
#include "unit/programs/mesh_file_test.hpp"

namespace ecods::scenes::read_strict_test {
namespace {

class ReadStrict : public MeshFileTest {
  protected:
    void expect_good(const std::string& name, const std::string& bytes) {
        EXPECT_EQ(read_mesh_file(write(name, bytes))->triangles().size(), 1U) << bytes;
    }

    const std::string ply_ =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "property uchar red\nelement face 1\nproperty list uchar int vertex_indices\nproperty char c\nend_header\n"
        "0 0 0 1\n1 0 0 2\n0 1 0 255\n3 0 1 2 -128\n";
};

TEST_F(ReadStrict, ObjVerticesHaveCoordinatesAndPerhapsAWeightOrAColour) {
    expect_good("m.obj", obj_);
    expect_good("m.obj", replaced(obj_, "v 1 0 0", "v 1 0 0 1.0"));
    expect_good("m.obj", replaced(obj_, "v 1 0 0", "v 1 0 0 0.5 0.5 0.5"));
    expect_bad("m.obj", replaced(obj_, "v 1 0 0", "v 1 0 0 2"), "line 2", "a weight other than 1 is not supported");
    expect_bad("m.obj", replaced(obj_, "v 1 0 0", "v 1 0 0 junk"), "line 2", "'junk' is not a finite number");
    expect_bad("m.obj", replaced(obj_, "v 1 0 0", "v 1 0 0 1 1"), "line 2", "a number is missing");
    expect_bad("m.obj", replaced(obj_, "v 1 0 0", "v 1 0 0 1 1 junk"), "line 2", "'junk' is not a number");
    expect_bad("m.obj", replaced(obj_, "v 1 0 0", "v 1 0 0 1 1 1 7"), "line 2", "'7' is one word too many");
    expect_bad("m.obj", replaced(obj_, "v 1 0 0", "v 1 0 0#"), "line 2", "'0#' is not a finite number");
}

TEST_F(ReadStrict, ObjCornersAreIndicesAndSlashes) {
    expect_good("m.obj", replaced(obj_, "f 1 2 3", "f 1/ 2// 3/-1/7"));
    for (const std::string corner : {"3/x", "3/1/x", "3/1/1/1", "3/1.5", "3//1/"}) {
        expect_bad("m.obj", replaced(obj_, "f 1 2 3", "f 1 2 " + corner), "line 4",
                   "the corner '" + corner + "' is not i, i/t, i//n or i/t/n");
    }
}

TEST_F(ReadStrict, ObjKeywordsAreKnown) {
    expect_good("m.obj", obj_ + "s off\nusemtl a b\nl 1 2\np 1\ncstype bezier\nend\n");
    expect_bad("m.obj", replaced(obj_, "v 1 0 0", "V 1 0 0"), "line 2", "'V' does not begin a line of an OBJ file");
    expect_bad("m.obj", obj_ + "F 1 2 3\n", "line 5", "'F' does not begin a line");
    expect_bad("m.obj", obj_ + "fo 1 2 3\n", "line 5", "fo is not supported");
    expect_bad("m.obj", obj_ + "call other.obj\n", "line 5", "call is not supported");
    expect_bad("m.obj", obj_ + "surf 0 1 0 1 1 2 3 4\n", "line 5", "surf is not supported");
}

TEST_F(ReadStrict, OffLinesEndWhereTheyShould) {
    expect_good("m.off", off_);
    expect_bad("m.off", replaced(off_, "1 0 0", "1 0 0 7"), "line 4", "'7' is one word too many");
    expect_bad("m.off", replaced(off_, "3 1 0", "3 1 0 0"), "line 2", "'0' is one word too many");
    expect_bad("m.off", replaced(off_, "3 1 0", "3 1 x"), "line 2", "'x' is not a whole number");
    expect_good("m.off", replaced(off_, "3 0 1 2", "3 0 1 2 0.5 0.5 0.5 1"));
    expect_good("m.off", replaced(off_, "3 0 1 2", "3 0 1 2 7 # a colour"));
    expect_bad("m.off", replaced(off_, "3 0 1 2", "3 0 1 2 junk"), "line 6", "'junk' is not a number");
    expect_bad("m.off", replaced(off_, "3 0 1 2", "3 0 1 2 1 1"), "line 6", "no colour");
    expect_bad("m.off", replaced(off_, "3 0 1 2", "3 0 1 2 1 1 1 1 9"), "line 6", "'9' is one word too many");
    expect_bad("m.off", off_ + "3 0 1 2\n", "line 7", "the file goes on behind the last face");
    expect_good("m.off", off_ + "# nothing\n\n");
    const std::string coloured = "COFF\n3 1 0\n0 0 0 1 1 1\n1 0 0 1 1 1 1\n0 1 0 1 1 1\n3 0 1 2\n";
    expect_good("m.off", coloured);
    expect_bad("m.off", replaced(coloured, "0 1 0 1 1 1", "0 1 0 1 1"), "line 5", "a number is missing");
    expect_bad("m.off", replaced(coloured, "1 0 0 1 1 1 1", "1 0 0 1 1 1 1 1"), "line 4", "one word too many");
}

TEST_F(ReadStrict, PlyLinesEndWhereTheyShould) {
    expect_good("m.ply", ply_);
    expect_bad("m.ply", replaced(ply_, "1 0 0 2", "1 0 0 2 9"), "line 13, vertex 1", "more values than properties");
    expect_bad("m.ply", replaced(ply_, "1 0 0 2", "1 0 0\n2"), "line 13, vertex 1", "fewer values than properties");
    expect_bad("m.ply", replaced(ply_, "2 -128", "2 -128 0"), "line 15, face 0", "more values than properties");
    expect_bad("m.ply", ply_ + "0\n", "line 16", "the file goes on behind the last element");
    expect_bad("m.ply", replaced(ply_, "ply", "ply x"), "line 1", "'x' is one word too many");
    expect_bad("m.ply", replaced(ply_, "1.0", "1.0 x"), "line 2", "'x' is one word too many");
    expect_bad("m.ply", replaced(ply_, "1.0", "2.0"), "line 2", "version of the format is not 1.0");
    expect_bad("m.ply", replaced(ply_, "vertex 3", "vertex 3 3"), "line 3", "'3' is one word too many");
    expect_bad("m.ply", replaced(ply_, "float x", "float x y"), "line 4", "'y' is one word too many");
    expect_bad("m.ply", replaced(ply_, "end_header", "end_header x"), "line 11", "'x' is one word too many");
}

TEST_F(ReadStrict, PlyNamesAreGivenOnce) {
    expect_bad("m.ply", replaced(ply_, "uchar red", "uchar x"), "line 7", "the property x is given twice");
    expect_bad("m.ply", replaced(ply_, "char c", "list uchar int vertex_index"), "line 11", "both vertex_indices and");
    expect_bad("m.ply", replaced(ply_, "element face 1", "element vertex 1\nproperty int a\nelement face 1"), "line 8",
               "the element vertex is given twice");
    expect_bad("m.ply", replaced(ply_, "element face 1", "element tristrips 1"), "line 8", "tristrips are not");
}

TEST_F(ReadStrict, PlyValuesAreOfTheirType) {
    for (const std::string value : {"256", "-1", "0.5", "1e300", "nan"}) {
        expect_bad("m.ply", replaced(ply_, "0 0 0 1", "0 0 0 " + value), "line 12, vertex 0",
                   value + " is not a value of the property's type");
    }
    expect_good("m.ply", replaced(ply_, "0 0 0 1", "0 0 0 255.0"));
    expect_bad("m.ply", replaced(ply_, "-128", "-129"), "line 15, face 0", "-129 is not a value");
    expect_bad("m.ply", replaced(ply_, "3 0 1 2", "3 0 1 2147483648"), "line 15, face 0", "2147483648 is not a value");
    expect_bad("m.ply", replaced(ply_, "3 0 1 2", "259 0 1 2"), "line 15, face 0", "259 is not a value");
    expect_bad("m.ply", replaced(ply_, "1 0 0 2", "1e39 0 0 2"), "line 13, vertex 1", "1e39 is not a value");
    expect_good("m.ply", replaced(replaced(ply_, "float x", "double x"), "1 0 0 2", "1e39 0 0 2"));
}

TEST_F(ReadStrict, BinaryPlyEndsWithItsLastElement) {
    const std::string header =
        "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty char x\nproperty char y\nproperty char z\n"
        "element face 1\nproperty list uchar uchar vertex_indices\nend_header\n";
    const std::string bytes = header + std::string("\0\0\0\1\0\0\0\1\0\3\0\1\2", 13);
    expect_good("m.ply", bytes);
    expect_bad("m.ply", bytes + "\n", "", "1 bytes follow the last element");
}

// Blender 2.4 wrote its name into the header, and no "comment" before it.
TEST_F(ReadStrict, PlyOfBlenderIsRead) {
    expect_good("m.ply", replaced(ply_, "1.0\n", "1.0\nCreated by Blender3D 247 - www.blender.org, source file: \n"));
    expect_bad("m.ply", replaced(ply_, "1.0\n", "1.0\nCreated\n"), "line 3", "this is not a line of a PLY header");
}

TEST_F(ReadStrict, StlLinesEndWhereTheyShould) {
    expect_good("m.stl", stl_);
    expect_good("m.stl", replaced(stl_, "normal 0 0 1", "normal -1.#IND 0 0"));
    expect_bad("m.stl", replaced(stl_, "vertex 1 0 0", "vertex 1 0 0 7"), "line 5", "'7' is one word too many");
    expect_bad("m.stl", replaced(stl_, "normal 0 0 1", "normal 0 0 1 7"), "line 2", "'7' is one word too many");
    expect_bad("m.stl", replaced(stl_, "normal 0 0 1", "normal 0 0"), "line 2", "a facet has no normal");
    expect_bad("m.stl", replaced(stl_, "outer loop", "outer loop 1"), "line 3", "'1' is one word too many");
    expect_bad("m.stl", replaced(stl_, "endloop", "endloop 1"), "line 7", "'1' is one word too many");
    expect_bad("m.stl", replaced(stl_, "endfacet", "endfacet 1"), "line 8", "'1' is one word too many");
    expect_bad("m.stl", replaced(stl_, "outer loop\n", ""), "line 3", "vertex is out of place");
    expect_bad("m.stl", replaced(stl_, "endloop\n", ""), "line 7", "endfacet is out of place");
    expect_bad("m.stl", stl_ + "vertex 0 0 0\n", "line 10", "vertex is out of place");
}

}  // namespace
}  // namespace ecods::scenes::read_strict_test
