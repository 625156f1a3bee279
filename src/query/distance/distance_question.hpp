// DistanceQuestion is the PairQuestion (query/search) whose numbers are the distances of pairs of triangles.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "bvh/axes/distance_axes.hpp"
#include "bvh/axes/far_gap.hpp"
#include "bvh/masks/triangle_bounds.hpp"
#include "query/distance/triangle_distances.hpp"
#include "query/search/search.hpp"

namespace ecods {

class DistanceQuestion {
  public:
    using Interval = DistanceInterval;
    using Value = double;
    using Search = ecods::Search<DistanceQuestion>;

    // Binds the question to two bodies. Everything that the arguments refer to must outlive this object. No pair is
    // excluded until exclude() is called.
    void bind(const MeshPair& bodies, QueryCounts& counts);
    // Lets the search exclude pairs that are certainly not nearer than another pair, if the coordinates allow it. Call
    // exclude() only if the query needs the least distance alone, not all pairs that have it.
    void exclude() noexcept { excludes_ = pair_.can_refer(); }

    // Returns true if the bodies are so far apart that floats can order nodes only by their positions along the gap.
    bool is_far() const noexcept { return far_.is_far(); }
    // Returns two triangles that are probably among the nearest, by descending from the roots.
    TrianglePair dive(const MeshPair& bodies);
    TriangleDistances& pair() noexcept { return pair_; }
    // Counts one exact operation, and returns the object that performs it. Call it once for each rounding or
    // comparison.
    TriangleDistances& exact_pair() noexcept {
        ++counts_->distances.exact;
        return pair_;
    }

    // The search calls the following functions. Bounds are squared distances, or FarGap's ranks if the bodies are far
    // apart.
    float limit_above(double distance) const noexcept {
        return is_far() ? far_.rank_above(distance) : axes_.square_above(distance);
    }
    template <class X, class Y>
    std::uint64_t find_near(const X& x, const Y& y, float limit, LaneBounds& bounds) const noexcept {
        return is_far() ? far_mask(far_, limit, x, y, bounds)
                        : near_mask(axes_.sets(), direction_, limit, x, y, bounds);
    }
    bool may_share(float bound) const noexcept { return !(bound > 0) && !is_far(); }
    DistanceInterval enclose(const TrianglePair& triangles, double at_most);
    bool complete(const TrianglePair&, DistanceInterval&, std::optional<double>&) const noexcept { return true; }
    bool refer_to(const TrianglePair& triangles);
    bool is_not_less(const TrianglePair& triangles) { return pair_.is_not_nearer(triangles); }
    void gather(Search& search, const TreeLeaf& x, const TreeLeaf& y, LanePairs lanes, const LaneBounds& bounds);
    void advance(Search& search, float bound);

  private:
    struct Candidate {
        float lower;  // squared distance, in units of the axes
        TrianglePair triangles;
    };

    void bound_batch(Search& search);
    void enclose_candidates(Search& search);
    void take(Search& search, std::size_t lane);
    void set_direction(std::size_t lane);

    TriangleDistances pair_;
    DistanceAxes axes_;
    FarGap far_;
    QueryCounts* counts_ = nullptr;
    bool excludes_ = false;
    std::optional<TrianglePair> referred_;  // the pair with which pair_ compares others
    // Holds the approximate direction, in floats, from a triangle of body a to a triangle of body b: the nearest two
    // triangles so far. `direction_square_` is their squared distance on the axes of the first set.
    Direction direction_{};
    float direction_square_ = std::numeric_limits<float>::infinity();
    LeavesOnAxes leaves_{};
    TriangleBatch batch_{};
    TriangleSquares squares_{};
    std::vector<Candidate> candidates_;  // pairs that doubles have not enclosed yet
};

}  // namespace ecods
