#include <Eigen/Geometry>

#include "scenes/io/gltf_model.hpp"

namespace ecods::scenes {
namespace {

void check(const GltfModel& model, const std::string& place, const std::vector<double>& values, std::size_t size) {
    if (!values.empty() && values.size() != size)
        model.fail(place, "this should have " + std::to_string(size) + " numbers");
}

}  // namespace

Pose local_pose(const GltfModel& model, const std::string& place, const tinygltf::Node& node) {
    check(model, place + ".matrix", node.matrix, 16);
    check(model, place + ".translation", node.translation, 3);
    check(model, place + ".rotation", node.rotation, 4);
    check(model, place + ".scale", node.scale, 3);
    Pose pose;
    if (!node.matrix.empty()) {
        const auto matrix = Eigen::Map<const Eigen::Matrix4d>(node.matrix.data());  // by columns, as Eigen has it
        if (matrix.row(3) != Eigen::RowVector4d(0, 0, 0, 1))
            model.fail(place + ".matrix", "the last row is not 0 0 0 1");
        pose.R = matrix.topLeftCorner<3, 3>();
        pose.t = matrix.topRightCorner<3, 1>();
        return pose;
    }
    if (!node.rotation.empty()) {
        const Eigen::Quaterniond rotation(Eigen::Map<const Eigen::Vector4d>(node.rotation.data()));  // x, y, z, w
        if (!(rotation.norm() > 0)) model.fail(place + ".rotation", "the quaternion is zero");
        // Files store it in single precision; normalised in double, the matrix is a rotation to the last bits.
        pose.R = rotation.normalized().toRotationMatrix();
    }
    if (!node.scale.empty()) pose.R *= Eigen::Map<const Vec3>(node.scale.data()).asDiagonal();
    if (!node.translation.empty()) pose.t = Eigen::Map<const Vec3>(node.translation.data());
    return pose;
}

}  // namespace ecods::scenes
