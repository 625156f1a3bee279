// A page from what was saved of it: all of it from JSON (json.hpp), the tables from CSV (csv.hpp).
#pragma once

#include <filesystem>

#include "report/page.hpp"

namespace ecods::bench {

// By the name's ending. Of CSV: names of text columns other than "engine" are not in the file, nor is what stands
// around the tables. Throws std::runtime_error, with the line or the key, when the file is not one of ours.
Page read_page(const std::filesystem::path& file);

}  // namespace ecods::bench
