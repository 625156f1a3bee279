// Cells of CSV files, for spreadsheets and for programs.
#pragma once

#include <string>
#include <string_view>

namespace ecods::process {

// Writes a cell as RFC 4180 has it, in quotes where it has a comma, a quote or the end of a line. For numbers and words
// of the program's own.
std::string csv_field(std::string_view text);

// Writes text from elsewhere, such as a name in a file, so that no spreadsheet takes it, or a piece of it, for a
// formula. An apostrophe goes before =, +, -, @ and their full-width and small forms where a spreadsheet might begin a
// cell with them: at the start, and behind a comma, a semicolon, a tab, a bar or the end of a line, since some
// spreadsheets cut lines at these whatever the quotes; also with blanks, control characters and quotes between, since
// some trim. Such a cell is in quotes, as OWASP's "CSV Injection" advises. All other text is as csv_field() has it.
std::string csv_name(std::string_view text);

}  // namespace ecods::process
