#include "fuzz/pairs/text.hpp"

#include <fmt/format.h>

#include <span>

#include "judge/hit_truth.hpp"
#include "judge/text.hpp"
#include "judge/turn_truth.hpp"

namespace ecods::fuzz {
namespace {

std::string to_text(const char* body, const Pose& pose, std::span<const Vec3> vertices) {
    std::string text;
    for (int row = 0; row < 3; ++row) text += fmt::format("{}.R {}\n", body, judge::text(Vec3(pose.R.row(row))));
    text += fmt::format("{}.t {}\n", body, judge::text(pose.t));
    for (const Vec3& v : vertices) text += fmt::format("{}.v {}\n", body, judge::text(v));
    return text;
}

std::string to_text(const char* body, const Pose& pose, const Mesh& mesh) {
    std::string text = to_text(body, pose, mesh.vertices());
    for (const Triangle& t : mesh.triangles()) text += fmt::format("{}.f {} {} {}\n", body, t[0], t[1], t[2]);
    return text;
}

}  // namespace

std::string to_text(const scenes::PosedPair& pair) {
    return to_text("a", pair.pose_a, pair.a) + to_text("b", pair.pose_b, pair.b);
}

std::string to_text(const scenes::DistanceCase& made) {
    return to_text("a", made.pose_a, *made.a) + to_text("b", made.pose_b, *made.b);
}

std::string to_text(const scenes::SolidCase& made) {
    return to_text("a", made.a.pose, *made.a.mesh) + to_text("b", made.b.pose, *made.b.mesh);
}

std::string to_text(const scenes::ConvexCase& made) {
    return to_text("a", made.a.pose, *made.a.mesh) + to_text("b", made.b.pose, *made.b.mesh);
}

std::string to_text(const scenes::HitCase& made) {
    return to_text("body", made.pose, *made.mesh) + judge::text(made.line) + "\n";
}

std::string to_text(const scenes::CastCase& made) {
    return to_text("a", made.pose_a, *made.a) + "motion " + judge::text(made.motion) + "\n" +
           to_text("b", made.pose_b, *made.b);
}

std::string to_text(const scenes::MoveCase& made) {
    return to_text("a", made.from_a, *made.a) + to_text("to_a", made.to_a, std::span<const Vec3>()) +
           to_text("b", made.from_b, *made.b) + to_text("to_b", made.to_b, std::span<const Vec3>());
}

std::string to_text(const scenes::TurnCase& made) {
    return to_text("a", made.pose_a, *made.a) + "turn " + judge::text(made.turn) + "\n" +
           to_text("b", made.pose_b, *made.b);
}

}  // namespace ecods::fuzz
