// The work of first hits.
#include <gtest/gtest.h>

#include "ecods/hit.hpp"
#include "scenes/segment_workloads.hpp"
#include "unit/query/golden.hpp"

namespace ecods {
namespace {

// Hits, tests of boxes and of triangles, enclosures and exact hits.
const std::vector<Golden> golden = {
    {"torus 10k, chords", {7, 59, 125, 6, 7}},
    {"torus 10k, probes", {20, 105, 294, 22, 20}},
    {"torus 10k, near vertices", {20, 100, 444, 136, 115}},
    {"torus 10k, near edges", {20, 108, 434, 60, 41}},
    {"torus 10k, through vertices", {20, 105, 482, 39, 20}},
    {"torus 10k, through edges", {20, 91, 285, 39, 20}},
    {"torus 10k, along edges", {20, 124, 421, 102, 41}},
    {"torus 10k, haptic probe", {1, 17, 56, 2, 1}},
    {"soup 2k, chords", {15, 69, 2248, 15, 15}},
};

TEST(HitCounts, WorkIsWhatItWas) {
    std::vector<Golden> actual;
    for (const scenes::SegmentWorkload& workload : scenes::segment_workloads(scenes::WorkloadSize::tiny)) {
        if (workload.bodies.size() > 1) continue;
        const MeshShape shape(workload.meshes.front().mesh);
        QueryMemory memory;
        PairWitness witness;
        std::uint64_t hits = 0;
        for (const Segment& segment : workload.queries) {
            hits += first_hit(segment, {shape, workload.bodies.front().pose}, {memory, witness}).has_value();
        }
        const HitCounts& counts = memory.counts().hits;
        actual.push_back(
            {workload.name, {hits, memory.counts().box_tests, counts.triangle_tests, counts.enclosures, counts.exact}});
    }
    EXPECT_EQ(actual, golden);
}

}  // namespace
}  // namespace ecods
