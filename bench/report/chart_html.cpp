#include "report/chart_html.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <vector>

#include "report/draw_chart.hpp"
#include "report/engine_style.hpp"
#include "report/table.hpp"

namespace ecods::bench {

namespace {

std::string key(const Chart& chart) {
    const std::vector<std::string> names = names_of(chart);
    const std::vector<EngineStyle> styles = engine_styles(names);
    const bool has_lines = std::ranges::any_of(chart.panels, [](const Panel& panel) { return panel.has_lines; });
    constexpr std::array dashes = {"", "4 3", "1.5 2", "6 2 1.5 2", "6 2 1.5 2 1.5 2"};
    std::string html = "<ul class=\"key\">";
    for (std::size_t e = 0; e < names.size(); ++e) {
        const std::string colour = fmt::format("var(--{})", styles[e].colour->name);
        html += "<li><svg viewBox=\"0 0 26 12\" aria-hidden=\"true\">";
        if (has_lines)
            html += fmt::format("<path d=\"M0,6h26\" stroke=\"{}\" stroke-width=\"1.8\" stroke-dasharray=\"{}\"/>",
                                colour, dashes[static_cast<std::size_t>(styles[e].dash - 1)]);
        // gnuplot's point types count from 1, the marks of its SVG from 0.
        html += fmt::format(
            "<use href=\"#gpPt{}\" transform=\"translate(13,6) scale({})\" color=\"{}\" fill=\"none\"/></svg>{}</li>",
            styles[e].mark - 1, has_lines ? 3.5 : 5, colour, escape_html(names[e]));
    }
    return html + "</ul>\n";
}

}  // namespace

std::string to_html(const Chart& chart, const std::filesystem::path& folder, const std::string& origin,
                    std::string& marks) {
    const Drawing drawing = draw_chart(chart, folder);
    std::string html = "<figure class=\"chart\">";
    if (!drawing.failure.empty()) {
        html += "<p>No picture: " + escape_html(drawing.failure) + "</p>";
    } else {
        if (!drawing.marks.empty()) marks = drawing.marks;
        const char* width = chart.panels.size() == 1 ? " one" : chart.panels.size() == 2 ? " two" : "";
        std::array<std::string, 2> panels;  // open, folded
        std::array<std::size_t, 2> counts = {};
        for (std::size_t p = 0; p < drawing.panels.size(); ++p) {
            panels[chart.panels[p].is_folded ? 1 : 0] += drawing.panels[p];
            ++counts[chart.panels[p].is_folded ? 1 : 0];
        }
        html += key(chart);
        if (counts[0] > 0) html += fmt::format("<div class=\"panels{}\">{}</div>", width, panels[0]);
        if (counts[1] > 0)
            html += fmt::format("<details><summary>{} more {}, {}</summary><div class=\"panels{}\">{}</div></details>",
                                counts[1], counts[1] == 1 ? "workload" : "workloads", escape_html(chart.fold), width,
                                panels[1]);
    }
    return html + "<figcaption>" + escape_html(chart.caption) + " <span class=\"origin\">" + escape_html(origin) +
           "</span></figcaption></figure>\n";
}

}  // namespace ecods::bench
