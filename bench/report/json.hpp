// The page for programs, and for being drawn again.
#pragma once

#include <filesystem>

#include "report/page.hpp"

namespace ecods::bench {

// {"title", "summary": [...], "environment": {what: value}, "sections": [{"title", "paragraphs", "tables": [{"title",
// "header", "text_columns", "rows", "notes"}], "charts": [{"name", "caption", "fold", "panels": [{"title", "x", "y",
// "lines", "folded", "curves": [{"name", "points": [[x, y, text]]}]}]}], "pictures": [{"file", "caption",
// "failure"}]}]}. Cells are the strings that the page shows; pictures stay where they are. Throws std::runtime_error
// when the file cannot be written.
void write_json(const Page& page, const std::filesystem::path& file);

// What write_json() wrote. Throws std::runtime_error when the file cannot be read or is none of these.
Page read_json(const std::filesystem::path& file);

}  // namespace ecods::bench
