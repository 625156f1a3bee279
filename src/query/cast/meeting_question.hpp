// MeetingQuestion is a PairQuestion (query/search): the number of a pair of triangles is the time of its first contact,
// for any kind of motion of the two bodies.
//
// The search refines bounds of pairs of triangles step by step, earliest pairs first. It decides a pair exactly only
// when no waiting pair may be earlier.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>

#include "base/double_key.hpp"
#include "base/next.hpp"
#include "bvh/axes/motion_axes.hpp"
#include "bvh/walks/waiting.hpp"
#include "ecods/cast.hpp"
#include "exact/measure/contact/bound_meeting.hpp"
#include "exact/measure/distance/name_features.hpp"
#include "query/cast/contact_interval.hpp"
#include "query/search/search.hpp"

namespace ecods {

// MeetingQuestion finds the first contact of two bodies that move as `Motion` says. A `bound` is a float that
// meeting_mask() computes on the axes of motion_axes.hpp. A Motion has these functions:
// sets(), trees(): the axes, and the trees on them, for a straight motion that bounds this motion;
// begin(): the beginning of the time that is searched;
// time_of(bound): a lower bound of the time at which a pair with this bound meets;
// bound_of(time): an upper bound of the bounds of all pairs that meet up to `time`;
// may_go_on(): false if the search is given up; the result of the search then has no meaning;
// bound(), decide(): as in MovingPairs.
template <class Motion>
class MeetingQuestion {
  public:
    using Interval = ContactInterval;
    using Value = FirstContact;
    using Search = ecods::Search<MeetingQuestion>;

    Motion& motion() noexcept { return motion_; }

    // Prepares the search for contacts up to `at_most`. The motion must be bound, and the bodies must not share a point
    // up to its begin().
    void start(double at_most) {
        waiting_.clear();
        order_ = 0;
        at_most_ = at_most;
        is_by_then_ = false;
    }
    // Returns true if the search found a contact whose real time is at most `at_most`. (A rounded time may be at most
    // `at_most` although the real time is later.)
    bool is_by_then() const noexcept { return is_by_then_; }

    // Search calls the following functions.
    float limit_above(double time) const noexcept { return motion_.bound_of(time); }
    template <class X, class Y>
    std::uint64_t find_near(const X& x, const Y& y, float limit, LaneBounds& times) noexcept {
        if (!motion_.may_go_on()) return 0;
        return meeting_mask(motion_.sets(), limit, motion_.trees()[0].of(x), motion_.trees()[1].of(y), times);
    }
    bool may_share(float) const noexcept { return false; }
    ContactInterval enclose(const TrianglePair& triangles, double latest) {
        ContactInterval interval;
        const bool may_meet = narrow(triangles, motion_.begin(), latest, exact::Effort::fine);
        interval.lower = may_meet ? span_.from : std::numeric_limits<double>::infinity();
        return interval;
    }
    bool complete(const TrianglePair& triangles, ContactInterval& interval, std::optional<FirstContact>& contact) {
        const auto meeting = motion_.decide(triangles, span_, to_);
        if (!meeting || key_of(meeting->time) > key_of(at_most_)) return false;
        is_by_then_ = is_by_then_ || !meeting->is_late || key_of(meeting->time) < key_of(at_most_);
        contact.emplace();
        contact->time = interval.lower = interval.upper = meeting->time;
        exact::name_features(*contact, meeting->features, triangles);
        return true;
    }
    void gather(Search&, const TreeLeaf& x, const TreeLeaf& y, LanePairs lanes, const LaneBounds& times) {
        for (; lanes.more(); lanes.next()) {
            const std::size_t i = lanes.i(), j = lanes.j();
            wait(motion_.time_of(times[tree_width * i + j]), Candidate::Known::boxes, {x.triangle[i], y.triangle[j]});
        }
    }
    void advance(Search& search, float bound) {
        const double time = motion_.time_of(bound);
        while (!waiting_.is_empty() && waiting_.front().time <= key_of(time)) {
            const Candidate next = waiting_.pop();
            // All other candidates are later, so none is left to be searched.
            if (!motion_.may_go_on() || !search.sieve().counts(double_of(next.time))) return waiting_.clear();
            refine(search, next, time);
        }
    }

  private:
    // A Candidate is a pair of triangles that waits in the queue. `known` says how `time` was computed: as the bound of
    // the boxes, or by narrow() with coarse or fine effort.
    struct Candidate {
        enum class Known : std::uint8_t { boxes, coarse, fine };

        std::int64_t time;  // key of a lower bound of the time of first contact
        std::uint32_t order;
        Known known;
        TrianglePair triangles;

        // Orders candidates by time; at equal times the pair inserted last comes first, which makes the search
        // depth-first.
        friend bool operator<(const Candidate& x, const Candidate& y) noexcept {
            return ((x.time < y.time) | ((x.time == y.time) & (x.order > y.order))) != 0;
        }
    };

    // Returns true if the triangles may share a point from `from` to `latest`; then sets span_ to an interval that
    // contains the first such time. Searches up to the double above `latest`, because a time above `latest` may round
    // to it.
    bool narrow(const TrianglePair& triangles, double from, double latest, exact::Effort effort) {
        to_ = std::min(next_up(latest), 1.0);
        if (key_of(from) > key_of(to_)) return false;
        const auto span = motion_.bound(triangles, from, to_, effort);
        if (!span || key_of(span->from) > key_of(latest)) return false;
        span_ = *span;
        return true;
    }

    void wait(double time, typename Candidate::Known known, const TrianglePair& triangles) {
        waiting_.push({key_of(time), order_++, known, triangles});
    }

    // Refines the bound of the candidate. If a waiting candidate, or a node that is still to be visited (no such node
    // begins before time `next`), may be earlier, puts the candidate back into the queue. Otherwise passes the
    // candidate to the search, which decides it exactly.
    void refine(Search& search, const Candidate& candidate, double next) {
        using Known = typename Candidate::Known;
        const double latest = search.sieve().bound();
        double from = double_of(candidate.time);
        const auto is_after_others = [&] {
            const std::int64_t time = key_of(span_.from);
            return time > key_of(next) || (!waiting_.is_empty() && time > waiting_.front().time);
        };
        if (candidate.known == Known::boxes) {
            if (!narrow(candidate.triangles, from, latest, exact::Effort::coarse)) return;
            if (is_after_others()) return wait(span_.from, Known::coarse, candidate.triangles);
            from = span_.from;
        }
        if (!narrow(candidate.triangles, from, latest, exact::Effort::fine)) return;
        if (candidate.known != Known::fine && is_after_others())
            return wait(span_.from, Known::fine, candidate.triangles);
        ContactInterval interval;
        interval.lower = span_.from;
        search.take(candidate.triangles, interval);
    }

    Motion motion_;
    Waiting<Candidate> waiting_;
    std::uint32_t order_ = 0;
    exact::TimeSpan span_{};  // result of narrow(), searched up to to_
    double to_ = 1;
    double at_most_ = 1;
    bool is_by_then_ = false;
};

}  // namespace ecods
