// Declares the functions for two convex solids: distance, closest points and comparisons of the distance with a limit.
// All functions throw SingularPose.
#pragma once

#include <cstddef>
#include <optional>

#include "ecods/ask.hpp"
#include "ecods/pose.hpp"
#include "ecods/results.hpp"
#include "ecods/shape.hpp"
#include "exact/measure/round/rounded_ends.hpp"
#include "exact/number/exact_sum.hpp"

namespace ecods::convex {

// Returns true if R is not singular.
bool is_regular(const Pose& pose);

// A SolidInMemory holds addresses of a solid's data that a query reads, so that the data can be prefetched. Prefetching
// is only a hint.
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

// Returns the distance, rounded once. This function and the next ones start from the triangles of the witness, and
// leave triangles of the closest features in it.
double distance(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, QueryMemory& memory, PairWitness& witness);
// Returns the closest points; nullopt if the solids share a point. If radii are given, points and distance are those of
// the rounded solids.
std::optional<ClosestPoints> closest(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, QueryMemory& memory,
                                     PairWitness& witness, const exact::Radii& radii = {});
// Returns the distance minus the margin, rounded once; 0 if the margin is at least the distance.
double distance_beyond(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, const exact::ExactSum& margin,
                       QueryMemory& memory, PairWitness& witness);
// Returns true if the real distance is within the limit, which must not be zero.
bool within(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, const exact::Limit& limit, QueryMemory& memory,
            PairWitness& witness);

// Returns true if the real distance is at most `limit`, which must be >= 0 and may be infinity. Tries first whether the
// solids are further apart along `axis`, which may be any vector; zero stands for the direction between their centers.
// If a search finds the distance above the limit, sets `axis` to the direction from the first solid's closest point to
// the second's, along which their gap is their distance.
bool within(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, double limit, QueryMemory& memory,
            PairWitness& witness, Vec3& axis);

// Answer questions about many pairs of a list, without a witness. The first returns the distance, rounded once, if the
// real distance is at most `limit`; otherwise nullopt. `limit` must be >= 0, or infinity. The second returns true if
// the solids share a point.
std::optional<double> distance_within(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, double limit,
                                      QueryMemory& memory);

bool do_meet(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, QueryMemory& memory);

}  // namespace ecods::convex
