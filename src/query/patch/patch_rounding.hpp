// This header rounds the points and the gaps of a patch's corners; each number is rounded once.
#pragma once

#include "ecods/contact.hpp"
#include "exact/measure/round/rounded_ends.hpp"
#include "query/patch/seen_along.hpp"

namespace ecods::patches {

// Reach holds the sum of the radii of two rounded bodies, and the lengths by which the points of a corner, and their
// middle, move along the normal from their places on the cores.
struct Reach {
    explicit Reach(const exact::Radii& radii)
        : sum(radii.sum()), of_a(radii.a), of_b(-ScaledInteger(radii.b)), of_middle(half_of(of_a + of_b)) {}

    exact::ExactSum sum;
    ScaledInteger of_a, of_b, of_middle;

  private:
    static ScaledInteger half_of(const ScaledInteger& x) { return {x.m(), x.e() - 1}; }
};

// Sets both points and the middle of the corner that the features of `pair`, which have the least difference, make.
// `normal` is used only if a radius is not 0.
void round_least(convex::PosedHulls& hulls, const HullFeaturePair& pair, const Reach& reach, const ExactNormal& normal,
                 PatchCorner& corner);

// Sets both points, the middle and the gap of a corner with the exact position `exact`.
void round_corner(const LongCorner& exact, const Reach& reach, const ExactNormal& normal, PatchCorner& corner);

// Returns the sign of (gap of the cores) - (sum of the radii) - d, for a finite d.
int compare_gap(const LongCorner& exact, const Reach& reach, const ExactNormal& normal, double d);

}  // namespace ecods::patches
