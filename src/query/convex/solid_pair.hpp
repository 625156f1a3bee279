// What lists of many pairs of convex solids ask of each: no more is found out of a pair that is not in the list.
#pragma once

#include <cstddef>
#include <optional>

#include "ecods/convex_solid.hpp"
#include "ecods/pose.hpp"

namespace ecods::convex {

// Whether a solid has a volume at a pose: R is not singular.
bool is_regular(const Pose& pose);

// Where what a question reads of a solid is in memory; and asks for it ahead of the question. No more than a hint.
struct SolidInMemory {
    const void* parts = nullptr;
    const double* points = nullptr;
    std::size_t point_count = 0;

    SolidInMemory() = default;
    explicit SolidInMemory(const ConvexSolid& solid) noexcept;
    void prefetch() const noexcept;

    // What the constructor reads: a solid first, or null, and when that has come, its parts.
    static void prefetch_solid(const ConvexSolid* solid) noexcept;
    static void prefetch_parts(const ConvexSolid& solid) noexcept;
};

// The distance, rounded once, if the real one is at most the limit. Throws SingularPose. limit >= 0, or infinity.
std::optional<double> distance_within(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, double limit,
                                      QueryMemory& memory);

// Whether the sets share a point. Throws SingularPose.
bool do_meet(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, QueryMemory& memory);

}  // namespace ecods::convex
