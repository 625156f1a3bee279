// The page's tables as one list of values, for keeping and for comparing machines.
#pragma once

#include <filesystem>

#include "report/page.hpp"

namespace ecods::bench {

// RFC 4180 with plain line ends, and with a line before it that begins with # and holds command, date, commit, machine,
// compiler and versions. The columns: section, table, row (its text cells, joined by " | "; of a table of texts alone
// the first), column, value. Values are the cells that the page shows; empty cells are left out. A paragraph is a row
// of no table, numbered, with the column `text`; the page's summary has no section, either. Makes the folder. Throws
// std::runtime_error when the file cannot be written.
void write_csv(const Page& page, const std::filesystem::path& file);
inline constexpr const char* text_column = "text";

// NAME-DATE.csv, NAME the processor's model in letters, digits and hyphens, DATE that of the page.
std::string results_name(const Page& page);

}  // namespace ecods::bench
