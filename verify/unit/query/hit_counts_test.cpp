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
    {"torus 10k, chords", 7, 59, 125, 6, 7},
    {"torus 10k, probes", 20, 105, 294, 22, 20},
    {"torus 10k, near vertices", 20, 100, 444, 136, 115},
    {"torus 10k, near edges", 20, 108, 434, 60, 41},
    {"torus 10k, through vertices", 20, 105, 482, 39, 20},
    {"torus 10k, through edges", 20, 91, 285, 39, 20},
    {"torus 10k, along edges", 20, 124, 421, 102, 41},
    {"torus 10k, haptic probe", 1, 17, 56, 2, 1},
    {"soup 2k, chords", 15, 69, 2248, 15, 15},
};

TEST(HitCounts, WorkIsWhatItWas) {
    std::size_t at = 0;
    for (const scenes::SegmentWorkload& workload : scenes::segment_workloads(scenes::WorkloadSize::tiny)) {
        if (workload.bodies.size() > 1) continue;
        const MeshShape shape(workload.meshes.front().mesh);
        QueryMemory memory;
        PairWitness witness;
        std::uint64_t hits = 0;
        for (const Segment& segment : workload.queries) {
            hits += first_hit(segment, {shape, workload.bodies.front().pose}, memory, witness).has_value();
        }
        const HitCounts& counts = memory.counts().hits;
        const Golden actual{workload.name.c_str(), hits,        memory.counts().box_tests, counts.triangle_tests,
                            counts.enclosures,     counts.exact};
        const Golden expected = at < std::size(golden) ? golden[at] : Golden{"none", 0, 0, 0, 0, 0};
        EXPECT_STREQ(actual.workload, expected.workload);
        EXPECT_TRUE(actual.hits == expected.hits && actual.box_tests == expected.box_tests &&
                    actual.triangle_tests == expected.triangle_tests && actual.enclosures == expected.enclosures &&
                    actual.exact == expected.exact)
            << actual << " in place of " << expected;
        ++at;
    }
    EXPECT_EQ(at, std::size(golden));
}

}  // namespace
}  // namespace ecods
