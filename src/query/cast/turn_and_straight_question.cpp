#include "query/cast/turn_and_straight_question.hpp"

#include <algorithm>

namespace ecods {

void TurnAndStraightMotion::bind(const Turning<MeshShape>& a, const Moving<MeshShape>& b, CastCounts& counts) {
    TurnAndStraightPairs::bind(a, b, counts);
    between_ = b.from.t - a.pose.t;
    turning_.bind(MeshShapeAccess::tree(*a.what), a.pose.R, angles(), a.turn.pivot_from - a.pose.t,
                  a.turn.pivot_to - a.turn.pivot_from, rounded().way_size, between_);
    straight_.bind(MeshShapeAccess::tree(*b.what), b.from, b.to, between_);
    turning_.require_moderate(turning_.half.sum() + straight_.half.sum());
    bind_bodies({*a.what, *b.what, turning_.half, straight_.half, turning_.radius + turning_.way_length,
                 turning_.size + straight_.size, straight_.least});
}

void TurnAndStraightMotion::set_piece(double from, double to) {
    set_times(from, to);
    constexpr double known = exact::TurnAngles::condition_max;
    const exact::HalfAngle start = angles().at(from_), end = angles().at(to_);
    const double lag = angles().piece(start, end).lag();
    const auto [least_condition, most_condition] = std::minmax(start.condition, end.condition);
    const bool is_bounded = turning_.is_bounded() && straight_.is_bounded();
    set_bounds({.near = turning_.radius * lag,
                .parts = {.across = {turning_.across(lag)}},
                .rounding = turning_.rounding(start, end) + straight_.rounding(from_),
                .later = turning_.later(start, end) + (to_ - from_) * straight_.end_size,
                .pace = 1,
                .is_bounded = is_bounded && most_condition < known,
                .may_divide = is_bounded && least_condition < known,
                .lengths = {start.length, end.length}});
    set_places({turning_.place_at(start), turning_.place_at(end)}, {straight_.place_at(from_), straight_.place_at(to_)},
               between_);
}

}  // namespace ecods
