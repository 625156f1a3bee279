// A table that is printed on the terminal and on the page alike.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace ecods::bench {

struct Table {
    std::string title = {};
    std::vector<std::string> header = {};
    std::vector<std::vector<std::string>> rows = {};  // as wide as the header
    std::size_t text_columns = 1;                     // so many are aligned left; the rest are numbers, aligned right
    std::vector<std::string> notes = {};              // one line each, below
    std::set<std::pair<std::size_t, std::size_t>> loud = {};  // row and column of cells to be seen first, on the page
    bool is_summary = false;                                  // the main job prints it, and no other of its suite
};

std::string to_text(const Table& table);
std::string to_html(const Table& table);

// For text in HTML.
std::string escape_html(const std::string& text);

}  // namespace ecods::bench
