// TurnBoxes computes boxes that contain a body while it turns, from a box that contains it at the start. A world uses
// the boxes only to exclude bodies that cannot meet; no result depends on a box.
//
// Bound. Every point of the body is a convex combination of the corners p of the box at the start, and remains the same
// combination of the corners' places x, since these are affine in p. Let c be the pivot, m its glide, g = p - c, and G
// >= |g| for all corners. c and p are doubles; g and m are differences, off by u' of themselves. So x as computed
// (turning_points.hpp, with e_p = 0, e_g = 1.01 u' G and e_m = 1.01 u' |m|) is off on each axis by less than
//     148 u' (1 + k) |sin| G + 7.2 u' (|p| + |m|)
// of that axis; 256 and 16 in place of both factors cover the rounding of the bound. In a piece of the turn, every
// point is within its distance from the axis times the sagitta, and |m| times the shift, of a chord of its places at
// both ends (turning_points.hpp), and so the places of the corners at both ends, widened, contain it. The distance from
// the axis is convex, so it is the greatest at a corner: |e x g|, off by 6.2 u' G + 1.42 e_g on each axis, below 32 u'
// G in length.
//
// Underflow. Numbers are not scaled: squares that are lost are below 2^-1021, so a length is off by less than 2^-508,
// and every other lost number is smaller. 2^-500 is added.
// Claim: verify/proofs/turn_pieces.md
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ecods/primitives.hpp"
#include "exact/measure/contact/half_angle.hpp"

namespace ecods {

class TurnBoxes {
  public:
    TurnBoxes(const Aabb& start, const Turn& turn);

    // Next says what visit() does after a piece.
    enum class Next : std::uint8_t { go_on, divide, stop };

    // Calls found(from, box, may_divide) for the pieces of the time from 0 to `latest`, earliest first. `box` contains
    // the body in the piece, which begins at time `from`. If may_divide is true, the piece is long, and found() may
    // return Next::divide to have its two parts visited instead. If no bound in doubles holds, the box is infinite.
    template <class Found>
    void visit(double latest, const Found& found) const {
        std::vector<End> ends{{latest, 0}};  // ends of the pieces left; the next one is last
        for (double from = 0; !ends.empty();) {
            const End end = ends.back();
            const Piece piece = piece_between(from, end.time);
            const bool may_divide =
                piece.is_long && end.depth < depth_max && piece.middle > from && piece.middle < end.time;
            const Next next = may_divide && !piece.is_bounded ? Next::divide : found(from, piece.box, may_divide);
            if (next == Next::stop) return;
            if (next == Next::divide && may_divide) {
                ends.back().depth = end.depth + 1;
                ends.push_back({piece.middle, end.depth + 1});
            } else {
                from = end.time;
                ends.pop_back();
            }
        }
    }

    // Returns a box that contains the body at all times from 0 to 1.
    Aabb whole() const;

  private:
    struct End {
        double time;
        int depth;
    };
    struct Piece {
        Aabb box;
        bool is_bounded, is_long;
        double middle;
    };
    Piece piece_between(double from, double to) const;
    void include_places(const exact::HalfAngle& half, Aabb& box) const;

    // Limits how often a piece is halved. The limit affects only the cost.
    static constexpr int depth_max = 7;

    exact::TurnAngles angles_;
    std::array<Vec3, 8> corners_, across_, inwards_;  // p, d1 and d2
    Vec3 glide_ = Vec3::Zero(), most_ = Vec3::Zero(), widths_ = Vec3::Zero();
    double arm_ = 0;  // G
    double radius_ = 0, way_ = 0, size_ = 0;
    bool is_bounded_ = false;
};

}  // namespace ecods
