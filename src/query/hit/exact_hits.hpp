// exact_hits() finds all hits of a line with one body, with the exact parameters of the hits.
#pragma once

#include <vector>

#include "ecods/hit.hpp"
#include "exact/measure/round/fraction.hpp"
#include "exact/number/integer.hpp"
#include "geometry/line.hpp"

namespace ecods {

// A LongFraction is a fraction >= 0 of any length.
struct LongFraction {
    exact::Integer num, den{std::int64_t{1}};

    exact::FractionRef ref() const noexcept { return {num.limbs(), den.limbs()}; }
    friend int compare(const LongFraction& x, const LongFraction& y) noexcept {
        return exact::compare(x.ref(), y.ref());
    }
};

// An ExactHit is a hit, rounded once, and the real parameters of its first and last shared point.
struct ExactHit {
    Hit hit;
    LongFraction enter, leave;
};

// Returns the hits of all triangles of the surface, ascending by real parameter, then by triangle. The ranks of the
// hits are set.
std::vector<ExactHit> exact_hits(const Line& line, const Posed<MeshShape>& body, QueryMemory& memory);

}  // namespace ecods
