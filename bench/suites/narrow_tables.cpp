// What it takes to make meshes ready for queries, and what engines that report distances say of meshes at known gaps.
#include <fmt/core.h>

#include <algorithm>

#include "engines/distance_engine.hpp"
#include "harness/query_runs.hpp"
#include "harness/statistics.hpp"
#include "suites/parts.hpp"

namespace ecods::bench {

namespace {

// A turn: one build, from the mesh's lists to the first query that could be asked.
process::Contained::Run start_builds(const NarrowMaker& maker, const scenes::MeshPairs& workload) {
    return [&maker, &workload]() -> std::vector<double> {
        const Stopwatch watch;
        const std::unique_ptr<Touch::Engine> engine = maker.set_up(workload);
        return {watch.nanoseconds()};
    };
}

// The radius of the ball around the middle of the mesh's box, as scenes/mesh_pairs.hpp has it.
double radius_of(const Mesh& mesh) {
    Vec3 min = mesh.vertices()[0], max = min;
    for (const Vec3& v : mesh.vertices()) {
        min = min.cwiseMin(v);
        max = max.cwiseMax(v);
    }
    double radius = 0;
    for (const Vec3& v : mesh.vertices()) radius = std::max(radius, (v - (min + max) / 2).norm());
    return radius;
}

std::vector<std::string> row_of(const Run<Distance>& run, const scenes::MeshPairs& workload,
                                const Truths<double>& truths) {
    if (!run.failure.empty()) return {run.maker->name, workload.name, run.failure, "", ""};
    std::size_t zero_count = 0, positive_count = 0;
    double most = 0;
    for (std::size_t i = 0; i < run.answers.size(); ++i) {
        const double distance = run.answers[i];
        if (truths.answers[i] != 0) {
            positive_count += distance > 0;
        } else {
            zero_count += !(distance > 0);
            most = std::max(most, distance);
        }
    }
    return {run.maker->name, workload.name, fmt::format("{}", zero_count), fmt::format("{}", positive_count),
            fmt::format("{:.2g}", most / radius_of(*workload.meshes[0].mesh))};
}

}  // namespace

Table build_table(const std::vector<scenes::NamedMesh>& meshes, const std::vector<NarrowMaker>& makers,
                  std::size_t repetition_count) {
    Table table{
        .title = "Building trees, nanoseconds per triangle",
        .header = {"mesh", "triangles"},
        .notes = {"From lists of vertices and triangles. An engine that copies the lists copies them in this time."}};
    for (const NarrowMaker& maker : makers) table.header.push_back(maker.name);
    for (const scenes::NamedMesh& mesh : meshes) {
        const scenes::MeshPairs workload{mesh.name, {mesh}, {}};
        const auto count = static_cast<double>(mesh.mesh->triangles().size());
        std::vector<std::string> row = {mesh.name, fmt::format("{}", mesh.mesh->triangles().size())};
        for (const NarrowMaker& maker : makers) {
            process::Contained child([&] { return start_builds(maker, workload); }, turn_limit);
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
    return table;
}

Table distance_table(std::span<const scenes::MeshPairs> workloads, std::span<const Truths<double>> truths,
                     const std::vector<NarrowMaker>& makers) {
    std::vector<DistanceMaker> same = fcl_distance();
    std::erase_if(same, [&](const DistanceMaker& maker) {
        return std::ranges::find(makers, maker.name, &NarrowMaker::name) == makers.end();
    });
    Table table{
        .title = "Distances reported at these gaps",
        .header = {"engine", "gap in radii", "0 where apart", "more than 0 where they touch", "most where apart"},
        .text_columns = 2,
        .notes = {
            "The last column in radii: the gap is along a line on which the two touch, so that the true distance is at "
            "most the gap, but for the rounding of positions. Engines that report no distance are not listed, ECoDS "
            "among them."}};
    for (std::size_t i = 0; i < workloads.size(); ++i)
        for (const Run<Distance>& run : measure<Distance>({workloads[i]}, same, 0))
            table.rows.push_back(row_of(run, workloads[i], truths[i]));
    return table;
}

}  // namespace ecods::bench
