#include "report/csv.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <initializer_list>
#include <stdexcept>

#include "process/csv_field.hpp"

namespace ecods::bench {

namespace {

std::string fact(const Page& page, const std::string& what) {
    for (const std::vector<std::string>& row : page.environment.rows)
        if (row.at(0) == what) return row.at(1);
    return "unknown";
}

// Names may be those of other engines and files; the value is a cell as the file has it.
void write_line(std::ostream& out, std::initializer_list<std::string> names, const std::string& value) {
    for (const std::string& name : names) out << process::csv_name(name) << ',';
    out << value << "\n";
}

// Paragraphs are rows of no table; those of the page's own summary are of no section, either.
void write_paragraphs(std::ostream& out, const std::string& section, const std::vector<std::string>& paragraphs) {
    for (std::size_t i = 0; i < paragraphs.size(); ++i)
        write_line(out, {section, "", std::to_string(i + 1), text_column}, process::csv_field(paragraphs[i]));
}

void write_table(std::ostream& out, const Section& section, const Table& table) {
    // A table whose first columns are texts, and one that names its rows by numbers (of ships, say), alike. Where all
    // are texts, the first alone is a name.
    const bool is_words = table.text_columns >= table.header.size();
    const std::size_t label_count = is_words ? 1 : std::max<std::size_t>(1, table.text_columns);
    for (const std::vector<std::string>& row : table.rows) {
        std::string label = row.at(0);
        for (std::size_t c = 1; c < std::min(label_count, row.size()); ++c) label += " | " + row[c];
        for (std::size_t c = label_count; c < row.size(); ++c) {
            if (row[c].empty()) continue;
            write_line(out, {section.title, table.title, label, table.header.at(c)},
                       is_words ? process::csv_name(row[c]) : process::csv_field(row[c]));
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
    write_paragraphs(out, "", page.summary);
    for (const Section& section : page.sections) {
        write_paragraphs(out, section.title, section.paragraphs);
        for (const Table& table : section.tables) write_table(out, section, table);
    }
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
