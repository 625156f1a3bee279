#include "report/page.hpp"

#include <fmt/core.h>

#include <fstream>
#include <stdexcept>

#include "report/chart_html.hpp"
#include "report/draw_chart.hpp"
#include "report/engine_style.hpp"
#include "report/headline.hpp"
#include "report/page_style.hpp"

namespace ecods::bench {

namespace {

// The colours, by what the reader's system prefers; paper is always light.
std::string colour_style() {
    return fmt::format(
        ":root {{ {} --soft:#aaa; --soft-ink:#555; }}\n"
        "@media screen and (prefers-color-scheme: dark) {{ :root {{ {} --soft:#555; --soft-ink:#aaa; }} }}\n",
        colour_variables(false), colour_variables(true));
}

// RFC 4648, section 4.
std::string base64(const std::string& bytes) {
    constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : digits[group >> (18 - 6 * k) & 63];
    }
    return text;
}

// What made the figures of this page: for whoever takes one of them out of it.
std::string origin(const Page& page) {
    std::string text;
    for (const std::vector<std::string>& row : page.environment.rows) {
        if (row.front() == "command" || row.front() == "commit" || row.front() == "date")
            text += (text.empty() ? "" : "; ") + row.front() + ": " + row.at(1);
    }
    return text;
}

std::string to_html(const Picture& picture, const std::string& origin) {
    std::string html = "<figure class=\"picture\">";
    if (!picture.failure.empty()) {
        html += "<p>No picture: " + escape_html(picture.failure) + "</p>";
    } else {
        const char* type = picture.file.extension() == ".svg" ? "svg+xml" : "png";
        html += fmt::format("<img alt=\"{}\" src=\"data:image/{};base64,{}\">", escape_html(picture.caption), type,
                            base64(read_all(picture.file)));
    }
    return html + "<figcaption>" + escape_html(picture.caption) + " <span class=\"origin\">" + escape_html(origin) +
           "</span></figcaption></figure>\n";
}

void write_contents(std::ostream& out, const std::vector<Section>& sections) {
    out << "<nav aria-label=\"Contents\"><ol>\n";
    for (std::size_t i = 0; i < sections.size(); ++i)
        out << fmt::format("<li><a href=\"#section-{}\">{}</a></li>\n", i + 1, escape_html(sections[i].title));
    out << "<li><a href=\"#environment\">Where and how this was measured</a></li></ol></nav>\n";
}

// Sections with their charts. The marks of charts are in `marks`.
std::string to_html(const Section& section, std::size_t number, const Page& page, const std::filesystem::path& parts,
                    std::string& marks) {
    std::string html = fmt::format("<h2 id=\"section-{}\">{}</h2>\n", number, escape_html(section.title));
    for (const std::string& text : section.paragraphs) html += "<p>" + escape_html(text) + "</p>\n";
    for (const Chart& chart : section.charts) html += to_html(chart, parts, origin(page), marks);
    for (const Table& table : section.tables) html += to_html(table);
    for (const Picture& picture : section.pictures) html += to_html(picture, origin(page));
    return html;
}

}  // namespace

void write_page(const Page& page, const std::filesystem::path& file) {
    const std::filesystem::path parts = file.parent_path() / "parts";
    std::filesystem::create_directories(parts);
    std::vector<Section> sections = headline(page);
    // The first of the paragraphs is the verdict, which stands on top.
    if (page.summary.size() > 1)
        sections.push_back({"How to read this page", {page.summary.begin() + 1, page.summary.end()}, {}, {}});
    sections.insert(sections.end(), page.sections.begin(), page.sections.end());
    std::string body, marks;
    for (std::size_t i = 0; i < sections.size(); ++i) body += to_html(sections[i], i + 1, page, parts, marks);
    std::ofstream out(file);
    out << "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
        << "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        << "<title>" << escape_html(page.title) << "</title>\n<style>" << colour_style() << page_style
        << "</style></head><body>\n"
        << "<svg width=\"0\" height=\"0\" style=\"position:absolute\" aria-hidden=\"true\">" << marks << "</svg>\n"
        << "<h1>" << escape_html(page.title) << "</h1>\n";
    if (!page.summary.empty()) out << "<p class=\"verdict\">" << escape_html(page.summary.front()) << "</p>\n";
    write_contents(out, sections);
    out << body << "<h2 id=\"environment\">Where and how this was measured</h2>\n"
        << to_html(page.environment)
        // What is folded on the screen is on paper, too.
        << "<script>addEventListener('beforeprint',()=>document.querySelectorAll('details')"
           ".forEach(d=>{d.open=true}))</script>\n</body></html>\n";
    out.close();
    if (!out) throw std::runtime_error("cannot write " + file.string());
}

}  // namespace ecods::bench
