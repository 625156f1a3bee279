#include "bounds/local_frame.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace ecods {
namespace {

// Bounds the coordinates of a mesh that gets a frame. With larger coordinates, differences of coordinates, and their
// products with the frame, may overflow.
constexpr double coordinate_max = 0x1p900;
constexpr double scale_min = 0x1p-900;

// The axes are chosen from a sample of about this many triangles. A sample suffices, since boxes on any axes contain
// their triangles.
constexpr std::size_t sample_size_max = 4096;

struct Range {
    Vec3 min, max;

    Vec3 middle() const { return 0.5 * min + 0.5 * max; }
    double surface() const {
        const Vec3 e = max - min;
        return e[0] * e[1] + e[1] * e[2] + e[2] * e[0];
    }
};

// Calls visit(v) for each corner v of every stride-th triangle.
template <class Visit>
void visit_corners(const Mesh& mesh, std::size_t stride, Visit&& visit) {
    for (std::size_t i = 0; i < mesh.triangles().size(); i += stride) {
        for (const std::uint32_t index : mesh.triangles()[i]) visit(mesh.vertices()[index]);
    }
}

template <class Map>
Range range_of(const Mesh& mesh, std::size_t stride, Map&& map) {
    Range range;
    range.min = range.max = map(mesh.vertices()[mesh.triangles().front()[0]]);
    visit_corners(mesh, stride, [&](const Vec3& v) {
        const Vec3 y = map(v);
        range.min = range.min.cwiseMin(y);
        range.max = range.max.cwiseMax(y);
    });
    return range;
}

// Returns the principal axes of the corners of every stride-th triangle, as orthonormal columns; the identity if the
// computed axes are not orthonormal enough.
Mat3 principal_axes(const Mesh& mesh, std::size_t stride, const Vec3& center, double size) {
    Vec3 mean = Vec3::Zero();
    Mat3 moment = Mat3::Zero();
    double count = 0;
    visit_corners(mesh, stride, [&](const Vec3& v) {
        const Vec3 x = (v - center) / size;
        mean += x;
        moment += x * x.transpose();
        count += 1;
    });
    mean /= count;
    moment = moment / count - mean * mean.transpose();
    Eigen::SelfAdjointEigenSolver<Mat3> solver(moment);
    Mat3 axes = solver.eigenvectors();
    axes.col(0).normalize();
    axes.col(1) = (axes.col(1) - axes.col(0) * axes.col(0).dot(axes.col(1))).normalized();
    axes.col(2) = axes.col(0).cross(axes.col(1));
    // Tiny entries are set to zero: they would underflow when they are scaled.
    for (int i = 0; i < 9; ++i) {
        if (std::abs(axes.data()[i]) < 0x1p-100) axes.data()[i] = 0;
    }
    // The computed product is off by at most 4 u', u' = 2^-52, which is far below the limit.
    // Claim: verify/proofs/small_bounds.py
    const double tau = (axes.transpose() * axes - Mat3::Identity()).cwiseAbs().maxCoeff();
    return tau <= 0.5 * frame_tau_max ? axes : Mat3::Identity();
}

// Returns the frame with these axes. Its center is computed relative to `near`, which may be any point near the mesh.
LocalFrame frame_along(const Mesh& mesh, const Mat3& axes, const Vec3& near) {
    LocalFrame frame;
    frame.center =
        near + axes * range_of(mesh, 1, [&](const Vec3& v) -> Vec3 { return axes.transpose() * (v - near); }).middle();
    Vec3 reaches = Vec3::Zero();
    visit_corners(mesh, 1, [&](const Vec3& v) {
        reaches = reaches.cwiseMax((axes.transpose() * (v - frame.center)).cwiseAbs());
    });
    const double reach = reaches.maxCoeff();
    // The scale is a power of two that is greater than the reach, by a margin for the error of coordinates.
    int exponent = 0;
    const double fraction = std::frexp(reach, &exponent);
    const double scale =
        reach == 0 ? 1 : std::max(scale_min, std::ldexp(1.0, fraction > 1 - 0x1p-40 ? exponent + 1 : exponent));
    frame.axes = axes;
    frame.map = axes * scale;
    frame.inverse = axes.transpose() / scale;
    frame.scale = scale;
    // The constant 2 coordinate_error covers the error of coordinates, at most coordinate_error, and the rounding of
    // this sum, at most half of that error.
    frame.half = reaches / scale + Vec3::Constant(2 * coordinate_error);
    frame.map_size = frame.map.cwiseAbs().rowwise().sum();
    frame.size_max = std::max({1.0, frame.map.cwiseAbs().maxCoeff(), frame.center.cwiseAbs().maxCoeff()});
    return frame;
}

LocalFrame unbounded_frame() {
    LocalFrame frame;
    frame.is_bounded = false;
    return frame;
}

bool is_moderate(const Range& range) {
    return range.min.cwiseAbs().maxCoeff() <= coordinate_max && range.max.cwiseAbs().maxCoeff() <= coordinate_max;
}

}  // namespace

LocalFrame fit_frame(const Mesh& mesh) {
    const Range box = range_of(mesh, 1, [](const Vec3& v) { return v; });
    if (!is_moderate(box)) return unbounded_frame();
    const std::size_t stride = (mesh.triangles().size() + sample_size_max - 1) / sample_size_max;
    const Vec3 center = box.middle();
    const double size = (box.max - box.min).maxCoeff();
    Mat3 axes = Mat3::Identity();
    if (size > scale_min) {
        const Mat3 principal = principal_axes(mesh, stride, center, size);
        const auto surface = [&](const Mat3& along) {
            return range_of(mesh, stride,
                            [&](const Vec3& v) -> Vec3 { return along.transpose() * (v - center) / size; })
                .surface();
        };
        if (surface(principal) <= 0.9 * surface(axes)) axes = principal;
    }
    return frame_along(mesh, axes, center);
}

LocalFrame refit_frame(const LocalFrame& frame, const Mesh& mesh) {
    const Range box = range_of(mesh, 1, [](const Vec3& v) { return v; });
    if (!is_moderate(box)) return unbounded_frame();
    return frame_along(mesh, frame.axes, box.middle());
}

}  // namespace ecods
