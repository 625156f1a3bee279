// The search for the closest triangles of two posed meshes: a walk of both trees, nearest nodes first, that leaves a
// few pairs of triangles among which the exact distance decides.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "base/double_key.hpp"
#include "bvh/axes/distance_axes.hpp"
#include "bvh/axes/far_gap.hpp"
#include "bvh/masks/triangle_bounds.hpp"
#include "bvh/walks/walk_nearest.hpp"
#include "bvh/walks/walk_two.hpp"
#include "ecods/distance.hpp"
#include "query/distance/triangle_distances.hpp"
#include "query/intersection/query_memory.hpp"
#include "query/shape/mesh_tree.hpp"

namespace ecods {

// What a search may leave out, and when it may stop. Its answer is among pairs whose distance is at most `at_most`; of
// others it says no more than that they are farther.
struct DistanceGoal {
    double at_most = std::numeric_limits<double>::infinity();
    double stop_at = -1;  // as soon as some pair is proven not to be farther
    // Pairs less than that nearer than the nearest one found may be left out; see DistanceSearch::floor.
    double relative = 0;
    double absolute = 0;
};

// What is left of a pair that was apart: no triangle, and an axis (query/intersection). One that was not within a
// distance is asked from its roots on next time, since two triangles would be measured in vain.
inline constexpr PairWitness apart_witness{.a = PairWitness::none, .b = 0};
constexpr bool is_apart(const PairWitness& witness) noexcept {
    return witness.a == PairWitness::none && witness.b != PairWitness::none;
}

// A pair of triangles that the doubles leave open.
struct OpenPair {
    DistanceInterval interval;
    TrianglePair triangles;
};

class DistanceSearch {
  public:
    // Everything that the arguments refer to must outlive the search.
    DistanceSearch(const Posed<MeshShape>& a, const Posed<MeshShape>& b, QueryMemory& memory);
    ~DistanceSearch();
    DistanceSearch(const DistanceSearch&) = delete;
    DistanceSearch& operator=(const DistanceSearch&) = delete;

    // Tries the witness's triangles first, then the trees. Afterwards every pair of triangles is in open_pairs(), or it
    // is farther than another that is, farther than at_most, or not nearer than floor().
    void run(const DistanceGoal& goal, const PairWitness& witness);

    // The same for the least distance, rounded once, and no more; 0 where the bodies share a point. Leaves no open
    // pairs. Only where can_refer() holds for the pair.
    double find_distance(const PairWitness& witness);
    bool can_refer() const noexcept;

    // Calls visit(pair, interval) for every pair of triangles within d, with what contains its distance.
    template <class Visit>
    void visit_within(double d, Visit&& visit);
    DistanceInterval enclosure(const TrianglePair& triangles);

    // Whether two triangles were found that share a point. Then nothing more is known.
    bool is_zero() const noexcept { return is_zero_; }
    // No distance is above it that is in question; with triangles that have that, or none.
    double upper() const noexcept { return upper_; }
    PairWitness witness() const noexcept { return nearest_; }
    // No pair that was left out because of the goal's relative or absolute width is nearer.
    double floor() const noexcept { return floor_; }

    std::vector<OpenPair>& open_pairs() noexcept;
    // Counts one exact rounding or comparison.
    TriangleDistances& exact_pair() noexcept;

    // What walk_nearest asks.
    float limit() const noexcept { return limit_; }
    template <class X, class Y>
    std::uint64_t find_near(const X& x, const Y& y, LaneSquares& bounds) noexcept;
    bool visits(const NearPair& pair);
    bool take(const TreeLeaf& x, const TreeLeaf& y);

    const std::array<DistanceSet, 2>& sets() const noexcept;

  private:
    struct Memory;

    // The bound of a walk in which all pairs within a distance matter.
    class WithinBound;

    static Memory& memory_of(QueryMemory& memory);
    const DistanceAxes& axes() const noexcept;
    const FarGap& far_gap() const noexcept;
    // What bounds of pairs within the distance are not above: squares, or ranks of bodies that are far apart.
    float bound_above(double distance) const noexcept;
    bool take_far(const TreeLeaf& x, const TreeLeaf& y, LanePairs pairs);
    bool is_decided() const noexcept;
    void dive();
    void walk(const PairWitness& witness);
    bool bound_batch();
    void drop_candidates();
    void lower_distance(const TrianglePair& triangles, double& least);
    void refer_to(const TrianglePair& nearest, double distance);
    void enclose_candidates();
    void take(std::size_t lane);
    void set_direction(std::size_t lane);
    void enclose(const TrianglePair& triangles);
    void set_upper(double upper, const TrianglePair& triangles);
    void set_limit();
    Relation relation(const TrianglePair& triangles);
    void leave_relations() noexcept;

    const Posed<MeshShape>& a_;
    const Posed<MeshShape>& b_;
    const MeshTree& tree_a_;
    const MeshTree& tree_b_;
    QueryMemory& query_memory_;
    Memory& memory_;
    QueryCounts& counts_;
    DistanceGoal goal_;
    PairWitness nearest_;
    double upper_ = std::numeric_limits<double>::infinity();
    double floor_ = std::numeric_limits<double>::infinity();
    float limit_ = std::numeric_limits<float>::infinity();
    // From the nearest triangle of a to that of b, as far as floats know, and its square on the axes of the first set.
    Direction direction_{};
    float direction_square_ = std::numeric_limits<float>::infinity();
    bool is_zero_ = false;
    bool refers_ = false;  // whether only the least distance is wanted, and pairs that are not nearer are left out
    bool has_relations_ = false;  // whether the memory's TriangleRelations are bound to these bodies
    std::uint32_t overlap_count_ = 0;
};

class DistanceSearch::WithinBound {
  public:
    WithinBound(DistanceSearch& search, double d)
        : sets_(search.sets()), far_(search.far_gap()), limit_(search.bound_above(d)), counts_(search.counts_) {}

    template <class X, class Y>
    std::uint64_t operator()(const X& x, const Y& y) {
        ++counts_.box_tests;
        if (far_.is_far()) return far_mask(far_, limit_, x, y, squares_);
        return near_mask(sets_, {}, limit_, x, y, squares_);
    }
    void order(const BvhNode&, const BvhNode&, LanePairs, std::span<NodePair>) const noexcept {}

  private:
    const std::array<DistanceSet, 2>& sets_;
    const FarGap& far_;
    float limit_;
    QueryCounts& counts_;
    alignas(32) LaneSquares squares_;
};

template <class Visit>
void DistanceSearch::visit_within(double d, Visit&& visit) {
    const std::int64_t key = key_of(d);
    auto& stack = QueryMemoryAccess::state(query_memory_).stack;
    walk_two(tree_a_.boxes, tree_b_.boxes, stack, WithinBound(*this, d), [&](std::uint32_t i, std::uint32_t j) {
        const TrianglePair pair{i, j};
        const DistanceInterval interval = enclosure(pair);
        if (key_of(interval.lower) > key) return true;
        if (key_of(interval.upper) <= key || exact_pair().compare(i, j, d) <= 0) visit(pair, interval);
        return true;
    });
}

}  // namespace ecods
