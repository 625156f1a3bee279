// What every question about two rounded bodies must say, as the oracle has it of surfaces' cores.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "ecods/rounded.hpp"
#include "oracle/rounded.hpp"

namespace ecods::rounded_bodies {

constexpr double infinity = std::numeric_limits<double>::infinity();
using Ball = std::shared_ptr<const Rounded>;

inline Ball around(const std::shared_ptr<const Mesh>& mesh, double radius) {
    return std::make_shared<const Rounded>(std::make_shared<const MeshShape>(mesh), radius);
}

inline oracle::ExactClosest closest_of_cores(const Posed<Rounded>& a, const Posed<Rounded>& b) {
    const auto soup = [](const Posed<Rounded>& body) {
        const Mesh& mesh = body.what->core().mesh();
        return oracle::Soup{mesh.vertices(), mesh.triangles(), body.pose};
    };
    return oracle::MeshDistances(soup(a), soup(b)).closest();
}

// Expects the answers in one order of the bodies.
inline void expect_as_oracle(const Posed<Rounded>& a, const Posed<Rounded>& b, const Ask& ask = {}) {
    const oracle::ExactClosest cores = closest_of_cores(a, b);
    const oracle::RoundedDistance truth(cores, a.what->radius(), b.what->radius());
    const double expected = truth.distance();
    EXPECT_EQ(intersects(a, b, ask), truth.compare(0) <= 0);
    EXPECT_EQ(distance(a, b, ask), expected);
    EXPECT_EQ(within(a, b, 0, ask), truth.compare(0) <= 0);
    for (const double d : {expected, expected / 2, std::nextafter(expected, 0), std::nextafter(expected, infinity)}) {
        if (d < infinity) {
            EXPECT_EQ(within(a, b, d, ask), truth.compare(d) <= 0) << d;
        }
    }
    for (const DistanceTolerance& tolerance :
         {DistanceTolerance{}, {.relative = 0.25}, {.absolute = 0.5}, {.max_distance = expected / 2}}) {
        const DistanceBounds bounds = distance_bounds(a, b, tolerance, ask);
        EXPECT_TRUE(bounds.lower <= 0 || truth.compare(bounds.lower) >= 0) << bounds.lower;
        EXPECT_TRUE(bounds.upper == infinity || truth.compare(bounds.upper) <= 0);
        const bool is_far = bounds.lower > tolerance.max_distance;
        const double width = std::max(tolerance.absolute, tolerance.relative * bounds.lower);
        EXPECT_TRUE(is_far || bounds.upper - bounds.lower <= width * (1 + 0x1p-50) ||
                    bounds.upper <= std::nextafter(bounds.lower, infinity))
            << bounds.lower << ", " << bounds.upper;
    }
    const ClosestPoints points = closest(a, b, ask);
    EXPECT_EQ(points.distance, expected);
    EXPECT_EQ(static_cast<int>(points.kind), static_cast<int>(cores.kind));
    if (cores.distance.is_zero()) return;
    EXPECT_EQ(points.point_a, truth.point(0));
    EXPECT_EQ(points.point_b, truth.point(1));
    if (truth.compare(0) == 0) {
        EXPECT_EQ(points.point_a, points.point_b);
    }
}

// Expects the answers in both orders, with one witness all along and with none.
inline void expect_right(const Posed<Rounded>& a, const Posed<Rounded>& b) {
    PairWitness witness;
    QueryMemory memory;
    expect_as_oracle(a, b);
    expect_as_oracle(b, a, memory);
    expect_as_oracle(a, b, {memory, witness});
    expect_as_oracle(a, b, {memory, witness});
}

}  // namespace ecods::rounded_bodies
