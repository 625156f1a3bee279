#include "report/page.hpp"

#include <fmt/core.h>

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace ecods::bench {

namespace {

// Wide things scroll in their own box, so that the page itself never does; on paper nothing is cut off.
constexpr const char* style = R"(
:root { color-scheme: light; }
body { font: 16px/1.5 Georgia, "Times New Roman", serif; color: #1b1b1b; background: #fff; margin: 0 auto;
       max-width: 68rem; padding: 1.2rem; }
h1 { font-size: 1.7rem; line-height: 1.2; margin: .5rem 0 1rem; }
h2 { font-size: 1.25rem; margin: 2.6rem 0 .6rem; border-top: 1px solid #999; padding-top: 1rem; }
p { margin: .5rem 0; max-width: 46rem; }
.table { overflow-x: auto; margin: 1rem 0 .3rem; }
table { border-collapse: collapse; font: 14px/1.4 "DejaVu Sans", Verdana, sans-serif;
        font-variant-numeric: tabular-nums; }
caption { text-align: left; font-weight: bold; padding-bottom: .35rem; }
th, td { padding: .22rem .75rem; text-align: right; border-bottom: 1px solid #ddd; vertical-align: top; }
td { white-space: nowrap; }
thead th { border-bottom: 1.5px solid #333; vertical-align: bottom; }
th:first-child, td:first-child { padding-left: 0; }
.text { text-align: left; }
.group td { border-top: 2px solid #aaa; }
.words td + td { white-space: normal; }
.note { font-size: .85rem; color: #444; margin: .15rem 0; }
figure { margin: 1.2rem 0; }
figure img, figure svg { width: 100%; height: auto; display: block; }
figure img { border: 1px solid #bbb; box-sizing: border-box; }
figcaption { font-size: .9rem; color: #333; margin-top: .4rem; }
.origin { display: block; font: 11px/1.4 "DejaVu Sans", Verdana, sans-serif; color: #666; overflow-wrap: anywhere; }
@media screen and (max-width: 44rem) {
  body { font-size: 15px; padding: .7rem; } table { font-size: 12px; } th, td { padding: .2rem .45rem; }
  .chart { overflow-x: auto; } .chart img { min-width: 46rem; }  /* else the letters in it are too small to be read */
}
@media print { body { max-width: none; padding: 0; font-size: 10.5pt; } table { font-size: 8.5pt; }
               .table { overflow: visible; } figure, tr { break-inside: avoid; } h2 { break-after: avoid; }
               td { white-space: normal; } }
)";

std::string read_all(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) throw std::runtime_error("cannot read " + file.string());
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
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
    std::string html = "<figure>";
    if (!picture.failure.empty()) {
        html += "<p>No picture: " + escape_html(picture.failure) + "</p>";
    } else {
        // SVG goes in as an image, too: identifiers of several plots in one page would clash.
        const bool is_chart = picture.file.extension() == ".svg";
        html += fmt::format("<div class=\"{}\"><img alt=\"{}\" src=\"data:image/{};base64,{}\"></div>",
                            is_chart ? "chart" : "picture", escape_html(picture.caption), is_chart ? "svg+xml" : "png",
                            base64(read_all(picture.file)));
    }
    return html + "<figcaption>" + escape_html(picture.caption) + " <span class=\"origin\">" + escape_html(origin) +
           "</span></figcaption></figure>\n";
}

}  // namespace

void write_page(const Page& page, const std::filesystem::path& file) {
    std::ofstream out(file);
    out << "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
        << "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        << "<title>" << escape_html(page.title) << "</title>\n<style>" << style << "</style></head><body>\n"
        << "<h1>" << escape_html(page.title) << "</h1>\n";
    for (const std::string& text : page.summary) out << "<p>" << escape_html(text) << "</p>\n";
    for (const Section& section : page.sections) {
        out << "<h2>" << escape_html(section.title) << "</h2>\n";
        for (const std::string& text : section.paragraphs) out << "<p>" << escape_html(text) << "</p>\n";
        for (const Table& table : section.tables) out << to_html(table);
        for (const Picture& picture : section.pictures) out << to_html(picture, origin(page));
    }
    out << "<h2>Where and how this was measured</h2>\n" << to_html(page.environment) << "</body></html>\n";
    out.close();
    if (!out) throw std::runtime_error("cannot write " + file.string());
}

}  // namespace ecods::bench
