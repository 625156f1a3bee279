#include "report/json.hpp"

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace ecods::bench {

namespace {

using Json = nlohmann::ordered_json;

template <class Thing, class Convert>
Json list(const std::vector<Thing>& things, const Convert& convert) {
    Json array = Json::array();
    for (const Thing& thing : things) array.push_back(convert(thing));
    return array;
}

template <class Convert>
auto unlist(const Json& array, const Convert& convert) {
    std::vector<decltype(convert(array))> things;
    for (const Json& one : array) things.push_back(convert(one));
    return things;
}

Json from_table(const Table& table) {
    return {{"title", table.title},
            {"header", table.header},
            {"text_columns", table.text_columns},
            {"rows", table.rows},
            {"notes", table.notes}};
}
Table to_table(const Json& json) {
    Table table;
    table.title = json.at("title");
    table.header = json.at("header").get<std::vector<std::string>>();
    table.text_columns = json.at("text_columns");
    table.rows = json.at("rows").get<std::vector<std::vector<std::string>>>();
    table.notes = json.at("notes").get<std::vector<std::string>>();
    for (const std::vector<std::string>& row : table.rows)
        if (row.size() != table.header.size())
            throw std::runtime_error("a row of \"" + table.title + "\" has other columns");
    return table;
}

Json from_axis(const Axis& axis) {
    return {{"title", axis.title},
            {"logarithmic", axis.is_logarithmic},
            {"tics", axis.tics},
            {"range", {axis.low, axis.high}}};
}
Axis to_axis(const Json& json) {
    return {json.at("title"), json.at("logarithmic"),
            json.at("tics").get<std::vector<std::pair<std::string, double>>>(), json.at("range").at(0),
            json.at("range").at(1)};
}

Json from_curve(const Curve& curve) {
    return {{"name", curve.name}, {"points", list(curve.points, [](const ChartPoint& point) {
                                       return Json::array({point.x, point.y, point.text});
                                   })}};
}
Curve to_curve(const Json& json) {
    return {json.at("name"), unlist(json.at("points"), [](const Json& point) {
                return ChartPoint{point.at(0), point.at(1), point.at(2)};
            })};
}

Json from_panel(const Panel& panel) {
    return {{"title", panel.title},
            {"x", from_axis(panel.x)},
            {"y", from_axis(panel.y)},
            {"lines", panel.has_lines},
            {"names", panel.has_names},
            {"folded", panel.is_folded},
            {"curves", list(panel.curves, from_curve)}};
}
Panel to_panel(const Json& json) {
    return {json.at("title"),
            to_axis(json.at("x")),
            to_axis(json.at("y")),
            unlist(json.at("curves"), to_curve),
            json.at("lines").get<bool>(),
            json.at("names"),
            json.at("folded")};
}

Json from_chart(const Chart& chart) {
    return {{"name", chart.name},
            {"caption", chart.caption},
            {"fold", chart.fold},
            {"panels", list(chart.panels, from_panel)}};
}
Chart to_chart(const Json& json) {
    Chart chart{json.at("name"), unlist(json.at("panels"), to_panel), json.at("caption"), json.at("fold")};
    if (chart.name.find('/') != std::string::npos) throw std::runtime_error("a chart's name is a path: " + chart.name);
    return chart;
}

Json from_picture(const Picture& picture) {
    return {{"file", picture.file.string()}, {"caption", picture.caption}, {"failure", picture.failure}};
}
Picture to_picture(const Json& json) {
    Picture picture{json.at("file").get<std::string>(), json.at("caption"), json.at("failure")};
    if (picture.failure.empty() && !exists(picture.file)) picture.failure = picture.file.string() + " is not there";
    return picture;
}

Json from_section(const Section& section) {
    return {{"title", section.title},
            {"paragraphs", section.paragraphs},
            {"tables", list(section.tables, from_table)},
            {"charts", list(section.charts, from_chart)},
            {"pictures", list(section.pictures, from_picture)}};
}
Section to_section(const Json& json) {
    return {json.at("title"), json.at("paragraphs").get<std::vector<std::string>>(),
            unlist(json.at("tables"), to_table), unlist(json.at("pictures"), to_picture),
            unlist(json.at("charts"), to_chart)};
}

}  // namespace

void write_json(const Page& page, const std::filesystem::path& file) {
    Json document;
    document["title"] = page.title;
    document["summary"] = page.summary;
    for (const std::vector<std::string>& row : page.environment.rows) document["environment"][row.at(0)] = row.at(1);
    document["sections"] = list(page.sections, from_section);
    std::ofstream out(file);
    out << document.dump(1) << "\n";
    out.close();
    if (!out) throw std::runtime_error("cannot write " + file.string());
}

Page read_json(const std::filesystem::path& file) {
    std::ifstream in(file);
    if (!in) throw std::runtime_error("cannot read " + file.string());
    try {
        const Json document = Json::parse(in);
        Page page;
        page.title = document.at("title");
        page.summary = document.at("summary").get<std::vector<std::string>>();
        page.environment.header = {"what", "value"};
        page.environment.text_columns = 2;
        for (const auto& [what, value] : document.at("environment").items())
            page.environment.rows.push_back({what, value.get<std::string>()});
        page.sections = unlist(document.at("sections"), to_section);
        return page;
    } catch (const std::exception& error) {
        throw std::runtime_error(file.string() + ": no page of ecods_bench: " + error.what());
    }
}

}  // namespace ecods::bench
