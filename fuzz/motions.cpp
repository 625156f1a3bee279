#include "fuzz/motions.hpp"

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace ecods::fuzz {
namespace {

using scenes::Random;

std::size_t pick(std::size_t count, Random& random) {
    return random.below(static_cast<std::uint32_t>(count));
}

Mat3 signed_permutation(Random& random) {
    std::array<int, 3> columns = {0, 1, 2};
    for (std::uint32_t i = 2; i > 0; --i) std::swap(columns[i], columns[random.below(i + 1)]);
    Mat3 matrix = Mat3::Zero();
    for (int row = 0; row < 3; ++row) matrix(row, columns[row]) = random.below(2) == 0 ? 1 : -1;
    return matrix;
}

Mat3 integer_matrix(Random& random) {
    Mat3 matrix;
    for (double& entry : matrix.reshaped()) entry = static_cast<double>(random.below(5)) - 2;
    return matrix;
}

Vec3 half_integers(Random& random) {
    Vec3 point;
    for (double& x : point) x = 0.5 * (static_cast<double>(random.below(9)) - 4);
    return point;
}

Vec3 any_offset(double reach, Random& random) {
    Vec3 offset;
    for (double& x : offset) x = random.uniform(-reach, reach);
    return offset;
}

Vec3 random_place(const Setting& setting, Random& random) {
    return setting.origin + setting.unit * (random.below(2) == 0 ? half_integers(random) : any_offset(2, random));
}

// Puts a vertex of the body onto a vertex of the other: exactly, while coordinates are short.
Vec3 onto_vertex(const Body& body, const Body& other, const Mat3& matrix, Random& random) {
    const auto vertex = [&](const Body& of) { return of.mesh->vertices()[pick(of.mesh->vertices().size(), random)]; };
    return other.pose.R * vertex(other) + other.pose.t - matrix * vertex(body);
}

struct NamedPose {
    const char* name;
    Pose pose;
};

NamedPose next_pose(const Body& body, const Body& other, const Setting& setting, Random& random) {
    Pose pose = body.pose;
    const int axis = static_cast<int>(random.below(3));
    const double sign = random.below(2) == 0 ? 1 : -1;
    switch (random.below(14)) {
        case 0:
            pose.t[axis] += sign * 0.5 * setting.unit;
            return {"half step", pose};
        case 1:
            pose.t[axis] = std::nextafter(pose.t[axis], sign * std::numeric_limits<double>::infinity());
            return {"one ulp", pose};
        case 2:
            pose.t = random_place(setting, random);
            return {"teleport", pose};
        case 3:
            return {"equal pose", other.pose};
        case 4:
            pose.R = signed_permutation(random);
            return {"permutation matrix", pose};
        case 5:
            pose.R = integer_matrix(random);
            return {"integer matrix", pose};
        case 6:
            pose.R = random.rotation().toRotationMatrix();
            return {"rotation", pose};
        case 7: {
            const std::array<double, 6> factors = {0.5, 2, 1.5, 0.1, 16, 0};
            pose.R = factors[random.below(6)] * (random.below(3) == 0 ? Mat3::Identity().eval() : pose.R);
            if (pose.R.cwiseAbs().maxCoeff() > 100) pose.R.setIdentity();
            return {"size change", pose};
        }
        case 8:
            pose.t = onto_vertex(body, other, pose.R, random);
            return {"vertex onto vertex", pose};
        case 9:
            pose.R = other.pose.R;
            pose.t = onto_vertex(body, other, pose.R, random);
            return {"vertex onto vertex, equal matrices", pose};
        case 10:
            pose.R = other.pose.R;
            pose.t = other.pose.t + other.pose.R * (setting.unit * half_integers(random));
            return {"shift in the other's frame", pose};
        case 11:
            return {"same pose again", pose};
        default:
            pose.t += any_offset(0.3 * setting.unit, random);
            return {"step", pose};
    }
}

}  // namespace

Pose random_pose(const Setting& setting, Random& random) {
    Pose pose;
    pose.t = random_place(setting, random);
    switch (random.below(4)) {
        case 0:
            pose.R = random.rotation().toRotationMatrix();
            break;
        case 1:
            pose.R = signed_permutation(random);
            break;
        default:
            break;
    }
    return pose;
}

void change(Scene& scene, const Setting& setting, Random& random, Counters& counters) {
    const auto any_mesh = [&] { return setting.meshes[pick(setting.meshes.size(), random)]; };
    const std::size_t count = scene.bodies.size();
    const std::uint32_t kind = random.below(20);
    if (count < 2 || (kind == 0 && count < setting.bodies_max)) {
        scene.create(any_mesh(), random_pose(setting, random));
        ++counters["create"];
    } else if (kind == 1) {
        scene.destroy(pick(count, random));
        ++counters["destroy"];
    } else if (kind == 2) {
        // Its slot is used again at once, often at the same place.
        const std::size_t index = pick(count, random);
        const Body body = scene.bodies[index];
        scene.destroy(index);
        scene.create(random.below(2) == 0 ? body.mesh : any_mesh(), body.pose);
        ++counters["destroy and create"];
    } else if (kind == 3) {
        scene.set_mesh(pick(count, random), any_mesh());
        ++counters["set shape"];
    } else if (kind == 4) {
        const std::size_t index = pick(count, random);
        const Pose pose = scene.bodies[index].pose;
        scene.set_pose(index, random_pose(setting, random));
        scene.set_pose(index, pose);
        ++counters["there and back"];
    } else {
        const std::size_t index = pick(count, random);
        const auto next = next_pose(scene.bodies[index], scene.bodies[pick(count, random)], setting, random);
        scene.set_pose(index, next.pose);
        ++counters[next.name];
    }
}

}  // namespace ecods::fuzz
