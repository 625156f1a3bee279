#include "exact/measure/contact/bound_meeting.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/arithmetic.hpp"
#include "base/next.hpp"
#include "simd/dispatch.hpp"
#include "simd/vec.hpp"

namespace ecods::exact {
namespace {

using Double4 = Vec<double, 4>;
using Four = std::array<Double4, 3>;  // three coordinates of four vectors, one vector in each lane

// Limits the number of steps, each of which shortens or splits an interval. More steps are needed only if the triangles
// graze each other. A turn may take more steps, since its exact decision takes as long as some thousand steps.
constexpr int step_max = 96, turn_step_max = 512;
constexpr int coarse_step_max = 3;
// Limits how far an interval is split: the part that is searched next has at least 2^-32 of its length. The distance of
// a chord's zero from the meeting shrinks as the square of the interval's length. So the first half of an interval is
// searched; if the triangles may meet in it, its first quarter, then its first sixteenth (as in quadratic interval
// refinement: Abbott, Quadratic interval refinement for real roots, 2014).
constexpr int halvings_max = 32;
// Limits the length of an interval that is split: relative to the interval's end, the length must be more than a few
// times the distance of neighboring doubles.
constexpr double length_min = 0x1p-44;

ECODS_ALWAYS_INLINE Four four(const Point& a, const Point& b, const Point& c, const Point& d) noexcept {
    return {Double4{a[0], b[0], c[0], d[0]}, Double4{a[1], b[1], c[1], d[1]}, Double4{a[2], b[2], c[2], d[2]}};
}

// Ends holds the least and the largest dot products of each triangle's corners with four vectors, one vector in each
// lane.
struct Ends {
    Double4 low_a, high_a, low_b, high_b;

    ECODS_ALWAYS_INLINE Ends(const Four& n, const Points<6>& p) noexcept {
        const auto on = [&](std::size_t i)
                            ECODS_INLINE_LAMBDA { return (n[0] * p[i][0] + n[1] * p[i][1]) + n[2] * p[i][2]; };
        const Double4 a0 = on(0), a1 = on(1), a2 = on(2), b0 = on(3), b1 = on(4), b2 = on(5);
        low_a = min(a0, min(a1, a2));
        high_a = max(a0, max(a1, a2));
        low_b = min(b0, min(b1, b2));
        high_b = max(b0, max(b1, b2));
    }
};

// A Part is the part of an interval from `first` to `last`, both relative to the interval's length; it is empty if
// first > last.
struct Part {
    double first = 0, last = 1;
};

// Shortens `part` to the times at which all four gaps may be at most zero: it ends at the zeros of the gaps' chords.
// `gap_from` and `gap_to` are the gaps along four vectors at the beginning and the end of the interval.
// Claim: verify/proofs/moving_points.py
// Claim: verify/proofs/motion_chords.md
ECODS_ALWAYS_INLINE void shorten(Part& part, Double4 gap_from, Double4 gap_to) noexcept {
    const Double4 zero{}, one = zero + 1, two = zero + 2;
    const auto apart_before = gap_from > zero, apart_after = gap_to > zero;
    const Double4 at = gap_from / (gap_from - gap_to);
    const Double4 first = select(apart_before, select(apart_after, two, at * (1 - 16 * two_u)), zero);
    const Double4 last = select(~apart_before & apart_after, at * (1 + 16 * two_u), one);
    for (int i = 0; i < 4; ++i) {
        part.first = first[i] > part.first ? first[i] : part.first;
        part.last = last[i] < part.last ? last[i] : part.last;
    }
}

// Returns an upper bound of the exact sum, from the sum as computed. No term may be rounded by more than an ULP, or
// lose more than 2^-1022 to underflow.
ECODS_ALWAYS_INLINE double above(double sum) noexcept {
    return next_up(next_up(sum + 0x1p-1000));
}

// Straight is a motion of corners on straight lines, for the search. `At` holds the corners at one time, and the
// factors of their error bound on each axis. A `Chord` is the straight motion between two times. A gap of the chord
// less widened(error) is a lower bound of the true gap. earliest() and latest() bound the part of the time at which the
// chord has gone the part `way` of its way.
class Straight {
  public:
    struct At {
        Points<6> points;
        Point error;
    };
    struct Chord {
        ECODS_ALWAYS_INLINE static const Point& widened(const Point& error) noexcept { return error; }
        ECODS_ALWAYS_INLINE static double earliest(double way) noexcept { return way; }
        ECODS_ALWAYS_INLINE static double latest(double way) noexcept { return way; }
    };

    ECODS_ALWAYS_INLINE explicit Straight(const MovingPoints& points) noexcept : corners_(points) {}
    ECODS_ALWAYS_INLINE bool is_bounded() const noexcept { return corners_.is_bounded(); }
    ECODS_ALWAYS_INLINE At at(double s) const noexcept { return {corners_.at(s), corners_.error_at(s)}; }
    ECODS_ALWAYS_INLINE static Chord chord(const At&, const At&) noexcept { return {}; }

  private:
    MovingCorners corners_;
};

class Turned {
  public:
    using At = TurningCorners::At;
    struct Chord {
        TurnPiece piece;
        Point margins;

        ECODS_ALWAYS_INLINE Point widened(const Point& error) const noexcept {
            return {error[0] + margins[0], error[1] + margins[1], error[2] + margins[2]};
        }
        ECODS_ALWAYS_INLINE double earliest(double way) const noexcept { return piece.earliest(way); }
        ECODS_ALWAYS_INLINE double latest(double way) const noexcept { return piece.latest(way); }
    };

    ECODS_ALWAYS_INLINE explicit Turned(const TurningPoints& points) noexcept : corners_(points) {}
    ECODS_ALWAYS_INLINE bool is_bounded() const noexcept { return corners_.is_bounded(); }
    ECODS_ALWAYS_INLINE At at(double s) const noexcept { return corners_.at(s); }
    ECODS_ALWAYS_INLINE Chord chord(const At& from, const At& to) const noexcept {
        const TurnPiece piece = corners_.piece(from, to);
        return {piece, corners_.margins(piece, to.half.time - from.half.time)};
    }

  private:
    TurningCorners corners_;
};

// AtOneTime is a motion of two triangles, each of which is near a straight motion at the same time.
template <class Corners>
class AtOneTime {
  public:
    using At = typename Corners::At;
    struct Chord {
        Point margins;

        ECODS_ALWAYS_INLINE Point widened(const Point& error) const noexcept {
            return {error[0] + margins[0], error[1] + margins[1], error[2] + margins[2]};
        }
        ECODS_ALWAYS_INLINE static double earliest(double way) noexcept { return way; }
        ECODS_ALWAYS_INLINE static double latest(double way) noexcept { return way; }
    };

    template <class MotionPoints>
    ECODS_ALWAYS_INLINE explicit AtOneTime(const MotionPoints& points) noexcept : corners_(points) {}
    ECODS_ALWAYS_INLINE bool is_bounded() const noexcept { return corners_.is_bounded(); }
    ECODS_ALWAYS_INLINE At at(double s) const noexcept { return corners_.at(s); }
    ECODS_ALWAYS_INLINE Chord chord(const At& from, const At& to) const noexcept {
        return {corners_.margins(from, to)};
    }

  private:
    Corners corners_;
};

template <class Motion>
class Bounds {
  public:
    using At = typename Motion::At;
    using Chord = typename Motion::Chord;

    template <class MotionPoints>
    ECODS_ALWAYS_INLINE explicit Bounds(const MotionPoints& points) noexcept : motion_(points) {}

    ECODS_ALWAYS_INLINE std::optional<TimeSpan> first(double from, double to, int step_count) const noexcept {
        if (!motion_.is_bounded()) return TimeSpan{from, to};
        std::array<double, turn_step_max> later;  // ends of the intervals to be searched later; the next one is last
        std::size_t later_count = 0;
        double end = to;  // end of the interval that is being shortened
        int halvings = 1;
        At at_from = motion_.at(from), at_to = motion_.at(to);
        for (int step = 0; step < step_count; ++step) {
            const Chord chord = motion_.chord(at_from, at_to);
            const Part part = remaining(at_from, at_to, chord);
            if (part.first > part.last) {
                if (later_count == 0) return std::nullopt;
                from = end;
                to = end = later[--later_count];
                halvings = std::max(1, halvings / 2);
                at_from = motion_.at(from);
                at_to = motion_.at(to);
                continue;
            }
            const double length = to - from;
            const double first = std::max(from, next_down(from + length * chord.earliest(part.first)));
            const double last = part.last < 1 ? std::min(to, above(from + length * chord.latest(part.last))) : to;
            if (!(first <= last)) return TimeSpan{from, to};
            if (first > from) at_from = motion_.at(first);
            from = first;
            to = last;
            if (to - from <= length_min * to) return TimeSpan{from, to};
            later[later_count++] = end;
            to = end = std::min(to, next_up(from + std::ldexp(to - from, -halvings)));
            at_to = motion_.at(to);
            halvings = std::min(2 * halvings, halvings_max);
        }
        return TimeSpan{from, to};
    }

  private:
    // An End holds the corners at one end of an interval, with the error bound of gaps of its chord.
    struct End {
        const Points<6>& points;
        Point error;

        ECODS_ALWAYS_INLINE Double4 bound(const Four& n) const noexcept {
            return ((absolute(n[0]) * error[0] + absolute(n[1]) * error[1]) + absolute(n[2]) * error[2]) +
                   MovingCorners::underflow;
        }
    };

    ECODS_ALWAYS_INLINE static void shorten_by(const Four& n, const End& p, const End& q, Part& part) noexcept {
        const Ends before(n, p.points), after(n, q.points);
        const Double4 bound_before = p.bound(n), bound_after = q.bound(n);
        shorten(part, (before.low_b - before.high_a) - bound_before, (after.low_b - after.high_a) - bound_after);
        shorten(part, (before.low_a - before.high_b) - bound_before, (after.low_a - after.high_b) - bound_after);
    }

    // Returns the points, multiplied by a power of two if products of their differences could underflow, as they can if
    // the bodies grow by a large factor on their way.
    ECODS_ALWAYS_INLINE static Points<6> without_small(const Points<6>& points) noexcept {
        constexpr double small = 0x1p-64;
        double size = 0;
        for (const Point& p : points) size = std::max({size, std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
        if (size >= small) return points;
        const double scale = MovingCorners::inverse_power(size);
        Points<6> result = points;
        for (Point& p : result) {
            for (double& x : p) x *= scale;
        }
        return result;
    }

    // Returns the part of the interval in which the triangles may share a point. Shortens the interval by gaps along
    // the normals of the faces and along the cross products of edges, both taken at the beginning of the interval.
    ECODS_ALWAYS_INLINE static Part remaining(const At& at_from, const At& at_to, const Chord& chord) noexcept {
        const End from{at_from.points, chord.widened(at_from.error)}, to{at_to.points, chord.widened(at_to.error)};
        const Points<6> p = without_small(from.points);
        const auto [a, b] = edges_of(p);
        const Point normal_a = cross(a[0], a[1]), normal_b = cross(b[0], b[1]);
        const Point between = {(p[3][0] + p[4][0] + p[5][0]) - (p[0][0] + p[1][0] + p[2][0]),
                               (p[3][1] + p[4][1] + p[5][1]) - (p[0][1] + p[1][1] + p[2][1]),
                               (p[3][2] + p[4][2] + p[5][2]) - (p[0][2] + p[1][2] + p[2][2])};
        Part part;
        shorten_by(four(normal_a, normal_b, between, cross(normal_a, a[0])), from, to, part);
        if (part.first > part.last) return part;
        for (std::size_t i = 0; i < 3; ++i) {
            const Point in_plane = i == 0 ? cross(normal_a, a[1]) : cross(normal_b, b[i]);
            shorten_by(four(cross(a[i], b[0]), cross(a[i], b[1]), cross(a[i], b[2]), in_plane), from, to, part);
            if (part.first > part.last) return part;
        }
        return part;
    }

    Motion motion_;
};

template <class Motion, class MotionPoints>
ECODS_ALWAYS_INLINE std::optional<TimeSpan> find_bound(const MotionPoints& points, double from, double to,
                                                       int step_count) noexcept {
    return Bounds<Motion>(points).first(from, to, step_count);
}

int steps_of(Effort effort, int most) noexcept {
    return effort == Effort::coarse ? coarse_step_max : most;
}

}  // namespace

std::optional<TimeSpan> bound_first_meeting(const MovingPoints& points, double from, double to,
                                            Effort effort) noexcept {
    return dispatch<find_bound<Straight, MovingPoints>>(points, from, to, steps_of(effort, step_max));
}

std::optional<TimeSpan> bound_first_meeting(const TurningPoints& points, double from, double to,
                                            Effort effort) noexcept {
    return dispatch<find_bound<Turned, TurningPoints>>(points, from, to, steps_of(effort, turn_step_max));
}

std::optional<TimeSpan> bound_first_meeting(const BothTurningPoints& points, double from, double to,
                                            Effort effort) noexcept {
    return dispatch<find_bound<AtOneTime<BothTurningCorners>, BothTurningPoints>>(points, from, to,
                                                                                  steps_of(effort, turn_step_max));
}

std::optional<TimeSpan> bound_first_meeting(const TurnAndStraightPoints& points, double from, double to,
                                            Effort effort) noexcept {
    return dispatch<find_bound<AtOneTime<TurnAndStraightCorners>, TurnAndStraightPoints>>(
        points, from, to, steps_of(effort, turn_step_max));
}

}  // namespace ecods::exact
