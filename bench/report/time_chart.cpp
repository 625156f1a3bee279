#include "report/time_chart.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace ecods::bench {

Chart time_chart(std::span<const SceneRun> runs, const std::string& name, const std::string& caption) {
    Panel panel{.title = "",
                .x = {.title = "frame"},
                .y = {.title = "milliseconds per frame", .is_logarithmic = true},
                .curves = {},
                .has_lines = true};
    for (const SceneRun& run : runs) {
        Curve& curve = panel.curves.emplace_back();
        curve.name = run.name;
        const std::size_t step = std::max<std::size_t>(1, run.frame_ms.size() / 12);
        for (std::size_t frame = 1; frame < run.frame_ms.size(); ++frame) {
            const double ms = run.frame_ms[frame];
            curve.points.push_back(
                {static_cast<double>(frame), ms,
                 frame % step == 0 ? fmt::format("{}: frame {}, {:.3g} ms", run.name, frame, ms) : ""});
        }
    }
    return {name, {std::move(panel)}, caption};
}

}  // namespace ecods::bench
