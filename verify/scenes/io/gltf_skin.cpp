#include <fmt/format.h>

#include <array>

#include "scenes/io/gltf_mesh.hpp"

namespace ecods::scenes {
namespace {

constexpr std::size_t set_size = 4;  // joints and weights of a vertex in one attribute

// The inverse bind matrix of a joint.
Pose matrix_at(const JsonPlace& place, const GltfElements& matrices, std::size_t joint) {
    std::array<double, 16> values{};
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = matrices.number(joint, i);
    return pose_of_matrix(place, values);
}

}  // namespace

std::vector<Pose> joint_poses(GltfModel& model, const JsonPlace& skin, std::span<const std::optional<Pose>> nodes) {
    const auto place = skin.find("inverseBindMatrices");
    std::optional<GltfElements> matrices;
    if (place) matrices = read_accessor(model, *place, "MAT4", std::array{GltfType::float_});
    std::vector<Pose> poses;
    for (const JsonPlace& joint : skin.at("joints").elements()) {
        model.target(joint, "nodes");
        const std::optional<Pose>& pose = nodes[joint.index()];
        if (!pose) joint.fail("this joint is not in the default scene");
        if (matrices && poses.size() >= matrices->count) place->fail("there are more joints than matrices");
        poses.push_back(matrices ? product(*pose, matrix_at(*place, *matrices, poses.size())) : *pose);
    }
    return poses;
}

GltfSkinning::GltfSkinning(GltfModel& model, const JsonPlace& attributes, std::span<const Pose> joints)
    : attributes_(attributes), joints_(joints) {
    for (std::size_t i = 0; i == 0 || attributes.find(fmt::format("JOINTS_{}", i)); ++i) {
        const JsonPlace joints_place = attributes.at(fmt::format("JOINTS_{}", i));
        const JsonPlace weights_place = attributes.at(fmt::format("WEIGHTS_{}", i));
        Set set{joints_place, weights_place,
                read_accessor(model, joints_place, "VEC4", std::array{GltfType::ubyte, GltfType::ushort}),
                read_accessor(model, weights_place, "VEC4",
                              std::array{GltfType::float_, GltfType::ubyte, GltfType::ushort})};
        const std::size_t count = model.target(attributes.at("POSITION"), "accessors").at("count").count();
        if (set.joints.count < count || set.weights.count < count)
            joints_place.fail(fmt::format("there are {} vertices, and fewer joints or weights", count));
        sets_.push_back(std::move(set));
    }
}

Vec3 GltfSkinning::operator()(std::size_t vertex, const Vec3& position) const {
    std::optional<Vec3> first;
    Vec3 weighted_sum = Vec3::Zero();
    double sum = 0;
    for (const Set& set : sets_) {
        for (std::size_t i = 0; i < set_size; ++i) {
            const double weight = set.weights.number(vertex, i);
            if (weight == 0) continue;
            if (!(weight > 0))
                set.weights_place.fail(fmt::format("vertex {}: weight {} is negative or nan", vertex, i));
            const std::uint32_t joint = set.joints.whole(vertex, i);
            if (joint >= joints_.size())
                set.joints_place.fail(fmt::format("vertex {}: joint {} does not exist", vertex, joint));
            const Vec3 image = joints_[joint].R * position + joints_[joint].t;
            if (!first) first = image;
            weighted_sum += weight * (image - *first);
            sum += weight;
        }
    }
    if (!first) attributes_.fail(fmt::format("vertex {}: all weights are zero", vertex));
    return *first + weighted_sum / sum;
}

}  // namespace ecods::scenes
