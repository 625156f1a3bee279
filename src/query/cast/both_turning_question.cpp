#include "query/cast/both_turning_question.hpp"

#include <algorithm>

namespace ecods {

void BothTurnMotion::bind(const Turning<MeshShape>& a, const Turning<MeshShape>& b, CastCounts& counts) {
    BothTurningPairs::bind(a, b, counts);
    between_ = b.pose.t - a.pose.t;
    const auto bind_body = [&](std::size_t side, const Turning<MeshShape>& body) {
        const Vec3 glide = body.turn.pivot_to - body.turn.pivot_from;
        bodies_[side].bind(MeshShapeAccess::tree(*body.what), body.pose.R, angles(side),
                           body.turn.pivot_from - body.pose.t, glide, sum_of(glide), between_);
    };
    bind_body(0, a);
    bind_body(1, b);
    const TurningBody &first = bodies_[0], &second = bodies_[1];
    const double sizes = first.half.sum() + second.half.sum();
    double travel = 0;
    for (const TurningBody& body : bodies_) {
        body.require_moderate(sizes);
        travel += body.radius + body.way_length;
    }
    bind_bodies({*a.what, *b.what, first.half, second.half, travel, first.size + second.size});
}

// Restricts the motion to the piece. To halve a piece, divides the angle of that turn whose points leave their straight
// motions by more than those of the other turn.
void BothTurnMotion::set_piece(double from, double to) {
    set_times(from, to);
    constexpr double known = exact::TurnAngles::condition_max;
    Bounds bounds{
        .near = 0, .parts = {}, .rounding = 0, .pace = 1, .is_bounded = true, .may_divide = true, .lengths = {1, 1}};
    std::array<Places, 2> places;
    double most = 0;
    for (std::size_t side = 0; side < 2; ++side) {
        const TurningBody& body = bodies_[side];
        const exact::HalfAngle start = angles(side).at(from_), end = angles(side).at(to_);
        const double lag = angles(side).piece(start, end).lag(), near = body.radius * lag;
        const auto [least_condition, most_condition] = std::minmax(start.condition, end.condition);
        bounds.near += near;
        bounds.parts.across[side] = body.across(lag);
        bounds.rounding += body.rounding(start, end);
        bounds.later += body.later(start, end);
        bounds.is_bounded = bounds.is_bounded && body.is_bounded() && most_condition < known;
        bounds.may_divide = bounds.may_divide && body.is_bounded() && least_condition < known;
        if (!(near <= most)) {
            most = near;
            bounds.lengths = {start.length, end.length};
        }
        places[side] = {body.place_at(start), body.place_at(end)};
    }
    set_bounds(bounds);
    set_places(places[0], places[1], between_);
}

}  // namespace ecods
