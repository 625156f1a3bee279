#include "report/csv.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <iterator>

namespace ecods::bench {
namespace {

Page page() {
    Page page;
    page.environment.rows = {{"command", "ecods_bench --csv x"},
                             {"date", "2026-02-03 04:05 UTC"},
                             {"processor", "Some(R) CPU @ 2.0GHz, 2 threads"}};
    Table table;
    table.title = "Boxes, \"dense\"";
    table.text_columns = 2;
    table.header = {"boxes", "engine", "ns", "errors"};
    table.rows = {{"dense 1k", "A", "1.5", "0"}, {"dense 1k", "B", "", "3"}};
    Table words;
    words.text_columns = 2;
    words.header = {"engine", "use"};
    words.rows = {{"A", "so"}, {"B", "not"}};
    words.title = "Use";
    page.summary = {"All is well.", "How to, read."};
    page.sections.push_back({"Boxes only", {"Dense."}, {table, words}, {}});
    return page;
}

TEST(Csv, ListsEveryCellWithItsLabels) {
    const std::string folder = "ecods_csv_test_" + std::to_string(getpid());
    const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / folder / "out.csv";
    write_csv(page(), file);
    std::ifstream in(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    EXPECT_EQ(text,
              "# command: ecods_bench --csv x; date: 2026-02-03 04:05 UTC; processor: Some(R) CPU @ 2.0GHz, 2 "
              "threads;\n"
              "section,table,row,column,value\n"
              ",,1,text,All is well.\n"
              ",,2,text,\"How to, read.\"\n"
              "Boxes only,,1,text,Dense.\n"
              "Boxes only,\"Boxes, \"\"dense\"\"\",dense 1k | A,ns,1.5\n"
              "Boxes only,\"Boxes, \"\"dense\"\"\",dense 1k | A,errors,0\n"
              "Boxes only,\"Boxes, \"\"dense\"\"\",dense 1k | B,errors,3\n"
              "Boxes only,Use,A,use,so\n"
              "Boxes only,Use,B,use,not\n");
    std::filesystem::remove_all(file.parent_path());
}

TEST(Csv, FilesAreNamedAfterMachineAndDay) {
    EXPECT_EQ(results_name(page()), "Some-R-CPU-2-0GHz-2026-02-03.csv");
}

TEST(Csv, AFileThatCannotBeWrittenIsAnError) {
    EXPECT_THROW(write_csv(page(), "/proc/none.csv"), std::exception);
}

}  // namespace
}  // namespace ecods::bench
