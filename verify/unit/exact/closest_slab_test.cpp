// Pairs of triangles that lie on the two sides of the slab between two closest points are not nearer than these.

#include <gtest/gtest.h>

#include "exact/point/mesh_extent.hpp"
#include "query/distance/triangle_distances.hpp"
#include "scenes/distance_cases.hpp"

namespace ecods::closest_slab_test {
namespace {

struct Counts {
    std::uint64_t asked = 0, said = 0, ties = 0, ties_said = 0;
};

// Refers to each of some pairs of triangles, and asks about all.
void ask_all(const scenes::DistanceCase& c, Counts& counts) {
    const exact::MeshExtent extent_a = exact::measure(*c.a), extent_b = exact::measure(*c.b);
    TriangleDistances distances, truth;
    for (TriangleDistances* d : {&distances, &truth})
        d->bind({c.a.get(), &extent_a, &c.pose_a}, {c.b.get(), &extent_b, &c.pose_b});
    const auto count_a = static_cast<std::uint32_t>(c.a->triangles().size());
    const auto count_b = static_cast<std::uint32_t>(c.b->triangles().size());
    for (std::uint32_t r = 0; r < std::min(count_a, count_b); r += 5) {
        const TrianglePair reference{r, (7 * r) % count_b};
        distances.refer_to(reference);
        for (std::uint32_t i = 0; i < count_a; ++i) {
            for (std::uint32_t j = 0; j < count_b; ++j) {
                const bool is_not_nearer = distances.is_not_nearer({i, j});
                const int sign = truth.compare(TrianglePair{i, j}, reference);
                ASSERT_TRUE(!is_not_nearer || sign >= 0) << "triangles " << i << " and " << j << ", referred to " << r;
                ++counts.asked;
                counts.said += is_not_nearer;
                counts.ties += sign == 0;
                counts.ties_said += sign == 0 && is_not_nearer;
            }
        }
    }
}

TEST(ClosestSlab, NeverHidesANearerPair) {
    for (const auto& family : scenes::distance_families()) {
        scenes::Random random(17);
        Counts counts;
        for (int k = 0; k < 30 && counts.asked < 50000; ++k) {
            ask_all(family.make(random), counts);
            if (HasFatalFailure()) FAIL() << family.name << " " << k;
        }
        if (family.name != "bricks") continue;
        EXPECT_GT(counts.said, counts.asked / 10);
        EXPECT_GT(counts.ties_said, counts.ties / 4) << "of " << counts.ties;
    }
}

TEST(ClosestSlab, SaysNothingUntilItIsReferredTo) {
    scenes::Random random(1);
    const scenes::DistanceCase c = scenes::family_named(scenes::distance_families(), "apart").make(random);
    const exact::MeshExtent extent_a = exact::measure(*c.a), extent_b = exact::measure(*c.b);
    TriangleDistances distances;
    distances.bind({c.a.get(), &extent_a, &c.pose_a}, {c.b.get(), &extent_b, &c.pose_b});
    EXPECT_FALSE(distances.is_not_nearer({0, 0}));
    distances.refer_to({0, 0});
    EXPECT_EQ(distances.is_not_nearer({0, 0}), distances.can_refer());
    distances.bind({c.a.get(), &extent_a, &c.pose_a}, {c.b.get(), &extent_b, &c.pose_b});
    EXPECT_FALSE(distances.is_not_nearer({0, 0}));
}

}  // namespace
}  // namespace ecods::closest_slab_test
