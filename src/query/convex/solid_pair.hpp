// Answers the questions that lists of many pairs of convex solids ask of each pair, with no work beyond the answer.
#pragma once

#include <cstddef>
#include <optional>

#include "ecods/pose.hpp"
#include "ecods/shape.hpp"
#include "ecods/solid.hpp"

namespace ecods::convex {

// True if R is not singular, so that a posed solid has a volume.
bool is_regular(const Pose& pose);

// Addresses of the data of a solid that a query reads, to prefetch them. Only a hint.
struct SolidInMemory {
    const void* parts = nullptr;
    const double* points = nullptr;
    std::size_t point_count = 0;

    SolidInMemory() = default;
    explicit SolidInMemory(const ConvexSolid& solid) noexcept;
    void prefetch() const noexcept;

    // Prefetch what the constructor reads: first a solid, or null; when it has arrived, its parts.
    static void prefetch_solid(const ConvexSolid* solid) noexcept;
    static void prefetch_parts(const ConvexSolid& solid) noexcept;
};

// The distance, rounded once, if the real distance is at most `limit`; otherwise nullopt. `limit` must be >= 0, or
// infinity. Throws SingularPose.
std::optional<double> distance_within(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, double limit,
                                      QueryMemory& memory);

// True if the solids share a point. Throws SingularPose.
bool do_meet(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, QueryMemory& memory);

}  // namespace ecods::convex
