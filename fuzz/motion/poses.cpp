#include "fuzz/motion/poses.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "fuzz/motion/extremes.hpp"
#include "fuzz/motion/numbers.hpp"

namespace ecods::fuzz {
namespace {

using scenes::Random;

// A corner, the middle of an edge, or a point within a face: exact while coordinates are short.
Vec3 point_of(const Mesh& mesh, Random& random) {
    const auto triangles = mesh.triangles();
    const Triangle& triangle = triangles[random.below(static_cast<std::uint32_t>(triangles.size()))];
    const Vec3& a = mesh.vertices()[triangle[0]];
    const Vec3& b = mesh.vertices()[triangle[1]];
    const Vec3& c = mesh.vertices()[triangle[2]];
    switch (random.below(3)) {
        case 0:
            return a;
        case 1:
            return 0.5 * a + 0.5 * b;
        default:
            return 0.5 * a + 0.25 * b + 0.25 * c;
    }
}

Pose onto_point(const PoseContext& c, const Mat3& matrix) {
    const auto vertices = c.body.part.mesh->vertices();
    const Vec3& vertex = vertices[c.random.below(static_cast<std::uint32_t>(vertices.size()))];
    const Vec3 target = c.other.pose.R * point_of(*c.other.part.mesh, c.random) + c.other.pose.t;
    return {matrix, target - matrix * vertex};
}

// The two ends of a body along an axis.
std::pair<double, double> extent(const ModelBody& body, const Pose& pose, int along) {
    double min = std::numeric_limits<double>::infinity();
    double max = -min;
    for (const Vec3& v : body.part.mesh->vertices()) {
        const double x = pose.R.row(along).dot(v) + pose.t[along];
        min = std::min(min, x);
        max = std::max(max, x);
    }
    return {min, max};
}

Pose face_to_face(const PoseContext& c) {
    Pose pose = c.body.pose;
    const int along = axis(c.random);
    const double gap = extent(c.other, c.other.pose, along).second - extent(c.body, pose, along).first;
    pose.t[along] += gap;
    return pose;
}

Pose size_change(const PoseContext& c) {
    constexpr std::array<double, 8> factors = {0.5, 2, 1.5, 0.1, 16, 0, 0x1p-60, 3};
    const double factor = factors[c.random.below(8)];
    Pose pose = c.body.pose;
    pose.R = factor * (c.random.below(3) == 0 ? Mat3::Identity().eval() : pose.R);
    if (pose.R.cwiseAbs().maxCoeff() > 100) pose.R.setIdentity();
    return pose;
}

// Where the middle of the other's coordinates is, or beside it; smaller in the other's frame, or larger.
Pose within(const PoseContext& c) {
    constexpr std::array<double, 4> factors = {0.25, 0.5, 0.5, 2};
    const Mat3& R = c.other.pose.R;
    return {factors[c.random.below(4)] * R, c.other.pose.t + R * (0.25 * c.setting.unit * half_integers(1, c.random))};
}

Pose with_R(const PoseContext& c, const Mat3& matrix) {
    return {matrix, c.body.pose.t};
}

Pose shifted(const PoseContext& c, const Vec3& offset) {
    return {c.body.pose.R, c.body.pose.t + offset};
}

const std::array move_table = {
    Move{"step", &Weights::step,
         [](const PoseContext& c) { return shifted(c, any_offset(0.3 * c.setting.unit, c.random)); }},
    Move{"half step along an axis", &Weights::step,
         [](const PoseContext& c) {
             const int along = axis(c.random);
             return shifted(c, sign(c.random) * 0.5 * c.setting.unit * Vec3::Unit(along));
         }},
    Move{"small turn", &Weights::step,
         [](const PoseContext& c) {
             const Eigen::Vector3d half = 0.05 * c.random.direction();
             const Eigen::Quaterniond turn(1, half[0], half[1], half[2]);
             return with_R(c, turn.normalized().toRotationMatrix() * c.body.pose.R);
         }},
    Move{"home again", &Weights::step, [](const PoseContext& c) { return c.home; }},
    Move{"same pose again", &Weights::step, [](const PoseContext& c) { return c.body.pose; }},

    Move{"exact contact: vertex onto a point of the other", &Weights::contact,
         [](const PoseContext& c) { return onto_point(c, c.body.pose.R); }},
    Move{"exact contact: vertex onto a point, equal matrices", &Weights::contact,
         [](const PoseContext& c) { return onto_point(c, c.other.pose.R); }},
    Move{"exact contact: face to face", &Weights::contact, face_to_face},
    Move{"exact contact: shift in the other's frame", &Weights::contact,
         [](const PoseContext& c) {
             const Mat3& R = c.other.pose.R;
             return Pose{R, c.other.pose.t + R * (c.setting.unit * half_integers(2, c.random))};
         }},
    Move{"within the other", &Weights::solids, within},
    Move{"within the other, on a point of it", &Weights::solids,
         [](const PoseContext& c) { return onto_point(c, 0.5 * c.other.pose.R); }},
    Move{"equal pose", &Weights::contact, [](const PoseContext& c) { return c.other.pose; }},

    Move{"one ulp", &Weights::ulp,
         [](const PoseContext& c) {
             Pose pose = c.body.pose;
             double& x = pose.t[axis(c.random)];
             x = neighbour(x, c.random);
             return pose;
         }},
    Move{"one ulp of the matrix", &Weights::ulp,
         [](const PoseContext& c) {
             Pose pose = c.body.pose;
             double& x = pose.R.reshaped()[c.random.below(9)];
             x = neighbour(x, c.random);
             return pose;
         }},
    Move{"one ulp beside the other", &Weights::ulp,
         [](const PoseContext& c) {
             Pose pose = onto_point(c, c.other.pose.R);
             double& x = pose.t[axis(c.random)];
             x = neighbour(x, c.random);
             return pose;
         }},

    Move{"size change", &Weights::size, size_change},
    Move{"size change: grown around all", &Weights::size,
         [](const PoseContext& c) { return with_R(c, 16 * c.setting.profile.space * Mat3::Identity()); }},
    Move{"size change: sheared", &Weights::size,
         [](const PoseContext& c) {
             Mat3 shear = Mat3::Identity();
             shear(axis(c.random), axis(c.random)) = 2;
             return with_R(c, shear);
         }},
    Move{"size change: flat", &Weights::size,
         [](const PoseContext& c) {
             Pose pose = c.body.pose;
             const int row = axis(c.random);
             pose.R.row(row).setZero();
             return pose;
         }},

    Move{"teleport", &Weights::jump,
         [](const PoseContext& c) {
             return Pose{c.body.pose.R, any_place(c.setting, c.random)};
         }},
    Move{"far from the origin", &Weights::jump,
         [](const PoseContext& c) {
             Pose pose = c.body.pose;
             const int exponent = static_cast<int>(c.random.below(60));
             pose.t[axis(c.random)] = sign(c.random) * std::ldexp(c.setting.unit, exponent);
             return pose;
         }},

    Move{"permutation matrix", &Weights::matrix,
         [](const PoseContext& c) { return with_R(c, signed_permutation(c.random)); }},
    Move{"integer rotation", &Weights::matrix,
         [](const PoseContext& c) { return with_R(c, integer_rotation(c.random)); }},
    Move{"integer matrix", &Weights::matrix, [](const PoseContext& c) { return with_R(c, integer_matrix(c.random)); }},
    Move{"rotation", &Weights::matrix, [](const PoseContext& c) { return with_R(c, any_rotation(c.random)); }},
    Move{"the other's matrix", &Weights::matrix, [](const PoseContext& c) { return with_R(c, c.other.pose.R); }},
};

}  // namespace

std::span<const Move> moves() {
    static const std::vector<Move> all = [] {
        std::vector<Move> both(move_table.begin(), move_table.end());
        both.insert(both.end(), extreme_moves().begin(), extreme_moves().end());
        return both;
    }();
    return all;
}

Vec3 any_place(const Setting& setting, Random& random) {
    const double space = setting.profile.space;
    const Vec3 offset = random.below(2) == 0 ? half_integers(space, random) : any_offset(space, random);
    return setting.origin + setting.unit * offset;
}

Pose any_pose(const Setting& setting, Random& random) {
    Pose pose;
    pose.t = any_place(setting, random);
    const std::uint32_t how = random.below(4);
    if (how == 0) pose.R = any_rotation(random);
    if (how == 1) pose.R = signed_permutation(random);
    return pose;
}

Pose stacked_pose(const Setting& setting, std::uint32_t i) {
    const Vec3 place(i % 3, i / 3 % 3, i / 9);
    return {setting.lattice, setting.origin + setting.lattice * (setting.unit * place)};
}

}  // namespace ecods::fuzz
