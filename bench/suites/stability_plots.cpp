#include "suites/stability_plots.hpp"

#include <fmt/core.h>

#include <fstream>

#include "process/program.hpp"

namespace ecods::bench {
namespace {

// Curves differ in marks and dashes, bars in hatching, for print without colours. The last engine is ECoDS.
constexpr const char* colours[] = {"#b9b9b9", "#8c1c13", "#d1682e", "#5b9bd5", "#111111"};
constexpr int hatching[] = {3, 1, 4, 2, 3};  // gnuplot: full, crossed, strokes, dense

Picture draw(const std::filesystem::path& picture, const std::filesystem::path& script, const std::string& caption) {
    const process::ProgramResult result = process::run_program({"gnuplot", script.string()});
    return {picture, caption, result.status == 0 ? "" : "gnuplot failed: " + result.text()};
}

// For gnuplot, lines of about a bar group's width.
std::string broken_in_lines(const std::string& text) {
    std::string result;
    std::size_t length = 0;
    for (const char c : text) {
        if (c == ' ' && length > 6) {
            result += "\\n";
            length = 0;
        } else {
            result += c;
            ++length;
        }
    }
    return result;
}

}  // namespace

Picture plot_wrong_curves(std::span<const WrongCurves> panels, std::span<const std::string> engines,
                          const std::filesystem::path& folder, const std::string& name, const std::string& caption) {
    const std::filesystem::path picture = folder / (name + ".svg"), script = folder / (name + ".gnuplot");
    std::ofstream out(script);
    out << "set terminal svg size 1000,430 font 'DejaVu Sans,14' background '#ffffff'\n"
        << fmt::format("set output '{}'\n", picture.string())
        << "set multiplot\nset yrange [-2:*]\nset offsets graph 0.06, graph 0.06, graph 0.05, 0\n"
        << "set grid ytics lt 1 lc rgb '#dddddd'\nset border 3\nset tics nomirror\nunset key\n"
        << "set bmargin at screen 0.19\nset tmargin at screen 0.88\n";
    const auto style = [](std::size_t e) {
        return fmt::format("with linespoints lw 2 dt {} pt {} ps 0.9 lc rgb '{}'", e + 1, 2 * e + 4, colours[e]);
    };
    for (std::size_t p = 0; p < panels.size(); ++p) {
        const WrongCurves& panel = panels[p];
        const std::filesystem::path data = folder / fmt::format("{}-{}.txt", name, p + 1);
        std::ofstream table(data);
        for (std::size_t i = 0; i < panel.x.size(); ++i) {
            table << fmt::format("{}", panel.x[i]);
            for (const std::vector<double>& curve : panel.percent) table << fmt::format(" {:.4f}", curve[i]);
            table << "\n";
        }
        table.close();
        const double width = 1.0 / static_cast<double>(panels.size());
        const double left = static_cast<double>(p) * width;
        out << fmt::format("set lmargin at screen {}\nset rmargin at screen {}\n", left + 0.08, left + width - 0.01)
            << fmt::format("set xlabel '{}'\nset ylabel '{}'\n", panel.x_label, p == 0 ? "wrong answers, percent" : "")
            << (panel.x_is_logarithmic ? "set logscale x\nset format x '10^{%T}'\n"
                                       : "unset logscale x\nset format x '2^{%.0f}'\n")
            << "set xtics (";
        const std::size_t every = panel.x.size() > 5 ? 2 : 1;  // else the labels run into each other
        for (std::size_t i = 0; i < panel.x.size(); i += every) {
            out << (i == 0 ? "" : ", ") << fmt::format("{}", panel.x[i]);
        }
        out << ")\nplot ";
        for (std::size_t e = 0; e < engines.size(); ++e) {
            out << fmt::format("{}'{}' using 1:{} {}", e == 0 ? "" : ", ", data.string(), e + 2, style(e));
        }
        out << "\n";
    }
    // One key for all panels, above them: a plot without anything else that is as wide as the picture.
    out << "set lmargin at screen 0\nset rmargin at screen 1\nset bmargin at screen 0\nset tmargin at screen 1\n"
        << "unset logscale\nunset border\nunset tics\nunset xlabel\nunset ylabel\nunset grid\n"
        << "set key at screen 0.5,0.985 center top horizontal samplen 4 width 2\nplot [0:1][0:1] ";
    for (std::size_t e = 0; e < engines.size(); ++e) {
        out << fmt::format("{}NaN {} title '{}'", e == 0 ? "" : ", ", style(e), engines[e]);
    }
    out << "\n";
    out << "unset multiplot\n";
    out.close();
    return draw(picture, script, caption);
}

Picture plot_wrong_bars(std::span<const std::string> groups, std::span<const std::string> engines,
                        std::span<const std::vector<double>> percent, const std::filesystem::path& folder,
                        const std::string& name, const std::string& caption) {
    const std::filesystem::path picture = folder / (name + ".svg"), script = folder / (name + ".gnuplot"),
                                data = folder / (name + ".txt");
    std::ofstream table(data);
    for (std::size_t g = 0; g < groups.size(); ++g) {
        table << '"' << broken_in_lines(groups[g]) << '"';
        for (const std::vector<double>& of_engine : percent) table << fmt::format(" {:.4f}", of_engine[g]);
        table << "\n";
    }
    table.close();
    std::ofstream out(script);
    out << "set terminal svg size 1000,430 font 'DejaVu Sans,14' background '#ffffff'\n"
        << fmt::format("set output '{}'\n", picture.string())
        << "set style data histogram\nset style histogram clustered gap 1.5\nset boxwidth 0.9\n"
        << "set style fill pattern border rgb '#333333'\nset yrange [0:*]\nset ylabel 'wrong answers, percent'\n"
        << "set grid ytics lt 1 lc rgb '#dddddd'\nset border 3\nset tics nomirror\nset xtics scale 0\nset bmargin 4\n"
        << "set key outside top center horizontal samplen 2 width 2\nplot ";
    for (std::size_t e = 0; e < engines.size(); ++e) {
        out << fmt::format("{}'{}' using {}:xtic(1) fs pattern {} lc rgb '{}' title '{}'", e == 0 ? "" : ", \\\n     ",
                           data.string(), e + 2, hatching[e], colours[e], engines[e]);
    }
    out << "\n";
    out.close();
    return draw(picture, script, caption);
}

Picture plot_sign_maps(std::span<const SignMap> maps, const std::filesystem::path& folder, const std::string& name,
                       const std::string& caption) {
    const std::filesystem::path picture = folder / (name + ".png"), script = folder / (name + ".gnuplot");
    std::ofstream out(script);
    out << "set terminal pngcairo size 1120,600 font 'DejaVu Sans,14' background '#ffffff'\n"
        << fmt::format("set output '{}'\n", picture.string())
        << fmt::format("set multiplot layout 1,{} margins 0.03,0.97,0.06,0.91 spacing 0.05,0.1\n", maps.size())
        << "set palette maxcolors 3 defined (-1 '#262626', 0 '#ffffff', 1 '#9c9c9c')\nset cbrange [-1.5:1.5]\n"
        << "unset colorbox\nunset key\nunset tics\nset border 15 lc rgb '#777777'\nset size square\n";
    for (std::size_t m = 0; m < maps.size(); ++m) {
        const SignMap& map = maps[m];
        const std::filesystem::path data = folder / fmt::format("{}-{}.txt", name, m + 1);
        std::ofstream table(data);
        for (std::size_t i = 0; i < map.signs.size(); ++i) {
            table << map.signs[i] << ((i + 1) % map.size == 0 ? '\n' : ' ');
        }
        table.close();
        out << fmt::format("set title '{0}'\nset xrange [-0.5:{1}.5]\nset yrange [-0.5:{1}.5]\n", map.title,
                           map.size - 1)
            << fmt::format("plot '{}' matrix with image\n", data.string());
    }
    out << "unset multiplot\n";
    out.close();
    return draw(picture, script, caption);
}

}  // namespace ecods::bench
