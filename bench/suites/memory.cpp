// What engines allocate: for each triangle of a mesh, each box of a broad phase, each body of a system.
#include <fmt/core.h>
#include <malloc.h>

#include <functional>

#include "engines/broad_engine.hpp"
#include "engines/narrow_engine.hpp"
#include "engines/scene_engine.hpp"
#include "harness/frame_runs.hpp"
#include "harness/turns.hpp"
#include "process/contained.hpp"
#include "scenes/narrow_workloads.hpp"
#include "scenes/room.hpp"
#include "suites/comparison.hpp"
#include "suites/suite.hpp"

namespace ecods::bench {

namespace {

// Bytes that this process has allocated and not freed, as the C library's allocator counts them: what was asked for,
// rounded up to its units. What a library maps by itself is not in it.
double heap_bytes() {
    const struct mallinfo2 info = mallinfo2();
    return static_cast<double>(info.uordblks) + static_cast<double>(info.hblkhd);
}

// What `make` has allocated when it returns what must stay alive; why not, when it fails.
process::Outcome allocated_by(const std::function<std::shared_ptr<void>()>& make) {
    process::Contained child(
        [&make] {
            return process::Contained::Run([&make]() -> std::vector<double> {
                const double before = heap_bytes();
                const std::shared_ptr<void> kept = make();
                return {heap_bytes() - before};
            });
        },
        turn_limit);
    return child.run();
}

// An engine that has run all frames.
template <class Q>
std::shared_ptr<void> after_frames(const Maker<Q>& maker, const typename Q::Workload& workload) {
    std::shared_ptr<typename Q::Engine> engine = maker.set_up(workload);
    engine->run_frame({});
    for (const auto& frame : workload.frames) engine->run_frame(moves_of(frame));
    return engine;
}

std::string per(const process::Outcome& outcome, std::size_t count) {
    return outcome.is_right() ? fmt::format("{:.1f}", outcome.values[0] / static_cast<double>(count)) : outcome.failure;
}

Table triangle_table(const SuiteOptions& options) {
    Table table{.title = "Heap bytes per triangle of a mesh made ready for queries", .header = {"engine"}};
    const std::vector<scenes::NamedMesh> meshes = build_workloads(options.workload_size());
    for (const scenes::NamedMesh& mesh : meshes)
        table.header.push_back(fmt::format("{} ({})", mesh.name, mesh.mesh->triangles().size()));
    for (const NarrowMaker& maker : options.wanted(narrow_engines())) {
        std::vector<std::string> row = {maker.name};
        for (const scenes::NamedMesh& mesh : meshes) {
            const scenes::MeshPairs workload{mesh.name, {mesh}, {}};
            const process::Outcome outcome =
                allocated_by([&]() -> std::shared_ptr<void> { return maker.set_up(workload); });
            row.push_back(per(outcome, mesh.mesh->triangles().size()));
        }
        table.rows.push_back(std::move(row));
    }
    table.notes = {
        "ECoDS shares the mesh's vertices and indices, 36 to 40 bytes a triangle, which are not in its figure; the "
        "others hold copies, which are."};
    return table;
}

Table box_table(const SuiteOptions& options) {
    const std::size_t count = options.is_quick() ? 1000 : 10'000;
    Table table{.title = fmt::format("Heap bytes per box, {} boxes after some frames", count),
                .header = {"engine", "dense", "sparse"},
                .notes = {"With the list of pairs as delivered. Embree maps memory by itself, which is not counted."}};
    const scenes::MovingBoxes dense = scenes::moving_boxes({.count = count, .frame_count = 3});
    const scenes::MovingBoxes sparse =
        scenes::moving_boxes({.layout = scenes::BoxLayout::sparse, .count = count, .frame_count = 3});
    for (const BroadMaker& maker : options.wanted(broad_engines())) {
        std::vector<std::string> row = {maker.name};
        for (const scenes::MovingBoxes* boxes : {&dense, &sparse}) {
            row.push_back(per(allocated_by([&] { return after_frames(maker, *boxes); }), count));
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

Table body_table(const SuiteOptions& options) {
    const std::size_t few = options.is_quick() ? 32 : 512, many = 2 * few;
    Table table{.title = "Heap bytes per body: ships at the calibrated density, after some frames",
                .header = {"engine", "bytes/body", fmt::format("{} ships", few), fmt::format("{} ships", many)}};
    for (const SceneMaker& maker : options.wanted(scene_engines())) {
        std::vector<double> bytes;
        std::string failure;
        for (const std::size_t ships : {few, many}) {
            const scenes::Scene scene = scenes::room(
                {.ship_count = ships, .frame_count = 3, .side = scenes::calibrated_side_by_density(ships), .seed = 10});
            const process::Outcome outcome = allocated_by([&] { return after_frames(maker, scene); });
            failure += outcome.failure;
            bytes.push_back(outcome.is_right() ? outcome.values[0] : 0);
        }
        table.rows.push_back(
            {maker.name, failure.empty() ? fmt::format("{:.0f}", (bytes[1] - bytes[0]) / double(many - few)) : failure,
             fmt::format("{:.0f}", bytes[0]), fmt::format("{:.0f}", bytes[1])});
    }
    table.notes = {
        "The difference between the two numbers of ships, over the difference of the numbers: what is there once "
        "is not in it."};
    return table;
}

}  // namespace

SuiteResult run_memory(const SuiteOptions& options) {
    SuiteResult result;
    result.sections.push_back(
        {"Memory",
         {"What each engine has allocated, by the C library's own count, in a process of its own."},
         {triangle_table(options), box_table(options), body_table(options)},
         {}});
    for (const Table& table : result.sections.front().tables) print(table);
    return result;
}

}  // namespace ecods::bench
