#include <algorithm>
#include <limits>

#include "base/next.hpp"
#include "ecods/aabb.hpp"
#include "exact/point/point.hpp"

namespace ecods {
namespace {

// The box of rounded vertices, and the largest coordinates of the vertices themselves. std::min and std::max in this
// argument order ignore NaN. NaN arises only with overflow, which finish() handles.
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

    // Returns the box enlarged by the error of a rounded vertex, and to the next double for the subtraction itself. The
    // error is 4.25 2^-52 of a sum of magnitudes: below 2^960 it proves that neither the sum nor a coordinate
    // overflowed; otherwise the box is infinite. Infinities themselves prove nothing: a mode that rounds down turns
    // some of them into large numbers.
    Aabb finish() const {
        const double delta = exact::point_error_bound(pose_.R, v_max_, pose_.t);
        Aabb box{Vec3::Constant(-infinity), Vec3::Constant(infinity)};
        if (!(delta < 0x1p960)) return box;
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

}  // namespace

Aabb box_of(const Mesh& mesh, const Pose& pose) {
    BoxBuilder builder(pose);
    if (mesh.uses_all_vertices()) {
        for (const Vec3& v : mesh.vertices()) builder.add(v);
    } else {
        for (const Triangle& triangle : mesh.triangles()) {
            for (const std::uint32_t index : triangle) builder.add(mesh.vertices()[index]);
        }
    }
    return builder.finish();
}

}  // namespace ecods
