#include "query/cast/turn_boxes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/arithmetic.hpp"
#include "base/next.hpp"

namespace ecods {
namespace {

constexpr double no_end = std::numeric_limits<double>::infinity();
constexpr double end_max = 0x1p1000, square_max = 0x1p500, box_margin = 0x1p-500;

const Aabb everywhere{Vec3::Constant(-no_end), Vec3::Constant(no_end)};

// Returns an upper bound of the length of v, whose sum of magnitudes is at most `sum`.
double long_enough(const Vec3& v, double sum) {
    return (sum < square_max ? std::sqrt(v.squaredNorm()) : sum) * (1 + 8 * two_u) + box_margin;
}

}  // namespace

TurnBoxes::TurnBoxes(const Aabb& start, const Turn& turn)
    : angles_(turn.q.w, {turn.q.x, turn.q.y, turn.q.z}), glide_(turn.pivot_to - turn.pivot_from) {
    const Vec3 axis(angles_.axis()[0], angles_.axis()[1], angles_.axis()[2]);
    most_ = start.min.cwiseAbs().cwiseMax(start.max.cwiseAbs());
    // Compares coordinate by coordinate, since NaN then fails. Differences of moderate numbers are below twice the
    // limit.
    const auto are_moderate = [](const Vec3& v) {
        return std::abs(v[0]) < end_max && std::abs(v[1]) < end_max && std::abs(v[2]) < end_max;
    };
    is_bounded_ =
        angles_.is_bounded() && are_moderate(most_) && are_moderate(turn.pivot_from) && are_moderate(turn.pivot_to);
    if (!is_bounded_) return;
    for (std::size_t i = 0; i < 8; ++i) {
        Vec3& p = corners_[i];
        p = {i % 2 == 0 ? start.min[0] : start.max[0], i / 2 % 2 == 0 ? start.min[1] : start.max[1],
             i / 4 == 0 ? start.min[2] : start.max[2]};
        const Vec3 arm = p - turn.pivot_from;
        const double sum = arm.cwiseAbs().sum();
        arm_ = std::max(arm_, sum);
        across_[i] = axis.cross(arm);
        inwards_[i] = axis.cross(across_[i]);
        radius_ = std::max(radius_, long_enough(across_[i], 2 * sum));
    }
    radius_ += 32 * two_u * arm_;
    way_ = long_enough(glide_, glide_.cwiseAbs().sum());
    size_ = (start.max - start.min).maxCoeff();
    // widths_[k] bounds coordinate k of a unit vector that is perpendicular to the axis (TurningCorners::margins).
    for (int k = 0; k < 3; ++k) {
        const double x = axis[(k + 1) % 3], y = axis[(k + 2) % 3];
        widths_[k] = std::sqrt(x * x + y * y) * (1 + 16 * two_u) + 0x1p-499;
    }
}

Aabb TurnBoxes::whole() const {
    const bool turns = angles_.axis() != exact::Point{};
    Aabb box{Vec3::Constant(no_end), Vec3::Constant(-no_end)};
    visit(1, [&](double, const Aabb& of_piece, bool may_divide) {
        if (turns && may_divide) return Next::divide;
        box = {box.min.cwiseMin(of_piece.min), box.max.cwiseMax(of_piece.max)};
        return Next::go_on;
    });
    return box;
}

TurnBoxes::Piece TurnBoxes::piece_between(double from, double to) const {
    Piece result{everywhere, false, true, from};
    if (!is_bounded_) return result;
    const exact::HalfAngle at_from = angles_.at(from), at_to = angles_.at(to);
    const exact::TurnPiece piece = angles_.piece(at_from, at_to);
    // The middle divides the angle into two parts of about the same size.
    result.middle = (from * at_to.length + to * at_from.length) / (at_from.length + at_to.length);
    const double condition = std::max(at_from.condition, at_to.condition);
    if (!(condition < exact::TurnAngles::condition_max) || !(piece.sagitta < no_end)) return result;
    result.is_bounded = true;
    result.is_long = radius_ * std::sqrt(8 * piece.sagitta) + way_ * (to - from) > 0.5 * size_;
    result.box = {Vec3::Constant(no_end), Vec3::Constant(-no_end)};
    include_places(at_from, result.box);
    include_places(at_to, result.box);
    for (int k = 0; k < 3; ++k) {
        const double way = std::abs(glide_[k]) * (1 + 2 * two_u);
        const double margin =
            (radius_ * piece.sagitta * widths_[k] + way * (to - from) * piece.shift) * (1 + 16 * two_u) + box_margin;
        result.box.min[k] = next_down(result.box.min[k] - margin);
        result.box.max[k] = next_up(result.box.max[k] + margin);
    }
    return result;
}

void TurnBoxes::include_places(const exact::HalfAngle& half, Aabb& box) const {
    const double turned = 2 * half.sin * half.cos, inward = 2 * half.sin * half.sin;
    const double common = 256 * two_u * (1 + half.condition) * std::abs(half.sin) * arm_;
    for (int k = 0; k < 3; ++k) {
        const double error = common + 16 * two_u * (most_[k] + std::abs(glide_[k])) + box_margin;
        for (std::size_t i = 0; i < 8; ++i) {
            const double x =
                ((corners_[i][k] + half.time * glide_[k]) + turned * across_[i][k]) + inward * inwards_[i][k];
            box.min[k] = std::min(box.min[k], next_down(x - error));
            box.max[k] = std::max(box.max[k], next_up(x + error));
        }
    }
}

}  // namespace ecods
