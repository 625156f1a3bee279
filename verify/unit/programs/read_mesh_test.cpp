// Mesh files: full precision, the forms that occur, and each kind of bad input.
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <random>

#include "unit/programs/mesh_file_test.hpp"

namespace ecods::scenes {
namespace {

template <class T>
std::string bytes_of(T value, bool big_endian = false) {
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    return big_endian ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

// Decimals with their nearest doubles: short, 17 digits, halfway cases, the ends of the range.
struct Decimal {
    const char* text;
    double value;
};
constexpr std::array<Decimal, 12> decimals{{{"0.1", 0x1.999999999999ap-4},
                                            {"0.10000000000000002", 0x1.999999999999bp-4},
                                            {"-3.1415926535897931", -0x1.921fb54442d18p+1},
                                            {"9007199254740993", 0x1p+53},
                                            {"9007199254740993.00000001", 0x1.0000000000001p+53},
                                            {"1e23", 0x1.52d02c7e14af6p+76},
                                            {"1.7976931348623157e308", 0x1.fffffffffffffp+1023},
                                            {"2.2250738585072011e-308", 0x0.fffffffffffffp-1022},
                                            {"5e-324", 0x0.0000000000001p-1022},
                                            {"1e-400", 0.0},
                                            {"+1.5", 1.5},
                                            {"-0", -0.0}}};

class ReadMesh : public MeshFileTest {
  protected:
    // A mesh of two triangles on the vertices 0 0 0, 1 0 0, 0 1 0, 1 1 0.5.
    void expect_quad(const std::string& name, const std::string& bytes, std::vector<Triangle> triangles) {
        const auto mesh = read_mesh_file(write(name, bytes));
        const std::vector<Vec3> vertices{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0.5}};
        EXPECT_TRUE(std::equal(mesh->vertices().begin(), mesh->vertices().end(), vertices.begin(), vertices.end()));
        EXPECT_TRUE(std::equal(mesh->triangles().begin(), mesh->triangles().end(), triangles.begin(), triangles.end()));
    }
};

TEST_F(ReadMesh, KeepsEveryBitOfDecimals) {
    for (std::size_t i = 0; i < decimals.size(); i += 3) {
        const std::string point =
            std::string(decimals[i].text) + " " + decimals[i + 1].text + " " + decimals[i + 2].text;
        const std::string obj = "v " + point + "\nv 0 0 1\nv 0 1 0\nf 1 2 3\n";
        const std::string off = "OFF\n3 1 0\n" + point + "\n0 0 1\n0 1 0\n3 0 1 2\n";
        const std::string ply =
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
            "element face 1\nproperty list uchar int vertex_indices\nend_header\n" +
            point + "\n0 0 1\n0 1 0\n3 0 1 2\n";
        const std::string stl = "solid s\nfacet normal 0 0 0\nouter loop\nvertex " + point +
                                "\nvertex 0 0 1\nvertex 0 1 0\nendloop\nendfacet\nendsolid s\n";
        for (const auto& [name, text] : {std::pair{"m.obj", obj}, {"m.off", off}, {"m.ply", ply}, {"m.stl", stl}}) {
            const auto mesh = read_mesh_file(write(name, text));
            for (std::size_t axis = 0; axis < 3; ++axis) {
                EXPECT_EQ(std::bit_cast<std::uint64_t>(mesh->vertices()[0][static_cast<Eigen::Index>(axis)]),
                          std::bit_cast<std::uint64_t>(decimals[i + axis].value))
                    << name << " " << decimals[i + axis].text;
            }
        }
    }
}

TEST_F(ReadMesh, RoundTripsRandomDoubles) {
    std::mt19937_64 random(1);
    std::string text;
    std::vector<double> values;
    while (values.size() < 3000) {
        const double value = std::bit_cast<double>(random());
        if (!std::isfinite(value)) continue;
        std::array<char, 40> word{};
        std::snprintf(word.data(), word.size(), "%.17g", value);
        text += (values.size() % 3 == 0 ? "\nv " : " ") + std::string(word.data());
        values.push_back(value);
    }
    const auto mesh = read_mesh_file(write("m.obj", text + "\nf 1 2 3\n"));
    for (std::size_t i = 0; i < values.size(); ++i) {
        EXPECT_EQ(mesh->vertices()[i / 3][static_cast<Eigen::Index>(i % 3)], values[i]);
    }
}

TEST_F(ReadMesh, ReadsObj) {
    expect_quad(
        "m.OBJ",
        "# comment\r\nmtllib a.mtl\r\n\r\no thing\r\nv 0 0 0\r\nv 1 0 0 # first\r\nv\t0 1 0\r\nv 1 1 \\\r\n0.5\r\n"
        "vn 0 0 1\nvt 0 0\nf 1/1/1 2//1 4/1\nf -4 -1 -2",
        {{0, 1, 3}, {0, 3, 2}});
    expect_quad("m.obj", "v 0 0 0 1 1 1\nv 1 0 0\nv 0 1 0\nv 1 1 0.5\nf 1 2 4 3\n", {{0, 1, 3}, {0, 3, 2}});
}

TEST_F(ReadMesh, ReadsOff) {
    const std::string body = "0 0 0\n1 0 0\n0 1 0 # a vertex\n\n1 1 0.5\n";
    expect_quad("m.off", "OFF\n# comment\n4 2 0\n" + body + "3 0 1 2\n3 1 3 2 255 0 0\n", {{0, 1, 2}, {1, 3, 2}});
    expect_quad("m.off", "OFF 4 1 0\n" + body + "4 0 1 3 2\n", {{0, 1, 3}, {0, 3, 2}});
    expect_quad("m.off", "COFF\n4 1\n0 0 0 255 255 255 255\n1 0 0 9 9 9 9\n0 1 0 1 1 1 1\n1 1 0.5 0 0 0 0\n4 0 1 3 2\n",
                {{0, 1, 3}, {0, 3, 2}});
}

TEST_F(ReadMesh, ReadsTextPly) {
    expect_quad(
        "m.ply",
        "ply\nformat ascii 1.0\ncomment x\nelement vertex 4\nproperty float nx\nproperty float x\nproperty float y\n"
        "property float32 z\nelement edge 1\nproperty int a\nelement face 2\nproperty uchar red\n"
        "property list uchar uint vertex_index\nend_header\n"
        "nan 0 0 0\n0 1 0 0\n0 0 1 0\n0 1 1 0.5\n7\n9 3 0 1 2\n9 3 1 3 2\n",
        {{0, 1, 2}, {1, 3, 2}});
}

TEST_F(ReadMesh, ReadsBinaryPly) {
    for (const bool big : {false, true}) {
        std::string bytes = std::string("ply\nformat binary_") + (big ? "big" : "little") +
                            "_endian 1.0\nelement vertex 4\nproperty double x\nproperty float y\nproperty double z\n"
                            "element face 1\nproperty list uchar ushort vertex_indices\nproperty short s\nend_header\n";
        for (const Vec3& v : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(1, 1, 0.5)}) {
            bytes += bytes_of(v[0], big) + bytes_of(static_cast<float>(v[1]), big) + bytes_of(v[2], big);
        }
        bytes += "\x04";
        for (const int index : {0, 1, 3, 2}) bytes += bytes_of(static_cast<std::uint16_t>(index), big);
        bytes += bytes_of(std::int16_t{-1}, big);
        expect_quad("m.ply", bytes, {{0, 1, 3}, {0, 3, 2}});
        // Cut off anywhere, it is an error, and never anything else.
        for (std::size_t size = 0; size < bytes.size(); ++size) {
            EXPECT_THROW(read_mesh_file(write("cut.ply", bytes.substr(0, size))), ReadError) << size;
        }
        expect_bad("m.ply", replaced(bytes, bytes_of(0.5, big), bytes_of(std::nan(""), big)), "vertex 3",
                   "not a finite number");
        const std::string three = bytes_of(std::uint16_t{3}, big) + bytes_of(std::uint16_t{2}, big);
        expect_bad("m.ply", replaced(bytes, three, bytes_of(std::uint16_t{4}, big) + bytes_of(std::uint16_t{2}, big)),
                   "face 0", "index 4 is out of range: there are 4 vertices");
    }
}

std::string binary_stl(std::uint32_t count, std::initializer_list<float> corners) {
    std::string bytes = "solid, though binary";
    bytes.resize(80, ' ');
    bytes += bytes_of(count);
    std::size_t i = 0;
    for (const float x : corners) {
        if (i++ % 9 == 0) bytes += std::string(12, '\0');
        bytes += bytes_of(x);
        if (i % 9 == 0) bytes += std::string(2, '\0');
    }
    return bytes;
}

TEST_F(ReadMesh, ReadsBinaryStl) {
    const auto mesh = read_mesh_file(write("m.stl", binary_stl(1, {0, 0, 0, 1, 0, 0, 0, 0.1F, 0})));
    EXPECT_EQ(mesh->triangles().size(), 1U);
    EXPECT_EQ(mesh->vertices()[2], Vec3(0, static_cast<double>(0.1F), 0));
    expect_bad("m.stl", binary_stl(1, {0, 0, 0, 1, 0, 0, 0, std::nanf(""), 0}), "triangle 0", "not finite");
    expect_bad("m.stl", binary_stl(0, {}), "", "there is no triangle");
    expect_bad("m.stl", binary_stl(4000000000U, {0, 0, 0, 1, 0, 0, 0, 1, 0}), "",
               "the file has 134 bytes, and its count of 4000000000 triangles asks for 200000000084");
}

TEST_F(ReadMesh, ReadsSeveralSolidsOfTextStl) {
    const std::string solid =
        "SOLID a b\nfacet normal nan 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
        "endloop\nendfacet\nendsolid a b\n";
    const auto mesh = read_mesh_file(write("m.stl", solid + solid));
    EXPECT_EQ(mesh->triangles().size(), 2U);
    EXPECT_EQ(mesh->vertices().size(), 6U);
    expect_bad("m.stl", solid.substr(0, solid.size() - 13), "line 8", "the file ends before endsolid");
    expect_bad("m.stl", replaced(solid, "vertex 1 0 0\n", ""), "line 6", "does not have three corners");
    expect_bad("m.stl", replaced(solid, "vertex 1 0 0", "vertex 1 zero 0"), "line 5", "'zero' is not a finite number");
    expect_bad("m.stl", replaced(solid, "vertex 1 0 0", "vertex 1 0"), "line 5", "a number is missing");
    expect_bad("m.stl", replaced(solid, "outer loop", "inner loop"), "line 3", "not a line of an STL file");
    expect_bad("m.stl", "solid a\nendsolid a\n", "", "there is no triangle");
    expect_bad("m.stl", "a picture", "", "neither a text STL");
}

TEST_F(ReadMesh, NamesTheLineOfBadObj) {
    expect_bad("m.obj", "v 0 0 0\nv nan 0 0\n", "line 2", "'nan' is not a finite number");
    expect_bad("m.obj", "v 0 0 0\n\n\nv 0 0 inf\n", "line 4", "'inf' is not a finite number");
    expect_bad("m.obj", "v 0 0 1e309\n", "line 1", "'1e309' is not a finite number");
    expect_bad("m.obj", "v 0 0 1x\n", "line 1", "'1x' is not a finite number");
    expect_bad("m.obj", "v 0 0\n", "line 1", "a number is missing");
    const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    expect_bad("m.obj", vertices + "f 1 2 4\n", "line 4", "index 4 is out of range: there are 3 vertices");
    expect_bad("m.obj", vertices + "f 1 2 0\n", "line 4", "index 0 is out of range");
    expect_bad("m.obj", vertices + "f 1 2 -4\n", "line 4", "index -4 is out of range");
    expect_bad("m.obj", vertices + "f 1 2 99999999999999999999\n", "line 4", "not a whole number");
    expect_bad("m.obj", vertices + "f 1 2 three\n", "line 4", "not a whole number");
    expect_bad("m.obj", vertices + "f 1 2\n", "line 4", "fewer than three corners");
    expect_bad("m.obj", vertices, "", "there is no triangle: the mesh is empty");
    expect_bad("m.obj", "", "", "there is no triangle");
    expect_bad("m.obj",
               std::string("\x7f"
                           "ELF\x01\x02\x00\x00",
                           8),
               "line 1", "does not begin a line of an OBJ file");
}

TEST_F(ReadMesh, NamesTheLineOfBadOff) {
    expect_bad("m.off", "", "line 0", "the file ends where OFF should be");
    expect_bad("m.off", "4OFF\n1 1 0\n", "line 1", "does not begin with OFF");
    expect_bad("m.off", "OFF\n3 x 0\n", "line 2", "'x' is not a whole number");
    expect_bad("m.off", "OFF\n-3 1 0\n", "line 2", "negative");
    expect_bad("m.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n", "line 4", "the file ends where vertex 2 should be");
    expect_bad("m.off", "OFF\n999999999999 1 0\n0 0 0\n", "line 3", "the file ends where vertex 1 should be");
    const std::string start = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
    expect_bad("m.off", start, "line 5", "the file ends where face 0 should be");
    expect_bad("m.off", start + "3 0 1 3\n", "line 6", "index 3 is out of range: there are 3 vertices");
    expect_bad("m.off", start + "2 0 1\n", "line 6", "fewer than three corners");
    expect_bad("m.off", start + "4 0 1 2\n", "line 6", "the file ends where the rest of face 0 should be");
    expect_bad("m.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n", "", "there is no triangle");
}

TEST_F(ReadMesh, NamesThePlaceOfBadPly) {
    const std::string header =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    const std::string good = header + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    EXPECT_EQ(read_mesh_file(write("m.ply", good))->triangles().size(), 1U);
    expect_bad("m.ply", "plyx\n", "line 1", "does not begin with ply");
    expect_bad("m.ply", replaced(good, "ascii", "klingon"), "line 2", "unknown format");
    expect_bad("m.ply", replaced(good, "vertex 3", "vertex -3"), "line 3", "negative");
    expect_bad("m.ply", replaced(good, "double x", "complex x"), "line 4", "unknown type");
    expect_bad("m.ply", replaced(good, "property double z\n", ""), "line 8", "a vertex has no x, y or z");
    expect_bad("m.ply", replaced(good, "vertex_indices", "corners"), "line 9", "a face has no vertex_indices");
    expect_bad("m.ply", replaced(good, "end_header", "header_end"), "line 9", "not a line of a PLY header");
    expect_bad("m.ply", header + "0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n", "line 11, vertex 1", "not a finite number");
    expect_bad("m.ply", header + "0 0 0\n1 one 0\n0 1 0\n3 0 1 2\n", "line 11, vertex 1", "'one' is not a number");
    expect_bad("m.ply", header + "0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", "line 13, face 0", "index -1 is out of range");
    expect_bad("m.ply", header + "0 0 0\n1 0 0\n0 1 0\n3 0 1 1.5\n", "line 13, face 0", "1.5 is not a value");
    expect_bad("m.ply", header + "0 0 0\n1 0 0\n0 1 0\n-1 0 1\n", "line 13, face 0", "-1 is not a value");
    expect_bad("m.ply", header + "0 0 0\n1 0 0\n0 1 0\n4000000000 0 1\n", "line 13, face 0",
               "4000000000 is not a value");
    expect_bad("m.ply", header + "0 0 0\n1 0 0\n0 1 0\n2 0 1\n", "line 13, face 0", "fewer than three corners");
    expect_bad("m.ply", header + "0 0 0\n1 0 0\n", "line 11, vertex 2", "the file ends here");
    expect_bad("m.ply", replaced(header, "face 1", "face 0") + "0 0 0\n1 0 0\n0 1 0\n", "", "there is no triangle");
    expect_bad("m.ply", replaced(good, "vertex 3", "vertex 300000000000"), "line 13, vertex 3", "more values");
}

TEST_F(ReadMesh, RefusesWhatIsNoMeshFile) {
    const auto missing = path("missing.obj");
    expect_error([&] { read_mesh_file(missing); }, missing, "", "no such file");
    std::filesystem::create_directory(path("folder.obj"));
    expect_error([&] { read_mesh_file(path("folder.obj")); }, path("folder.obj"), "", "is a folder");
    expect_bad("m.txt", "v 0 0 0", "", "unknown kind of mesh file");
    EXPECT_TRUE(is_mesh_file("a/b.STL"));
    EXPECT_FALSE(is_mesh_file("a/obj"));
}

// Damage of any kind is an error or another mesh; it never crashes or hangs.
TEST_F(ReadMesh, SurvivesDamage) {
    const std::string ply =
        "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 1\nproperty list uint int vertex_indices\nend_header\n" +
        std::string(36, '\0') + bytes_of(3U) + bytes_of(0) + bytes_of(1) + bytes_of(2);
    const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/2/3 2 -1\n";
    const std::string stl = binary_stl(1, {0, 0, 0, 1, 0, 0, 0, 1, 0});
    std::mt19937_64 random(2);
    int errors = 0;
    for (const auto& [name, bytes] : {std::pair{"m.ply", ply}, {"m.obj", obj}, {"m.off", off_}, {"m.stl", stl}}) {
        for (int i = 0; i < 500; ++i) {
            std::string damaged = bytes;
            for (std::uint64_t k = 1 + random() % 4; k > 0; --k)
                damaged[random() % damaged.size()] = static_cast<char>(random());
            try {
                read_mesh_file(write(name, damaged));
            } catch (const ReadError&) {
                ++errors;
            }
        }
    }
    EXPECT_GT(errors, 300);
}

}  // namespace
}  // namespace ecods::scenes
