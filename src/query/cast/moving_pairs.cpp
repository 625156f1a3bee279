#include "query/cast/moving_pairs.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/arithmetic.hpp"
#include "base/double_key.hpp"
#include "base/next.hpp"
#include "exact/measure/contact/moving_triangles.hpp"
#include "exact/measure/contact/turning_triangles.hpp"

namespace ecods {
namespace {

// bound_at_beginning() first searches the time intervals from 0 to these times. Both times are powers of two; the first
// one is the least normal number.
constexpr std::array<double, 2> beginnings{0x1p-1022, 0x1p-537};

// Returns the part of the motion from time 0 up to time s, as a motion from time 0 to 1. Its end is P (1 - s) + Q s,
// with P and Q the points at times 0 and 1, computed as in moving_points.hpp. The end is off by the errors of the given
// points, at most e0 + s e1, by 3.01 u' (|P| + s |Q|) of rounding, and by 2^-1022 for each product that underflows.
// Claim: verify/proofs/moving_points.py
exact::MovingPoints points_up_to(const exact::MovingPoints& points, double s) {
    exact::MovingPoints result = points;
    double most_at_start = 0, most_at_end = 0;
    for (std::size_t i = 0; i < 6; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const double p = points.start[i][k], q = points.end[i][k];
            most_at_start = std::max(most_at_start, std::abs(p));
            most_at_end = std::max(most_at_end, std::abs(q));
            result.end[i][k] = p * (1 - s) + q * s;
        }
    }
    const double off = points.start_error + s * points.end_error;
    result.end_error = (1 + 8 * two_u) * off + 4 * two_u * (most_at_start + s * most_at_end) + 0x1p-1000;
    return result;
}

// Returns the corners of two triangles at times 0 and 1, if at least one of the bodies is translated. `points` has all
// corners at the start and at the pose at the end, the world's origin and both translations.
template <class Kernel>
std::array<exact::LongVector3, 12> translated_corners(const exact::IntegerPoints<Kernel, 15>& points,
                                                      const std::array<const Vec3*, 2>& translations) {
    const auto at = [&](std::size_t i, std::size_t k) { return exact::Integer(points.at[i][k]); };
    std::array<exact::LongVector3, 12> corners;
    for (std::size_t i = 0; i < 12; ++i) {
        const std::size_t side = i / 3 % 2;
        const bool is_translated = i >= 6 && translations[side] != nullptr;
        for (std::size_t k = 0; k < 3; ++k) {
            corners[i][k] = is_translated ? at(i - 6, k) + (at(13 + side, k) - at(12, k)) : at(i, k);
        }
    }
    return corners;
}

}  // namespace

void MovingPairs::bind(const MeshAtEnds& a, const MeshAtEnds& b, CastCounts& counts) {
    counts_ = &counts;
    const std::array<exact::BodyRef, 4> bodies{a.start.ref(), b.start.ref(), a.end, b.end};
    frame_.bind(bodies);
    translations_ = {a.translation, b.translation};
    ends_off_ = {a.end_off, b.end_off};
    known_.clear();
}

std::array<exact::VertexRef, 12> MovingPairs::corners_of(const TrianglePair& triangles) const {
    const std::array of{mesh(0).triangles()[triangles.a], mesh(1).triangles()[triangles.b]};
    std::array<exact::VertexRef, 12> corners;
    for (std::size_t body = 0; body < 4; ++body) {
        for (std::size_t i = 0; i < 3; ++i) corners[3 * body + i] = {body, of[body % 2][i]};
    }
    return corners;
}

exact::MovingPoints MovingPairs::points_of(const TrianglePair& triangles) {
    const exact::Points<12> rounded = frame_.rounded(corners_of(triangles));
    exact::MovingPoints points;
    std::copy_n(rounded.begin(), 6, points.start.begin());
    std::copy_n(rounded.begin() + 6, 6, points.end.begin());
    points.start_error = std::max(frame_.delta(0), frame_.delta(1));
    const auto error_at_end = [&](std::size_t side) {
        const double delta = frame_.delta(2 + side), off = ends_off_[side];
        return off > 0 ? (delta + off) * (1 + 2 * two_u) : delta;
    };
    points.end_error = std::max(error_at_end(0), error_at_end(1));
    return points;
}

std::optional<exact::TimeSpan> MovingPairs::bound(const TrianglePair& triangles, double from, double to,
                                                  exact::Effort effort) {
    ++counts_->enclosures;
    const exact::MovingPoints points = points_of(triangles);
    const auto time = exact::bound_first_meeting(points, from, to, effort);
    return time && time->from < beginnings.back() ? bound_at_beginning(points, from, to, effort) : time;
}

// Returns the result of bound() for the corners `points`; searches two short intervals from time 0 on before the rest.
// If bodies grow by a factor of 2^500 or more, their sizes at the start underflow beside their sizes at the end; within
// the short intervals they do not. A time divided by an interval's end is exact, or is a subnormal number that is
// flushed to zero, which is earlier. A product that underflows becomes earlier, too, or changes by less than the
// distance to the next double.
std::optional<exact::TimeSpan> MovingPairs::bound_at_beginning(const exact::MovingPoints& points, double from,
                                                               double to, exact::Effort effort) {
    for (const double end : beginnings) {
        if (from >= end) continue;
        ++counts_->enclosures;
        if (const auto part = exact::bound_first_meeting(points_up_to(points, end), from / end, 1, effort)) {
            const double first = std::max(from, next_down(part->from * end));
            if (key_of(first) > key_of(to)) return std::nullopt;
            return exact::TimeSpan{first, std::min(to, next_up(std::max(part->to * end, beginnings[0])))};
        }
        if (key_of(to) <= key_of(end)) return std::nullopt;
        from = end;
    }
    ++counts_->enclosures;
    return exact::bound_first_meeting(points, from, to, effort);
}

// Calls `ask` with the triangles of bodies of which at least one is translated. The rounded pose at the end of a
// translated body has no integers, so the pose at the start is used in its place.
template <class Function>
auto MovingPairs::ask_translated(const TrianglePair& triangles, Function& ask) {
    static const Pose world;
    static const Vec3 origin = Vec3::Zero();
    std::array<exact::VertexRef, 12> corners = corners_of(triangles);
    for (std::size_t i = 6; i < 12; ++i) {
        if (translations_[i / 3 % 2] != nullptr) corners[i].body -= 2;
    }
    exact::PosedPoints<15> points;
    std::ranges::copy(frame_.posed(corners), points.begin());
    points[12] = {&world, &origin};
    for (std::size_t side = 0; side < 2; ++side) {
        points[13 + side] = {&world, translations_[side] != nullptr ? translations_[side] : &origin};
    }
    const auto exact_corners =
        exact::with_integers(points, [&](const auto& integers) { return translated_corners(integers, translations_); });
    exact::MovingTriangles moving(exact_corners);
    return ask(moving);
}

template <class Function>
auto MovingPairs::ask_exactly(const TrianglePair& triangles, Function&& ask) {
    ++counts_->exact;
    if (translations_[0] != nullptr || translations_[1] != nullptr) return ask_translated(triangles, ask);
    return exact::with_integers(frame_.posed(corners_of(triangles)), [&](const auto& integers) {
        exact::MovingTriangles moving(integers);
        return ask(moving);
    });
}

std::optional<exact::Meeting> MovingPairs::decide(const TrianglePair& triangles, exact::TimeSpan time, double to) {
    return MeetingDecision(*this, known_, triangles).decide(time, to);
}

}  // namespace ecods
