// The search for the first contact of two bodies on their way: a walk of both trees, earliest nodes first, that leaves
// a few pairs of triangles among which exact times and the order of features decide. For any motion.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <tuple>
#include <vector>

#include "base/double_key.hpp"
#include "bvh/walks/walk_nearest.hpp"
#include "ecods/cast.hpp"
#include "query/cast/contact_at_start.hpp"
#include "query/cast/contact_interval.hpp"
#include "query/intersection/query_memory.hpp"
#include "query/shape/mesh_tree.hpp"

namespace ecods {

// A pair of triangles that may have the first contact.
struct OpenContact {
    ContactInterval interval;
    TrianglePair triangles;
    std::optional<FirstContact> contact = {};  // where it is known exactly
};

// What a search works in, kept from one to the next.
struct CastMemory {
    NearestQueue queue;
    alignas(32) LaneBounds times{};
    std::vector<OpenContact> open;
};

// What a Motion knows of two bodies and where they go, for the search:
//     float limit_above(double time)           bounds of nodes that have contact at a time that rounds to `time`, or
//                                              before, are not above it
//     find_near(x, y, float limit, times)      as near_mask: pairs of lanes that may have contact, with bounds of when,
//                                              finite and not negative
//     ContactInterval enclose(i, j)            of two triangles
//     std::optional<FirstContact> contact(i, j, interval)    of two triangles, exact, from what enclose() says; nothing
//                                              if there is none; only asked of times above 0
//     bool meet_by(i, j, double latest)        whether the real time of two triangles is at most `latest`
template <class Motion>
class CastSearch {
  public:
    // `a` and `b` are the bodies at time 0. Everything that the arguments refer to must outlive the search.
    CastSearch(Motion& motion, const Posed<MeshShape>& a, const Posed<MeshShape>& b, CastMemory& working,
               QueryMemory& memory)
        : motion_(motion),
          a_(a),
          b_(b),
          tree_a_(MeshShapeAccess::tree(*a.what)),
          tree_b_(MeshShapeAccess::tree(*b.what)),
          working_(working),
          query_memory_(memory),
          counts_(QueryMemoryAccess::state(memory).counts) {
        working_.open.clear();
    }
    ~CastSearch() { leave_relations(); }
    CastSearch(const CastSearch&) = delete;
    CastSearch& operator=(const CastSearch&) = delete;

    // The first contact, if its real time is at most `latest`, which is from 0 to 1. Tries the witness's triangles
    // first, and leaves those that decided; where there is no contact, the witness as it was.
    std::optional<FirstContact> find(double latest, PairWitness& witness);

    // What walk_nearest asks.
    float limit() const noexcept { return limit_; }
    template <class X, class Y>
    std::uint64_t find_near(const X& x, const Y& y, LaneBounds& times) {
        ++counts_.box_tests;
        return motion_.find_near(x, y, limit_, times);
    }
    bool visits(const NearPair& pair);
    bool take(const TreeLeaf& x, const TreeLeaf& y);

  private:
    void walk(const PairWitness& witness);
    void enclose(const TrianglePair& triangles);
    void set_upper(double upper);
    bool is_met(const TrianglePair& triangles);
    void drop_open();
    std::optional<FirstContact> least_of_open();
    bool is_by(const FirstContact& least, double latest);
    void leave_relations() noexcept;

    Motion& motion_;
    const Posed<MeshShape>& a_;
    const Posed<MeshShape>& b_;
    const MeshTree& tree_a_;
    const MeshTree& tree_b_;
    CastMemory& working_;
    QueryMemory& query_memory_;
    QueryCounts& counts_;
    double upper_ = std::numeric_limits<double>::infinity();  // no contact after it is in question
    float limit_ = std::numeric_limits<float>::infinity();
    bool is_zero_ = false;        // whether triangles were found that share a point at time 0
    bool has_relations_ = false;  // whether the memory's TriangleRelations are bound to the bodies
    std::uint32_t overlap_count_ = 0;
};

template <class Motion>
std::optional<FirstContact> CastSearch<Motion>::find(double latest, PairWitness& witness) {
    set_upper(latest);
    walk(witness);
    std::optional<FirstContact> result;
    if (is_zero_) {
        leave_relations();
        result = contact_at_start(a_, b_, query_memory_);
    } else {
        result = least_of_open();
        if (result && !is_by(*result, latest)) result.reset();
    }
    if (result) witness = {result->a.triangle, result->b.triangle};
    return result;
}

template <class Motion>
void CastSearch<Motion>::walk(const PairWitness& witness) {
    if (witness.a < a_.what->mesh().triangles().size() && witness.b < b_.what->mesh().triangles().size()) {
        enclose({witness.a, witness.b});
        working_.open.clear();  // it comes again
        if (is_zero_) return;
    }
    walk_nearest(tree_a_.boxes, tree_b_.boxes, working_.queue, *this);
}

// So many pairs of nodes that overlap at time 0 are visited before the bodies are tested for a common point (as in
// distance_search.cpp).
template <class Motion>
bool CastSearch<Motion>::visits(const NearPair& pair) {
    constexpr std::uint32_t overlap_max = 1024;
    if (pair.square > 0 || ++overlap_count_ != overlap_max) return true;
    leave_relations();
    is_zero_ = as_part(query_memory_, [&] { return intersects(a_, b_, query_memory_); });
    return !is_zero_;
}

template <class Motion>
bool CastSearch<Motion>::take(const TreeLeaf& x, const TreeLeaf& y) {
    for (LanePairs pairs(find_near(x, y, working_.times)); pairs.more(); pairs.next()) {
        const std::size_t i = pairs.i(), j = pairs.j();
        if (working_.times[tree_width * i + j] > limit_) continue;
        enclose({x.triangle[i], y.triangle[j]});
        if (is_zero_) return false;
    }
    return true;
}

// A pair of which it is not known whether there is contact is asked exactly at once: otherwise nothing would be left
// out because of it.
template <class Motion>
void CastSearch<Motion>::enclose(const TrianglePair& triangles) {
    ++counts_.casts.enclosures;
    OpenContact open{motion_.enclose(triangles.a, triangles.b), triangles};
    if (key_of(open.interval.lower) > key_of(upper_)) return;
    if (key_of(open.interval.lower) <= 0 && is_met(triangles)) {
        is_zero_ = true;
        return;
    }
    if (key_of(open.interval.upper) > key_of(1.0)) {
        ++counts_.casts.exact;
        open.contact = motion_.contact(triangles.a, triangles.b, open.interval);
        if (!open.contact || key_of(open.contact->time) > key_of(upper_)) return;
        open.interval.lower = open.interval.upper = open.contact->time;
    }
    set_upper(open.interval.upper);
    working_.open.push_back(open);
}

template <class Motion>
void CastSearch<Motion>::set_upper(double upper) {
    if (key_of(upper) >= key_of(upper_)) return;
    upper_ = upper;
    limit_ = motion_.limit_above(upper);
}

// Leaves out what is later than another pair, and all but the first by rank() of those that share their features:
// around a vertex, and on both sides of an edge.
template <class Motion>
void CastSearch<Motion>::drop_open() {
    auto& open = working_.open;
    std::erase_if(open, [&](const OpenContact& o) { return key_of(o.interval.lower) > key_of(upper_); });
    const auto others = std::partition(open.begin(), open.end(), [](const auto& o) { return o.interval.is_certain; });
    const auto features = [](const OpenContact& o) { return std::tie(o.interval.a, o.interval.b); };
    std::sort(open.begin(), others, [&](const OpenContact& x, const OpenContact& y) {
        if (features(x) != features(y)) return features(x) < features(y);
        return rank(x.interval.contact) < rank(y.interval.contact);
    });
    const auto last =
        std::unique(open.begin(), others, [&](const auto& x, const auto& y) { return features(x) == features(y); });
    open.erase(last, others);
}

// Of all open pairs whose time rounds to the least. Rounding is monotone: it takes no number below or above one that is
// a double.
template <class Motion>
std::optional<FirstContact> CastSearch<Motion>::least_of_open() {
    drop_open();
    std::optional<FirstContact> least;
    for (const OpenContact& open : working_.open) {
        if (key_of(open.interval.lower) > key_of(upper_)) continue;
        std::optional<FirstContact> contact = open.contact;
        if (!contact) {
            ++counts_.casts.exact;
            contact = motion_.contact(open.triangles.a, open.triangles.b, open.interval);
        }
        if (!contact || key_of(contact->time) > key_of(upper_)) continue;
        if (!least || rank_in_time(*contact) < rank_in_time(*least)) least = contact;
        upper_ = least->time;
    }
    return least;
}

// Whether some pair has its contact by then. What rounds to less is less; what rounds to `latest` may be above it, of
// one pair that has the least rounded time and not of another. No motion goes on beyond 1.
template <class Motion>
bool CastSearch<Motion>::is_by(const FirstContact& least, double latest) {
    if (key_of(least.time) < key_of(latest) || key_of(latest) >= key_of(1.0)) return true;
    return std::ranges::any_of(working_.open, [&](const OpenContact& open) {
        if (key_of(open.interval.lower) > key_of(latest)) return false;
        ++counts_.casts.exact;
        return motion_.meet_by(open.triangles.a, open.triangles.b, latest);
    });
}

template <class Motion>
bool CastSearch<Motion>::is_met(const TrianglePair& triangles) {
    TriangleRelations& relations = QueryMemoryAccess::state(query_memory_).pair;
    if (!has_relations_) {
        relations.reset_counts();
        relations.bind({&a_.what->mesh(), &tree_a_.extent, &a_.pose}, {&b_.what->mesh(), &tree_b_.extent, &b_.pose});
        has_relations_ = true;
    }
    return relations.relation(triangles.a, triangles.b) != Relation::disjoint;
}

template <class Motion>
void CastSearch<Motion>::leave_relations() noexcept {
    if (!has_relations_) return;
    counts_.stages += QueryMemoryAccess::state(query_memory_).pair.counts();
    has_relations_ = false;
}

}  // namespace ecods
