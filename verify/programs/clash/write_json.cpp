// The report as JSON. Numbers are the shortest decimals that name the doubles, in any locale; infinity is null. It is
// written clash by clash: a document of all of them in memory would cost more than judging them.
#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <ostream>

#include "programs/clash/text.hpp"
#include "programs/clash/write.hpp"

namespace ecods::clash {
namespace {

using Buffer = fmt::memory_buffer;

template <class... Values>
void add(Buffer& out, fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(out), format, std::forward<Values>(values)...);
}

void add_number(Buffer& out, double value) {
    if (std::isfinite(value)) {
        add(out, "{}", value);
    } else {
        add(out, "null");
    }
}

void add_point(Buffer& out, const Vec3& point) {
    for (int axis = 0; axis < 3; ++axis) {
        add(out, "{}", axis == 0 ? "[" : ", ");
        add_number(out, point[axis]);
    }
    add(out, "]");
}

// [item, item], each by `add_item`.
template <class List, class AddItem>
void add_list(Buffer& out, const List& list, const char* separator, const AddItem& add_item) {
    bool is_first = true;
    add(out, "[");
    for (const auto& item : list) {
        if (!is_first) add(out, "{}", separator);
        is_first = false;
        add_item(item);
    }
    add(out, "]");
}

void add_head(Buffer& out, const ClashReport& report) {
    add(out, "{{\n  \"format\": \"ecods_clash 1\",\n  \"options\": ");
    add_list(out, report.options, ", ", [&](const auto& option) {
        add(out, "{{\"name\": {}, \"value\": {}}}", json_text(option.first), json_text(option.second));
    });
    add(out, ",\n  \"counts\": {{");
    for (const Kind kind : all_kinds) {
        add(out, "{}\"{}\": {}", kind == all_kinds[0] ? "" : ", ", name_of(kind),
            report.counts[static_cast<std::size_t>(kind)]);
    }
    add(out, "}},\n  \"notes\": ");
    add_list(out, report.notes, ",\n    ", [&](const std::string& note) { add(out, "{}", json_text(note)); });
    add(out, ",\n  \"failed_files\": ");
    add_list(out, report.failed, ",\n    ", [&](const FailedFile& file) {
        add(out, "{{\"file\": {}, \"error\": {}}}", json_text(file.file), json_text(file.error));
    });
}

void add_part(Buffer& out, const Part& part) {
    add(out, "{{\"name\": {}, \"file\": {}, \"group\": \"{}\", \"triangles\": {}, \"is_solid\": {}",
        json_text(part.name), json_text(part.file), part.group, part.shape->mesh().triangles().size(), part.is_solid);
    if (!part.is_solid) add(out, ", \"not_solid_because\": {}", json_text(part.not_solid_because));
    add(out, "}}");
}

void add_clash(Buffer& out, const ClashReport& report, const Clash& clash) {
    const auto number_or_null = [&](bool has_value, double value) {
        if (has_value) return add_number(out, value);
        add(out, "null");
    };
    add(out, "{{\"kind\": \"{}\", \"relation\": \"{}\", \"a\": {}, \"b\": {}, \"distance\": ", name_of(clash.kind),
        clash.relation, json_text(report.parts[clash.a].name), json_text(report.parts[clash.b].name));
    number_or_null(clash.distance.has_value(), clash.distance.value_or(0));
    add(out, ", \"depth\": ");
    if (clash.depth) {
        add(out, "{{\"lower\": ");
        add_number(out, clash.depth->lower);
        add(out, ", \"upper\": ");
        add_number(out, clash.depth->upper);
        add(out, "}}");
    } else {
        add(out, "null");
    }
    const Place& place = clash.place;
    add(out, ", \"box\": [");
    add_point(out, place.box.min);
    add(out, ", ");
    add_point(out, place.box.max);
    add(out, "], \"points\": ");
    add_list(out, place.points, ", ", [&](const Vec3& point) { add_point(out, point); });
    add(out, ", \"line_count\": {}, \"lines\": ", place.line_count);
    add_list(out, place.lines, ", ",
             [&](const Line& line) { add_list(out, line, ", ", [&](const Vec3& end) { add_point(out, end); }); });
    add(out, "}}");
}

}  // namespace

void write_json(std::ostream& out, const ClashReport& report) {
    Buffer text;
    add_head(text, report);
    add(text, ",\n  \"parts\": ");
    add_list(text, report.parts, ",\n    ", [&](const Part& part) { add_part(text, part); });
    add(text, ",\n  \"clashes\": ");
    add_list(text, report.clashes, ",\n    ", [&](const Clash& clash) {
        add_clash(text, report, clash);
        constexpr std::size_t block_size = std::size_t{1} << 20;
        if (text.size() < block_size) return;
        out.write(text.data(), static_cast<std::streamsize>(text.size()));
        text.clear();
    });
    add(text, "\n}}\n");
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
}

}  // namespace ecods::clash
