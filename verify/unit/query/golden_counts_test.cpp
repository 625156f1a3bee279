// The work of questions whether two bodies meet.
#include <gtest/gtest.h>

#include <deque>

#include "ecods/intersection.hpp"
#include "scenes/narrow_workloads.hpp"
#include "unit/query/golden.hpp"

namespace ecods {
namespace {

// Queries, hits, tests of boxes and of triangles.
const std::vector<Golden> golden = {
    {"ship, near", {20, 10, 352, 26}},        {"ship, random", {20, 3, 24, 7}},
    {"torus 10k, near", {4, 2, 244, 10}},     {"torus 10k, random", {4, 3, 39, 5}},
    {"Wuson, near", {4, 2, 98, 8}},           {"Wuson, random", {4, 1, 4, 1}},
    {"spider, near", {4, 2, 98, 18}},         {"spider, random", {4, 1, 42, 1}},
    {"stacked bricks", {12, 6, 18, 6}},       {"splined shaft in its hub", {4, 2, 1661, 3071}},
    {"flush boxes", {12, 6, 24, 34}},         {"flush plates", {4, 2, 16, 48}},
    {"100-gons in one plane", {4, 2, 24, 2}}, {"one triangle, near", {20, 10, 0, 20}},
    {"one triangle, random", {20, 1, 0, 20}},
};

TEST(NarrowPhase, WorkIsWhatItWas) {
    std::vector<Golden> actual;
    for (const scenes::MeshPairs& workload : scenes::narrow_workloads(scenes::WorkloadSize::tiny)) {
        std::deque<MeshShape> shapes;
        for (const scenes::NamedMesh& named : workload.meshes) shapes.emplace_back(named.mesh);
        QueryMemory memory;
        std::uint64_t hits = 0;
        for (const scenes::MeshQuery& query : workload.queries) {
            hits += intersects({shapes[query.a.mesh_index], query.a.pose}, {shapes[query.b.mesh_index], query.b.pose},
                               memory);
        }
        const QueryCounts& counts = memory.counts();
        actual.push_back({workload.name, {counts.queries, hits, counts.box_tests, counts.stages.triangle_tests}});
    }
    EXPECT_EQ(actual, golden);
}

}  // namespace
}  // namespace ecods
