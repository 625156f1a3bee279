#include "suites/narrow_builds.hpp"

#include <fmt/core.h>

#include <chrono>

#include "harness/statistics.hpp"
#include "harness/stopwatch.hpp"
#include "process/contained.hpp"

namespace ecods::bench {

namespace {

constexpr std::chrono::seconds build_limit{300};

// A turn: one build, from the mesh's lists to the first query that could be asked.
process::Contained::Run start_builds(const NarrowMaker& maker, const scenes::NamedMesh& mesh) {
    return [&maker, &mesh]() -> std::vector<double> {
        const Stopwatch watch;
        const std::unique_ptr<NarrowEngine> engine = maker.set_up(std::span(&mesh, 1));
        return {watch.nanoseconds()};
    };
}

}  // namespace

Table build_table(const std::vector<scenes::NamedMesh>& meshes, std::span<const NarrowMaker> makers,
                  std::size_t repetition_count) {
    Table table;
    table.title = "Building trees, nanoseconds per triangle";
    table.header = {"mesh", "triangles"};
    for (const NarrowMaker& maker : makers) table.header.push_back(maker.name);
    for (const scenes::NamedMesh& mesh : meshes) {
        const auto count = static_cast<double>(mesh.mesh->triangles().size());
        std::vector<std::string> row = {mesh.name, fmt::format("{}", mesh.mesh->triangles().size())};
        for (const NarrowMaker& maker : makers) {
            process::Contained child([&] { return start_builds(maker, mesh); }, build_limit);
            std::vector<double> ns;
            std::string failure;
            for (std::size_t i = 0; i < repetition_count && failure.empty(); ++i) {
                const process::Outcome outcome = child.run();
                failure = outcome.failure;
                if (outcome.is_right()) ns.push_back(outcome.values[0] / count);
            }
            row.push_back(failure.empty() ? fmt::format("{:.0f}", median(ns)) : failure);
        }
        table.rows.push_back(std::move(row));
    }
    table.notes = {"From lists of vertices and triangles. An engine that copies the lists copies them in this time."};
    return table;
}

}  // namespace ecods::bench
