// The work of the sweep and prune as it grows with the number of boxes: swaps and box tests in the dense scene, and the
// power of the number that they grow with.
#include <fmt/core.h>

#include <vector>

#include "ecods/broad_phase.hpp"
#include "harness/statistics.hpp"
#include "scenes/moving_boxes.hpp"
#include "suites/parts.hpp"

namespace ecods::bench {

namespace {

BroadPhaseCounts count_work(const scenes::MovingBoxes& boxes) {
    const auto broad_phase = make_broad_phase(BroadPhaseKind::sweep_and_prune);
    for (std::size_t i = 0; i < boxes.boxes.size(); ++i) broad_phase->add(static_cast<ProxyIndex>(i), boxes.boxes[i]);
    broad_phase->update();
    const BroadPhaseCounts before = broad_phase->counts();
    for (const auto& frame : boxes.frames) {
        for (const scenes::BoxMove& move : frame) broad_phase->move(move.index, move.box);
        broad_phase->update();
    }
    BroadPhaseCounts counts = broad_phase->counts();
    counts.swaps -= before.swaps;
    counts.box_tests -= before.box_tests;
    return counts;
}

std::string exponent(const std::vector<double>& counts, const std::vector<double>& work) {
    for (const double value : work)
        if (value <= 0) return "";
    const PowerLaw law = fit_power_law(counts, work);
    return fmt::format("N^({:.2f} ± {:.2f})", law.exponent, law.exponent_error);
}

}  // namespace

Table swap_table(std::size_t count_max, std::size_t frame_count) {
    Table table{.title = "Sweep and prune, dense boxes: work per frame",
                .header = {"boxes", "swaps/frame", "swaps/box/frame", "box tests/frame", "box tests/box/frame"}};
    std::vector<double> counts, swaps, tests;
    for (std::size_t count = 250; count <= count_max; count *= 2) {
        const BroadPhaseCounts work = count_work(scenes::moving_boxes({.count = count, .frame_count = frame_count}));
        const auto frames = static_cast<double>(frame_count);
        counts.push_back(static_cast<double>(count));
        swaps.push_back(static_cast<double>(work.swaps) / frames);
        tests.push_back(static_cast<double>(work.box_tests) / frames);
        table.rows.push_back({fmt::format("{}", count), fmt::format("{:.0f}", swaps.back()),
                              fmt::format("{:.2f}", swaps.back() / counts.back()), fmt::format("{:.0f}", tests.back()),
                              fmt::format("{:.2f}", tests.back() / counts.back())});
    }
    table.rows.push_back({"growth", exponent(counts, swaps), "", exponent(counts, tests), ""});
    table.notes = {
        "Fitted by least squares to the logarithms. A box that moves passes others on each axis: N^(2/3) of them "
        "in a cube of constant density."};
    return table;
}

}  // namespace ecods::bench
