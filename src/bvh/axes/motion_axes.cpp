#include "bvh/axes/motion_axes.hpp"

#include "bvh/axes/posed_axes.hpp"

#define ECODS_TEXT "bvh/axes/motion_axes_text.hpp"
#include "simd/each_set.hpp"

namespace ecods {

void MotionAxes::bind(const MovingTree& a, const MovingTree& b, const Vec3& d_from, const Vec3& d_to) {
    if (a.is_bounded() && b.is_bounded()) {
        return call_widest<ECODS_OF_EACH_SET(bind_motion_sets)>(sets_, a, b, d_from, d_to);
    }
    set_unbounded();
}

void MotionAxes::bind(const MovingTree& a, const MovingTree& b, const Vec3& d_from, const Vec3& d_to,
                      const MotionMargin& margin) {
    if (a.is_bounded() && b.is_bounded()) {
        MotionMargin rounded = margin;
        rounded.everywhere += 8 * two_u * margin.along.cwiseAbs().sum();
        for (const MotionMargin::Across& across : margin.across) rounded.everywhere += 16 * two_u * across.most;
        return call_widest<ECODS_OF_EACH_SET(bind_near_motion_sets)>(sets_, a, b, d_from, d_to, rounded);
    }
    set_unbounded();
}

// An unbounded tree is never proven apart from anything.
void MotionAxes::set_unbounded() noexcept {
    for (MotionSet& set : sets_) {
        set = {};
        set.start.set_unbounded();
        set.end.set_unbounded();
    }
}

}  // namespace ecods
