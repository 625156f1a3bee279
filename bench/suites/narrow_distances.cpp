#include "suites/narrow_distances.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>

#include "process/contained.hpp"

namespace ecods::bench {

namespace {

constexpr std::chrono::seconds distance_limit{120};

// A turn: the distances of all queries, or nothing from an engine that has none.
process::Contained::Run start_distances(const NarrowMaker& maker, const scenes::MeshPairs& workload) {
    std::shared_ptr<NarrowEngine> engine = maker.set_up(workload.meshes);
    return [engine, &workload]() {
        std::vector<double> distances;
        for (const scenes::MeshQuery& query : workload.queries) {
            const std::optional<double> distance = engine->distance(query);
            if (!distance) break;
            distances.push_back(*distance);
        }
        return distances;
    };
}

// Of the ball around the middle of the mesh's box, as scenes/mesh_pairs.hpp has it.
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

std::vector<std::string> row_of(const NarrowMaker& maker, const scenes::MeshPairs& workload, const NarrowTruth& truth,
                                const process::Outcome& outcome) {
    if (!outcome.is_right()) return {maker.name, workload.name, outcome.failure, "", ""};
    std::size_t zero_count = 0, positive_count = 0;
    double most = 0;
    for (std::size_t i = 0; i < outcome.values.size(); ++i) {
        const double distance = outcome.values[i];
        if (truth.answers[i]) {
            positive_count += distance > 0;
        } else {
            zero_count += !(distance > 0);
            most = std::max(most, distance);
        }
    }
    return {maker.name, workload.name, fmt::format("{}", zero_count), fmt::format("{}", positive_count),
            fmt::format("{:.2g}", most / radius_of(*workload.meshes[0].mesh))};
}

}  // namespace

Table distance_table(std::span<const scenes::MeshPairs> workloads, std::span<const NarrowTruth> truth,
                     std::span<const NarrowMaker> makers) {
    Table table;
    table.title = "Distances reported at these gaps";
    table.text_columns = 2;
    table.header = {"engine", "gap in radii", "0 where apart", "more than 0 where they touch", "most where apart"};
    for (const NarrowMaker& maker : makers) {
        for (std::size_t i = 0; i < workloads.size(); ++i) {
            process::Contained child([&] { return start_distances(maker, workloads[i]); }, distance_limit);
            const process::Outcome outcome = child.run();
            if (outcome.is_right() && outcome.values.empty()) break;
            table.rows.push_back(row_of(maker, workloads[i], truth[i], outcome));
        }
    }
    table.notes = {
        "The last column in radii: the gap is along a line on which the two touch, so that the true distance is at "
        "most "
        "the gap, but for the rounding of positions. Engines that report no distance are not listed, ECoDS among "
        "them."};
    return table;
}

}  // namespace ecods::bench
