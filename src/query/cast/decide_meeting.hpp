// MeetingDecision decides exactly when two moving triangles first share a point, for any kind of motion. Exact results
// are kept for other pairs of triangles that meet in the same features.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "base/double_key.hpp"
#include "base/next.hpp"
#include "ecods/ask.hpp"
#include "ecods/ids.hpp"
#include "ecods/mesh.hpp"
#include "exact/measure/contact/bound_meeting.hpp"
#include "exact/measure/contact/first_meeting.hpp"
#include "exact/measure/contact/possible_features.hpp"
#include "exact/measure/distance/name_features.hpp"
#include "geometry/feature_key.hpp"

namespace ecods {

// KnownMeeting holds the time at which features a and b first share a point. It is stored only for a pair of triangles
// that can meet in no other features in the time span searched. So every other pair of triangles with this property
// first meets at the same time.
struct KnownMeeting {
    FeatureKey a, b;
    double time;   // rounded once
    bool is_late;  // true if the exact time is above `time`
};

class KnownMeetings {
  public:
    void clear() noexcept {
        all_.clear();
        whole_.clear();
    }
    void add(const KnownMeeting& known) { all_.push_back(known); }

    // Stores the first meeting of two triangles in the whole motion; nullopt if the triangles never meet. Without this
    // cache, triangles that stay near each other would be decided again in many pieces of the motion.
    void add_whole(const TrianglePair& triangles, const std::optional<exact::Meeting>& meeting) {
        whole_.insert_or_assign(key_of_pair(triangles), meeting);
    }
    // Returns the meeting that add_whole() stored for the triangles; null if add_whole() was not called for these
    // triangles.
    const std::optional<exact::Meeting>* find_whole(const TrianglePair& triangles) const {
        const auto found = whole_.find(key_of_pair(triangles));
        return found == whole_.end() ? nullptr : &found->second;
    }
    // Returns an interval within [from, to] that contains the meeting `whole`, which add_whole() stored; nullopt if the
    // meeting is later than `to`, or if `whole` is empty.
    static std::optional<exact::TimeSpan> span_of(const std::optional<exact::Meeting>& whole, double from, double to) {
        if (!whole || key_of(next_down(whole->time)) > key_of(to)) return std::nullopt;
        return exact::TimeSpan{double_of(std::max(key_of(from), key_of(next_down(whole->time)))),
                               double_of(std::min(key_of(to), key_of(next_up(whole->time))))};
    }

    // Returns the known meeting of features a and b if it certainly is within `time`; otherwise null. The known time is
    // rounded, so both neighboring doubles of the known time must be within `time`.
    const KnownMeeting* find(const FeatureKey& a, const FeatureKey& b, const exact::TimeSpan& time) const {
        for (const KnownMeeting& known : all_) {
            if (known.a == a && known.b == b && key_of(next_down(known.time)) >= key_of(time.from) &&
                key_of(next_up(known.time)) <= key_of(time.to)) {
                return &known;
            }
        }
        return nullptr;
    }

  private:
    static std::uint64_t key_of_pair(const TrianglePair& triangles) noexcept {
        return std::uint64_t{triangles.a} << 32 | triangles.b;
    }

    std::vector<KnownMeeting> all_;
    std::unordered_map<std::uint64_t, std::optional<exact::Meeting>> whole_;  // the key has both indices
};

// MeetingDecision decides when one pair of triangles first meets. `Pairs` represents all pairs of triangles of two
// moving meshes. It has the functions mesh(side); points_of(triangles), which returns the corners in doubles for
// bound_first_meeting() and possible_features(); and ask_exactly(triangles, ask), which returns ask(position) for the
// RelativePositionOf the triangles. It has the member counts_.
template <class Pairs>
class MeetingDecision {
  public:
    MeetingDecision(Pairs& pairs, KnownMeetings& known, const TrianglePair& triangles)
        : pairs_(pairs), known_(known), triangles_(triangles) {}

    // Returns the first meeting, computed exactly. First tries short time spans that begin with the bound `time`,
    // because few features can meet in a short span. If these spans do not suffice, decides for all times. Each span is
    // longer than the one before, because `time` may end before the meeting: points far from their mesh's origin have
    // large errors. For turns, `time` mostly ends before the meeting; its length is about 2^-42 there. With a first
    // span of 2^-44, turns took five times as many exact decisions, and straight motions took as many.
    std::optional<exact::Meeting> decide(exact::TimeSpan time, double to) {
        if (const auto* whole = known_.find_whole(triangles_)) return *whole;
        constexpr std::array<double, 3> lengths{0x1p-40, 0x1p-34, 0x1p-28};  // relative to time.to
        const auto points = pairs_.points_of(triangles_);
        for (const double length : lengths) {
            time.to = std::min(1.0, std::max(time.to, time.from + length * time.to));
            const auto cells = exact::cells_around(time);
            if (!cells) break;
            const exact::TimeSpan span = cells->span();
            const exact::PartialAnswer answer = decide_in(*cells, exact::possible_features(points, span));
            if (!answer.is_known) break;
            if (answer.meeting) return answer.meeting;
            if (key_of(span.to) >= key_of(to)) return std::nullopt;
            ++pairs_.counts_->enclosures;
            const auto next = exact::bound_first_meeting(points, span.to, to, exact::Effort::fine);
            if (!next) return std::nullopt;
            time = *next;
        }
        const auto whole = pairs_.ask_exactly(triangles_, [](auto& at) { return exact::first_meeting(at); });
        known_.add_whole(triangles_, whole);
        return whole;
    }

  private:
    // Returns the first meeting in the cells, in which only pairs of `features` may share points, as first_meeting_in()
    // does.
    exact::PartialAnswer decide_in(const exact::TimeCells& cells, exact::FeatureSet features) {
        if (features == 0) return {true, std::nullopt};
        const bool is_one = std::has_single_bit(features);
        FeatureKey a, b;
        if (is_one) {
            const exact::FeaturePair& pair = exact::feature_pairs[static_cast<std::size_t>(std::countr_zero(features))];
            a = key_on(pair, 0, triangles_.a);
            b = key_on(pair, 1, triangles_.b);
            if (const KnownMeeting* known = known_.find(a, b, cells.span())) {
                return {true, exact::Meeting{known->time, known->is_late, pair}};
            }
        }
        const exact::PartialAnswer answer =
            pairs_.ask_exactly(triangles_, [&](auto& at) { return exact::first_meeting_in(at, cells, features); });
        if (answer.is_known && answer.meeting && is_one) {
            known_.add({a, b, answer.meeting->time, answer.meeting->is_late});
        }
        return answer;
    }

    FeatureKey key_on(const exact::FeaturePair& pair, std::size_t side, std::uint32_t triangle) const {
        return feature_key(exact::feature_of(pair, side, triangle), pairs_.mesh(side).triangles()[triangle]);
    }

    Pairs& pairs_;
    KnownMeetings& known_;
    const TrianglePair& triangles_;
};

// EnclosedPairs bounds the first meetings of pairs of triangles by doubles alone. Pairs derives from this class, and
// has points_of(triangles), the rounded motion of their corners.
template <class Pairs>
class EnclosedPairs {
  public:
    // Does what MovingPairs::bound() does.
    std::optional<exact::TimeSpan> bound(const TrianglePair& triangles, double from, double to, exact::Effort effort) {
        if (const auto* whole = known_.find_whole(triangles)) return KnownMeetings::span_of(*whole, from, to);
        ++counts_->enclosures;
        return exact::bound_first_meeting(static_cast<Pairs&>(*this).points_of(triangles), from, to, effort);
    }

  protected:
    // Forgets all meetings, and counts work in `counts` from now on.
    void bind_counts(CastCounts& counts) {
        counts_ = &counts;
        known_.clear();
    }

    CastCounts* counts_ = nullptr;
    KnownMeetings known_;
};

}  // namespace ecods
