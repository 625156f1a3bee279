// The work of queries, exactly: who changes a tree, a bound or the order of a search sees here what it costs.

#include <gtest/gtest.h>

#include <deque>

#include "ecods/intersection.hpp"
#include "scenes/narrow_workloads.hpp"

namespace ecods {
namespace {

struct Golden {
    const char* workload;
    std::uint64_t queries, hits, box_tests, triangle_tests;
};

std::ostream& operator<<(std::ostream& out, const Golden& g) {
    return out << "{\"" << g.workload << "\", " << g.queries << ", " << g.hits << ", " << g.box_tests << ", "
               << g.triangle_tests << "}";
}

constexpr Golden golden[] = {
    {"ship, near", 20, 10, 352, 26},        {"ship, random", 20, 3, 24, 7},
    {"torus 10k, near", 4, 2, 244, 10},     {"torus 10k, random", 4, 3, 39, 5},
    {"Wuson, near", 4, 2, 98, 8},           {"Wuson, random", 4, 1, 4, 1},
    {"spider, near", 4, 2, 98, 18},         {"spider, random", 4, 1, 42, 1},
    {"stacked bricks", 12, 6, 18, 6},       {"splined shaft in its hub", 4, 2, 1661, 3071},
    {"flush boxes", 12, 6, 24, 34},         {"flush plates", 4, 2, 16, 48},
    {"100-gons in one plane", 4, 2, 24, 2}, {"one triangle, near", 20, 10, 0, 20},
    {"one triangle, random", 20, 1, 0, 20},
};

TEST(NarrowPhase, WorkIsWhatItWas) {
    std::size_t at = 0;
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
        const Golden actual{workload.name.c_str(), counts.queries, hits, counts.box_tests,
                            counts.stages.triangle_tests};
        ASSERT_LT(at, std::size(golden)) << actual;
        EXPECT_STREQ(actual.workload, golden[at].workload);
        EXPECT_TRUE(actual.queries == golden[at].queries && actual.hits == golden[at].hits &&
                    actual.box_tests == golden[at].box_tests && actual.triangle_tests == golden[at].triangle_tests)
            << actual << " in place of " << golden[at];
        ++at;
    }
    EXPECT_EQ(at, std::size(golden));
}

}  // namespace
}  // namespace ecods
