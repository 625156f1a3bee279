// The oracle's answers for a whole scene, and how an engine's compare with them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "ecods/ids.hpp"
#include "ecods/results.hpp"
#include "engines/frame_engine.hpp"
#include "harness/differences.hpp"
#include "scenes/scene.hpp"

namespace ecods::bench {

// How two bodies that share a point meet.
struct Contact {
    Relation relation = Relation::touching;
    std::vector<TrianglePair> triangles;  // all that share a point, ascending; a belongs to the body of lower index
};

// A pair that shares a point in one frame.
struct TrueHit {
    IndexPair pair;
    std::shared_ptr<const Contact> contact;  // null unless asked for
};

struct Truth {
    std::vector<std::vector<TrueHit>> hits;  // [frame], ascending
    std::uint64_t pair_count = 0;            // pairs of bodies answered, all frames
    std::uint64_t exact_count = 0;  // of these, given to the oracle's triangle tests; the rest by certified boxes
    double seconds = 0;

    std::vector<IndexPair> pairs_of(std::size_t frame) const;
};

enum class Detail { hits_only, contacts };

// Every pair of bodies in every frame. Pairs whose certified boxes do not overlap are no hits; a pair of which neither
// body moved keeps its answer, which depends on poses and meshes alone. Works in as many threads as the machine has.
Truth ask_oracle(const scenes::Scene& scene, Detail detail, const std::string& label);

// The lists of all frames beside the oracle's.
Errors compare(std::span<const std::vector<IndexPair>> reported, const Truth& truth);

}  // namespace ecods::bench
