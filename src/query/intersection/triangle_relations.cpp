#include "query/intersection/triangle_relations.hpp"

#include <type_traits>

#include "exact/sign/difference_signs.hpp"
#include "exact/sign/filter_bound.hpp"
#include "exact/sign/frame_signs.hpp"
#include "exact/sign/plain_signs.hpp"
#include "exact/simplex/common_pose.hpp"
#include "exact/simplex/edge_axes.hpp"
#include "exact/simplex/triangle_pair.hpp"

namespace ecods {

using namespace exact;

void TriangleRelations::bind(const BodyRef& a, const BodyRef& b) {
    std::array<BodyRef, 2> bodies{a, b};
    // Bodies with one pose are compared where they were modelled.
    cancel_common_pose(bodies);
    frame_.bind(bodies);
    triangles_ = {a.mesh->triangles().data(), b.mesh->triangles().data()};
    static_bound_ = orient3d_bound(frame_);
    doubles_are_exact_ = false;
}

ECODS_ALWAYS_INLINE Points<6> TriangleRelations::rounded(const Triangle& a, const Triangle& b) {
    Points<6> points;
    for (std::size_t i = 0; i < 3; ++i) {
        points[i] = frame_.rounded(0, a[i]);
        points[3 + i] = frame_.rounded(1, b[i]);
    }
    return points;
}

Relation TriangleRelations::relation(std::uint32_t a, std::uint32_t b) {
    ECODS_ASSERT(a < frame_.body(0).mesh->triangles().size() && b < frame_.body(1).mesh->triangles().size());
    ++counts_.triangle_tests;
    const Triangle& ta = triangles_[0][a];
    const Triangle& tb = triangles_[1][b];
    const Points<6> points = rounded(ta, tb);
    if (doubles_are_exact_) return decide_in_doubles(points);
    FilterTrace trace;
    const FilterAnswer answer = filter(points, static_bound_, trace);
    if (answer == FilterAnswer::unknown) [[unlikely]]
        return decide_open(ta, tb, points, trace);
    ++counts_.filter_passes;
    return answer == FilterAnswer::disjoint ? Relation::disjoint : Relation::crossing;
}

Relation TriangleRelations::decide_in_doubles(const Points<6>& points) {
    if (frame_.arithmetic() == Arithmetic::plain) {
        ++counts_.local_passes;
        PlainSigns signs(points);
        return triangle_pair(signs);
    }
    DifferenceSigns signs(points, frame_.to_integers());
    const Relation relation = triangle_pair(signs);
    ++(signs.has_used_integers() ? counts_.one_limb : counts_.semi_static_passes);
    return relation;
}

// Decides triangles that the filter left open with the bound of the bodies.
[[gnu::noinline]] Relation TriangleRelations::decide_open(const Triangle& a, const Triangle& b, const Points<6>& points,
                                                          const FilterTrace& trace) {
    frame_.find_arithmetic();
    doubles_are_exact_ = frame_.arithmetic() >= Arithmetic::differences;
    // `points` may be in other units than the frame's points are now.
    if (doubles_are_exact_) return decide_in_doubles(rounded(a, b));
    const DeterminantBounds bounds = determinant_bounds(points, frame_.delta());
    switch (filter_again(points, bounds.orient3d, trace)) {
        case FilterAnswer::disjoint:
            ++counts_.semi_static_passes;
            return Relation::disjoint;
        case FilterAnswer::crossing:
            ++counts_.semi_static_passes;
            return Relation::crossing;
        case FilterAnswer::unknown:
            break;
    }
    const bool may_be_flat = certain_normal_axis(points, 0, bounds) < 0 || certain_normal_axis(points, 3, bounds) < 0;
    if (may_be_flat && edges_separate(points, bounds.orient3d)) {
        ++counts_.semi_static_passes;
        return Relation::disjoint;
    }
    const Corners corners{VertexRef{0, a[0]}, {0, a[1]}, {0, a[2]}, {1, b[0]}, {1, b[1]}, {1, b[2]}};
    return decide_by_integers(corners, points, bounds, trace);
}

Relation TriangleRelations::decide_by_integers(const Corners& corners, const Points<6>& points,
                                               const DeterminantBounds& bounds, const FilterTrace& trace) {
    return frame_.with_integers(corners, [&]<class Kernel>(const IntegerPoints<Kernel, 6>& integers) {
        if constexpr (std::is_same_v<Kernel, OneLimbKernel>)
            ++counts_.one_limb;
        else if constexpr (std::is_same_v<Kernel, TwoLimbKernel>)
            ++counts_.two_limbs;
        else
            ++counts_.many_limbs;
        TracedSigns signs(points, bounds, trace, integers);
        return triangle_pair(signs);
    });
}

}  // namespace ecods
