#include <Eigen/Geometry>

#include "scenes/io/gltf_model.hpp"

namespace ecods::scenes {
namespace {

// The numbers of a member, or nothing if there is none.
template <int Size>
std::optional<Eigen::Matrix<double, Size, 1>> numbers(const JsonPlace& node, const char* key) {
    const auto member = node.find(key);
    if (!member) return std::nullopt;
    Eigen::Matrix<double, Size, 1> values;
    const auto elements = member->elements(Size);
    for (int i = 0; i < Size; ++i) values[i] = elements[static_cast<std::size_t>(i)].number();
    return values;
}

}  // namespace

Pose pose_of_matrix(const JsonPlace& place, std::span<const double, 16> values) {
    const auto matrix = Eigen::Map<const Eigen::Matrix4d>(values.data());  // by columns, as Eigen has it
    if (matrix.row(3) != Eigen::RowVector4d(0, 0, 0, 1)) place.fail("the last row is not 0 0 0 1");
    return {matrix.topLeftCorner<3, 3>(), matrix.topRightCorner<3, 1>()};
}

Pose local_pose(const JsonPlace& node) {
    const auto translation = numbers<3>(node, "translation");
    const auto rotation = numbers<4>(node, "rotation");
    const auto scale = numbers<3>(node, "scale");
    if (const auto matrix = numbers<16>(node, "matrix")) {
        if (translation || rotation || scale)
            node.fail("a matrix and a translation, rotation or scale exclude another");
        return pose_of_matrix(node.at("matrix"), std::span<const double, 16>(matrix->data(), 16));
    }
    Pose pose;
    if (rotation) {
        const Eigen::Quaterniond quaternion(*rotation);  // x, y, z, w
        const double norm = quaternion.norm();
        if (!(norm > 0)) node.at("rotation").fail("the quaternion is zero");
        if (norm > 0x1p500) node.at("rotation").fail("the quaternion is too large");
        // Files store it in single precision; normalised in double, the matrix is a rotation to the last bits.
        pose.R = quaternion.normalized().toRotationMatrix();
    }
    if (scale) pose.R *= scale->asDiagonal();
    if (translation) pose.t = *translation;
    return pose;
}

}  // namespace ecods::scenes
