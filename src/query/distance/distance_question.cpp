#include "query/distance/distance_question.hpp"

#include <algorithm>
#include <cmath>

#include "bvh/walks/open_pair.hpp"

namespace ecods {

void DistanceQuestion::bind(const MeshPair& bodies, QueryCounts& counts) {
    counts_ = &counts;
    excludes_ = false;
    referred_.reset();
    direction_ = {};
    direction_square_ = std::numeric_limits<float>::infinity();
    batch_.count = 0;
    candidates_.clear();
    pair_.bind(bodies.a.ref(), bodies.b.ref());
    const PosedTree tree_a{bodies.a.tree.boxes, bodies.a.pose.R}, tree_b{bodies.b.tree.boxes, bodies.b.pose.R};
    const Vec3 d = bodies.b.pose.t - bodies.a.pose.t;
    axes_.bind(tree_a, tree_b, d);
    far_.bind(axes_, tree_a, tree_b, d);
}

TrianglePair DistanceQuestion::dive(const MeshPair& bodies) {
    const MeshBvh &a = bodies.a.tree.boxes, &b = bodies.b.tree.boxes;
    NodePair at{a.root, b.root};
    std::optional<TrianglePair> found;
    while (!found) {
        with_nodes(a, b, at, [&](const auto& x, const auto& y) {
            const LanePair lanes = nearest_lanes(axes_.sets()[0], x, y);
            if constexpr (requires { x.child; }) at.a = x.child[lanes.i];
            if constexpr (requires { y.child; }) at.b = y.child[lanes.j];
            if constexpr (requires {
                              x.triangle;
                              y.triangle;
                          }) {
                found = {x.triangle[lanes.i], y.triangle[lanes.j]};
            } else {
                ++counts_->box_tests;
            }
        });
    }
    return *found;
}

DistanceInterval DistanceQuestion::enclose(const TrianglePair& triangles, double) {
    ++counts_->distances.enclosures;
    return pair_.enclose(triangles.a, triangles.b);
}

bool DistanceQuestion::refer_to(const TrianglePair& triangles) {
    if (!excludes_ || referred_ == triangles) return false;
    pair_.refer_to(triangles);
    referred_ = triangles;
    return true;
}

void DistanceQuestion::gather(Search& search, const TreeLeaf& x, const TreeLeaf& y, LanePairs lanes,
                              const LaneBounds&) {
    // If the bodies are far apart, floats bound the distance of two triangles no better than that of their leaves.
    if (is_far()) return search.take_each(x, y, lanes);
    if (!lanes.more()) return;
    put_on_axes(axes_.sets()[0], x, y, leaves_);
    for (; lanes.more(); lanes.next()) {
        const std::size_t i = lanes.i(), j = lanes.j();
        batch_.add(leaves_, i, j, {x.triangle[i], y.triangle[j]});
        if (batch_.is_full()) bound_batch(search);
        if (search.sieve().is_decided()) return;
    }
}

// Bounds the distances of the pairs in the batch, takes each pair, and empties the batch.
void DistanceQuestion::bound_batch(Search& search) {
    counts_->distances.triangle_bounds += batch_.count;
    bound_triangles(axes_.sets()[0], batch_, squares_);
    for (std::size_t lane = 0; lane < batch_.count && !search.sieve().is_decided(); ++lane) take(search, lane);
    batch_.count = 0;
}

// Takes a pair whose squared distance floats have bounded. If the lower bound is zero, doubles enclose the distance at
// once, so that a common point is found early. Otherwise the pair becomes a candidate, unless it is beyond the limit.
void DistanceQuestion::take(Search& search, std::size_t lane) {
    const TrianglePair& triangles = batch_.pairs[lane];
    const float lower = squares_.lower[lane], upper = squares_.upper[lane];
    // A pair beyond the limit may set the direction, too: if all pairs are beyond the limit, a walk proves this soonest
    // along the direction of the nearest of them.
    if (upper < direction_square_ && upper > 0) set_direction(lane);
    if (lower > search.limit()) return;
    if (!(lower > 0)) return search.take(triangles);
    if (upper * axes_.sets()[0].square <= search.limit()) search.take_upper(axes_.distance_above(upper), triangles);
    candidates_.push_back({lower, triangles});
}

void DistanceQuestion::set_direction(std::size_t lane) {
    direction_square_ = squares_.upper[lane];
    const double factor = (1 - 0x1p-18) / std::sqrt(static_cast<double>(direction_square_));
    for (std::size_t k = 0; k < 3; ++k) {
        direction_[k] = static_cast<float>(static_cast<double>(squares_.between[k][lane]) * factor);
    }
}

// Encloses the distances of the candidates once all nodes have been visited (`bound` is then infinite); until then does
// nothing.
void DistanceQuestion::advance(Search& search, float bound) {
    if (bound < std::numeric_limits<float>::infinity()) return;
    bound_batch(search);
    if (!search.sieve().is_decided()) enclose_candidates(search);
}

// Encloses the distances of candidates in ascending order of their lower bounds, until all others are beyond the limit.
// If pairs may be excluded by a slab, first computes the exact distance of the nearest pair so far; this pair sets the
// slab.
void DistanceQuestion::enclose_candidates(Search& search) {
    if (excludes_) {
        const TrianglePair nearest{search.sieve().nearest().a, search.sieve().nearest().b};
        refer_to(nearest);
        const double distance = exact_pair().distance(nearest.a, nearest.b);
        DistanceInterval interval;
        interval.lower = interval.upper = distance;
        search.take_upper(distance, nearest);
        search.sieve().add({interval, nearest, distance});
    }
    std::erase_if(candidates_, [&](const Candidate& c) { return c.lower > search.limit(); });
    std::ranges::sort(candidates_, {}, &Candidate::lower);
    for (const Candidate& candidate : candidates_) {
        if (candidate.lower > search.limit() || search.sieve().is_decided()) return;
        search.take(candidate.triangles);
    }
}

}  // namespace ecods
