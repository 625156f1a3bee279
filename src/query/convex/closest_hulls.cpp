#include <optional>

#include "query/convex/closest_hulls.hpp"
#include "query/convex/gjk.hpp"
#include "query/convex/posed_hulls.hpp"

namespace ecods {
namespace {

using namespace convex;

// Set the witness to a triangle of each solid at its closest feature, or at a vertex near it.
void leave(const PosedHulls& hulls, const Simplex& guess, PairWitness& witness) noexcept {
    witness = {hulls.hull(0).vertex_names[guess.pairs[0][0]].triangle,
               hulls.hull(1).vertex_names[guess.pairs[0][1]].triangle};
}
void leave(const PosedHulls& hulls, const ClosestHulls& closest, PairWitness& witness) noexcept {
    witness = {name_of(hulls.hull(0), closest.part(hulls, 0)).triangle,
               name_of(hulls.hull(1), closest.part(hulls, 1)).triangle};
}

}  // namespace

// Tries the witness's triangles first. The features that they suggest are proven like any others.
std::optional<ClosestHulls> convex::find_closest(PosedHulls& hulls, PairWitness* witness) {
    if (witness == nullptr || !is_known(*witness)) return find_closest(hulls, between_centers(hulls), witness);
    const Simplex guess =
        run_gjk_of_triangles(hulls, {hulls.vertices_near(0, witness->a), hulls.vertices_near(1, witness->b)});
    if (auto proven = prove_closest(hulls, guess)) return proven;
    return find_closest(hulls, guess, witness);
}

std::optional<ClosestHulls> convex::find_closest(PosedHulls& hulls, const Simplex& start, PairWitness* witness) {
    const Simplex guess = run_gjk(hulls, start);
    if (witness != nullptr) leave(hulls, guess, *witness);
    if (prove_meeting(hulls, guess)) return std::nullopt;
    std::optional<ClosestHulls> closest = prove_closest(hulls, guess);
    if (!closest) closest = find_closest_exactly(hulls, guess);
    if (closest && witness != nullptr) leave(hulls, *closest, *witness);
    return closest;
}

}  // namespace ecods
