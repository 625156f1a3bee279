// Checking one's own engine: a test of triangles in plain doubles, beside the oracle's exact answers to questions that
// are hard. Put your own test in place of `my_engine_intersects`.
#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "oracle/oracle.hpp"
#include "scenes/hard_pairs.hpp"

namespace {

using namespace ecods;
using Corners = std::array<Vec3, 3>;

Corners posed(const Pose& pose, const Corners& v) {
    return {pose.R * v[0] + pose.t, pose.R * v[1] + pose.t, pose.R * v[2] + pose.t};
}

bool is_parted(const Corners& a, const Corners& b, const Vec3& axis) {
    double least[2], greatest[2];
    for (int k = 0; k < 2; ++k) {
        const Corners& c = k == 0 ? a : b;
        const double x = axis.dot(c[0]), y = axis.dot(c[1]), z = axis.dot(c[2]);
        least[k] = std::min({x, y, z});
        greatest[k] = std::max({x, y, z});
    }
    return greatest[0] < least[1] || greatest[1] < least[0];
}

// The separating axes of two triangles: correct in real numbers, and rounded here.
bool my_engine_intersects(const Corners& a, const Corners& b) {
    const auto edge = [](const Corners& c, std::size_t k) -> Vec3 { return c[(k + 1) % 3] - c[k]; };
    const Vec3 normal_a = edge(a, 0).cross(edge(a, 1)), normal_b = edge(b, 0).cross(edge(b, 1));
    if (is_parted(a, b, normal_a) || is_parted(a, b, normal_b)) return false;
    for (std::size_t i = 0; i < 3; ++i) {
        if (is_parted(a, b, normal_a.cross(edge(a, i))) || is_parted(a, b, normal_b.cross(edge(b, i)))) return false;
        for (std::size_t k = 0; k < 3; ++k)
            if (is_parted(a, b, edge(a, i).cross(edge(b, k)))) return false;
    }
    return true;
}

}  // namespace

int main() {
    constexpr int count = 400;
    fmt::print("{:26} {:>9} {:>5} {:>7} {:>7}\n", "family", "questions", "yes", "false -", "false +");
    for (const auto& family : scenes::hard_families()) {
        scenes::Random random(1);  // the same questions on every machine
        int yes = 0, false_negatives = 0, false_positives = 0;
        for (int i = 0; i < count; ++i) {
            const scenes::PosedPair pair = family.make(random);
            const bool truth = oracle::triangle_triangle(pair.pose_a, pair.a, pair.pose_b, pair.b) != Relation::apart;
            const bool answer = my_engine_intersects(posed(pair.pose_a, pair.a), posed(pair.pose_b, pair.b));
            yes += truth;
            false_negatives += truth && !answer;
            false_positives += answer && !truth;
        }
        fmt::print("{:26} {:9} {:5} {:7} {:7}\n", family.name, count, yes, false_negatives, false_positives);
    }
}
