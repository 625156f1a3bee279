// Answers the questions that lists of many pairs of convex solids ask about each pair, without any other work.
#pragma once

#include <cstddef>
#include <optional>

#include "ecods/pose.hpp"
#include "ecods/shape.hpp"
#include "ecods/solid.hpp"

namespace ecods::convex {

// True if R is not singular. The posed solid then has a volume.
bool is_regular(const Pose& pose);

// Holds addresses of a solid's data that a query reads, so that the data can be prefetched. It is only a hint.
struct SolidInMemory {
    const void* parts = nullptr;
    const double* points = nullptr;
    std::size_t point_count = 0;

    SolidInMemory() = default;
    explicit SolidInMemory(const ConvexSolid& solid) noexcept;
    void prefetch() const noexcept;

    // Prefetch the data that the constructor reads. First call prefetch_solid() (null is allowed); when that data has
    // arrived, call prefetch_parts().
    static void prefetch_solid(const ConvexSolid* solid) noexcept;
    static void prefetch_parts(const ConvexSolid& solid) noexcept;
};

// Returns the distance, rounded once, if the real distance is at most `limit`; otherwise nullopt. `limit` must be >= 0;
// it may be infinity. Throws SingularPose.
std::optional<double> distance_within(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, double limit,
                                      QueryMemory& memory);

// True if the solids share a point. Throws SingularPose.
bool do_meet(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, QueryMemory& memory);

}  // namespace ecods::convex
