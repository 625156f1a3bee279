#include "programs/clash/picture/camera.hpp"

#include <algorithm>
#include <cmath>

namespace ecods::clash {

Camera camera_from(const Vec3& to_eye, const Vec3& vertical) {
    Camera camera;
    camera.forward = -to_eye.normalized();
    camera.right = camera.forward.cross(vertical).normalized();
    camera.up = camera.right.cross(camera.forward);
    return camera;
}

double half_height_of(const Camera& camera, std::span<const Vec3> points, double aspect) {
    double half_height = 0;
    for (const Vec3& point : points) {
        const Vec3 arm = point - camera.target;
        half_height = std::max({half_height, std::abs(arm.dot(camera.up)), std::abs(arm.dot(camera.right)) / aspect});
    }
    return half_height;
}

void look_at_middle(Camera& camera, std::span<const Vec3> points) {
    if (points.empty()) return;
    const Vec3 origin = points.front();  // far from the scene's, differences would be rounded to nothing
    Vec3 least = Vec3::Zero();
    Vec3 most = Vec3::Zero();
    for (const Vec3& point : points) {
        const Vec3 arm = point - origin;
        const Vec3 seen(arm.dot(camera.right), arm.dot(camera.up), arm.dot(camera.forward));
        least = least.cwiseMin(seen);
        most = most.cwiseMax(seen);
    }
    const Vec3 middle = least / 2 + most / 2;
    camera.target = origin + camera.right * middle.x() + camera.up * middle.y() + camera.forward * middle.z();
}

Vec3 on_screen(const Vec3& point, const Camera& camera, std::size_t width, std::size_t height) {
    const Vec3 arm = point - camera.target;
    const double scale = static_cast<double>(height) / (2 * camera.half_height);
    return {static_cast<double>(width) / 2 + scale * arm.dot(camera.right),
            static_cast<double>(height) / 2 - scale * arm.dot(camera.up), scale * arm.dot(camera.forward)};
}

std::array<Vec3, 8> corners_of(const Aabb& box) {
    std::array<Vec3, 8> corners;
    for (std::size_t i = 0; i < 8; ++i) {
        corners[i] = {(i & 1) != 0 ? box.max.x() : box.min.x(), (i & 2) != 0 ? box.max.y() : box.min.y(),
                      (i & 4) != 0 ? box.max.z() : box.min.z()};
    }
    return corners;
}

}  // namespace ecods::clash
