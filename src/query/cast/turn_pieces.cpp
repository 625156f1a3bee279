#include "query/cast/turn_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/arithmetic.hpp"
#include "base/next.hpp"
#include "base/outward.hpp"
#include "query/cast/moving_question.hpp"

namespace ecods {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// These numbers affect only the work, not the results; they were found by measurement (tori of 400 to 14,400
// triangles). The reach is the size of both bodies together, or the radius and the glide together if they are less; for
// points, it is a small part of all magnitudes. A piece is divided at once if it leaves its straight motion by more
// than 2^-9 of the smaller body and by more than 2^-13 of the reach. It is divided during the search if this takes more
// than 512 steps plus one for each eight triangles, and if the piece leaves its straight motion by more than 2^-18 of
// the reach. A piece that leaves its straight motion by 2^-18 of a length is longer than 2^-8 of this length, so at
// most some hundred pieces are near the other body. With more than 2^13 triangles, each piece saves more work than it
// costs; so 2^-10 takes the place of 2^-9.
constexpr double wide_part = 0x1p-9, wide_part_of_many = 0x1p-10;
constexpr double wide_min = 0x1p-13, narrow_min = 0x1p-18, reach_min = 0x1p-30;
// Limits pieces from below. A length below this one does not come from the bodies, but from the term that
// length_above() adds against underflow. The bodies are then almost points; no change of units makes them larger, and
// smaller pieces would not be closer to a straight motion.
constexpr double narrowest = 0x1p-580;
constexpr std::uint64_t step_min = 512, triangles_per_step = 8, many = std::uint64_t{1} << 13;

}  // namespace

void TurnPieces::bind_bodies(const Bodies& bodies) {
    const MeshTree &tree_a = MeshShapeAccess::tree(bodies.a), &tree_b = MeshShapeAccess::tree(bodies.b);
    trees_ = {TreeAtEnds(tree_a.boxes), TreeAtEnds(tree_b.boxes)};
    centers_ = {tree_a.extent.center, tree_b.extent.center};
    balls_ = length_above(bodies.half_a) + length_above(bodies.half_b);
    const std::size_t triangle_count = bodies.a.mesh().triangles().size() + bodies.b.mesh().triangles().size();
    usual_step_max_ = step_min + triangle_count / triangles_per_step;
    const double size_a = bodies.half_a.norm(), size_b = std::min(bodies.half_b.norm(), bodies.least_b);
    const double reach = std::max(std::min(size_a + size_b, bodies.travel), reach_min * bodies.size);
    const double part = triangle_count > many ? wide_part_of_many : wide_part;
    wide_ = std::max(part * std::min(size_a, size_b), wide_min * reach);
    narrow_ = std::max(narrow_min * reach, narrowest);
}

// Extends the piece to two doubles above `to`, because a time above `to` may round to it.
void TurnPieces::set_times(double from, double to) noexcept {
    from_ = from;
    to_ = std::min(1.0, next_up(next_up(to)));
}

void TurnPieces::set_bounds(const Bounds& bounds) noexcept {
    near_ = bounds.near;
    const double rounding = 512 * two_u * bounds.rounding, later = 512 * two_u * bounds.later;
    margin_ = bounds.is_bounded ? (near_ + (rounding + later)) * (1 + 16 * two_u) + 0x1p-600 : infinity;
    // The margin is given by parts only if all parts are far from infinity: infinity times zero is no bound.
    if (margin_ < 0x1p900) {
        parts_ = bounds.parts;
        parts_.everywhere += rounding * (1 + 16 * two_u) + 0x1p-600;
        parts_.later = later * (1 + 16 * two_u);
    } else {
        parts_ = {.everywhere = margin_};
    }
    times_.pace = bounds.pace;
    lengths_ = bounds.lengths;
    middle_ = bounds.may_divide && !(near_ <= narrow_) ? find_middle() : std::nullopt;
    step_count_ = 0;
    step_max_ = middle_ ? usual_step_max_ : std::numeric_limits<std::uint64_t>::max() - 1;
}

void TurnPieces::set_places(const Places& a, const Places& b, const Vec3& between) {
    for (std::size_t i = 0; i < 2; ++i) {
        gaps_[i] = (a[i].R * centers_[0] + a[i].t) - (b[i].R * centers_[1] + (between + b[i].t));
    }
    axes_.bind({trees_[0], a[0].R, a[1].R}, {trees_[1], b[0].R, b[1].R}, (between + b[0].t) - a[0].t,
               (between + b[1].t) - a[1].t, parts_);
}

std::optional<float> TurnPieces::first_of_boxes() {
    // Compares balls around both bodies first, because floats cannot hold the way of a body whose pivot is very far
    // away.
    const double reach = (balls_ + margin_) * (1 + 16 * two_u);
    for (int k = 0; k < 3; ++k) {
        const auto [low, high] = std::minmax(gaps_[0][k], gaps_[1][k]);
        if (low > reach || high < -reach) return std::nullopt;
    }
    return first_of_roots(axes_, trees_[0], trees_[1]);
}

// Returns the time that divides the angle into two parts of about the same size; the middle of the time if rounding
// puts that time outside the piece; nullopt if the middle is outside, too.
std::optional<double> TurnPieces::find_middle() const noexcept {
    const double of_angle = (from_ * lengths_[1] + to_ * lengths_[0]) / (lengths_[0] + lengths_[1]);
    const auto is_inside = [&](double s) { return s > from_ && next_up(next_up(s)) < to_; };
    if (is_inside(of_angle)) return of_angle;
    const double half = 0.5 * from_ + 0.5 * to_;
    return is_inside(half) ? std::optional(half) : std::nullopt;
}

double TurnPieces::time_of(float bound) const noexcept {
    const double way = static_cast<double>(bound);
    if (!(way <= 1)) return infinity;
    return std::max(from_, next_down(from_ + (to_ - from_) * times_.earliest(way)));
}

// Returns the bound for the double above `time`, because a time above `time` may round to it. At the part t of a
// piece's time, the straight motion has gone at most the part t / (pace (1 - t) + t) of its way; the claim of TurnPiece
// has the proof.
float TurnPieces::bound_of(double time) const noexcept {
    const double last = next_up(time);
    if (!(last < to_)) return 1;
    const double part = std::clamp((last - from_) / (to_ - from_) * (1 + 8 * two_u), 0x1p-100, 1.0);
    const double way = part / (times_.pace * (1 - part) + part) * (1 + 16 * two_u) + 0x1p-100;
    return round_up(std::min(way, 1.0));
}

}  // namespace ecods
