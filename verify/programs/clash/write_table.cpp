// The report as a table for people: short numbers, columns that line up. Programs read the other formats.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

#include "programs/clash/write.hpp"

namespace ecods::clash {
namespace {

constexpr std::size_t column_count = 5;
using Row = std::array<std::string, column_count>;

// How many code points: bytes of UTF-8 that do not continue one.
std::size_t width_of(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80; }));
}

std::string short_number(double value) {
    return fmt::format("{:.6g}", value);
}

std::string length_of(const Clash& clash) {
    if (clash.distance) return "gap " + short_number(*clash.distance);
    if (!clash.depth) return "";
    const std::string lower = short_number(clash.depth->lower);
    const std::string upper = short_number(clash.depth->upper);
    return lower == upper ? "depth " + lower : "depth " + lower + " to " + upper;
}

// The middle of the place's box.
std::string middle_of(const Clash& clash) {
    const Vec3 middle = clash.place.box.min / 2 + clash.place.box.max / 2;
    return fmt::format("({}, {}, {})", short_number(middle[0]), short_number(middle[1]), short_number(middle[2]));
}

// What is a word for the reader: which of two is inside.
std::string word_of(const Clash& clash) {
    return std::string(clash.kind == Kind::inside ? clash.relation : name_of(clash.kind));
}

void write_rows(std::ostream& out, const std::vector<Row>& rows) {
    std::array<std::size_t, column_count> widths{};
    for (const Row& row : rows) {
        for (std::size_t i = 0; i < column_count; ++i) widths[i] = std::max(widths[i], width_of(row[i]));
    }
    for (const Row& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < column_count; ++i) {
            line += row[i];
            line.append(widths[i] - width_of(row[i]) + 2, ' ');
        }
        out << line.substr(0, line.find_last_not_of(' ') + 1) << '\n';
    }
}

std::ptrdiff_t count_no_solids(const ClashReport& report) {
    return std::ranges::count_if(report.parts, [](const Part& part) { return !part.is_solid; });
}

}  // namespace

void write_table(std::ostream& out, const ClashReport& report) {
    std::vector<Row> rows;
    if (!report.clashes.empty()) rows.push_back({"KIND", "A", "B", "HOW FAR", "WHERE"});
    for (const Clash& clash : report.clashes) {
        rows.push_back({word_of(clash), report.parts[clash.a].name, report.parts[clash.b].name, length_of(clash),
                        middle_of(clash)});
    }
    write_rows(out, rows);
    for (const Part& part : report.parts) {
        if (!part.is_solid) out << "not a solid: " << part.name << ": " << part.not_solid_because << '\n';
    }
    out << fmt::format("{} {}", report.parts.size(), report.parts.size() == 1 ? "part" : "parts");
    for (const Kind kind : all_kinds) {
        const std::size_t count = report.counts[static_cast<std::size_t>(kind)];
        if (count > 0) out << fmt::format(", {} {}", count, name_of(kind));
    }
    if (report.clashes.empty()) out << ", no clash";
    if (const auto count = count_no_solids(report); count > 0)
        out << fmt::format("; {}", count == 1 ? "1 is no solid" : fmt::format("{} are no solids", count));
    if (report.parts.size() == 1) out << " (nothing to clash with: in an OBJ file, o and g lines begin parts)";
    out << '\n';
}

}  // namespace ecods::clash
