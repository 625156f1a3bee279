#include "process/csv_field.hpp"

#include <gtest/gtest.h>

#include <string>

namespace ecods::process {
namespace {

TEST(CsvField, QuotesWhatNeedsQuotes) {
    EXPECT_EQ(csv_field(""), "");
    EXPECT_EQ(csv_field("-1.5"), "-1.5");
    EXPECT_EQ(csv_field("a b;c"), "a b;c");
    EXPECT_EQ(csv_field("a,b"), "\"a,b\"");
    EXPECT_EQ(csv_field("a \"b\""), "\"a \"\"b\"\"\"");
    EXPECT_EQ(csv_field("a\nb"), "\"a\nb\"");
    EXPECT_EQ(csv_field("a\rb"), "\"a\rb\"");
}

TEST(CsvName, IsNoFormula) {
    EXPECT_EQ(csv_name("=1+1"), "\"'=1+1\"");
    EXPECT_EQ(csv_name("+1+1"), "\"'+1+1\"");
    EXPECT_EQ(csv_name("-1.5"), "\"'-1.5\"") << "a name, not a number";
    EXPECT_EQ(csv_name("@SUM(1)"), "\"'@SUM(1)\"");
    EXPECT_EQ(csv_name("=HYPERLINK(\"x\",\"y\")"), "\"'=HYPERLINK(\"\"x\"\",\"\"y\"\")\"");
    EXPECT_EQ(csv_name("\uFF1D1"), "\"'\uFF1D1\"");
    EXPECT_EQ(csv_name("\uFE631"), "\"'\uFE631\"");
}

// Blanks and quotes that a spreadsheet may trim do not hide one.
TEST(CsvName, IsNoFormulaBehindBlanks) {
    EXPECT_EQ(csv_name(" =1"), "\" '=1\"");
    EXPECT_EQ(csv_name("\t=1"), "\"\t'=1\"");
    EXPECT_EQ(csv_name("\r=1"), "\"\r'=1\"");
    EXPECT_EQ(csv_name("\u00A0\uFEFF \u3000-1"), "\"\u00A0\uFEFF \u3000'-1\"");
    EXPECT_EQ(csv_name("\"=1\""), "\"\"\"'=1\"\"\"");
    EXPECT_EQ(csv_name(std::string("\0\x7F=1", 4)), std::string("\"\0\x7F'=1\"", 7));
}

// Neither is a piece, where a spreadsheet cuts lines at something else and knows no quotes within a cell.
TEST(CsvName, HasNoFormulaBehindASeparator) {
    EXPECT_EQ(csv_name("a,=1"), "\"a,'=1\"");
    EXPECT_EQ(csv_name("a; =1;-2"), "\"a; '=1;'-2\"");
    EXPECT_EQ(csv_name("a\t@1"), "\"a\t'@1\"");
    EXPECT_EQ(csv_name("a|+1"), "\"a|'+1\"");
    EXPECT_EQ(csv_name("a\n=1"), "\"a\n'=1\"");
}

TEST(CsvName, LeavesOtherTextAsItIs) {
    for (const char* name : {"", " ", "wall-1", "a = b", "1=1", "'=1", "IfcWall_\xC3\xA9", "a - b; c", "\xff\xfe"})
        EXPECT_EQ(csv_name(name), name);
    EXPECT_EQ(csv_name("a,b"), "\"a,b\"");
}

}  // namespace
}  // namespace ecods::process
