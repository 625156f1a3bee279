#include "query/cast/turning_question.hpp"

#include <algorithm>

namespace ecods {
namespace {

Vec3 vec3(const exact::Point& p) {
    return {p[0], p[1], p[2]};
}

}  // namespace

void TurnMotion::bind(const MeshShape& a, const TurnLeg& leg, const Posed<MeshShape>& b, CastCounts& counts) {
    TurningPairs::bind(a, leg, b, counts);
    const RoundedLeg& from = rounded();
    const MeshTree &tree_a = MeshShapeAccess::tree(a), &tree_b = MeshShapeAccess::tree(*b.what);
    between_ = from.b.t - from.a.t;
    body_.bind(tree_a, from.a.R, angles(), vec3(from.pivot), vec3(from.glide), from.way_size, between_);
    const Vec3 half_b = from.b.R.cwiseAbs() * tree_b.extent.half;
    body_.require_moderate(body_.half.sum() + half_b.sum());
    bind_bodies({a, *b.what, body_.half, half_b, body_.radius + body_.way_length, body_.size});
}

void TurnMotion::set_piece(double from, double to) {
    set_times(from, to);
    const exact::HalfAngle start = angles().at(from_), end = angles().at(to_);
    const exact::TurnPiece piece = angles().piece(start, end);
    const auto [least, most] = std::minmax(start.condition, end.condition);
    // If the rotation is known at neither end of the piece, it is known nowhere in the piece: h is convex, so the times
    // at which condition_max h is at most 1 - s + s |w| are an interval.
    constexpr double known = exact::TurnAngles::condition_max;
    const double share = (to_ - from_) * piece.shift * (1 + 4 * two_u);
    set_bounds({.near = body_.radius * piece.sagitta + body_.way_length * (to_ - from_) * piece.shift,
                .parts = {.everywhere = 4 * two_u * body_.way_size * share,
                          .across = {body_.across(piece.sagitta)},
                          .along = share * body_.glide},
                .rounding = body_.rounding(start, end),
                .later = body_.later(start, end),
                .pace = piece.pace,
                .is_bounded = body_.is_bounded() && most < known,
                .may_divide = body_.is_bounded() && least < known,
                .lengths = {start.length, end.length}});
    const TurningBody::Place rest{rounded().b.R, Vec3::Zero()};
    set_places({body_.place_at(start), body_.place_at(end)}, {rest, rest}, between_);
}

}  // namespace ecods
