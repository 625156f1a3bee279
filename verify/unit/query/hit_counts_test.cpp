// The work of hits, exactly: who changes a tree, a bound or the order of the walk sees here what it costs.
#include <gtest/gtest.h>

#include <cstdint>

#include "ecods/hit.hpp"
#include "scenes/segment_workloads.hpp"

namespace ecods {
namespace {

struct Golden {
    const char* workload;
    std::uint64_t hits, box_tests, triangle_tests, enclosures, exact;
};

std::ostream& operator<<(std::ostream& out, const Golden& g) {
    return out << "{\"" << g.workload << "\", " << g.hits << ", " << g.box_tests << ", " << g.triangle_tests << ", "
               << g.enclosures << ", " << g.exact << "}";
}

constexpr Golden golden[] = {
    {"", 0, 0, 0, 0, 0},
};

TEST(HitCounts, WorkIsWhatItWas) {
    std::size_t at = 0;
    for (const scenes::SegmentWorkload& workload : scenes::segment_workloads(scenes::WorkloadSize::tiny)) {
        if (workload.bodies.size() > 1) continue;
        const MeshShape shape(workload.meshes.front().mesh);
        QueryMemory memory;
        PairWitness witness;
        std::uint64_t hits = 0;
        for (const Segment& segment : workload.segments) {
            hits += first_hit(segment, {shape, workload.bodies.front().pose}, memory, witness).has_value();
        }
        const HitCounts& counts = memory.counts().hits;
        const Golden actual{workload.name.c_str(), hits,        memory.counts().box_tests, counts.triangle_tests,
                            counts.enclosures,     counts.exact};
        ASSERT_LT(at, std::size(golden)) << actual;
        EXPECT_STREQ(actual.workload, golden[at].workload);
        EXPECT_TRUE(actual.hits == golden[at].hits && actual.box_tests == golden[at].box_tests &&
                    actual.triangle_tests == golden[at].triangle_tests && actual.enclosures == golden[at].enclosures &&
                    actual.exact == golden[at].exact)
            << actual << " in place of " << golden[at];
        ++at;
    }
    EXPECT_EQ(at, std::size(golden));
}

}  // namespace
}  // namespace ecods
