#include "scenes/convex_workloads.hpp"

#include <gtest/gtest.h>

#include "ecods/distance.hpp"
#include "ecods/intersection.hpp"
#include "ecods/solid.hpp"

namespace ecods::scenes {
namespace {

TEST(ConvexWorkloads, AreWhatTheySay) {
    QueryMemory memory;
    std::size_t distance_count = 0;
    for (const ConvexWorkload& workload : convex_workloads(WorkloadSize::tiny)) {
        ASSERT_EQ(workload.queries.size(), 3u);
        for (const auto& [a, b] : workload.queries) {
            const Solid solid_a(workload.meshes[a.mesh_index].mesh), solid_b(workload.meshes[b.mesh_index].mesh);
            const Posed<Solid> posed_a(solid_a, a.pose), posed_b(solid_b, b.pose);
            const Relation relation = ecods::relation(posed_a, posed_b, memory);
            if (workload.question == ConvexQuestion::distance) {
                ++distance_count;
                const double d = distance(posed_a, posed_b, memory);
                EXPECT_GT(d, workload.nominal) << workload.name;
                EXPECT_LT(d, 1.01 * workload.nominal) << workload.name;
                EXPECT_EQ(relation, Relation::apart);
            } else {
                EXPECT_NE(relation, Relation::apart) << workload.name;
                EXPECT_NE(relation, Relation::touching) << workload.name;
            }
        }
    }
    EXPECT_EQ(distance_count, 18u);
}

}  // namespace
}  // namespace ecods::scenes
