#include "examples/plane_figures/picture.hpp"

#include <fmt/core.h>

#include <ostream>

namespace ecods::examples {

namespace {

constexpr double unit = 50;  // pixels
constexpr double width = 560, height = 400, title_height = 44, line_height = 19, lines_height = 130;

}  // namespace

void Picture::begin_field(const std::string& title, const Vec2& middle) {
    fields_.push_back({title, middle, {}, {}});
}

void Picture::add_line(const std::string& text) {
    fields_.back().lines.push_back(text);
}

std::string Picture::to_text(const Vec2& point) const {
    const Vec2 at = unit * (point - fields_.back().middle);
    return fmt::format("{:.2f},{:.2f}", width / 2 + at.x(), title_height + height / 2 - at.y());
}

std::string Picture::path_of(const PlacedFigure& placed, const Vec2& moved_by) const {
    std::string path;
    for (std::size_t i = 0; i < placed.figure.outline_count(); ++i) {
        char command = 'M';
        for (const Vec2& corner : placed.figure.outline_at(i)) {
            path += fmt::format("{}{}", command, to_text(placed.to_plane(corner) + moved_by));
            command = 'L';
        }
        path += 'Z';
    }
    return path;
}

void Picture::add_figure(const PlacedFigure& figure, const char* color) {
    add(fmt::format(
        R"(<path d="{}" fill="{}" fill-opacity="0.35" fill-rule="evenodd" stroke="{}" stroke-width="1.5"/>)",
        path_of(figure, {0, 0}), color, color));
}

void Picture::add_ghost(const PlacedFigure& figure, const Vec2& moved_by, const char* color) {
    add(fmt::format(R"(<path d="{}" fill="none" stroke="{}" stroke-dasharray="5 4"/>)", path_of(figure, moved_by),
                    color));
}

void Picture::add_region(std::span<const Vec2> corners) {
    std::string points;
    for (const Vec2& corner : corners) points += to_text(corner) + " ";
    add(fmt::format(R"(<polygon points="{}" fill="#c62828" fill-opacity="0.55" stroke="#c62828" stroke-width="0.5"/>)",
                    points));
}

void Picture::add_arrow(const Vec2& from, const Vec2& to) {
    const std::string at = to_text(from), head = to_text(to);
    add(fmt::format(R"-(<path d="M{}L{}" stroke="#111111" stroke-width="2" marker-end="url(#tip)"/>)-", at, head));
}

void Picture::add_segment(const Vec2& from, const Vec2& to) {
    add(fmt::format(R"(<path d="M{}L{}" stroke="#111111" stroke-width="1.5"/>)", to_text(from), to_text(to)));
    add_point(from);
    add_point(to);
}

void Picture::add_point(const Vec2& at) {
    const std::string point = to_text(at);
    const std::size_t comma = point.find(',');
    add(fmt::format(R"(<circle cx="{}" cy="{}" r="3.5" fill="#111111"/>)", point.substr(0, comma),
                    point.substr(comma + 1)));
}

void Picture::write(std::ostream& out) const {
    const double field_height = title_height + height + lines_height;
    const std::size_t row_count = (fields_.size() + 1) / 2;
    out << fmt::format(R"(<svg xmlns="http://www.w3.org/2000/svg" width="{0}" height="{1}" viewBox="0 0 {0} {1}" )",
                       2 * width, field_height * static_cast<double>(row_count))
        << R"(font-family="sans-serif" font-size="14">)"
        << "\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
        << R"(<defs><marker id="tip" viewBox="0 0 10 10" refX="8" refY="5" markerWidth="6" markerHeight="6" )"
        << R"(orient="auto"><path d="M0,0L10,5L0,10Z" fill="#111111"/></marker></defs>)"
        << "\n";
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        const Field& field = fields_[i];
        out << fmt::format("<g transform=\"translate({},{})\">\n", width * static_cast<double>(i % 2),
                           field_height * static_cast<double>(i / 2))
            << fmt::format("<rect x=\"5\" y=\"5\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#bbbbbb\"/>\n",
                           width - 10, field_height - 10)
            << fmt::format("<text x=\"18\" y=\"30\" font-size=\"17\" font-weight=\"bold\">{}</text>\n", field.title)
            << field.shapes;
        double y = title_height + height + line_height;
        for (const std::string& line : field.lines) {
            out << fmt::format("<text x=\"18\" y=\"{}\">{}</text>\n", y, line);
            y += line_height;
        }
        out << "</g>\n";
    }
    out << "</svg>\n";
}

}  // namespace ecods::examples
