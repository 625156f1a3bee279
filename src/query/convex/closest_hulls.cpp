#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include "query/convex/closest_hulls.hpp"
#include "query/convex/gjk.hpp"
#include "query/convex/gjk_rounds.hpp"
#include "query/convex/posed_hulls.hpp"

namespace ecods {
namespace {

using namespace convex;
using exact::FixedClosest;
using exact::PosedFeature;

// Set the witness to a triangle of each solid that has a vertex of the closest feature, or a vertex near this feature.
void leave(const PosedHulls& hulls, const Simplex& guess, PairWitness& witness) noexcept {
    witness = {hulls.hull(0).vertex_names[guess.pairs[0][0]].triangle,
               hulls.hull(1).vertex_names[guess.pairs[0][1]].triangle};
}
void leave(const PosedHulls& hulls, const ClosestHulls& closest, PairWitness& witness) noexcept {
    witness = {name_of(hulls.hull(0), closest.part(hulls, 0)).triangle,
               name_of(hulls.hull(1), closest.part(hulls, 1)).triangle};
}

PosedFeature posed_feature(const PosedHulls& hulls, std::size_t side, std::span<const std::uint32_t> corners) {
    PosedFeature result{hulls.reference({side, corners[0]}).pose, {}, corners.size()};
    for (std::size_t i = 0; i < corners.size(); ++i) result.corners[i] = hulls.reference({side, corners[i]}).v;
    return result;
}

FixedClosest::Names names_of(const PosedHulls& hulls, const HullFeaturePair& parts) noexcept {
    return {{}, name_of(hulls.hull(0), parts[0]), name_of(hulls.hull(1), parts[1])};
}

// Runs GJK from `start`, and tries to prove the closest features, or the common point, that GJK found.
QuickClosest run(PosedHulls& hulls, const Simplex& start) {
    QuickClosest result{run_gjk(hulls, start), std::nullopt, false};
    result.do_meet = prove_meeting(hulls, result.guess);
    if (!result.do_meet) result.closest = prove_closest(hulls, result.guess);
    return result;
}

std::optional<ClosestHulls> finish(PosedHulls& hulls, QuickClosest found, PairWitness* witness) {
    if (witness != nullptr) leave(hulls, found.guess, *witness);
    if (!found.do_meet && !found.closest) found.closest = find_closest_exactly(hulls, found.guess);
    if (found.closest && witness != nullptr) leave(hulls, *found.closest, *witness);
    return std::move(found.closest);
}

}  // namespace

std::optional<FixedClosest> convex::find_fixed(const PosedHulls& hulls, const ClosestHulls& closest,
                                               const exact::Radii& radii) {
    if (!closest.are_only) return std::nullopt;
    const auto of = [&](std::size_t side) { return posed_feature(hulls, side, closest.found.of_side(side)); };
    return FixedClosest::of_features({of(0), of(1)}, radii,
                                     names_of(hulls, {closest.part(hulls, 0), closest.part(hulls, 1)}));
}

// Tries the parallelograms that corners of the face make with their two neighbors, until one contains the foot
// (FixedClosest::Foot). The first one contains all feet if the face is a triangle or a parallelogram; otherwise few are
// tried.
std::optional<FixedClosest> convex::find_fixed(const PosedHulls& hulls, const HullFeaturePair& parts,
                                               const exact::Radii& radii) {
    constexpr std::size_t tries_max = 4;
    const HullFeatures found = features_of(hulls, parts);
    const FixedClosest::Names names = names_of(hulls, parts);
    std::array<PosedFeature, 2> features{posed_feature(hulls, 0, found.of_side(0)),
                                         posed_feature(hulls, 1, found.of_side(1))};
    const std::size_t face = parts[0].kind == Feature::Kind::face ? 0 : 1;
    if (parts[face].kind != Feature::Kind::face) return FixedClosest::of_features(features, radii, names);
    const auto cycle = hulls.hull(face).cycle_of(parts[face].index);
    for (std::size_t i = 0; i < std::min(cycle.size() - 2, tries_max); ++i) {
        const std::array<std::uint32_t, 3> corners{cycle[i + 1].vertex, cycle[i].vertex, cycle[i + 2].vertex};
        features[face] = posed_feature(hulls, face, corners);
        if (auto fixed = FixedClosest::of_features(features, radii, names, FixedClosest::Foot::in_face)) return fixed;
    }
    return std::nullopt;
}

// Tries first the closest features of the witness's two triangles. They are proven like any other features.
QuickClosest convex::find_quickly(PosedHulls& hulls, const PairWitness* witness) {
    if (witness == nullptr || !is_known(*witness)) return run(hulls, between_centers(hulls));
    const Simplex guess =
        run_gjk_of_triangles(hulls, {hulls.vertices_near(0, witness->a), hulls.vertices_near(1, witness->b)});
    if (auto proven = prove_closest(hulls, guess)) return {guess, std::move(proven), false};
    return run(hulls, guess);
}

bool convex::QuickClosest::may_touch(const PosedHulls& hulls) const noexcept {
    const double size = 0x1p-20 * (hulls.size(0) + hulls.size(1));
    return !do_meet && !closest && !(gjk::find_nearest(guess).square > size * size);
}

std::optional<ClosestHulls> convex::find_closest(PosedHulls& hulls, const QuickClosest& found, PairWitness* witness) {
    return finish(hulls, found, witness);
}
std::optional<ClosestHulls> convex::find_closest(PosedHulls& hulls, PairWitness* witness) {
    return finish(hulls, find_quickly(hulls, witness), witness);
}
std::optional<ClosestHulls> convex::find_closest(PosedHulls& hulls, const Simplex& start, PairWitness* witness) {
    return finish(hulls, run(hulls, start), witness);
}

}  // namespace ecods
