#include "report/read_page.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <stdexcept>

#include "report/csv.hpp"
#include "report/json.hpp"
#include "report/timings.hpp"

namespace ecods::bench {

namespace {

// The cells of one line of RFC 4180; cells with line ends do not occur.
std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells(1);
    bool is_quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"' && is_quoted && i + 1 < line.size() && line[i + 1] == '"') {
            cells.back() += line[++i];
        } else if (line[i] == '"') {
            is_quoted = !is_quoted;
        } else if (line[i] == ',' && !is_quoted) {
            cells.emplace_back();
        } else {
            cells.back() += line[i];
        }
    }
    return cells;
}

// What results of before the words changed call them.
std::string todays(std::string name) {
    static const std::map<std::string, std::string> names = {
        {"missed", "false -"},
        {"invented", "false +"},
        {"Ships at controlled gaps: answers missed / invented",
         "Ships at controlled gaps: false negatives / false positives"}};
    const auto found = names.find(name);
    return found == names.end() ? name : found->second;
}

// "command: ...; date: ...;" behind the #.
Table environment_of(const std::string& line) {
    Table table;
    table.header = {"what", "value"};
    table.text_columns = 2;
    std::size_t at = 1;
    while (at < line.size()) {
        const std::size_t colon = line.find(": ", at), end = std::min(line.find("; ", at), line.size());
        if (colon == std::string::npos || colon > end) break;
        std::string value = line.substr(colon + 2, end - colon - 2);
        if (value.ends_with(';')) value.pop_back();
        table.rows.push_back({line.substr(at + 1, colon - at - 1), value});
        at = end + 1;
    }
    return table;
}

std::vector<std::string> labels_of(const std::string& row) {
    std::vector<std::string> labels;
    std::size_t at = 0;
    for (std::size_t bar = row.find(" | "); bar != std::string::npos; at = bar + 3, bar = row.find(" | ", at))
        labels.push_back(row.substr(at, bar - at));
    labels.push_back(row.substr(at));
    return labels;
}

// Cells of a table as they come; columns in the order of their first appearance.
class TableReader {
  public:
    void add(const std::string& row, const std::string& column, const std::string& value) {
        const bool is_next = rows_.empty() || rows_.back().first != row || rows_.back().second.contains(column);
        if (is_next) rows_.emplace_back(row, std::map<std::string, std::string>());
        if (std::ranges::find(columns_, column) == columns_.end()) columns_.push_back(column);
        rows_.back().second[column] = value;
    }

    Table table(const std::string& title) const {
        Table table;
        table.title = title;
        table.text_columns = labels_of(rows_.front().first).size();
        table.header.resize(table.text_columns);
        if (table.text_columns > 1) table.header[1] = "engine";
        table.header.insert(table.header.end(), columns_.begin(), columns_.end());
        for (const auto& [label, cells] : rows_) {
            std::vector<std::string> row = labels_of(label);
            row.resize(table.text_columns);
            for (const std::string& column : columns_) row.push_back(cells.contains(column) ? cells.at(column) : "");
            table.rows.push_back(std::move(row));
        }
        const std::vector<std::string>& first = table.rows.front();
        if (std::none_of(first.begin() + 1, first.end(), [](const std::string& cell) { return number_in(cell); }))
            table.text_columns = table.header.size();
        return table;
    }

  private:
    std::vector<std::string> columns_;
    std::vector<std::pair<std::string, std::map<std::string, std::string>>> rows_;
};

Page read_csv(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::string line;
    if (!std::getline(in, line)) throw std::runtime_error("cannot read " + file.string());
    Page page;
    page.title = "ECoDS beside its peers";
    page.environment = environment_of(line);
    std::string section, title;
    TableReader reader;
    const auto find_section = [&]() -> Section& {
        if (page.sections.empty() || page.sections.back().title != section)
            page.sections.push_back({section, {}, {}, {}});
        return page.sections.back();
    };
    const auto close_table = [&] {
        if (!title.empty()) find_section().tables.push_back(reader.table(title));
        title.clear();
    };
    for (std::size_t number = 2; std::getline(in, line); ++number) {
        const std::vector<std::string> cells = cells_of(line);
        if (line.empty() || cells.front() == "section") continue;
        if (cells.size() != 5 || !page.environment.rows.size())
            throw std::runtime_error(fmt::format("{}:{}: this is no line of results", file.string(), number));
        if (cells[0] != section || todays(cells[1]) != title) {
            close_table();
            section = cells[0];
            title = todays(cells[1]);
            reader = {};
        }
        if (title.empty() && cells[3] == text_column) {
            (section.empty() ? page.summary : find_section().paragraphs).push_back(cells[4]);
            continue;
        }
        reader.add(cells[2], todays(cells[3]), cells[4]);
    }
    close_table();
    if (page.sections.empty()) throw std::runtime_error(file.string() + ": there are no results");
    return page;
}

}  // namespace

Page read_page(const std::filesystem::path& file) {
    return file.extension() == ".csv" ? read_csv(file) : read_json(file);
}

}  // namespace ecods::bench
