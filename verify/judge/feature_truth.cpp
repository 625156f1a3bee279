#include "judge/feature_truth.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "judge/text.hpp"

namespace ecods::judge {
namespace {

std::string text(const std::optional<Vec3>& v) {
    return v ? judge::text(*v) : "none";
}

std::optional<Vec3> to_vector(const std::optional<oracle::ExactDirection>& exact) {
    if (!exact) return std::nullopt;
    return exact->nearest();
}

bool is_same(const std::optional<Vec3>& x, const std::optional<Vec3>& y) {
    return x.has_value() == y.has_value() && (!x || same_bits(*x, *y));
}

bool is_same(const CloseFeatures& x, const CloseFeatures& y) {
    return judge::is_same(x.closest, y.closest) && is_same(x.direction, y.direction);
}

bool is_same(const TriangleIntersection& x, const TriangleIntersection& y) {
    const auto are_same = [](const Vec3& p, const Vec3& q) { return same_bits(p, q); };
    return x.triangles == y.triangles && std::ranges::equal(x.shared.corners(), y.shared.corners(), are_same) &&
           is_same(x.shared.normal, y.shared.normal);
}

template <class Item>
std::optional<Wrong> require_same(const std::string& question, const std::vector<Item>& expected,
                                  const std::vector<Item>& got) {
    for (std::size_t i = 0; i < std::min(expected.size(), got.size()); ++i) {
        if (!is_same(expected[i], got[i])) {
            return Wrong{fmt::format("{}, item {}", question, i), judge::text(expected[i]), judge::text(got[i])};
        }
    }
    if (expected.size() == got.size()) return std::nullopt;
    return Wrong{question + ": length", std::to_string(expected.size()), std::to_string(got.size())};
}

}  // namespace

std::vector<CloseFeatures> to_close_features(const std::vector<oracle::ExactCloseFeatures>& exact) {
    std::vector<CloseFeatures> result;
    for (const auto& [closest, direction] : exact) {
        result.push_back({to_closest_points(closest), to_vector(direction)});
    }
    return result;
}

std::vector<TriangleIntersection> to_intersections(const std::vector<oracle::ExactIntersection>& exact) {
    std::vector<TriangleIntersection> result;
    for (const auto& [triangles, corners, normal] : exact) {
        TriangleIntersection intersection;
        intersection.triangles = triangles;
        SharedSet& shared = intersection.shared;
        for (const auto& corner : corners) shared.all_corners[shared.corner_count++] = corner.nearest();
        shared.normal = to_vector(normal);
        result.push_back(intersection);
    }
    return result;
}

std::string text(const CloseFeatures& close) {
    return fmt::format("{}, direction {}", text(close.closest), text(close.direction));
}

std::string text(const TriangleIntersection& intersection) {
    const auto& [a, b] = intersection.triangles;
    std::string corners;
    for (const Vec3& corner : intersection.shared.corners()) corners += text(corner);
    return fmt::format("triangles {} and {}: {}, normal {}", a, b, corners, text(intersection.shared.normal));
}

std::optional<Wrong> require(const std::string& question, const std::vector<CloseFeatures>& expected,
                             const std::vector<CloseFeatures>& got) {
    return require_same(question, expected, got);
}

std::optional<Wrong> require(const std::string& question, const std::vector<TriangleIntersection>& expected,
                             const std::vector<TriangleIntersection>& got) {
    return require_same(question, expected, got);
}

}  // namespace ecods::judge
