#include "report/growth_plot.hpp"

#include <fmt/core.h>

#include <fstream>

#include "process/program.hpp"

namespace ecods::bench {

namespace {

constexpr const char* colours[] = {"#111111", "#8c1c13", "#d1682e", "#1d4e89", "#5b9bd5", "#7a7a7a", "#b08fb0"};

}  // namespace

Picture plot_growth(std::span<const GrowthPanel> panels, const std::filesystem::path& folder, const std::string& name,
                    const std::string& caption) {
    const std::filesystem::path picture = folder / (name + ".svg"), script = folder / (name + ".gnuplot");
    std::ofstream out(script);
    out << "set terminal svg size 1000,560 font 'DejaVu Sans,13' background '#ffffff'\n"
        << fmt::format("set output '{}'\nset multiplot\nset logscale xy\nset logscale x 2\n", picture.string())
        << "set border 3\nset tics nomirror\nset grid xtics ytics lt 1 lc rgb '#dddddd'\n"
        << "set format y '10^{%T}'\nset tmargin at screen 0.97\nset bmargin at screen 0.36\n"
        << "set offsets graph 0.03, graph 0.03, graph 0.04, graph 0.04\n";
    for (std::size_t p = 0; p < panels.size(); ++p) {
        const double width = 1.0 / static_cast<double>(panels.size()), left = static_cast<double>(p) * width;
        out << fmt::format("set lmargin at screen {}\nset rmargin at screen {}\n", left + 0.08, left + width - 0.02)
            << fmt::format("set xlabel '{}'\nset ylabel '{}'\n", panels[p].x_label, panels[p].y_label)
            << fmt::format("set key at screen {},0.245 left top Left reverse vertical maxrows 7 samplen 4\nplot ",
                           left + 0.06);
        std::string plots, data;
        for (std::size_t c = 0; c < panels[p].curves.size(); ++c) {
            const GrowthCurve& curve = panels[p].curves[c];
            plots += fmt::format("{}'-' with linespoints lw 2 dt {} pt {} ps 0.9 lc rgb '{}' title '{}'",
                                 plots.empty() ? "" : ", ", c % 5 + 1, 2 * c + 4, colours[c % 7], curve.name);
            for (std::size_t i = 0; i < curve.x.size(); ++i)
                if (curve.y[i] > 0) data += fmt::format("{} {}\n", curve.x[i], curve.y[i]);
            data += "e\n";
        }
        out << plots << "\n" << data;
    }
    out << "unset multiplot\n";
    out.close();
    const process::ProgramResult result = process::run_program({"gnuplot", script.string()});
    return {picture, caption, result.status == 0 ? "" : "gnuplot failed: " + result.text()};
}

}  // namespace ecods::bench
