#include "report/table.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>

namespace ecods::bench {

std::string to_text(const Table& table) {
    for (const std::vector<std::string>& row : table.rows)
        if (row.size() != table.header.size())
            throw std::logic_error(fmt::format("table \"{}\": a row of {} cells under a header of {}", table.title,
                                               row.size(), table.header.size()));
    std::vector<std::size_t> widths;
    for (std::size_t c = 0; c < table.header.size(); ++c) {
        widths.push_back(table.header[c].size());
        for (const std::vector<std::string>& row : table.rows) widths[c] = std::max(widths[c], row[c].size());
    }
    const auto line = [&](const std::vector<std::string>& cells) {
        std::string text;
        for (std::size_t c = 0; c < cells.size(); ++c) {
            text += c == 0 ? "  " : "   ";
            text += c < table.text_columns ? fmt::format("{:<{}}", cells[c], widths[c])
                                           : fmt::format("{:>{}}", cells[c], widths[c]);
        }
        while (!text.empty() && text.back() == ' ') text.pop_back();
        return text + "\n";
    };
    std::string text = table.title + "\n" + line(table.header);
    for (const std::vector<std::string>& row : table.rows) text += line(row);
    for (const std::string& note : table.notes) text += "  " + note + "\n";
    return text;
}

std::string escape_html(const std::string& text) {
    std::string escaped;
    for (const char c : text) {
        switch (c) {
            case '&':
                escaped += "&amp;";
                break;
            case '<':
                escaped += "&lt;";
                break;
            case '>':
                escaped += "&gt;";
                break;
            case '"':
                escaped += "&quot;";
                break;
            default:
                escaped += c;
        }
    }
    return escaped;
}

// Of a row that is none of the table's own: the header.
static constexpr auto no_row = static_cast<std::size_t>(-1);

std::string to_html(const Table& table) {
    const auto row_of = [&](const std::vector<std::string>& cells, const char* tag, bool begins_group,
                            std::size_t row = no_row) {
        std::string html = begins_group ? "<tr class=\"group\">" : "<tr>";
        for (std::size_t c = 0; c < cells.size(); ++c)
            html += fmt::format("<{0}{1}>{2}</{0}>", tag,
                                c < table.text_columns          ? " class=\"text\""
                                : table.loud.contains({row, c}) ? " class=\"loud\""
                                                                : "",
                                escape_html(cells[c]));
        return html + "</tr>\n";
    };
    // A table of words alone has lines that may be broken, and each of its rows stands for itself.
    const bool is_words = table.text_columns >= table.header.size();
    std::string html = fmt::format("<div class=\"table{}\"><table>\n", is_words ? " words" : "");
    if (!table.title.empty()) html += "<caption>" + escape_html(table.title) + "</caption>\n";
    html += "<thead>" + row_of(table.header, "th", false) + "</thead>\n<tbody>\n";
    const std::vector<std::string>* previous = nullptr;
    for (const std::vector<std::string>& row : table.rows) {
        // Several rows for one thing, engines for a workload say, belong together.
        const bool begins_group =
            table.text_columns > 1 && !is_words && previous != nullptr && previous->front() != row.front();
        html += row_of(row, "td", begins_group, static_cast<std::size_t>(&row - table.rows.data()));
        previous = &row;
    }
    html += "</tbody></table></div>\n";
    // Lines of one sentence, which the terminal needs, are one paragraph here.
    bool is_open = false;
    for (const std::string& note : table.notes) {
        html += (is_open ? " " : "<p class=\"note\">") + escape_html(note);
        is_open = !note.ends_with('.') && !note.ends_with(':');
        if (!is_open) html += "</p>\n";
    }
    return is_open ? html + "</p>\n" : html;
}

}  // namespace ecods::bench
