// The work of casts by a translation, exactly, as golden_counts_test.cpp has it of other questions.
#include <gtest/gtest.h>

#include <deque>

#include "ecods/cast.hpp"
#include "scenes/cast_workloads.hpp"
#include "unit/query/golden.hpp"

namespace ecods {
namespace {

// Contacts, tests of boxes, enclosures and exact times.
const std::vector<Golden> golden = {
    {"ship, to a gap of 1e-4", {0, 39, 87, 0}},  {"ship, to a gap of 1e-12", {0, 54, 86, 0}},
    {"ship, into contact", {3, 62, 67, 3}},      {"ship, grazing", {2, 31, 128, 2}},
    {"ball, to a gap of 1e-4", {0, 60, 117, 0}}, {"ball, to a gap of 1e-12", {0, 59, 105, 0}},
    {"ball, into contact", {3, 55, 109, 3}},     {"ball, grazing", {2, 87, 122, 2}},
};

TEST(Cast, WorkIsWhatItWas) {
    std::vector<Golden> actual;
    for (const scenes::CastWorkload& workload : scenes::cast_workloads(scenes::WorkloadSize::tiny)) {
        if (!workload.is_translation) continue;
        std::deque<MeshShape> shapes;
        for (const scenes::NamedMesh& named : workload.meshes) shapes.emplace_back(named.mesh);
        QueryMemory memory;
        std::uint64_t contacts = 0;
        for (const scenes::CastQuery& query : workload.queries) {
            contacts += cast({shapes[query.a.mesh_index], query.a.pose}, query.motion,
                             {shapes[query.b.mesh_index], query.b.pose}, 1, memory)
                            .has_value();
        }
        const QueryCounts& counts = memory.counts();
        EXPECT_EQ(counts.queries, workload.queries.size());
        actual.push_back({workload.name, {contacts, counts.box_tests, counts.casts.enclosures, counts.casts.exact}});
    }
    EXPECT_EQ(actual, golden);
}

}  // namespace
}  // namespace ecods
