#include "report/csv.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <stdexcept>

#include "process/csv_field.hpp"

namespace ecods::bench {

namespace {

std::string fact(const Page& page, const std::string& what) {
    for (const std::vector<std::string>& row : page.environment.rows)
        if (row.at(0) == what) return row.at(1);
    return "unknown";
}

void write_table(std::ostream& out, const Section& section, const Table& table) {
    // A table whose first columns are texts, and one that names its rows by numbers (of ships, say), alike.
    const std::size_t label_count = std::max<std::size_t>(1, table.text_columns);
    for (const std::vector<std::string>& row : table.rows) {
        std::string label = row.at(0);
        for (std::size_t c = 1; c < std::min(label_count, row.size()); ++c) label += " | " + row[c];
        for (std::size_t c = label_count; c < row.size(); ++c) {
            if (row[c].empty()) continue;
            out << process::csv_name(section.title) << ',' << process::csv_name(table.title) << ','
                << process::csv_name(label) << ',' << process::csv_name(table.header.at(c)) << ','
                << process::csv_field(row[c]) << "\n";
        }
    }
}

}  // namespace

void write_csv(const Page& page, const std::filesystem::path& file) {
    if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path());
    std::ofstream out(file, std::ios::binary);
    out << '#';
    for (const std::vector<std::string>& row : page.environment.rows) {
        std::string value = row.at(1);
        std::replace_if(
            value.begin(), value.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
        out << ' ' << row.at(0) << ": " << value << ';';
    }
    out << "\nsection,table,row,column,value\n";
    for (const Section& section : page.sections)
        for (const Table& table : section.tables)
            if (table.text_columns < table.header.size()) write_table(out, section, table);
    out.close();
    if (!out) throw std::runtime_error("cannot write " + file.string());
}

std::string results_name(const Page& page) {
    const std::string processor = fact(page, "processor");
    std::string name;
    for (const char c : processor.substr(0, processor.find(','))) {
        const bool is_plain = std::isalnum(static_cast<unsigned char>(c)) != 0;
        if (is_plain)
            name += c;
        else if (!name.empty() && name.back() != '-')
            name += '-';
    }
    while (!name.empty() && name.back() == '-') name.pop_back();
    return name + "-" + fact(page, "date").substr(0, 10) + ".csv";
}

}  // namespace ecods::bench
