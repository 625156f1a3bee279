#include "fuzz/motion/calm.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <variant>
#include <vector>

#include "fuzz/motion/numbers.hpp"
#include "fuzz/motion/poses.hpp"

namespace ecods::fuzz {
namespace {

using Chosen = bool (*)(Writing& w, Label body);

bool all(Writing&, Label) {
    return true;
}
bool tenth(Writing&, Label body) {
    return body % 10 == 0;
}
bool random_few(Writing& w, Label) {
    return w.random.below(50) == 0;
}
bool random_some(Writing& w, Label) {
    return w.random.below(20) == 0;
}

// Each body has a direction of its own and turns back after some frames, so that the scene stays together.
void drift(Writing& w, double share, Chosen chosen, const Vec3& common = Vec3::Zero()) {
    const bool goes_back = w.script.size() / 64 % 2 == 1;
    SetPoses call;
    for (const auto& [label, body] : w.model.bodies) {
        if (!chosen(w, label)) continue;
        scenes::Random own(static_cast<std::uint32_t>(label) + 1);
        Pose pose = body.pose;
        pose.t += w.setting.unit * (common + (goes_back ? -share : share) * own.direction());
        call.bodies.push_back(label);
        call.poses.push_back(pose);
    }
    w.make(std::move(call));
}

// By the angle of which the half has a tangent of 1/128, about the middle of the scene.
void turn(Writing& w) {
    constexpr double t = 1.0 / 128, cosine = (1 - t * t) / (1 + t * t), sine = 2 * t / (1 + t * t);
    Mat3 R;
    R << cosine, -sine, 0, sine, cosine, 0, 0, 0, 1;
    SetPoses call;
    for (const auto& [label, body] : w.model.bodies) {
        call.bodies.push_back(label);
        call.poses.push_back({R * body.pose.R, w.setting.origin + R * (body.pose.t - w.setting.origin)});
    }
    w.make(std::move(call));
}

void replace(Writing& w, Label body) {
    w.make(Destroy{body});
    w.create(w.any_part(), any_pose(w.setting, w.random));
}

void churn(Writing& w) {
    std::vector<Label> chosen;
    for (const auto& [label, body] : w.model.bodies) {
        if (random_some(w, label)) chosen.push_back(label);
    }
    for (const Label body : chosen) replace(w, body);
}

void teleport_few(Writing& w) {
    std::vector<Label> chosen;
    for (const auto& [label, body] : w.model.bodies) {
        if (random_few(w, label)) chosen.push_back(label);
    }
    for (const Label body : chosen) w.make(SetPose{body, any_pose(w.setting, w.random)});
}

struct Motion {
    const char* name;
    void (*make)(Writing& w);
};
const std::array motions = {
    Motion{"slow", [](Writing& w) { drift(w, 0.01, all); }},
    Motion{"a tenth of a size", [](Writing& w) { drift(w, 0.1, all); }},
    Motion{"half a size", [](Writing& w) { drift(w, 0.5, all); }},
    Motion{"a tenth moves", [](Writing& w) { drift(w, 0.01, tenth); }},
    Motion{"random ones move", [](Writing& w) { drift(w, 0.01, random_few); }},
    Motion{"some teleport",
           [](Writing& w) {
               drift(w, 0.01, all);
               teleport_few(w);
           }},
    Motion{"a swarm turns", turn},
    Motion{"a swarm flies",
           [](Writing& w) {
               drift(w, 0, all, {4, 3, 0});
           }},
    Motion{"a swarm flies, not quite together",
           [](Writing& w) {
               drift(w, 0.01, all, {-40, 3, 0.1});
           }},
    Motion{"some come and go",
           [](Writing& w) {
               churn(w);
               drift(w, 0.01, all);
           }},
    Motion{"some come and go, others at rest", churn},
    Motion{"one in, one out", [](Writing& w) { replace(w, w.any_body()); }},
    Motion{"rest before a burst", [](Writing&) {}},
};

}  // namespace

void calm_motion(Writing& w) {
    constexpr std::uint32_t frames_each = 6;
    const auto frame = static_cast<std::uint32_t>(
        std::ranges::count_if(w.script, [](const Call& call) { return std::holds_alternative<Update>(call); }));
    const Motion& motion = motions[(w.setting.body_count + 5 * (frame / frames_each)) % motions.size()];
    ++w.counters["calm motions: " + std::string(motion.name)];
    motion.make(w);
}

Pose calm_pose(const Setting& setting, const Model& model, std::uint32_t i, scenes::Random& random) {
    constexpr std::uint32_t per_cluster = 12, per_wall = 40;
    Pose pose = any_pose(setting, random);
    if (i % per_wall == 0) pose.R *= Vec3(10, 8, 0.25).asDiagonal();
    const bool is_clustered = setting.body_count % 3 == 0 && i % per_cluster != 0;
    if (!is_clustered) return pose;
    const auto middle = std::next(model.bodies.begin(), i - i % per_cluster);
    pose.t = middle->second.pose.t + setting.unit * any_offset(1.5, random);
    return pose;
}

}  // namespace ecods::fuzz
