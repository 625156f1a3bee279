#include "report/plot.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <fstream>

#include "process/program.hpp"

namespace ecods::bench {

namespace {

// 1, 2 and 5 in each decade, which a logarithmic axis of less than two decades needs to be read.
std::string tics() {
    std::string list;
    for (const char* decade : {"e-4", "e-3", "e-2", "e-1", "e0", "e1", "e2", "e3"})
        for (const char* digit : {"1", "2", "5"})
            list += fmt::format("{}{}{}", list.empty() ? "" : ", ", digit, decade);
    return list;
}

}  // namespace

Picture plot_times(std::span<const Run> runs, const std::filesystem::path& folder, const std::string& name,
                   const std::string& caption) {
    const std::filesystem::path picture = folder / (name + ".svg");
    const std::filesystem::path data = folder / (name + ".txt");
    const std::filesystem::path script = folder / (name + ".gnuplot");
    const std::size_t frame_count = runs.empty() ? 0 : runs.front().frame_ms.size();

    std::ofstream table(data);
    for (std::size_t frame = 1; frame < frame_count; ++frame) {
        table << frame;
        for (const Run& run : runs) table << fmt::format(" {:.6f}", run.frame_ms[frame]);
        table << "\n";
    }
    table.close();

    // Curves differ in marks and dashes, not in colour alone.
    const std::vector<std::string> colours = {"#111111", "#8c1c13", "#d1682e", "#1d4e89",
                                              "#5b9bd5", "#7a7a7a", "#b08fb0"};
    std::ofstream out(script);
    out << "set terminal svg size 1000,520 font 'DejaVu Sans,15' background '#ffffff'\n"
        << fmt::format("set output '{}'\n", picture.string())
        << "set logscale y\nset autoscale yfix\nset offsets 0, 0, graph 0.06, graph 0.06\n"
        << "set ytics (" << tics() << ")\n"
        << "set xlabel 'frame'\nset ylabel 'milliseconds per frame'\n"
        << "set grid ytics lc rgb '#cccccc'\nset border 3\nset tics nomirror\n"
        << "set key outside top left horizontal Left reverse spacing 1.3 samplen 4 width 2\n"
        << fmt::format("set xrange [0:{}]\n", frame_count) << "plot ";
    for (std::size_t i = 0; i < runs.size(); ++i)
        out << fmt::format(
            "{}'{}' using 1:{} with linespoints lw 1.6 dt {} pt {} ps 0.7 pointinterval {} lc rgb '{}' "
            "title '{}'",
            i == 0 ? "" : ", \\\n     ", data.string(), i + 2, i + 1, 2 * i + 4,
            std::max<std::size_t>(1, frame_count / 12), colours[i % colours.size()], runs[i].name);
    out << "\n";
    out.close();

    const process::ProgramResult result = process::run_program({"gnuplot", script.string()});
    return {picture, caption, result.status == 0 ? "" : "gnuplot failed: " + result.text()};
}

}  // namespace ecods::bench
