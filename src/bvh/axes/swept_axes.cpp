#include "bvh/axes/swept_axes.hpp"

#include <algorithm>
#include <cmath>

#include "base/next.hpp"
#include "base/outward.hpp"
#include "bvh/axes/posed_axes.hpp"

namespace ecods {

struct SweptWindow {
    double begin = 0, end = axes::infinity;
};

}  // namespace ecods

#define ECODS_TEXT "bvh/axes/swept_axes_text.hpp"
#include "simd/each_set.hpp"

namespace ecods {
namespace {

constexpr double least_time = 0x1p-100;

}  // namespace

bool SweptAxes::bind(const PosedTree& a, const PosedTree& b, const Vec3& d, const Vec3& motion, double latest) {
    if (a.tree.frame.is_bounded && b.tree.frame.is_bounded) {
        const SweptWindow window = call_widest<ECODS_OF_EACH_SET(bind_swept_sets)>(sets_, a, b, d, motion, latest);
        start_ = window.begin;
        length_ = window.end;
        return length_ > 0;
    }
    // Nothing is known about the nodes of an unbounded tree, so no pair is excluded.
    start_ = 0;
    length_ = 1;
    for (SweptSet& set : sets_) {
        set = {};
        set.axes.set_unbounded();
    }
    return true;
}

// The result is rounded up: 2^-48 covers three roundings, and next_up() the rounding of the time in the world.
float SweptAxes::window_above(double time) const noexcept {
    const double at = (next_up(time) - start_) / length_;
    return round_up(std::min(std::max(at + std::abs(at) * 0x1p-48, 0.0), 1.0) + least_time);
}

}  // namespace ecods
