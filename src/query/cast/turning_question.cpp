#include "query/cast/turning_question.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/arithmetic.hpp"
#include "base/next.hpp"
#include "base/outward.hpp"
#include "ecods/error.hpp"
#include "query/cast/moving_question.hpp"

namespace ecods {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// These numbers affect only the work, not the results; they are measured (tori of 400 to 14,400 triangles). The reach
// is the size of both bodies, or the radius and the glide where these are less; of points, a part of all magnitudes. A
// piece is divided at once if it leaves its straight motion by more than 2^-9 of the smaller body and more than 2^-13
// of the reach; later, if it takes more than 512 steps and one for each eight triangles, and leaves it by more than
// 2^-18 of the reach. A piece that leaves it by 2^-18 of a length is longer than 2^-8 of this length, so some hundred
// pieces at most are near the other body.
constexpr double wide_part = 0x1p-9, wide_min = 0x1p-13, narrow_min = 0x1p-18, reach_min = 0x1p-30;
constexpr std::uint64_t step_min = 512, triangles_per_step = 8;

Vec3 vec3(const exact::Point& p) {
    return {p[0], p[1], p[2]};
}

double sum_of(const Vec3& v) {
    return v.cwiseAbs().sum();
}

// Returns an upper bound of the length; where its square may overflow, the sum of magnitudes.
double length_above(const Vec3& v) {
    const double square = v.squaredNorm(), length = square < 0x1p1000 ? std::sqrt(square) : sum_of(v);
    return length * (1 + 8 * two_u) + 0x1p-600;
}

}  // namespace

void TurnMotion::bind(const Turning<MeshShape>& a, const Vec3& motion, const Posed<MeshShape>& b, CastCounts& counts) {
    TurningPairs::bind(a, motion, b, counts);
    const MeshTree &tree_a = MeshShapeAccess::tree(*a.what), &tree_b = MeshShapeAccess::tree(*b.what);
    trees_ = {TreeAtEnds(tree_a.boxes), TreeAtEnds(tree_b.boxes)};
    a_start_ = &a.pose.R;
    b_pose_ = &b.pose.R;
    between_ = b.pose.t - a.pose.t;
    const Mat3 size_a = a.pose.R.cwiseAbs(), size_b = b.pose.R.cwiseAbs();
    const Vec3 c = vec3(pivot()), m = vec3(glide());
    size_ = (size_a * tree_a.extent.magnitude).sum() + sum_of(between_);
    arm_ = sum_of(c);
    const Vec3 arm = a.pose.R * tree_a.extent.center - c, half_a = size_a * tree_a.extent.half;
    const Vec3 half_b = size_b * tree_b.extent.half;
    radius_ = (length_above(vec3(angles().axis()).cross(arm)) + length_above(half_a)) + 128 * two_u * (size_ + arm_);
    way_ = length_above(m) + 4 * two_u * way_size();
    balls_ = length_above(half_a) + length_above(half_b);
    require_moderate(half_a.sum() + half_b.sum(), radius_ + way_);
    centers_ = {tree_a.extent.center, b.pose.R * tree_b.extent.center + between_};
    const std::size_t triangle_count = a.what->mesh().triangles().size() + b.what->mesh().triangles().size();
    usual_step_max_ = step_min + triangle_count / triangles_per_step;
    const double sizes = half_a.norm() + half_b.norm(), travel = radius_ + way_;
    const double reach = std::max(std::min(sizes, travel), reach_min * size_);
    wide_ = std::max(wide_part * std::min(half_a.norm(), half_b.norm()), wide_min * reach);
    narrow_ = narrow_min * reach;
}

// Beyond these limits bounds in doubles exclude nothing, and all pairs of triangles would be decided exactly.
void TurnMotion::require_moderate(double sizes, double way) const {
    if (angles().condition_limit() > exact::TurnAngles::condition_max) {
        throw NotSupported("the turn is within some 2^-28 of a whole one: turn twice");
    }
    if (!angles().is_bounded()) throw NotSupported("the turn's quaternion has parts below 2^-500 or above 2^500");
    if (way > 0x1p500 * sizes && sizes > 0) {
        throw NotSupported("the turn's pivot or glide is above 2^500 times as large as the bodies");
    }
}

void TurnMotion::set_piece(double from, double to) {
    // A time above `to` may round to it.
    from_ = from;
    to_ = std::min(1.0, next_up(next_up(to)));
    at_from_ = angles().at(from_);
    at_to_ = angles().at(to_);
    piece_ = angles().piece(at_from_, at_to_);
    const double condition = std::max(at_from_.condition, at_to_.condition);
    near_ = radius_ * piece_.sagitta + way_ * (to_ - from_) * piece_.shift;
    // Sizes of what turns, times the sine of half the angle, and of what is at rest or glides.
    const double turned = (1 + condition) * std::max(std::abs(at_from_.sin), std::abs(at_to_.sin)) * (size_ + arm_);
    const double off = turned + (size_ + to_ * way_size());
    margin_ = (near_ + 512 * two_u * off) * (1 + 16 * two_u) + 0x1p-600;
    const bool is_bounded = angles().is_bounded() && size_ + arm_ + way_size() < 0x1p1000;
    if (!is_bounded || !(condition < exact::TurnAngles::condition_max)) margin_ = infinity;
    // The rotation is known nowhere between two ends at which it is not known: h is convex, so the times at which
    // condition_max h is at most 1 - s + s |w| are an interval.
    const bool is_known = std::min(at_from_.condition, at_to_.condition) < exact::TurnAngles::condition_max;
    may_divide_ = is_bounded && is_known && !(near_ <= narrow_) && from < to;
    step_count_ = 0;
    step_max_ = may_divide_ ? usual_step_max_ : std::numeric_limits<std::uint64_t>::max() - 1;
    const Place start = place_at(at_from_), end = place_at(at_to_);
    gaps_ = {start.R * centers_[0] + start.t - centers_[1], end.R * centers_[0] + end.t - centers_[1]};
    axes_.bind({trees_[0], start.R, end.R}, {trees_[1], *b_pose_, *b_pose_}, between_ - start.t, between_ - end.t,
               margin_);
}

TurnMotion::Place TurnMotion::place_at(const exact::HalfAngle& half) const {
    const Vec3 axis = vec3(angles().axis());
    const double turned = 2 * half.sin * half.cos, inward = 2 * half.sin * half.sin;
    const auto way_of = [&](const Vec3& g) -> Vec3 {
        const Vec3 across = axis.cross(g);
        return turned * across + inward * axis.cross(across);
    };
    Place result;
    for (int k = 0; k < 3; ++k) result.R.col(k) = a_start_->col(k) + way_of(a_start_->col(k));
    result.t = half.time * vec3(glide()) - way_of(vec3(pivot()));
    return result;
}

std::optional<float> TurnMotion::first_of_boxes() {
    // Floats cannot hold the way of a body whose pivot is very far: balls around both bodies come first.
    const double reach = (balls_ + margin_) * (1 + 16 * two_u);
    for (int k = 0; k < 3; ++k) {
        const auto [low, high] = std::minmax(gaps_[0][k], gaps_[1][k]);
        if (low > reach || high < -reach) return std::nullopt;
    }
    return first_of_roots(axes_, trees_[0], trees_[1]);
}

// Divides the angle about in halves.
std::optional<double> TurnMotion::middle() const noexcept {
    const double of_angle = (from_ * at_to_.length + to_ * at_from_.length) / (at_from_.length + at_to_.length);
    const auto is_inside = [&](double s) { return s > from_ && next_up(next_up(s)) < to_; };
    if (!may_divide_) return std::nullopt;
    if (is_inside(of_angle)) return of_angle;
    const double half = 0.5 * from_ + 0.5 * to_;
    return is_inside(half) ? std::optional(half) : std::nullopt;
}

double TurnMotion::time_of(float bound) const noexcept {
    const double way = static_cast<double>(bound);
    if (!(way <= 1)) return infinity;
    return std::max(from_, next_down(from_ + (to_ - from_) * piece_.earliest(way)));
}

// The way l at the part t of a piece's time is at most t / (pace (1 - t) + t): the claim of TurnPiece has the proof. A
// time above `time` may round to it.
float TurnMotion::bound_of(double time) const noexcept {
    const double last = next_up(time);
    if (!(last < to_)) return 1;
    const double part = std::clamp((last - from_) / (to_ - from_) * (1 + 8 * two_u), 0x1p-100, 1.0);
    const double way = part / (piece_.pace * (1 - part) + part) * (1 + 16 * two_u) + 0x1p-100;
    return round_up(std::min(way, 1.0));
}

}  // namespace ecods
