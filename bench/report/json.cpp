#include "report/json.hpp"

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace ecods::bench {

void write_json(const Page& page, const std::filesystem::path& file) {
    nlohmann::ordered_json document;
    document["title"] = page.title;
    document["summary"] = page.summary;
    for (const std::vector<std::string>& row : page.environment.rows) document["environment"][row.at(0)] = row.at(1);
    document["sections"] = nlohmann::ordered_json::array();
    for (const Section& section : page.sections) {
        nlohmann::ordered_json tables = nlohmann::ordered_json::array();
        for (const Table& table : section.tables)
            tables.push_back(
                {{"title", table.title}, {"header", table.header}, {"rows", table.rows}, {"notes", table.notes}});
        document["sections"].push_back({{"title", section.title}, {"tables", tables}});
    }
    std::ofstream out(file);
    out << document.dump(1) << "\n";
    out.close();
    if (!out) throw std::runtime_error("cannot write " + file.string());
}

}  // namespace ecods::bench
