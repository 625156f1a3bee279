// The page's tables for programs.
#pragma once

#include <filesystem>

#include "report/page.hpp"

namespace ecods::bench {

// {"summary": [...], "environment": {what: value}, "sections": [{"title", "tables": [{"title", "header", "rows",
// "notes"}]}]}. Cells are the strings that the page shows. Throws std::runtime_error when the file cannot be written.
void write_json(const Page& page, const std::filesystem::path& file);

}  // namespace ecods::bench
