// The report as a page that opens from disk: style, script, data and pictures are in it. Its script makes the rows.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <ostream>

#include "programs/clash/page/page_files.hpp"
#include "programs/clash/text.hpp"
#include "programs/clash/write.hpp"

namespace ecods::clash {
namespace {

using Buffer = fmt::memory_buffer;

// So many lines of a clash are in the page; all that the report has are in the JSON.
constexpr std::size_t line_limit = 24;

template <class... Values>
void add(Buffer& out, fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(out), format, std::forward<Values>(values)...);
}

std::string number(double value) {
    return std::isfinite(value) ? fmt::format("{}", value) : "null";
}

void add_point(Buffer& out, const Vec3& point, bool is_first) {
    for (int axis = 0; axis < 3; ++axis) add(out, "{}{}", is_first && axis == 0 ? "" : ",", number(point[axis]));
}

// [[cell, cell], [cell, cell]], each row by `add_row`.
template <class List, class AddRow>
void add_rows(Buffer& out, const char* name, const List& list, const AddRow& add_row) {
    add(out, ",\n\"{}\":[", name);
    bool is_first = true;
    for (const auto& each : list) {
        add(out, "{}", is_first ? "" : ",\n");
        add_row(each);
        is_first = false;
    }
    add(out, "]");
}

// [kind, relation, a, b, distance, depth, box, points, number of lines, lines]: page.js reads them by position.
void add_clash(Buffer& out, const Clash& clash) {
    add(out, "[{},\"{}\",{},{},{},", static_cast<int>(clash.kind), clash.relation, clash.a, clash.b,
        clash.distance ? number(*clash.distance) : "null");
    if (clash.depth) {
        add(out, "[{},{}],[", number(clash.depth->lower), number(clash.depth->upper));
    } else {
        add(out, "null,[");
    }
    const Place& place = clash.place;
    add_point(out, place.box.min, true);
    add_point(out, place.box.max, false);
    add(out, "],[");
    for (std::size_t i = 0; i < place.points.size(); ++i) add_point(out, place.points[i], i == 0);
    add(out, "],{},[", place.line_count);
    for (std::size_t i = 0; i < std::min(place.lines.size(), line_limit); ++i) {
        add_point(out, place.lines[i][0], i == 0);
        add_point(out, place.lines[i][1], false);
    }
    add(out, "]]");
}

void add_data(Buffer& out, const ClashReport& report) {
    add(out, "{{\"size\":[{},{}],\"counts\":[", picture_width, picture_height);
    for (std::size_t i = 0; i < kind_count; ++i) add(out, "{}{}", i == 0 ? "" : ",", report.counts[i]);
    add(out, "]");
    add_rows(out, "options", report.options, [&](const auto& option) {
        add(out, "[{},{}]", json_text_in_html(option.first), json_text_in_html(option.second));
    });
    add_rows(out, "failed", report.failed, [&](const FailedFile& file) {
        add(out, "[{},{}]", json_text_in_html(file.file), json_text_in_html(file.error));
    });
    add_rows(out, "notes", report.notes, [&](const std::string& note) { add(out, "{}", json_text_in_html(note)); });
    add_rows(out, "parts", report.parts, [&](const Part& part) {
        add(out, "[{},{},\"{}\",{},{}]", json_text_in_html(part.name), json_text_in_html(part.file), part.group,
            part.shape->mesh().triangles().size(), json_text_in_html(part.not_solid_because));
    });
    add_rows(out, "clashes", report.clashes, [&](const Clash& clash) { add_clash(out, clash); });
    add(out, "}}");
}

}  // namespace

void write_html(std::ostream& out, const ClashReport& report, std::span<const Picture> pictures) {
    out << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        << "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>Clash report</title>\n"
        << "<link rel=\"icon\" href=\"data:,\">\n<style>\n"
        << page_css << "</style>\n</head>\n"
        << page_html << "<script type=\"application/json\" id=\"data\">\n";
    Buffer text;
    add_data(text, report);
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
    out << "\n</script>\n";
    for (std::size_t i = 0; i < pictures.size(); ++i)
        out << fmt::format("<script type=\"text/plain\" id=\"p{}\">", i) << base64(pictures[i].png) << "</script>\n";
    out << "<script>\n" << page_js << "</script>\n</body>\n</html>\n";
}

}  // namespace ecods::clash
