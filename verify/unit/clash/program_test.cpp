// ecods_clash as its users run it.
#include "unit/programs/program_test.hpp"

#include <gtest/gtest.h>

#include <string>

namespace ecods::scenes {
namespace {

class ClashProgram : public ProgramTest {
  protected:
    ProgramResult run(const std::string& arguments) const { return run_program(ECODS_CLASH_PROGRAM, arguments); }

    // A tetrahedron with a corner at (x, 0, 0) and edges of length 2 along the axes.
    static std::string tetrahedron(const std::string& name, int x) {
        return "o " + name + "\nv " + std::to_string(x) + " 0 0\nv " + std::to_string(x + 2) + " 0 0\nv " +
               std::to_string(x) + " 2 0\nv " + std::to_string(x) +
               " 0 2\nf -4 -2 -3\nf -4 -3 -1\nf -4 -1 -2\nf -3 -2 -1\n";
    }
};

TEST_F(ClashProgram, HelpAndVersion) {
    expect_help_and_version(ECODS_CLASH_PROGRAM);
}

TEST_F(ClashProgram, OutOfMemorySaysSo) {
    expect_out_of_memory(ECODS_CLASH_PROGRAM);
}

TEST_F(ClashProgram, FilesFromStrangersNameNoFilesElsewhere) {
    expect_untrusted_is_refused(ECODS_CLASH_PROGRAM);
    std::filesystem::create_directories(path("folder/sub"));
    write("folder/sub/own.obj", tetrahedron("own", 0));
    std::filesystem::create_symlink("own.obj", path("folder/sub/alias.obj"));
    EXPECT_EQ(run("--untrusted " + path("folder").string()).status, 0);
    const std::string other = write("other.obj", tetrahedron("other", 0)).string();
    std::filesystem::create_symlink(other, path("folder/sub/link.obj"));
    EXPECT_EQ(run(path("folder").string()).status, 0);
    const ProgramResult result = run("--untrusted " + path("folder").string());
    EXPECT_EQ(result.status, 2);
    EXPECT_NE(result.err.find("sub/link.obj: is a link that leads out of its folder; --untrusted"), std::string::npos)
        << result.err;
}

TEST_F(ClashProgram, ExitStatusSaysWhetherKindsWereFound) {
    const std::string two = write("two.obj", tetrahedron("a", 0) + tetrahedron("b", 1)).string();
    EXPECT_EQ(run(two).status, 0);
    EXPECT_EQ(run(two + " --fail-on overlapping").status, 1);
    EXPECT_EQ(run(two + " --fail-on equal --fail-on touching").status, 0);
    EXPECT_EQ(run(two + " --fail-on any").status, 1);
    EXPECT_EQ(run(two + " --fail-on any --ignore a b").status, 0);
    EXPECT_EQ(run(two + " --fail-on any --a a --b a").status, 0);
    EXPECT_EQ(run(two + " --fail-on clearance").status, 2);
    EXPECT_EQ(run(two + " --clearance -1").status, 2);
    EXPECT_EQ(run(two + " --clearance nan").status, 2);
    EXPECT_EQ(run(two + " --jobs 0").status, 2);
    const std::string far = write("far.obj", tetrahedron("a", 0) + tetrahedron("b", 2)).string();
    EXPECT_EQ(run(far + " --fail-on any").status, 0);
    EXPECT_EQ(run(far + " --fail-on touching").status, 1);
}

TEST_F(ClashProgram, BadFilesAreNamedWithTheLine) {
    const std::string good = write("good.obj", tetrahedron("a", 0)).string();
    const std::string bad = write("bad.obj", "v 0 0 0\nv 1 0 x\n").string();
    const ProgramResult result = run(good + " " + bad + " " + path("none.obj").string());
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find("bad.obj: line 2"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("none.obj: no such file"), std::string::npos) << result.err;
    const ProgramResult kept = run("--keep-going " + good + " " + bad + " --json -");
    EXPECT_EQ(kept.status, 2);
    EXPECT_NE(kept.err.find("bad.obj: line 2"), std::string::npos);
    EXPECT_NE(kept.out.find("bad.obj: line 2"), std::string::npos);
    EXPECT_NE(kept.out.find("\"name\": \"good\""), std::string::npos) << kept.out;
}

TEST_F(ClashProgram, MalformedInputsAreRefusedWell) {
    const std::string huge = "v 1e308 1e308 -1e308\nv -1e308 0 0\nv 0 1e-308 0\nf 1 2 3\n";
    EXPECT_EQ(run(write("huge.obj", huge).string()).status, 0);
    for (const auto& [name, bytes] : {std::pair{"empty.obj", ""},
                                      {"zero.stl", ""},
                                      {"nan.obj", "v nan 0 0\n"},
                                      {"index.obj", "v 0 0 0\nf 1 2 3\n"},
                                      {"header.ply", "ply\nformat ascii 1.0\nelement vertex 99999999999\nend_header\n"},
                                      {"counts.off", "OFF\n4000000000 4000000000 0\n"},
                                      {"deep.json", "[[[[[[[[[[[[[[[[[["},
                                      {"other.txt", "v 0 0 0\n"}}) {
        const ProgramResult result = run(write(name, bytes).string());
        EXPECT_EQ(result.status, 2) << name;
        EXPECT_NE(result.err.find(name), std::string::npos) << result.err;
    }
    EXPECT_EQ(run(path("").string()).status, 0 + 2);  // a folder with one good file and many bad ones
    EXPECT_EQ(run(write("two.obj", tetrahedron("a", 0)).string() + " --json /nowhere/a.json").status, 2);
}

TEST_F(ClashProgram, FoldersAreSearched) {
    std::filesystem::create_directories(path("a/b"));
    write("a/part.obj", tetrahedron("x", 0));
    write("a/b/part.OBJ", tetrahedron("x", 0));
    write("a/b/readme.txt", "no mesh");
    const ProgramResult result = run(path("a").string());
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.out.find("equal"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("2 parts, 1 equal"), std::string::npos) << result.out;
    std::filesystem::create_directories(path("c"));
    EXPECT_EQ(run(path("c").string()).status, 2);
}

TEST_F(ClashProgram, NamesOfAnyBytesAreWritten) {
    const std::string names = tetrahedron("a,\"b\"\t=\xff\xc3\xa9", 0) + tetrahedron("<b>&amp;\x01", 1);
    const std::string file = write("names.obj", names).string();
    const ProgramResult csv = run(file + " --csv -");
    EXPECT_NE(csv.out.find(",\"a,\"\"b\"\" =\xff\xc3\xa9\""), std::string::npos) << csv.out;
    EXPECT_NE(csv.out.find("<b>&amp;?"), std::string::npos) << csv.out;
    EXPECT_NE(run(file + " --json -").out.find("a,\\\"b\\\" =\xef\xbf\xbd\xc3\xa9"), std::string::npos);
}

// No name is a formula in a spreadsheet; numbers are numbers.
TEST_F(ClashProgram, NamesAreNoFormulas) {
    const std::string file =
        write("=formula.obj", tetrahedron("=1+1", -3) + tetrahedron("@SUM(1)", -2) + tetrahedron(" +1;-2", -4))
            .string();
    const ProgramResult csv = run("'" + file + "' --touching --csv -");
    EXPECT_EQ(csv.status, 0) << csv.err;
    EXPECT_NE(csv.out.find(",\"'=1+1\",\"'@SUM(1)\","), std::string::npos) << csv.out;
    EXPECT_NE(csv.out.find("'+1;'-2\","), std::string::npos) << csv.out;
    EXPECT_NE(csv.out.find(",-2,0,0,"), std::string::npos) << csv.out;
    for (const char* formula : {",=", ",@", ",+", ";-", "\"=", "\"@"})
        EXPECT_EQ(csv.out.find(formula), std::string::npos) << formula << " in " << csv.out;
}

TEST_F(ClashProgram, TheLastLineSaysWhatWasThereToClash) {
    const std::string open = "o open\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n";
    const std::string one = write("one.obj", tetrahedron("a", 0)).string();
    EXPECT_NE(
        run(one).out.find("1 part, no clash (nothing to clash with: in an OBJ file, o and g lines begin parts)\n"),
        std::string::npos);
    const std::string two = write("two.obj", tetrahedron("a", 5) + open).string();
    EXPECT_NE(run(two).out.find("\n2 parts, no clash; 1 is no solid\n"), std::string::npos) << run(two).out;
    const std::string three = write("three.obj", open + tetrahedron("a", 0) + "o other\n" + open.substr(7)).string();
    EXPECT_NE(run(three).out.find("; 2 are no solids\n"), std::string::npos) << run(three).out;
}

TEST_F(ClashProgram, DuplicatesOfSurfacesAreEqual) {
    const std::string one = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";
    const std::string file =
        write("open.obj", "o a\n" + one + "f 1 2 3\nf 2 4 3\no b\n" + one + "f 8 7 6\nf 5 7 6\n").string();
    const ProgramResult result = run(file);
    EXPECT_NE(result.out.find("equal"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("not a solid: a: triangle 0: its edge"), std::string::npos) << result.out;
}

TEST_F(ClashProgram, WhatHasNoAreaTouches) {
    // A wire that ends at a corner of a, one that is inside it, one beside it, and a solid with a wire of its own.
    const std::string text = tetrahedron("a", 0) + "o end\nv 0 0 0\nv -1 0 0\nv -2 0 0\nf -3 -2 -1\n" +
                             "o inner\nv 0.1 0.1 0.1\nv 0.2 0.2 0.2\nf -2 -1 -1\n" +
                             "o beside\nv 0 0 -0.0005\nv 0 0 -1\nf -2 -1 -1\n" + tetrahedron("with wire", 9) +
                             "v 2 0 0\nf -5 -1 -1\n";
    const std::string file = write("wires.obj", text).string();
    const ProgramResult result = run(file + " --touching --clearance 0.001 --csv -");
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.out.find("touching,touching,a,"), std::string::npos) << result.out;
    EXPECT_NE(run(file + " --touching --clearance 0.001").out.find("5 parts, 1 inside, 2 touching, 2 clearance"),
              std::string::npos)
        << run(file + " --touching --clearance 0.001").out;
    EXPECT_NE(run(file + " --touching").out.find("5 parts, 1 inside, 2 touching"), std::string::npos);
}

TEST_F(ClashProgram, ReportsThatCannotBeWritten) {
    const std::string two = write("two.obj", tetrahedron("a", 0) + tetrahedron("b", 1)).string();
    for (const char* format : {"--json", "--csv", "--html", "--bcf"}) {
        const ProgramResult full = run(two + " " + format + " /dev/full");
        EXPECT_EQ(full.status, 2) << format;
        EXPECT_NE(full.err.find("/dev/full: cannot be written"), std::string::npos) << full.err;
        for (const std::string& folder : {std::string("/nowhere"), two}) {
            const ProgramResult none = run(two + " " + format + " " + folder + "/report");
            EXPECT_EQ(none.status, 2) << format;
            EXPECT_NE(none.err.find(folder + "/report: cannot be written"), std::string::npos) << none.err;
        }
    }
}

TEST_F(ClashProgram, RealAssembly) {
    const std::string engine = "/usr/share/assimp/models/glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb";
    if (!std::filesystem::exists(engine)) GTEST_SKIP() << "assimp-testmodels is not installed";
    const ProgramResult result = run(engine + " --touching --clearance 0.001");
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.out.find("67 parts, 15 overlapping"), std::string::npos) << result.out;
}

}  // namespace
}  // namespace ecods::scenes
