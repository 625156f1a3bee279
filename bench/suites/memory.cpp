// What engines allocate: for each triangle of a mesh, each box of a broad phase, each body of a system.
#include <fmt/core.h>

#include <functional>

#include "engines/broad_engine.hpp"
#include "engines/engine.hpp"
#include "engines/narrow_engine.hpp"
#include "harness/heap.hpp"
#include "process/contained.hpp"
#include "scenes/narrow_workloads.hpp"
#include "scenes/room.hpp"
#include "suites/comparison.hpp"
#include "suites/suite.hpp"

namespace ecods::bench {

namespace {

constexpr std::chrono::seconds limit{300};

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
        limit);
    return child.run();
}

std::string per(const process::Outcome& outcome, std::size_t count) {
    return outcome.is_right() ? fmt::format("{:.1f}", outcome.values[0] / static_cast<double>(count)) : outcome.failure;
}

Table triangle_table(const SuiteOptions& options) {
    Table table;
    table.title = "Heap bytes per triangle of a mesh made ready for queries";
    table.header = {"engine"};
    const std::vector<scenes::NamedMesh> meshes =
        build_workloads(options.is_quick() ? scenes::WorkloadSize::tiny : scenes::WorkloadSize::full);
    for (const scenes::NamedMesh& mesh : meshes)
        table.header.push_back(fmt::format("{} ({})", mesh.name, mesh.mesh->triangles().size()));
    std::vector<NarrowMaker> makers = narrow_engines();
    options.keep_wanted(makers);
    for (const NarrowMaker& maker : makers) {
        std::vector<std::string> row = {maker.name};
        for (const scenes::NamedMesh& mesh : meshes) {
            const process::Outcome outcome =
                allocated_by([&]() -> std::shared_ptr<void> { return maker.set_up(std::span(&mesh, 1)); });
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
    Table table;
    const std::size_t count = options.is_quick() ? 1000 : 10'000;
    table.title = fmt::format("Heap bytes per box, {} boxes after some frames", count);
    table.header = {"engine", "dense", "sparse"};
    const scenes::MovingBoxes dense = scenes::moving_boxes({.count = count, .frame_count = 3});
    const scenes::MovingBoxes sparse =
        scenes::moving_boxes({.layout = scenes::BoxLayout::sparse, .count = count, .frame_count = 3});
    std::vector<BroadMaker> makers = broad_engines();
    options.keep_wanted(makers);
    for (const BroadMaker& maker : makers) {
        std::vector<std::string> row = {maker.name};
        for (const scenes::MovingBoxes* boxes : {&dense, &sparse}) {
            const process::Outcome outcome = allocated_by([&]() -> std::shared_ptr<void> {
                std::shared_ptr<BroadEngine> engine = maker.set_up(*boxes);
                engine->run_frame({});
                for (const std::vector<scenes::BoxMove>& frame : boxes->frames) engine->run_frame(frame);
                return engine;
            });
            row.push_back(per(outcome, count));
        }
        table.rows.push_back(std::move(row));
    }
    table.notes = {"With the list of pairs as delivered. Embree maps memory by itself, which is not counted."};
    return table;
}

Table body_table(const SuiteOptions& options) {
    Table table;
    const std::size_t few = options.is_quick() ? 32 : 512, many = 2 * few;
    table.title = "Heap bytes per body: ships at the calibrated density, after some frames";
    table.header = {"engine", "bytes/body", fmt::format("{} ships", few), fmt::format("{} ships", many)};
    std::vector<EngineMaker> makers = all_engines();
    options.keep_wanted(makers);
    for (const EngineMaker& maker : makers) {
        std::vector<double> bytes;
        std::string failure;
        for (const std::size_t ships : {few, many}) {
            const scenes::Scene scene = scenes::room(
                {.ship_count = ships, .frame_count = 3, .side = scenes::calibrated_side_by_density(ships), .seed = 10});
            const process::Outcome outcome = allocated_by([&]() -> std::shared_ptr<void> {
                std::shared_ptr<Engine> engine = maker.set_up(scene);
                engine->run_frame({});
                for (const scenes::Frame& frame : scene.frames) engine->run_frame(frame.moves);
                return engine;
            });
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
