#include "report/headline.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "report/csv.hpp"
#include "report/json.hpp"
#include "report/read_page.hpp"

namespace ecods::bench {
namespace {

// Of two engines, one is a quarter as fast on bricks, twice as fast on ships, and wrong.
Page page() {
    Page page;
    page.title = "A page";
    page.summary = {"All is well."};
    page.environment.header = {"what", "value"};
    page.environment.text_columns = 2;
    page.environment.rows = {{"command", "ecods_bench"}, {"date", "2026-02-03 04:05 UTC"}};
    Table meshes;
    meshes.title = two_meshes_title;
    meshes.text_columns = 2;
    meshes.header = {"workload", "engine", "us/query", "hits", "false -", "false +"};
    meshes.rows = {{"ship, near", "ECoDS", "2.0", "5 / 10", "0", "0"},
                   {"ship, near", "FCL OBB", "1.0", "5 / 10", "0", "4"},
                   {"stacked bricks", "ECoDS", "3.0", "50 / 100", "0", "0"},
                   {"stacked bricks", "FCL OBB", "12.0", "50 / 100", "7", "1"},
                   {"stacked bricks", "ODE", "crashed", "", "", ""}};
    Table gaps;
    gaps.title = gaps_title;
    gaps.header = {"gap in radii", "queries", "judged", "ECoDS", "FCL OBB"};
    gaps.rows = {{"1e-3", "100", "100", "0 / 0", "9 / 9"}, {adjacent_doubles, "100", "100", "0 / 0", "10 / 14"}};
    page.sections.push_back({"Two meshes", {"Text."}, {meshes, gaps}, {}});
    Panel panel;
    panel.title = "a \"panel\"";
    panel.curves = {{"ECoDS", {{1, 2.5, "one & two"}}}};
    panel.has_lines = true;
    page.sections.back().charts.push_back({"chart", {panel}, "so", "f"});
    return page;
}

const ChartPoint& point_of(const Chart& chart, const std::string& name) {
    for (const Curve& curve : chart.panels.front().curves)
        if (curve.name == name) return curve.points.front();
    throw std::runtime_error("no curve " + name);
}

void expect_headline(const Page& page) {
    const auto chart = summary_chart(page);
    ASSERT_TRUE(chart.has_value());
    // sqrt(2 * 1) and sqrt(1 * 4) times the fastest; 0 of 200, and 8 of 100 with 24 of 100.
    EXPECT_NEAR(point_of(*chart, "ECoDS").x, std::sqrt(2.0), 0x1p-40);
    EXPECT_NEAR(point_of(*chart, "FCL OBB").x, 2, 0x1p-40);
    EXPECT_EQ(point_of(*chart, "ECoDS").y, 0);
    EXPECT_NEAR(point_of(*chart, "FCL OBB").y, std::log10(0.16) + 4, 0x1p-40);
    EXPECT_NE(point_of(*chart, "FCL OBB").text.find("16 % wrong"), std::string::npos);

    const std::vector<Section> sections = headline(page);
    ASSERT_EQ(sections.size(), 3U);
    const Table& ratios = sections[1].tables.at(0);
    EXPECT_EQ(ratios.header, (std::vector<std::string>{"workload", "ECoDS, us/query", "FCL OBB"}));
    EXPECT_EQ(ratios.rows, (std::vector<std::vector<std::string>>{{"ship, near", "2", "0.5 ×, 4 wrong"},
                                                                  {"stacked bricks", "3", "4 ×, 8 wrong"}}));
    EXPECT_EQ(ratios.loud, (std::set<std::pair<std::size_t, std::size_t>>{{0, 2}}));
    EXPECT_EQ(sections[2].paragraphs.at(0), "On 1 of the 2 timed workloads of this page another engine is faster.");
    EXPECT_EQ(sections[2].tables.at(0).rows.at(0),
              (std::vector<std::string>{two_meshes_title, "ship, near", "FCL OBB", "1 us/query", "2", "2.00 ×", "4"}));
}

class Saved : public testing::Test {
  protected:
    void SetUp() override { std::filesystem::create_directories(folder_); }
    void TearDown() override { std::filesystem::remove_all(folder_); }
    std::filesystem::path file(const std::string& name) const { return folder_ / name; }

  private:
    std::filesystem::path folder_ =
        std::filesystem::path(testing::TempDir()) / ("ecods_headline_test_" + std::to_string(getpid()));
};

TEST(Headline, SaysWhatTheTablesSay) {
    expect_headline(page());
}

TEST(Headline, AMeanIsOfTheWorkloadsThatAnEngineFinishes) {
    Page changed = page();
    std::vector<Table>& tables = changed.sections.at(0).tables;
    tables[0].rows.insert(tables[0].rows.begin() + 2, {"ship, near", "ODE", "3.0", "5 / 10", "0", "0"});
    tables[1].header.push_back("ODE");
    for (std::vector<std::string>& row : tables[1].rows) row.push_back("1 / 1");
    const auto chart = summary_chart(changed);
    ASSERT_TRUE(chart.has_value());
    EXPECT_NEAR(point_of(*chart, "ODE").x, 3, 0x1p-40) << "it crashed on the other workload";
}

TEST(Headline, OfAPageWithoutTimesIsEmpty) {
    EXPECT_TRUE(headline(Page{}).empty());
    EXPECT_FALSE(summary_chart(Page{}).has_value());
}

TEST_F(Saved, JsonIsTheWholePage) {
    write_json(page(), file("page.json"));
    const Page again = read_page(file("page.json"));
    expect_headline(again);
    EXPECT_EQ(again.summary, page().summary);
    EXPECT_EQ(again.environment.rows, page().environment.rows);
    ASSERT_EQ(again.sections.at(0).charts.size(), 1U);
    const Panel& panel = again.sections[0].charts[0].panels.at(0);
    EXPECT_EQ(panel.title, "a \"panel\"");
    EXPECT_TRUE(panel.has_lines);
    EXPECT_EQ(panel.curves.at(0).points.at(0).text, "one & two");
    EXPECT_EQ(panel.curves[0].points[0].y, 2.5);
}

// But for charts, pictures and notes.
TEST_F(Saved, CsvIsItsTextsAndTables) {
    Page saved = page();
    saved.summary.push_back("How to read it.");
    Table words;
    words.title = "Hard cases";
    words.text_columns = 3;
    words.header = {"case", "touch", "ECoDS"};
    words.rows = {{"cube", "yes", "right"}, {"cube", "no", "right"}, {"right, of 2", "", "2"}};
    saved.sections.push_back({"Hard cases", {"Reported.", "And found."}, {words}, {}});
    write_csv(saved, file("page.csv"));
    const Page again = read_page(file("page.csv"));
    expect_headline(again);
    EXPECT_EQ(again.environment.rows, saved.environment.rows);
    EXPECT_EQ(again.summary, saved.summary);
    ASSERT_EQ(again.sections.size(), 2U);
    EXPECT_EQ(again.sections[0].paragraphs, saved.sections[0].paragraphs);
    EXPECT_EQ(again.sections[1].paragraphs, saved.sections[1].paragraphs);
    ASSERT_EQ(again.sections[1].tables.size(), 1U);
    EXPECT_EQ(again.sections[1].tables[0].rows, words.rows);
    EXPECT_EQ(again.sections[1].tables[0].text_columns, 3U) << "a table of words";
}

TEST_F(Saved, WhatIsNoPageIsAnError) {
    for (const char* text : {"", "{", "[]", "{\"title\": 3}", "#\nsection,table,row,column,value\na,b\n"}) {
        for (const char* name : {"bad.json", "bad.csv"}) {
            std::ofstream(file(name)) << text;
            EXPECT_THROW(read_page(file(name)), std::runtime_error) << name << ": " << text;
        }
    }
    EXPECT_THROW(read_page(file("none.json")), std::runtime_error);
}

}  // namespace
}  // namespace ecods::bench
