#include "bvh/axes/motion_axes.hpp"

#include "bvh/axes/posed_axes.hpp"
#include "simd/dispatch.hpp"

namespace ecods {
namespace {

using namespace axes;

ECODS_ALWAYS_INLINE Matrix4 middle(const Edges& start, const Edges& end) noexcept {
    Matrix4 result;
    for (int i = 0; i < 3; ++i) result.column[i] = 0.5 * start.edges.column[i] + 0.5 * end.edges.column[i];
    return result;
}

// The normals of either tree's boxes as they are half-way.
ECODS_ALWAYS_INLINE void bind_motion_sets(std::array<MotionSet, 2>& sets, const MovingTree& a, const MovingTree& b,
                                          const Vec3& d_from, const Vec3& d_to) noexcept {
    const Edges a_from(a.tree.frame, a.from), a_to(a.tree.frame, a.to);
    const Edges b_from(b.tree.frame, b.from), b_to(b.tree.frame, b.to);
    const Matrix4 a_middle = middle(a_from, a_to), b_middle = middle(b_from, b_to);
    const Double4 d0 = load3(d_from.data()), d1 = load3(d_to.data());
    const Matrix4 normals_a = axes_of(a_middle, b_middle), normals_b = axes_of(b_middle, a_middle);
    set_floats(sets[0].start, DoubleAxes(normals_a, a_from, b_from, d0, Own::a), sets[0].start.a);
    set_floats(sets[0].end, DoubleAxes(normals_a, a_to, b_to, d1, Own::a), sets[0].end.a);
    set_floats(sets[1].start, DoubleAxes(normals_b, a_from, b_from, d0, Own::b), sets[1].start.b);
    set_floats(sets[1].end, DoubleAxes(normals_b, a_to, b_to, d1, Own::b), sets[1].end.b);
}

}  // namespace

void MotionAxes::bind(const MovingTree& a, const MovingTree& b, const Vec3& d_from, const Vec3& d_to) {
    if (a.tree.frame.is_bounded && b.tree.frame.is_bounded) {
        return dispatch<bind_motion_sets>(sets_, a, b, d_from, d_to);
    }
    // A tree without bounds is never apart from anything.
    for (MotionSet& set : sets_) {
        set = {};
        set.start.set_unbounded();
        set.end.set_unbounded();
    }
}

}  // namespace ecods
