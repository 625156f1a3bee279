// Times of first contact of two bodies on straight ways between poses as the numbers of a search (query/search).
//
// Bounds of pairs of triangles are made narrower step by step, earliest pairs first: exact decisions are left to those
// that nothing which waits may come before.
#pragma once

#include <cstdint>
#include <optional>

#include "bvh/axes/motion_axes.hpp"
#include "bvh/walks/waiting.hpp"
#include "ecods/cast.hpp"
#include "query/cast/contact_interval.hpp"
#include "query/cast/moving_pairs.hpp"
#include "query/search/search.hpp"

namespace ecods {

class MovingQuestion {
  public:
    using Interval = ContactInterval;
    using Value = FirstContact;
    using Search = ecods::Search<MovingQuestion>;

    // Everything that the arguments refer to must outlive the questions.
    void bind_boxes(const Moving<MeshShape>& a, const Moving<MeshShape>& b);
    // A time before which the boxes around both bodies certainly do not meet; nothing if they never do.
    std::optional<float> first_of_boxes();
    // The bodies must not share a point at the start. Contacts are asked about up to `at_most`.
    void bind_pairs(const Moving<MeshShape>& a, const Moving<MeshShape>& b, double at_most, CastCounts& counts);
    // Returns whether some contact that was found is at `at_most` or before, and does not only round to it.
    bool is_by_then() const noexcept { return is_by_then_; }

    // A search asks these.
    float limit_above(double time) const noexcept;
    template <class X, class Y>
    std::uint64_t find_near(const X& x, const Y& y, float limit, LaneBounds& times) const noexcept {
        return meeting_mask(axes_.sets(), limit, x, y, times);
    }
    bool may_share(float) const noexcept { return false; }
    ContactInterval enclose(const TrianglePair& triangles, double latest);
    bool complete(const TrianglePair& triangles, ContactInterval& interval, std::optional<FirstContact>& contact);
    void gather(Search& search, const TreeLeaf& x, const TreeLeaf& y, LanePairs lanes, const LaneBounds& times);
    void advance(Search& search, float time);

  private:
    // A pair of triangles that waits, of which its boxes' time is known, or a coarse or a fine bound.
    struct Candidate {
        enum class Known : std::uint8_t { boxes, coarse, fine };

        std::int64_t time;  // the key of a time before which they share no point
        std::uint32_t order;
        Known known;
        TrianglePair triangles;

        // Earliest first; of those, what came last, so that the search goes deep.
        friend bool operator<(const Candidate& x, const Candidate& y) noexcept {
            return ((x.time < y.time) | ((x.time == y.time) & (x.order > y.order))) != 0;
        }
    };

    bool narrow(const TrianglePair& triangles, double from, double latest, exact::Effort effort);
    void wait(double time, Candidate::Known known, const TrianglePair& triangles);
    void refine(Search& search, const Candidate& candidate, float next);

    MotionAxes axes_;
    std::array<const MeshBvh*, 2> trees_{};
    MovingPairs pairs_;
    Waiting<Candidate> waiting_;
    std::uint32_t order_ = 0;
    exact::TimeSpan span_{};  // of the pair in question, which is asked about up to to_
    double to_ = 1;
    double at_most_ = 1;
    bool is_by_then_ = false;
};

}  // namespace ecods
