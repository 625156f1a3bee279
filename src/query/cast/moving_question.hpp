// MovingQuestion is the PairQuestion (query/search) whose numbers are the times of first contact, for two bodies whose
// points move straight between two poses.
//
// Bounds of pairs of triangles are refined step by step, earliest pairs first. A pair is decided exactly only when no
// waiting pair may be earlier.
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

    // Everything that the arguments refer to must outlive this object.
    void bind_boxes(const Moving<MeshShape>& a, const Moving<MeshShape>& b);
    // Returns a lower bound of the time at which the boxes of the bodies meet; nullopt if they never do.
    std::optional<float> first_of_boxes();
    // Prepares the search for contacts up to `at_most`. The bodies must not share a point at the start.
    void bind_pairs(const Moving<MeshShape>& a, const Moving<MeshShape>& b, double at_most, CastCounts& counts);
    // True if the real time of a contact found is at most `at_most`. (The rounded time may be, though the real time is
    // not.)
    bool is_by_then() const noexcept { return is_by_then_; }

    // The search calls the following functions.
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
    // Holds a pair of triangles that waits in the queue. `known` says which bound `time` is: the bound of the boxes, a
    // coarse one, or a fine one.
    struct Candidate {
        enum class Known : std::uint8_t { boxes, coarse, fine };

        std::int64_t time;  // key of a lower bound of the time of first contact
        std::uint32_t order;
        Known known;
        TrianglePair triangles;

        // Orders by time; at equal times the pair inserted last comes first, which makes the search depth-first.
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
    exact::TimeSpan span_{};  // result of narrow(), searched up to to_
    double to_ = 1;
    double at_most_ = 1;
    bool is_by_then_ = false;
};

}  // namespace ecods
