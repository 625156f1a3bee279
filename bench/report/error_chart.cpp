#include "report/error_chart.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "process/program.hpp"

namespace ecods::bench {

namespace {

// Height of a share: 0 for none, 1 for 0.1 %, 4 for 100 %. Smaller shares than 0.1 % of some hundred queries do not
// occur, but would be drawn between the two lowest lines.
double height(double share) {
    return share <= 0 ? 0 : std::max(0.5, std::log10(share) + 4);
}

// Of units in the last place: 0 for none, 1 for 1, 2 for 1000, and so on.
double height_of_ulps(double ulps) {
    return ulps <= 0 ? 0 : std::max(0.5, std::log10(ulps) / 3 + 1);
}

struct Scale {
    double (*height)(double error);
    const char* tics;
    double top;
};
constexpr Scale shares{height, "'0' 0, '0.1 %%' 1, '1 %%' 2, '10 %%' 3, '100 %%' 4", 4.15};
constexpr Scale units_in_the_last_place{height_of_ulps,
                                        "'0' 0, '1' 1, '10^3' 2, '10^6' 3, '10^9' 4, '10^{12}' 5, '10^{15}' 6", 6.3};

constexpr const char* colours[] = {"#111111", "#8c1c13", "#d1682e", "#1d4e89", "#5b9bd5", "#7a7a7a"};
constexpr int marks[] = {7, 5, 4, 9, 13, 2};

std::string style(std::size_t engine) {
    return fmt::format("with points pt {} ps {} lw 2 lc rgb '{}'", marks[engine % 6], engine == 0 ? 1.5 : 1.2,
                       colours[engine % 6]);
}

Picture plot(const Scale& scale, std::span<const ErrorPanel> panels, std::span<const std::string> engines,
             const std::string& time_label, const std::filesystem::path& folder, const std::string& name,
             const std::string& caption) {
    const std::filesystem::path picture = folder / (name + ".svg"), script = folder / (name + ".gnuplot");
    constexpr std::size_t columns = 3;
    const std::size_t rows = (panels.size() + columns - 1) / columns;
    const double height_px = 76 + 270 * static_cast<double>(rows), key = 66 / height_px;
    const double row_height = (1 - key) / static_cast<double>(rows);
    std::ofstream out(script);
    out << fmt::format("set terminal svg size 1000,{:.0f} font 'DejaVu Sans,13' background '#ffffff'\n", height_px)
        << fmt::format("set output '{}'\nset multiplot\nset logscale x\nset yrange [-0.35:{}]\n", picture.string(),
                       scale.top)
        << "set offsets graph 0.08, graph 0.08, 0, 0\nset ytics (" << scale.tics << ")\nset border 3\n"
        << "set tics nomirror\nset grid ytics lt 1 lc rgb '#dddddd'\nunset key\nset format x '%g'\n";
    for (std::size_t p = 0; p < panels.size(); ++p) {
        const std::size_t row = p / columns, column = p % columns;
        const double left = static_cast<double>(column) / columns,
                     top = 1 - key - static_cast<double>(row) * row_height;
        out << fmt::format("set lmargin at screen {}\nset rmargin at screen {}\n", left + 0.065, left + 0.32)
            << fmt::format("set tmargin at screen {}\nset bmargin at screen {}\n", top - 34 / height_px,
                           top - row_height + 62 / height_px)
            << fmt::format("set title '{}' offset 0,-0.5\nset xlabel '{}' offset 0,0.7\nplot ", panels[p].title,
                           time_label);
        std::string plots, data;
        for (const ErrorPoint& point : panels[p].points) {
            plots += fmt::format("{}'-' {}", plots.empty() ? "" : ", ", style(point.engine_index));
            data += fmt::format("{} {}\ne\n", point.time, scale.height(point.error));
        }
        out << plots << "\n" << data;
    }
    // One key for all panels: a plot without anything else.
    out << "set lmargin at screen 0\nset rmargin at screen 1\nset bmargin at screen 0\nset tmargin at screen 1\n"
        << "unset logscale\nunset border\nunset tics\nunset xlabel\nunset title\nunset grid\n"
        << "set key at screen 0.5,0.995 center top horizontal samplen 1 width 2\nplot [0:1][0:1] ";
    for (std::size_t e = 0; e < engines.size(); ++e)
        out << fmt::format("{}NaN {} title '{}'", e == 0 ? "" : ", ", style(e), engines[e]);
    out << "\nunset multiplot\n";
    out.close();
    const process::ProgramResult result = process::run_program({"gnuplot", script.string()});
    return {picture, caption, result.status == 0 ? "" : "gnuplot failed: " + result.text()};
}

}  // namespace

Picture plot_errors(std::span<const ErrorPanel> panels, std::span<const std::string> engines,
                    const std::string& time_label, const std::filesystem::path& folder, const std::string& name,
                    const std::string& caption) {
    return plot(shares, panels, engines, time_label, folder, name, caption);
}

Picture plot_ulps(std::span<const ErrorPanel> panels, std::span<const std::string> engines,
                  const std::string& time_label, const std::filesystem::path& folder, const std::string& name,
                  const std::string& caption) {
    return plot(units_in_the_last_place, panels, engines, time_label, folder, name, caption);
}

}  // namespace ecods::bench
