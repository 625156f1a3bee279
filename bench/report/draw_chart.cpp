#include "report/draw_chart.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <regex>
#include <stdexcept>

#include "process/program.hpp"
#include "report/engine_style.hpp"
#include "report/place_names.hpp"
#include "report/table.hpp"

namespace ecods::bench {

namespace {

struct Size {
    int width;
    int height;
};

// So that letters stay readable on 400 pixels, where each panel is as wide as the page.
Size size_of(const Chart& chart) {
    const std::size_t count = chart.panels.size();
    return count == 1 ? Size{560, 330} : count == 2 ? Size{460, 320} : Size{350, 260};
}

// For a string of gnuplot in single quotes, in which % begins a format.
std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text) result += c == '\'' || c == '%' ? std::string(2, c) : std::string(1, c);
    return result + "'";
}

void write_axis(std::ostream& out, char name, const Axis& axis) {
    out << fmt::format("set {}label {}\n{} logscale {}\n", name, quoted(axis.title),
                       axis.is_logarithmic ? "set" : "unset", name)
        << fmt::format("set {}range [{}]\n", name,
                       axis.low == axis.high ? "*:*" : fmt::format("{}:{}", axis.low, axis.high))
        << fmt::format("set format {} '%g'\nset {}tics autofreq\n", name, name);
    if (axis.tics.empty()) return;
    out << fmt::format("set {}tics (", name);
    for (std::size_t i = 0; i < axis.tics.size(); ++i)
        out << fmt::format("{}{} {}", i == 0 ? "" : ", ", quoted(axis.tics[i].first), axis.tics[i].second);
    out << ")\n";
}

bool is_drawn(const Panel& panel, const ChartPoint& point) {
    return (!panel.x.is_logarithmic || point.x > 0) && (!panel.y.is_logarithmic || point.y > 0);
}

// Points with texts are labels whose text is their number, which stands for the text until the SVG is there: so
// no text has to be quoted for gnuplot.
void write_panel(std::ostream& out, const Panel& panel, const Size& size, std::span<const std::string> names,
                 std::span<const EngineStyle> styles, std::vector<std::string>& texts) {
    write_axis(out, 'x', panel.x);
    write_axis(out, 'y', panel.y);
    out << fmt::format("set title {}\n", quoted(panel.title));
    const std::vector<NamePlace> places =
        panel.has_names ? place_names(panel, size.width, size.height) : std::vector<NamePlace>{};
    std::string plots, data;
    for (std::size_t c = 0; c < panel.curves.size(); ++c) {
        const Curve& curve = panel.curves[c];
        const auto e = static_cast<std::size_t>(std::ranges::find(names, curve.name) - names.begin());
        const EngineStyle& style = styles[e];
        std::string line, marks;
        for (const ChartPoint& point : curve.points) {
            if (!is_drawn(panel, point)) continue;
            line += fmt::format("{} {}\n", point.x, point.y);
            if (point.text.empty()) continue;
            marks += fmt::format("{} {} \"text{}\"\n", point.x, point.y, texts.size());
            texts.push_back(point.text);
        }
        if (panel.has_lines && !line.empty()) {
            plots += fmt::format("{}'-' with lines lw 1.8 dt {} lc rgb '{}'", plots.empty() ? "" : ", ", style.dash,
                                 style.colour->light);
            data += line + "e\n";
        }
        if (!marks.empty()) {
            plots += fmt::format("{}'-' using 1:2:3 with labels hypertext point pt {} ps {:.2f} lw 1.6 lc rgb '{}'",
                                 plots.empty() ? "" : ", ", style.mark,
                                 (panel.has_lines ? 0.6 : 1.1) + 0.3 * std::min(style.variant, 3), style.colour->light);
            data += marks + "e\n";
        }
        if (panel.has_names && !curve.points.empty()) {
            plots += fmt::format(", '-' using 1:2:3 with labels {} offset {},{} tc rgb '{}'", places[c].alignment,
                                 places[c].across, places[c].up, style.colour->light);
            data += fmt::format("{} {} \"{}\"\ne\n", curve.points.front().x, curve.points.front().y, curve.name);
        }
    }
    out << "plot " << (plots.empty() ? "NaN" : plots) << "\n" << data;
}

std::string replace_all(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    return text;
}

// What gnuplot calls by numbers gets the page's names.
std::string with_variables(std::string svg) {
    for (const Colour& colour : colours()) {
        int rgb[3];
        for (std::size_t k = 0; k < 3; ++k) rgb[k] = std::stoi(std::string(colour.light + 1 + 2 * k, 2), nullptr, 16);
        const std::string variable = fmt::format("var(--{})", colour.name);
        svg = replace_all(std::move(svg), fmt::format("rgb({:3}, {:3}, {:3})", rgb[0], rgb[1], rgb[2]), variable);
        svg = replace_all(std::move(svg), fmt::format("rgb({},{},{})", rgb[0], rgb[1], rgb[2]), variable);
    }
    for (const char* black : {"stroke='black'", "stroke=\"black\"", "stroke='rgb(  0,   0,   0)'"})
        svg = replace_all(std::move(svg), black, "stroke=\"var(--ink)\"");
    svg = replace_all(std::move(svg), "color=\"black\"", "color=\"var(--ink)\"");
    return replace_all(std::move(svg), "fill=\"black\"", "fill=\"var(--ink)\"");
}

// One panel's file, without what browsers do not need. Its <defs> go to `marks`.
std::string shortened(std::string svg, std::span<const std::string> texts, const Panel& panel, std::string& marks) {
    const std::size_t defs = svg.find("<defs>"), defs_end = svg.find("</defs>");
    if (defs == std::string::npos || defs_end == std::string::npos) return "";
    marks = svg.substr(defs, defs_end + 7 - defs);
    svg.erase(defs, defs_end + 7 - defs);
    svg.erase(0, svg.find("<svg"));
    static const std::regex title("<title>gnuplot</title>\\s*<desc>[^<]*</desc>");
    static const std::regex empty("<g [^>]*>\\s*</g>\n?");
    static const std::regex hover(
        R"re(<g onmousemove="gnuplot_svg\.showHypertext\(evt,'text(\d+)'\)" onmouseout="[^"]*"><title> </title>)re");
    svg = std::regex_replace(svg, title, "<title>" + escape_html(panel.title) + "</title>");
    svg = std::regex_replace(svg, empty, "");
    std::string result;
    auto last = svg.cbegin();
    for (std::sregex_iterator match(svg.begin(), svg.end(), hover), end; match != end; ++match) {
        result.append(last, match->prefix().second);
        result += "<g class=\"mark\"><title>" + escape_html(texts[std::stoul((*match)[1])]) + "</title>";
        last = match->suffix().first;
    }
    result.append(last, svg.cend());
    return with_variables(std::move(result));
}

}  // namespace

std::string read_all(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) throw std::runtime_error("cannot read " + file.string());
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::vector<std::string> names_of(const Chart& chart) {
    std::vector<std::string> names;
    for (const Panel& panel : chart.panels)
        for (const Curve& curve : panel.curves)
            if (std::ranges::find(names, curve.name) == names.end()) names.push_back(curve.name);
    return names;
}

Drawing draw_chart(const Chart& chart, const std::filesystem::path& folder) {
    const std::vector<std::string> names = names_of(chart);
    const std::vector<EngineStyle> styles = engine_styles(names);
    const std::filesystem::path script = folder / (chart.name + ".gnuplot");
    const auto picture = [&](std::size_t p) { return folder / fmt::format("{}-{}.svg", chart.name, p + 1); };
    const Size size = size_of(chart);
    std::vector<std::string> texts;
    std::ofstream out(script);
    out << fmt::format("set terminal svg size {},{} dynamic noenhanced font 'DejaVu Sans,{}'\n", size.width,
                       size.height, chart.panels.size() > 2 ? 12 : 13)
        << "set border 3\nset tics nomirror\nset grid xtics ytics lt 1 lc rgb '#dcdcdc'\nunset key\n"
        << "set offsets graph 0.06, graph 0.06, graph 0.04, graph 0.04\n";
    for (std::size_t p = 0; p < chart.panels.size(); ++p) {
        out << fmt::format("set output '{}'\n", picture(p).string());
        write_panel(out, chart.panels[p], size, names, styles, texts);
    }
    out.close();
    Drawing drawing;
    const process::ProgramResult result = process::run_program({"gnuplot", script.string()});
    for (std::size_t p = 0; p < chart.panels.size() && result.status == 0; ++p)
        drawing.panels.push_back(shortened(read_all(picture(p)), texts, chart.panels[p], drawing.marks));
    if (result.status != 0) drawing.failure = "gnuplot failed: " + result.text();
    return drawing;
}

void write_svg(const Chart& chart, const std::filesystem::path& file) {
    const Drawing drawing = draw_chart(chart, file.parent_path());
    if (drawing.panels.size() != 1) throw std::runtime_error("cannot draw " + chart.name + ": " + drawing.failure);
    const std::string& svg = drawing.panels.front();
    const std::size_t inside = svg.find('>') + 1;
    std::ofstream out(file);
    out << svg.substr(0, inside) << "\n<style>svg{" << colour_variables(false)
        << "background:var(--paper)} @media (prefers-color-scheme:dark){svg{" << colour_variables(true)
        << "}}</style>\n"
        << drawing.marks << svg.substr(inside) << "\n";
    out.close();
    if (!out) throw std::runtime_error("cannot write " + file.string());
    for (const char* ending : {".gnuplot", "-1.svg"})
        std::filesystem::remove(file.parent_path() / (chart.name + ending));
}

}  // namespace ecods::bench
