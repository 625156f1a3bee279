// Parts of mesh files, and the names of bodies.
#include <vector>

#include "file_test.hpp"
#include "scenes/io/mesh_file.hpp"
#include "scenes/io/scene_file.hpp"

namespace ecods::scenes {
namespace {

using Names = std::vector<std::string>;

class ReadParts : public FileTest {
  protected:
    static Names names_of(const std::vector<NamedMesh>& meshes) {
        Names names;
        for (const NamedMesh& mesh : meshes) names.push_back(mesh.name);
        return names;
    }
    static Names names_of(const Scene& scene) {
        Names names;
        for (const SceneBody& body : scene.bodies) names.push_back(body.name);
        return names;
    }
    static void expect_mesh(const Mesh& mesh, const std::vector<Vec3>& vertices,
                            const std::vector<Triangle>& triangles) {
        EXPECT_TRUE(std::equal(mesh.vertices().begin(), mesh.vertices().end(), vertices.begin(), vertices.end()));
        EXPECT_TRUE(std::equal(mesh.triangles().begin(), mesh.triangles().end(), triangles.begin(), triangles.end()));
    }

    // The names that the faces of an OBJ file get, one face for each line "f".
    Names parts_of(const std::string& lines) {
        return names_of(read_mesh_parts(write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n" + lines)));
    }

    const std::string obj_ =
        "v 0 0 0\nv 9 9 9\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
        "o left\nf 5 3 1\no right\nf 1 3 4\nf 1 4 5\no left\nf -5 -3 -2\n";
};

TEST_F(ReadParts, ObjObjectsAreMeshesWithTheVerticesThatTheyUse) {
    const auto parts = read_mesh_parts(write("m.obj", obj_));
    ASSERT_EQ(names_of(parts), (Names{"left", "right"}));
    const std::vector<Vec3> used{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    expect_mesh(*parts[0].mesh, used, {{3, 1, 0}, {0, 1, 2}});
    expect_mesh(*parts[1].mesh, used, {{0, 1, 2}, {0, 2, 3}});
}

TEST_F(ReadParts, TheWholeFileIsOneMesh) {
    expect_mesh(*read_mesh_file(write("m.obj", obj_)), {{0, 0, 0}, {9, 9, 9}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                {{4, 2, 0}, {0, 2, 3}, {0, 3, 4}, {0, 2, 3}});
}

TEST_F(ReadParts, OnePartKeepsAllVertices) {
    const auto parts = read_mesh_parts(write("m.obj", "o a\nv 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 2 3 4\no b\n"));
    ASSERT_EQ(names_of(parts), Names{"a"});
    EXPECT_EQ(parts[0].mesh->vertices().size(), 4U);
}

TEST_F(ReadParts, ObjObjectsAndGroupsNameParts) {
    const std::string f = "f 1 2 3\n";
    EXPECT_EQ(parts_of(f), Names{""});
    EXPECT_EQ(parts_of("g a\n" + f + "g b\n" + f), (Names{"a", "b"}));
    EXPECT_EQ(parts_of("o a\n" + f + "g b\n" + f + "o c\n" + f), (Names{"a", "a/b", "c"}));
    EXPECT_EQ(parts_of("o a\ng a\n" + f + "o b\ng b\n" + f), (Names{"a", "b"}));
    EXPECT_EQ(parts_of("g empty\ng a\n" + f + "g gone\ng b\n" + f + "g last\n"), (Names{"a", "b"}));
    EXPECT_EQ(parts_of("g a\n" + f + "g b\n" + f + "g a\n" + f), (Names{"a", "b"}));
    EXPECT_EQ(parts_of(f + "g a\n" + f + "g\n" + f), (Names{"", "a"}));
    EXPECT_EQ(parts_of("g a b\n" + f + "g b  a\n" + f), (Names{"a b", "b a"}));
    EXPECT_EQ(parts_of("o part #3\n" + f + "o part #4 # comment\n" + f), (Names{"part #3", "part #4 # comment"}));
    EXPECT_EQ(parts_of("g a # 12 faces\n" + f + "g b\n" + f + "g a # 7 faces\n" + f), (Names{"a", "b"}));
    EXPECT_EQ(parts_of("o a/b\n" + f + "o a\ng b\n" + f), (Names{"a/b", "a/b"}));
}

TEST_F(ReadParts, StlSolidsArePartsEvenUnderOneName) {
    const auto solid = [](const std::string& name, const std::string& height) {
        return "solid" + name + "\nfacet normal 0 0 1\nouter loop\nvertex 0 0 " + height + "\nvertex 1 0 " + height +
               "\nvertex 0 1 " + height + "\nendloop\nendfacet\nendsolid\n";
    };
    const auto file =
        write("m.stl", solid(" my part", "1") + "solid none\nendsolid\n" + solid("", "2") + solid(" my part", "3"));
    const auto parts = read_mesh_parts(file);
    EXPECT_EQ(names_of(parts), (Names{"my part", "solid 3", "my part"}));
    expect_mesh(*parts[2].mesh, {{0, 0, 3}, {1, 0, 3}, {0, 1, 3}}, {{0, 1, 2}});
    EXPECT_EQ(names_of(read_files(std::vector{file})), (Names{"my part", "solid 3", "my part (2)"}));
    EXPECT_EQ(names_of(read_files(std::vector{write("one.stl", solid(" my part", "1"))})), Names{"one"});
}

TEST_F(ReadParts, PartsAreBodies) {
    const Scene scene = read_files(std::vector{write("m.obj", obj_ + "o\nf 1 3 5\n")});
    EXPECT_EQ(names_of(scene), (Names{"left", "right", "m"}));
    ASSERT_EQ(scene.meshes.size(), 3U);
    EXPECT_EQ(scene.bodies[2].mesh_index, 2U);
    EXPECT_EQ(scene.meshes[1].name, "right");
    EXPECT_TRUE(scene.bodies[1].pose == Pose{});
}

TEST_F(ReadParts, PathsTellBodiesApart) {
    std::filesystem::create_directories(path("a"));
    std::filesystem::create_directories(path("b"));
    const std::string one = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    const auto a = write("a/part.obj", one);
    const auto b = write("b/part.obj", one);
    const auto both = write("b/both.obj", one + "o part\nf 1 2 3\no \x1b[31mred\nf 1 2 3\n");
    EXPECT_EQ(names_of(read_files(std::vector{a, b})), (Names{a.string(), b.string()}));
    EXPECT_EQ(names_of(read_files(std::vector{b, a})), (Names{b.string(), a.string()}));
    EXPECT_EQ(names_of(read_files(std::vector{a, both})),
              (Names{a.string(), "both", both.string() + ": part", "?[31mred"}));
    EXPECT_EQ(names_of(read_files(std::vector{a, a, a})), (Names{"part", "part (2)", "part (3)"}));
    EXPECT_EQ(names_of(read_files(std::vector{a, b, a})), (Names{a.string(), b.string(), a.string() + " (2)"}));
    // A name that a file gives is nobody else's.
    const auto numbered = write("b/numbered.obj", one + "o part (2)\nf 1 2 3\n");
    EXPECT_EQ(names_of(read_files(std::vector{a, a, numbered})), (Names{"part", "part (3)", "numbered", "part (2)"}));
}

TEST_F(ReadParts, EveryFileThatCannotBeReadIsNamed) {
    std::filesystem::create_directories(path("folder"));
    const auto good = write("good.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const auto bad = write("bad.obj", "v 0 0 nan\n");
    const std::vector<std::filesystem::path> files{path("one.obj"), good,           bad,
                                                   path("two.stl"), path("folder"), write("m.xyz", "")};
    try {
        read_files(files);
        FAIL() << "no error";
    } catch (const ReadErrors& errors) {
        EXPECT_EQ(std::string(errors.what()), files[0].string() + ": no such file\n" + bad.string() +
                                                  ": line 1: 'nan' is not a finite number\n" + files[3].string() +
                                                  ": no such file\n" + files[4].string() + ": is a folder\n" +
                                                  files[5].string() +
                                                  ": unknown kind of file; known are .obj, .off, .ply, .stl, .gltf, "
                                                  ".glb and .json");
        EXPECT_EQ(errors.errors.size(), 5U);
    }
}

}  // namespace
}  // namespace ecods::scenes
