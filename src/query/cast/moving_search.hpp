// The search for the first contact of two meshes on straight ways between poses: a walk of both trees, earliest pairs
// of nodes first, that leaves a few pairs of triangles to exact decisions.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "bvh/walks/open_pair.hpp"
#include "ecods/cast.hpp"
#include "exact/measure/contact/bound_meeting.hpp"
#include "query/intersection/query_memory.hpp"
#include "query/shape/mesh_tree.hpp"

namespace ecods {

class MovingSearch {
  public:
    // Everything that the arguments refer to must outlive the search.
    MovingSearch(const Moving<MeshShape>& a, const Moving<MeshShape>& b, QueryMemory& memory);
    MovingSearch(const MovingSearch&) = delete;
    MovingSearch& operator=(const MovingSearch&) = delete;

    // A time before which the boxes around both bodies certainly do not meet; nothing if they never do.
    std::optional<float> first_of_boxes();

    // The first contact, if there is one whose real time is at most `at_most`. The bodies must not share a point at the
    // start. Tries the witness's triangles first.
    std::optional<FirstContact> run(double at_most, const PairWitness& witness);

  private:
    struct Memory;

    static Memory& memory_of(QueryMemory& memory);
    // No contact after that matters.
    double limit() const noexcept;
    void walk();
    void visit(const NodePair& nodes);
    // They share no point before `from`. Decides about them if they come next, or will.
    void take(const TrianglePair& triangles, double from, exact::Effort effort, bool is_next);

    const Moving<MeshShape>& a_;
    const Moving<MeshShape>& b_;
    const MeshTree& tree_a_;
    const MeshTree& tree_b_;
    Memory& memory_;
    QueryCounts& counts_;
    double at_most_ = 1;
    bool is_by_then_ = false;  // whether there is contact at `at_most`, before that is rounded
    std::optional<FirstContact> first_;
};

}  // namespace ecods
