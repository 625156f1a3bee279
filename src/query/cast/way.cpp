// This file checks motions and the nodes of ways, and computes the poses of bodies on ways.
#include "ecods/turn.hpp"

#include <array>
#include <string>
#include <utility>
#include <variant>

#include "base/limits.hpp"
#include "geometry/find_invalid.hpp"
#include "query/cast/exact_quaternion.hpp"
#include "query/cast/turn_leg.hpp"

namespace ecods {
namespace {

void require_finite(const WayNode& node, std::size_t index) {
    const std::array<std::pair<const char*, double>, 4> components{
        {{"q.w", node.q.w}, {"q.x", node.q.x}, {"q.y", node.q.y}, {"q.z", node.q.z}}};
    for (const auto& [name, value] : components) {
        if (!is_finite(value)) throw invalid_turn(name, value).at({}, index);
    }
    for (int axis = 0; axis < 3; ++axis) {
        if (is_finite(node.pivot[axis])) continue;
        throw invalid_turn("pivot(" + std::to_string(axis) + ")", node.pivot[axis]).at({}, index);
    }
}

// Returns true if q is a positive number, so that its rotation is the identity: w is positive, and x, y and z are zero.
bool is_at_start(const Quaternion& q) noexcept {
    return key_of(q.w) > 0 && is_zero(Vec3(q.x, q.y, q.z));
}

// Returns true if z1 is a negative multiple of z0.
bool is_opposite(const Quaternion& z1, const Quaternion& z0) {
    const ExactQuaternion between = times_conjugate(exact_quaternion(z1), exact_quaternion(z0));
    return between.w.sign() < 0 && exact::is_zero(between.v);
}

}  // namespace

void validate(std::span<const WayNode> nodes) {
    if (nodes.size() < 2) throw invalid_turn("nodes", static_cast<double>(nodes.size()));
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        const Quaternion& q = nodes[k].q;
        require_finite(nodes[k], k);
        if (key_of(q.w) == 0 && is_zero(Vec3(q.x, q.y, q.z))) throw whole_turn(0).at({}, k);
        if (k == 0 && !is_at_start(q)) throw invalid_turn("q", q.w).at({}, k);
        if (k > 0 && is_opposite(q, nodes[k - 1].q)) throw whole_turn(-1).at({}, k);
    }
}

void validate(const Motion& motion) {
    if (const auto* const translation = std::get_if<Translation>(&motion)) return validate_motion(translation->by);
    if (const auto* const straight = std::get_if<Straight>(&motion)) return validate(straight->to);
    if (const auto* const along = std::get_if<Along>(&motion)) return validate(along->nodes);
    validate(std::get<Turn>(motion));
}

Pose pose_at(const Pose& pose, std::span<const WayNode> nodes, std::size_t leg, double time) {
    validate(pose);
    validate(nodes);
    if (!is_from_zero(time) || key_of(time) > key_of(1.0)) throw invalid_time(time);
    if (leg + 1 >= nodes.size()) throw invalid_turn("nodes", static_cast<double>(leg));
    return pose_less(leg_of(pose, nodes, leg), time, {Mat3::Zero(), Vec3::Zero()});
}

}  // namespace ecods
