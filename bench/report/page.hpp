// The report as one HTML page that opens from the disk: no other file and no network is needed.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/chart.hpp"
#include "report/table.hpp"

namespace ecods::bench {

// A picture in a file, PNG or SVG; the page contains it. When the file could not be made, `failure` says why.
struct Picture {
    std::filesystem::path file;
    std::string caption;
    std::string failure;
};

struct Section {
    std::string title;
    std::vector<std::string> paragraphs;
    std::vector<Table> tables;
    std::vector<Picture> pictures;
    std::vector<Chart> charts = {};
};

struct Page {
    std::string title;
    std::vector<std::string> summary;  // paragraphs
    Table environment;                 // machine, compiler, versions, commit, command
    std::vector<Section> sections;
};

// The page begins with the headline (headline.hpp) and a contents list. Charts are drawn into the folder `parts` beside
// the file. Throws std::runtime_error when a file cannot be read or written.
void write_page(const Page& page, const std::filesystem::path& file);

}  // namespace ecods::bench
