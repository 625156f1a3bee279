// The rules on made-up text: that they find what they are for, and nothing else.
#include <gtest/gtest.h>

#include "tidy/edges.hpp"
#include "tidy/include_rules.hpp"
#include "tidy/text_rules.hpp"

namespace ecods::tidy {
namespace {

const Files made_up = {
    "include/ecods/primitives.hpp",   "include/ecods/broad_phase.hpp",  "include/ecods/ecods.hpp",
    "include/ecods/ids.hpp",          "include/ecods/intersection.hpp", "include/ecods/mesh.hpp",
    "include/ecods/pose.hpp",         "include/ecods/world.hpp",        "src/base/hash.hpp",
    "src/bvh/tree/mesh_bvh.hpp",      "src/exact/number/limbs.hpp",     "src/exact/point/point.hpp",
    "src/exact/sign/exact_signs.hpp", "src/geometry/key_box.hpp",       "src/world/verdict_cache.hpp",
    "src/world/world_impl.hpp",       "verify/oracle/oracle.hpp",       "verify/scenes/ship.hpp",
    "fuzz/base/failure.hpp",          "bench/engines/engine.hpp",       "verify/unit/world/world_fixture.hpp",
};

bool is_allowed(std::string_view file, const std::string& path) {
    return !check_include(made_up, file, {.path = path, .is_angled = false});
}
bool is_allowed_angled(std::string_view file, const std::string& path) {
    return !check_include(made_up, file, {.path = path, .is_angled = true});
}

TEST(IncludeRules, DirectivesAreFoundAndCommentsAreNot) {
    const auto includes = find_includes(
        "#include <vector>\n"
        "// #include \"no.hpp\"\n"
        "  #  include \"base/hash.hpp\"  // why\n"
        "/* \n#include \"neither.hpp\"\n*/\n"
        "const char* text = \"// not a comment\";\n"
        "#include \"ecods/ids.hpp\"\n");
    ASSERT_EQ(includes.size(), 3u);
    EXPECT_EQ(includes[0].path, "vector");
    EXPECT_TRUE(includes[0].is_angled);
    EXPECT_EQ(includes[1].path, "base/hash.hpp");
    EXPECT_EQ(includes[1].line, 3);
    EXPECT_EQ(includes[2].path, "ecods/ids.hpp");
    EXPECT_EQ(includes[2].line, 8);
}

TEST(IncludeRules, RoomsLookDownAndOnlyWhereTheTableSays) {
    EXPECT_TRUE(is_allowed("src/world/world.cpp", "geometry/key_box.hpp"));
    EXPECT_TRUE(is_allowed("src/world/world.cpp", "world/verdict_cache.hpp"));
    EXPECT_TRUE(is_allowed("src/world/world.cpp", "ecods/world.hpp"));
    EXPECT_TRUE(is_allowed("src/geometry/aabb.cpp", "ecods/primitives.hpp"));
    EXPECT_TRUE(is_allowed("src/exact/sign/plain.cpp", "exact/point/point.hpp"));
    EXPECT_FALSE(is_allowed("src/exact/point/frame.cpp", "exact/sign/exact_signs.hpp")) << "a higher room";
    EXPECT_FALSE(is_allowed("src/broad_phase/sweep/sweep.cpp", "world/world_impl.hpp"));
    EXPECT_FALSE(is_allowed("src/broad_phase/sweep/sweep.cpp", "ecods/world.hpp"));
    EXPECT_FALSE(is_allowed("src/broad_phase/broad_phase.cpp", "bvh/tree/mesh_bvh.hpp")) << "it never sees a triangle";
    EXPECT_FALSE(is_allowed("src/world/world.cpp", "exact/number/limbs.hpp")) << "lower, and not in the table";
    EXPECT_FALSE(is_allowed("src/world/world.cpp", "ecods/ecods.hpp"));
}

TEST(IncludeRules, ThereAreNoOtherPaths) {
    EXPECT_FALSE(is_allowed("src/world/world.cpp", "world_impl.hpp"));
    EXPECT_FALSE(is_allowed("src/world/world.cpp", "../base/hash.hpp"));
    EXPECT_FALSE(is_allowed("src/world/world.cpp", "oracle/oracle.hpp"));
    EXPECT_FALSE(is_allowed("src/world/world.cpp", "fuzz/base/failure.hpp"));
    EXPECT_FALSE(is_allowed("src/world/world.cpp", "ecods/unheard_of.hpp"));
}

TEST(IncludeRules, PublicHeadersAreAmongThemselves) {
    EXPECT_TRUE(is_allowed("include/ecods/world.hpp", "ecods/broad_phase.hpp"));
    EXPECT_TRUE(is_allowed("include/ecods/mesh.hpp", "ecods/pose.hpp"));
    EXPECT_TRUE(is_allowed("include/ecods/ecods.hpp", "ecods/world.hpp"));
    EXPECT_FALSE(is_allowed("include/ecods/broad_phase.hpp", "ecods/world.hpp"));
    EXPECT_FALSE(is_allowed("include/ecods/world.hpp", "base/hash.hpp"));
    EXPECT_FALSE(is_allowed("include/ecods/unheard_of.hpp", "ecods/ids.hpp"));
}

TEST(IncludeRules, ThirdParties) {
    EXPECT_TRUE(is_allowed_angled("src/world/world.cpp", "vector"));
    EXPECT_TRUE(is_allowed_angled("src/world/world.cpp", "Eigen/Core"));
    EXPECT_TRUE(is_allowed_angled("src/simd/wide.hpp", "immintrin.h"));
    EXPECT_FALSE(is_allowed_angled("src/bvh/masks/overlap_mask.cpp", "immintrin.h"));
    EXPECT_FALSE(is_allowed_angled("include/ecods/world.hpp", "hwy/highway.h"));
    EXPECT_FALSE(is_allowed_angled("src/world/world.cpp", "gsl/gsl_rng.h"));
    EXPECT_FALSE(is_allowed_angled("src/world/world.cpp", "CGAL/Gmpq.h"));
    EXPECT_FALSE(is_allowed_angled("src/world/world.cpp", "stdio.h"));
    EXPECT_TRUE(is_allowed_angled("verify/oracle/mesh.cpp", "CGAL/Gmpq.h"));
    EXPECT_FALSE(is_allowed_angled("verify/scenes/ship.cpp", "CGAL/Gmpq.h"));
    EXPECT_FALSE(is_allowed_angled("fuzz/checks/answers.cpp", "fcl/fcl.h"));
    EXPECT_TRUE(is_allowed_angled("bench/engines/narrow_fcl.cpp", "fcl/fcl.h"));
}

TEST(IncludeRules, TheOracleSharesNoCodeWithTheLibrary) {
    EXPECT_TRUE(is_allowed("verify/oracle/mesh.cpp", "oracle/oracle.hpp"));
    EXPECT_TRUE(is_allowed("verify/oracle/mesh.cpp", "ecods/mesh.hpp"));
    EXPECT_FALSE(is_allowed("verify/oracle/mesh.cpp", "ecods/intersection.hpp"));
    EXPECT_FALSE(is_allowed("verify/oracle/mesh.cpp", "exact/number/limbs.hpp"));
    EXPECT_FALSE(is_allowed("verify/oracle/mesh.cpp", "../../src/exact/number/limbs.hpp"));
}

TEST(IncludeRules, ChecksAndBenchmarksAreHeldToTheTable) {
    EXPECT_TRUE(is_allowed("verify/unit/world/world_test.cpp", "unit/world/world_fixture.hpp"));
    EXPECT_TRUE(is_allowed("verify/unit/world/world_test.cpp", "world_fixture.hpp"));
    EXPECT_FALSE(is_allowed("verify/scenes/ship.cpp", "oracle/oracle.hpp"));
    EXPECT_FALSE(is_allowed("verify/scenes/ship.cpp", "base/hash.hpp"));
    EXPECT_FALSE(is_allowed("fuzz/script/play.cpp", "bench/engines/engine.hpp"));
    EXPECT_TRUE(is_allowed("fuzz/engines/engines.cpp", "bench/engines/engine.hpp"));
}

TEST(IncludeRules, EveryFileIsInARoom) {
    EXPECT_FALSE(check_place("src/world/world.cpp"));
    EXPECT_FALSE(check_place("include/ecods/primitives.hpp"));
    EXPECT_TRUE(check_place("include/ecods/unheard_of.hpp"));
    EXPECT_TRUE(check_place("include/other/primitives.hpp"));
    EXPECT_TRUE(check_place("src/util/util.cpp"));
    EXPECT_TRUE(check_place("src/main.cpp"));
    EXPECT_TRUE(check_place("src/exact/signs/filter.hpp")) << "no room is called exact";
}

TEST(IncludeRules, CyclesAreFound) {
    EXPECT_TRUE(find_cycle({{"a", {"b", "c"}}, {"b", {"c"}}, {"c", {}}}).empty());
    EXPECT_EQ(find_cycle({{"a", {"b"}}, {"b", {"c"}}, {"c", {"b"}}}).size(), 2u);
    EXPECT_EQ(find_cycle({{"a", {"a"}}}).size(), 1u);
}

TEST(TextRules, WordsAreFoundInNamesAndCommentsButNotInOtherWords) {
    for (const char* text :
         {"x.epsilon()", "// a fudge", "const int magic_number = 3;", "SLOP", "kMagic = 1; // Magic"}) {
        EXPECT_EQ(find_tolerances(text).size(), 1u) << text;
    }
    for (const char* text : {"slope", "a sloppy bound", "magical", "// the unit roundoff u"}) {
        EXPECT_TRUE(find_tolerances(text).empty()) << text;
    }
    EXPECT_EQ(find_tolerances("a\nb\nslop\n").at(0).line, 3);
}

TEST(TextRules, BareDecimalTolerancesAreFoundInCode) {
    for (const char* text : {"x < 1e-9", "1.5E-7", "return .5e-3;", "f(2.e-4)", "x=1e-3f"}) {
        EXPECT_EQ(find_tolerances(text).size(), 1u) << text;
    }
    for (const char* text :
         {"0x1p-52", "0x1.8e-3", "1e300", "name1e - 9", "// about 1e-3 of them", "x - 1", "0x1e-9"}) {
        EXPECT_TRUE(find_tolerances(text).empty()) << text;
    }
}

TEST(TextRules, CommentsAreBlankedAndNothingElse) {
    EXPECT_EQ(without_comments("a // b\nc /* d\ne */ f"), "a     \nc     \n     f");
    EXPECT_EQ(without_comments("\"//\" '\"' // x"), "\"//\" '\"'     ");
    EXPECT_EQ(without_comments("1'000 // x"), "1'000     ");
    EXPECT_EQ(without_comments("R\"re(//)re\" // x"), "R\"re(//)re\"     ");
    EXPECT_EQ(without_comments("\"\\\"//\" /"), "\"\\\"//\" /");
}

TEST(TextRules, CommentsAreTakenOut) {
    EXPECT_EQ(comments_of("a // b\nc /* d\ne */ f"), "  // b\n  /* d\ne */  ");
}

TEST(TextRules, PuzzlingWordsAreFoundWithTheirPlainNames) {
    for (const char* text : {"double horizon_ = 24;", "struct Habits {", "// a lively scene", "bool is_worn;",
                             "// room to move", "// is built anew", "int centre;", "// a if b; else c", "// 3 u in sum",
                             "turn_room(box)", "// which tells them apart"}) {
        EXPECT_EQ(find_puzzling_words(text).size(), 1U) << text;
    }
    for (const char* text : {"make_room(list);", "if (a) b; else c;", "// nothing else", "// the rest", "center",
                             "// from scratch", "dismissed", "intelligible", "mushroom"}) {
        EXPECT_TRUE(find_puzzling_words(text).empty()) << text;
    }
    EXPECT_TRUE(find_puzzling_prose("the rooms of the house").empty());
    EXPECT_EQ(find_puzzling_words("a\nhabits\n").at(0).line, 2);
    EXPECT_EQ(find_puzzling_words("habits").at(0).what.substr(0, 11), "motion hint");
}

TEST(TextRules, VagueOpeningsAreFound) {
    for (const char* text : {"// Of two boxes.", "int a;\n    // What is left.", "// As above.", "// The same of rays.",
                             "// Whether it is.\n// Sure.", "// A value that is not below x."}) {
        EXPECT_EQ(find_vague_openings(text).size(), 1U) << text;
    }
    for (const char* text : {"// Offers a box.", "// A box.\n// Of two.", "int a;  // Of two boxes.",
                             "const char* a = \"// Of two\";", "// Whatever it is.", "not_below(x);"}) {
        EXPECT_TRUE(find_vague_openings(text).empty()) << text;
    }
    EXPECT_EQ(find_vague_openings("a\n// Of b\n").at(0).line, 2);
}

TEST(TextRules, LongFunctionsAreFoundAndLongTablesAreNot) {
    const auto lines = [](std::size_t count, const std::string& line) {
        std::string text;
        for (std::size_t i = 0; i < count; ++i) text += line;
        return text;
    };
    const std::string longest = "void f() {\n" + lines(function_lines_max - 2, "    g();\n") + "}\n";
    EXPECT_TRUE(find_long_functions(longest).empty());
    const std::string longer = "void f() {\n" + lines(function_lines_max - 1, "    g();\n") + "}\n";
    ASSERT_EQ(find_long_functions("\n" + longer).size(), 1U);
    EXPECT_EQ(find_long_functions("\n" + longer)[0].line, 2);
    EXPECT_TRUE(find_long_functions("namespace a {\n" + longest + longest + "}\n").empty());
    EXPECT_EQ(find_long_functions("namespace a {\n" + longer + longer + "}\n").size(), 2U);
    EXPECT_EQ(find_long_functions("void f() {\n    if (a) {\n" + lines(80, "        g();\n") + "    }\n}\n").size(),
              1U);
    EXPECT_TRUE(
        find_long_functions("int f() {\n    const T t = {\n" + lines(80, "        1,\n") + "    };\n}\n").empty());
    EXPECT_EQ(find_long_functions("class A {\n    void f() {\n" + lines(80, "        g();\n") + "    }\n};\n").size(),
              1U);
}

TEST(TextRules, LongFunctionsAreFoundUnderWrappedSignatures) {
    std::string body;
    for (std::size_t i = 0; i < function_lines_max - 2; ++i) body += "    g();\n";
    const std::string before = "#include <a>\n\nint a;\n// why\n";
    for (const char* head :
         {"void f(int a,\n       int b) {\n", "template <class A,\n          class B>\nvoid f(\n    A a, B b) {\n",
          "A::A(int a)\n    : a_(a), b_(a) {\n", "[[gnu::noinline]]\nvoid f() {\n",
          "const auto f = [&](int a,\n                   int b) {\n"}) {
        const auto found = find_long_functions(before + head + body + "}\n");
        ASSERT_EQ(found.size(), 1U) << head;
        EXPECT_EQ(found[0].line, std::string(head).starts_with("template") ? 7 : 5) << head;
    }
    // A function that is as long as it may be passes.
    EXPECT_TRUE(find_long_functions("template <class A>\nvoid f(A a) {\n" + body + "}\n").empty());
    // No function: a class, and calls with a short one among their arguments.
    EXPECT_TRUE(find_long_functions("class A\n    : public B {\n" + body + body + "};\n").empty());
    EXPECT_TRUE(
        find_long_functions("f(\n    \"a\", [](A a) {\n        b();\n    },\n" + body + body + "    c);\n").empty());
}

TEST(TextRules, CallsInCommentsAreFoundWithTheNamesOfCode) {
    const std::string text = "// as g(x) and y.h() do, fl(x) + 1 (not k), f( )\nint a = m(2); /* n() */ \"// o()\";\n";
    std::vector<std::string> names;
    for (const Finding& finding : find_called_in_comments(text)) names.push_back(finding.what);
    EXPECT_EQ(names, (std::vector<std::string>{"g", "h", "f", "n"}));
    EXPECT_EQ(find_called_in_comments(text).back().line, 2);
    EXPECT_EQ(find_names(text), (std::set<std::string>{"int", "a", "m", "o"}));
}

TEST(TextRules, VectorTypesAreFoundUnderAnySpelling) {
    for (const char* text :
         {"__m512d x;", "const __m256 a;", "__m128i b", "__mmask8 c", "_mm256_add_ps(a, b)", "_mm_setcsr(0)",
          "__attribute__((vector_size(16)))", "using A = __m512;", "__builtin_ia32_movmskps(a)"}) {
        EXPECT_EQ(find_vector_types(text).size(), 1U) << text;
    }
    for (const char* text : {"// __m512d", "Vec<float, 8> x;", "wide::Doubles x;", "a_mm_b", "common_mm"}) {
        EXPECT_TRUE(find_vector_types(text).empty()) << text;
    }
}

TEST(TextRules, LinesAreCounted) {
    EXPECT_EQ(count_lines(""), 0u);
    EXPECT_EQ(count_lines("a"), 1u);
    EXPECT_EQ(count_lines("a\nb\n"), 2u);
}

}  // namespace
}  // namespace ecods::tidy
