#include "fuzz/pairs/text.hpp"

#include <fmt/format.h>

namespace ecods::fuzz {
namespace {

std::string to_text(const Vec3& v) {
    return fmt::format("({:a}, {:a}, {:a})", v[0], v[1], v[2]);
}

std::string to_text(const char* body, const Pose& pose, const std::array<Vec3, 3>& corners) {
    std::string text;
    for (int row = 0; row < 3; ++row) text += fmt::format("{}.R {}\n", body, to_text(pose.R.row(row).transpose()));
    text += fmt::format("{}.t {}\n", body, to_text(pose.t));
    for (const Vec3& v : corners) text += fmt::format("{}.v {}\n", body, to_text(v));
    return text;
}

}  // namespace

std::string to_text(const scenes::PosedPair& pair) {
    return to_text("a", pair.pose_a, pair.a) + to_text("b", pair.pose_b, pair.b);
}

const char* name(Relation relation) {
    switch (relation) {
        case Relation::disjoint:
            return "disjoint";
        case Relation::touching:
            return "touching";
        case Relation::crossing:
            return "crossing";
    }
    return "no relation";
}

}  // namespace ecods::fuzz
