// Search finds the least number among the pairs of triangles of two bodies. It walks both trees, nearest nodes first,
// and keeps a few pairs, among which exact arithmetic finds the least number.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "bvh/walks/walk_nearest.hpp"
#include "query/intersection/query_memory.hpp"
#include "query/search/common_point.hpp"
#include "query/search/question.hpp"
#include "query/search/sieve.hpp"
#include "query/shape/mesh_body.hpp"

namespace ecods {

// A GatheringQuestion can bound a pair of triangles more tightly than its leaves do, at less cost than an interval. The
// question collects pairs, and decides when the search takes the collected pairs.
//
// `gather(search, x, y, lanes, bounds)` stores the pairs of triangles of leaves x and y in `lanes`, with their bounds.
// `advance(search, bound)` is called before nodes with this lower bound are opened, and with infinity at the end. When
// the last call returns, every stored pair must have been passed to search.take(), or must be known not to have the
// least number.
template <class Question, class Search>
concept GatheringQuestion = requires(Question& question, Search& search, const TreeLeaf& leaf, LanePairs lanes,
                                     const LaneBounds& bounds, float bound) {
    question.gather(search, leaf, leaf, lanes, bounds);
    question.advance(search, bound);
};

template <class Question>
using SieveOf = Sieve<typename Question::Interval, typename Question::Value>;

// A SearchMemory holds a question and the scratch memory of its searches, which later searches reuse.
template <class Question>
struct SearchMemory final : QueryMemoryPart {
    Question question;
    SieveOf<Question> sieve;
    NearestQueue queue;
    alignas(32) LaneBounds bounds{};
};

template <class Question>
class Search {
  public:
    // Everything that the arguments refer to must outlive the search. The question must be bound to the bodies before.
    Search(const MeshPair& bodies, SearchMemory<Question>& working, QueryMemory& memory)
        : bodies_(bodies),
          question_(working.question),
          sieve_(working.sieve),
          queue_(working.queue),
          bounds_(working.bounds),
          common_point_(bodies, memory),
          counts_(QueryMemoryAccess::state(memory).counts) {
        static_assert(PairQuestion<Question>);
    }

    // Tries the pair `first`, if there is one, then walks the trees. Afterwards either sieve().is_decided(), or
    // sieve().open() holds every pair of triangles that may have the least number.
    void run(const SearchGoal& goal, const std::optional<TrianglePair>& first) {
        sieve_.start(goal);
        set_limit();
        if (first) take(*first);
        sieve_.forget_open();  // the walk will find `first` again
        if (sieve_.is_decided()) return;
        walk_nearest(bodies_.a.tree.boxes, bodies_.b.tree.boxes, queue_, *this);
        advance(std::numeric_limits<float>::infinity());
        sieve_.drop();
    }

    // walk_nearest() calls limit(), find_near(), visits() and take(x, y); see bvh/walks/walk_nearest.hpp.
    float limit() const noexcept { return limit_; }
    template <class X, class Y>
    std::uint64_t find_near(const X& x, const Y& y, LaneBounds& bounds) {
        ++counts_.box_tests;
        return question_.find_near(x, y, limit_, bounds);
    }
    bool visits(const NearPair& pair) {
        if (question_.may_share(pair.square) && common_point_.is_found_among_overlaps()) sieve_.take_zero();
        advance(pair.square);
        return !sieve_.is_decided();
    }
    bool take(const TreeLeaf& x, const TreeLeaf& y) {
        const LanePairs lanes(find_near(x, y, bounds_));
        if constexpr (GatheringQuestion<Question, Search>) {
            question_.gather(*this, x, y, lanes, bounds_);
        } else {
            take_each(x, y, lanes);
        }
        return !sieve_.is_decided();
    }

    // Takes the pairs of triangles of leaves x and y in `lanes`, except pairs whose bounds exceed the limit.
    void take_each(const TreeLeaf& x, const TreeLeaf& y, LanePairs lanes) {
        for (; lanes.more() && !sieve_.is_decided(); lanes.next()) {
            if (bounds_[tree_width * lanes.i() + lanes.j()] > limit_) continue;
            take({x.triangle[lanes.i()], y.triangle[lanes.j()]});
        }
    }

    // Encloses the number of a pair and adds the pair to the sieve, unless it is excluded or cannot have the least
    // number.
    void take(const TrianglePair& triangles) {
        if constexpr (ExcludingQuestion<Question>) {
            if (question_.is_not_less(triangles)) return;
        }
        take(triangles, question_.enclose(triangles, sieve_.bound()));
    }
    void take(const TrianglePair& triangles, const typename Question::Interval& interval) {
        if (!sieve_.counts(interval.lower)) return;
        if (key_of(interval.lower) <= 0 && question_.may_share(0) && common_point_.is_in(triangles))
            return sieve_.take_zero(triangles);
        typename SieveOf<Question>::Open open{interval, triangles};
        if (!question_.complete(triangles, open.interval, open.value) || !sieve_.counts(open.interval.lower)) return;
        const bool has_ties = !sieve_.open().empty();
        take_upper(open.interval.upper, triangles);
        if constexpr (ExcludingQuestion<Question>) {
            // A pair with the same number as the nearest pair shares features with that pair, or lies across the same
            // two parallel faces: more equal pairs will follow. From now on the nearest pair may be the only reason to
            // exclude others, so it must stay in the sieve.
            const TrianglePair nearest{sieve_.nearest().a, sieve_.nearest().b};
            if (has_ties && question_.refer_to(nearest)) {
                typename SieveOf<Question>::Open known{{}, nearest};
                known.interval.upper = sieve_.upper();
                sieve_.add(known);
            }
        }
        sieve_.add(open);
    }
    // Stores `upper` as an upper bound of the least number: the number of the pair `triangles` is at most `upper`, or
    // rounds to `upper`.
    void take_upper(double upper, const TrianglePair& triangles) {
        if (sieve_.take_upper(upper, triangles)) set_limit();
    }
    SieveOf<Question>& sieve() noexcept { return sieve_; }

  private:
    void advance(float bound) {
        if constexpr (GatheringQuestion<Question, Search>) {
            if (!sieve_.is_decided()) question_.advance(*this, bound);
        }
    }
    void set_limit() { limit_ = question_.limit_above(sieve_.bound()); }

    const MeshPair& bodies_;
    Question& question_;
    SieveOf<Question>& sieve_;
    NearestQueue& queue_;
    LaneBounds& bounds_;
    CommonPoint common_point_;
    QueryCounts& counts_;
    float limit_ = std::numeric_limits<float>::infinity();
};

}  // namespace ecods
