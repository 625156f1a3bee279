#include "query/intersection/triangle_relations.hpp"

#include <type_traits>

#include "exact/sign/difference_signs.hpp"
#include "exact/sign/filter_bound.hpp"
#include "exact/sign/frame_signs.hpp"
#include "exact/sign/plain_signs.hpp"
#include "exact/simplex/common_pose.hpp"
#include "exact/simplex/edge_axes.hpp"
#include "exact/simplex/flat_filter.hpp"
#include "exact/simplex/triangle_pair.hpp"

namespace ecods {

using namespace exact;

void TriangleRelations::bind(const BodyRef& a, const BodyRef& b) {
    std::array<BodyRef, 2> bodies{a, b};
    // If both bodies have the same pose, mesh coordinates are compared instead of posed points.
    cancel_common_pose(bodies);
    frame_.bind(bodies);
    triangles_ = {a.mesh->triangles().data(), b.mesh->triangles().data()};
    static_bound_ = orient3d_bound(frame_);
    doubles_are_exact_ = false;
    flat_axis_ = -1;
    forget_groups();
    open_count_ = 0;
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
    // The planes of groups are tried first: once groups are in use, their planes decide most undecided pairs, and cost
    // less than posing points.
    if (planes_.are_used() && planes_.are_triangles_apart(a, b)) [[unlikely]] {
        ++counts_.plane_passes;
        return Relation::apart;
    }
    const Triangle& ta = triangles_[0][a];
    const Triangle& tb = triangles_[1][b];
    const Points<6> points = rounded(ta, tb);
    if (doubles_are_exact_) return decide_in_doubles(points);
    if (flat_axis_ >= 0) return decide_flat(a, b, points);
    FilterTrace trace;
    const FilterAnswer answer = filter(points, static_bound_, trace);
    if (answer == FilterAnswer::unknown) [[unlikely]]
        return decide_open(a, b, points, trace);
    ++counts_.filter_passes;
    return answer == FilterAnswer::disjoint ? Relation::apart : Relation::crossing;
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

// Returns the relation of triangles a and b, which the filter with the error bound of the two bodies left undecided.
[[gnu::noinline]] Relation TriangleRelations::decide_open(std::uint32_t a, std::uint32_t b, const Points<6>& points,
                                                          const FilterTrace& trace) {
    const Triangle &ta = triangles_[0][a], &tb = triangles_[1][b];
    const bool is_first = frame_.arithmetic() == Arithmetic::unknown;
    frame_.find_arithmetic();
    doubles_are_exact_ = frame_.arithmetic() >= Arithmetic::differences;
    // Rounds the points again, because find_arithmetic() may have changed the frame's units.
    if (doubles_are_exact_) return decide_in_doubles(rounded(ta, tb));
    if (is_first) {
        find_flat_axis();
        if (flat_axis_ >= 0) return decide_flat(a, b, points);
    }
    const DeterminantBounds bounds = determinant_bounds(points, frame_.delta());
    if (const auto relation = certain_relation(filter_again(points, bounds.orient3d, trace))) {
        ++counts_.semi_static_passes;
        return *relation;
    }
    const bool may_be_flat = certain_normal_axis(points, 0, bounds) < 0 || certain_normal_axis(points, 3, bounds) < 0;
    if (may_be_flat && edges_separate(points, bounds.orient3d)) {
        ++counts_.semi_static_passes;
        return Relation::apart;
    }
    const Corners corners = corners_of(ta, tb);
    if (may_use_groups()) return decide_by_planes(a, b, corners, points, bounds, trace);
    return decide_by_integers(corners, points, bounds, trace);
}

namespace {

// Returns true only if all vertices of the mesh have the same coordinate on the axis. extent.half is the rounded half
// of the difference of two doubles. If the two doubles differ, extent.half can be zero only if both are near the least
// doubles: hence 2^-900. Zeros are recognized by their bits, because a processor may treat other numbers as zero.
bool is_constant(const MeshExtent& extent, int axis) noexcept {
    if (extent.digits[static_cast<std::size_t>(axis)].empty()) return true;
    return extent.half[axis] == 0 && extent.magnitude[axis] > 0x1p-900;
}

// Returns true only if all points of the body have the same coordinate on axis `row` of the world.
bool is_flat(const BodyRef& body, int row) noexcept {
    for (int column = 0; column < 3; ++column) {
        if (decode(body.pose->R(row, column)).m != 0 && !is_constant(*body.extent, column)) return false;
    }
    return true;
}

}  // namespace

void TriangleRelations::find_flat_axis() {
    for (int axis = 0; axis < 3; ++axis) {
        if (!is_flat(frame_.body(0), axis) || !is_flat(frame_.body(1), axis)) continue;
        const std::array<VertexRef, 2> any{VertexRef{0, triangles_[0][0][0]}, {1, triangles_[1][0][0]}};
        const bool is_same = frame_.with_integers(
            any, [axis](const auto& points) { return ExactSigns(points).compare(0, 1, axis) == 0; });
        if (!is_same) continue;
        const Vec3& extent = frame_.extent();
        const DifferenceBound differences = difference_bound({extent[0], extent[1], extent[2]}, frame_.delta());
        const auto k = static_cast<std::size_t>(axis);
        flat_axis_ = axis;
        flat_bound_ = orient2d_bound(differences, (k + 1) % 3, (k + 2) % 3);
        return;
    }
}

Relation TriangleRelations::decide_flat(std::uint32_t a, std::uint32_t b, const Points<6>& points) {
    if (const FlatAnswer answer = filter_flat(points, flat_axis_, flat_bound_); answer != FlatAnswer::unknown) {
        ++counts_.filter_passes;
        return answer == FlatAnswer::disjoint ? Relation::apart : Relation::touching;
    }
    const DeterminantBounds bounds = determinant_bounds(points, frame_.delta());
    const double bound = bounds.orient2d[static_cast<std::size_t>(flat_axis_)];
    if (const FlatAnswer answer = filter_flat(points, flat_axis_, bound); answer != FlatAnswer::unknown) {
        ++counts_.semi_static_passes;
        return answer == FlatAnswer::disjoint ? Relation::apart : Relation::touching;
    }
    const Corners corners = corners_of(triangles_[0][a], triangles_[1][b]);
    FilterTrace trace;
    filter(points, infinite_bound, trace);
    return decide_by_integers(corners, points, bounds, trace);
}

// Returns true if coplanar groups decide pairs from now on; enables the groups if enough pairs were undecided. A mesh's
// groups are found once, and only after integers have decided at least one pair of the query for each 512 triangles. So
// queries with fewer such pairs do not pay for the search. The rule depends only on the query, so equal queries count
// equal work.
bool TriangleRelations::may_use_groups() {
    if (planes_.are_used()) return true;
    if (shapes_[0] == nullptr) return false;
    const std::size_t triangle_count =
        frame_.body(0).mesh->triangles().size() + frame_.body(1).mesh->triangles().size();
    constexpr std::size_t triangles_a_pair = 512;
    if (triangles_a_pair * ++open_count_ < triangle_count) return false;
    if (triangle_count <= PlaneSigns::triangle_count_max) {
        const CoplanarGroups& a = groups_of_(*shapes_[0]);
        const CoplanarGroups& b = groups_of_(*shapes_[1]);
        if (!a.empty() || !b.empty()) planes_.use(frame_, a, b);
    }
    shapes_ = {};
    return planes_.are_used();
}

namespace {

// SignsOfPlanes computes the signs that triangle_pair needs of two triangles that are not coplanar. The sides of the
// corners are given (`sides`). Orientations and normal axes come from the filter, or from integers if the filter is
// uncertain.
class SignsOfPlanes {
  public:
    SignsOfPlanes(Frame& frame, const std::array<VertexRef, 6>& corners, const Points<6>& points,
                  const DeterminantBounds& bounds, const std::array<Sides, 2>& sides) noexcept
        : frame_(frame), corners_(corners), filter_(points, bounds), sides_(sides) {}

    const Sides& sides(int plane, int /*points*/) const noexcept { return sides_[plane == 3 ? 0 : 1]; }
    int orient3d(int a, int b, int c, int d) {
        if (const int s = filter_.orient3d(a, b, c, d)) return s;
        return ask_integers([=](const auto& signs) { return signs.orient3d(a, b, c, d); });
    }
    int orient2d(int a, int b, int c, int axis) {
        if (const int s = filter_.orient2d(a, b, c, axis)) return s;
        return ask_integers([=](const auto& signs) { return signs.orient2d(a, b, c, axis); });
    }
    int compare(int a, int b, int axis) {
        return ask_integers([=](const auto& signs) { return signs.compare(a, b, axis); });
    }
    int normal_axis(int plane) {
        if (const int axis = filter_.normal_axis(plane); axis >= 0) return axis;
        return ask_integers([=](const auto& signs) { return signs.normal_axis(plane); });
    }
    bool has_used_integers() const noexcept { return has_used_integers_; }

  private:
    template <class Function>
    int ask_integers(const Function& ask) {
        has_used_integers_ = true;
        return frame_.with_integers(corners_, [&](const auto& integers) { return ask(ExactSigns(integers)); });
    }

    Frame& frame_;
    const std::array<VertexRef, 6>& corners_;
    FilterSigns<6> filter_;
    const std::array<Sides, 2>& sides_;
    bool has_used_integers_ = false;
};

}  // namespace

// Returns the relation of triangles a and b from the sides of the triangles' planes on which corners lie. Coplanar
// triangles are decided in integers, because they need many more signs.
Relation TriangleRelations::decide_by_planes(std::uint32_t a, std::uint32_t b, const Corners& corners,
                                             const Points<6>& points, const DeterminantBounds& bounds,
                                             const FilterTrace& trace) {
    const std::uint64_t computed_before = planes_.computed_count();
    const Sides first = planes_.complete(trace.first.certain_signs(bounds.orient3d), 1, b, a);
    const bool is_flat = all_zero(first);
    if (is_flat) return decide_by_integers(corners, points, bounds, trace);
    std::array<Sides, 2> sides{first, first};
    Relation relation = Relation::apart;
    bool has_used_integers = false;
    if (!all_positive(first) && !all_negative(first)) {
        sides[1] = planes_.complete(trace.second.certain_signs(bounds.orient3d), 0, a, b);
        SignsOfPlanes signs(frame_, corners, points, bounds, sides);
        relation = triangle_pair(signs);
        has_used_integers = signs.has_used_integers();
    }
    if (has_used_integers || planes_.computed_count() != computed_before) {
        ++integer_stage(counts_, frame_.arithmetic());
    } else {
        ++counts_.plane_passes;
    }
    return relation;
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
