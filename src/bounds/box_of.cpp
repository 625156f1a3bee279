#include <algorithm>
#include <cmath>
#include <limits>

#include "base/double_key.hpp"
#include "base/next.hpp"
#include "bounds/scaled_pose.hpp"
#include "ecods/primitives.hpp"
#include "exact/point/point.hpp"
#include "geometry/used_vertices.hpp"

namespace ecods {
namespace {

// Collects the box of rounded vertices, and the largest |coordinates| of the vertices before posing. std::min and
// std::max in this argument order ignore NaN; NaN arises only with overflow, which is_moderate() excludes.
class BoxBuilder {
  public:
    explicit BoxBuilder(const Pose& pose) : pose_(pose) {}

    void add(const Vec3& v) {
        const exact::Point p = exact::pose_point(pose_.R, v, pose_.t);
        for (std::size_t k = 0; k < 3; ++k) {
            min_[k] = std::min(min_[k], p[k]);
            max_[k] = std::max(max_[k], p[k]);
        }
        v_max_ = v_max_.cwiseMax(v.cwiseAbs());
    }

    // Returns an upper bound of the error of each rounded coordinate.
    double delta() const { return exact::point_error_bound(pose_.R, v_max_, pose_.t); }

    // Returns true if the error bound `delta` is about 4.25 * 2^-52 times a sum of magnitudes that did not overflow.
    // Compares with a limit, because a rounding mode that rounds down turns some infinities into large numbers; these
    // exceed the limit, too.
    bool is_moderate(double delta) const {
        const double factor_max = std::max(pose_.R.cwiseAbs().maxCoeff(), v_max_.maxCoeff());
        return delta < 0x1p970 && delta > unscaled_min + unscaled_min * factor_max;
    }

    // Returns the box, enlarged by `delta` and then to the next doubles. The second step covers the rounding of the
    // first.
    Aabb box(double delta) const {
        Aabb box;
        for (int k = 0; k < 3; ++k) {
            box.min[k] = next_down(min_[static_cast<std::size_t>(k)] - delta);
            box.max[k] = next_up(max_[static_cast<std::size_t>(k)] + delta);
        }
        return box;
    }

  private:
    static constexpr double infinity = std::numeric_limits<double>::infinity();

    const Pose& pose_;
    exact::Point min_{infinity, infinity, infinity};
    exact::Point max_{-infinity, -infinity, -infinity};
    Vec3 v_max_ = Vec3::Zero();
};

// Returns the box of the posed mesh, computed in units in which no number overflows: only the ends of the box may
// overflow when they are scaled back. Compares keys of doubles, because the processor may take subnormal numbers for
// zero.
[[gnu::noinline]] Aabb scaled_box_of(const Mesh& mesh, const Pose& pose) {
    const auto vertices = mesh.vertices();
    Vec3 v_max = Vec3::Zero();
    for_each_used_vertex(mesh, [&](std::uint32_t index) {
        const Vec3 v = vertices[index].cwiseAbs();
        for (int k = 0; k < 3; ++k) {
            if (key_of(v[k]) > key_of(v_max[k])) v_max[k] = v[k];
        }
    });
    const ScaledPose scaled(pose, v_max, true);
    if (scaled.is_zero()) return {};
    BoxBuilder builder(scaled.pose());
    for_each_used_vertex(mesh, [&](std::uint32_t index) { builder.add(scaled.point(vertices[index])); });
    return scaled.unscaled(builder.box(builder.delta()));
}

}  // namespace

Aabb box_of(const Mesh& mesh, const Pose& pose) {
    const auto vertices = mesh.vertices();
    BoxBuilder builder(pose);
    for_each_used_vertex(mesh, [&](std::uint32_t index) { builder.add(vertices[index]); });
    const double delta = builder.delta();
    return builder.is_moderate(delta) ? builder.box(delta) : scaled_box_of(mesh, pose);
}

}  // namespace ecods
