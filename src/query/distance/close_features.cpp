#include <algorithm>
#include <array>
#include <compare>
#include <cstdint>

#include "base/double_key.hpp"
#include "ecods/contact.hpp"
#include "query/distance/distance_search.hpp"

namespace ecods {
namespace {

using PointKey = std::array<std::int64_t, 3>;

// A pair of features by the coordinates of their corners, and where it was found.
struct Key {
    ClosestKind kind;
    std::array<std::array<PointKey, 3>, 2> corners;  // of either feature, ascending; the last one fills the rest

    friend auto operator<=>(const Key&, const Key&) = default;
};

std::array<PointKey, 3> corners_of(const Feature& feature, const Mesh& mesh) {
    const Triangle& triangle = mesh.triangles()[feature.triangle];
    std::array<PointKey, 3> corners;
    const std::uint32_t last = static_cast<std::uint32_t>(feature.kind);  // 0, 1 or 2
    for (std::uint32_t i = 0; i < 3; ++i) {
        const Vec3& v = mesh.vertices()[triangle[(feature.corner + std::min(i, last)) % 3]];
        corners[i] = {key_of(v[0]), key_of(v[1]), key_of(v[2])};
    }
    std::ranges::sort(corners);
    // Of an edge whose second end is the lesser one, that end came twice.
    if (feature.kind == Feature::Kind::edge) corners[1] = corners[2];
    return corners;
}

}  // namespace

std::vector<CloseFeatures> close_features(const Posed<MeshShape>& a, const Posed<MeshShape>& b, double d,
                                          QueryMemory& memory) {
    const std::vector<ClosestPoints> all = close_triangles(a, b, d, memory);
    std::vector<std::pair<Key, std::size_t>> keys;
    for (std::size_t i = 0; i < all.size(); ++i) {
        keys.push_back(
            {{all[i].kind, {corners_of(all[i].a, a.what->mesh()), corners_of(all[i].b, b.what->mesh())}}, i});
    }
    std::ranges::sort(keys);
    const auto rest = std::ranges::unique(keys, {}, [](const auto& entry) { return entry.first; });
    keys.erase(rest.begin(), rest.end());
    std::ranges::sort(keys, {}, [](const auto& entry) { return entry.second; });

    DistanceSearch search(a, b, memory);
    std::vector<CloseFeatures> result;
    for (const auto& [key, i] : keys) {
        result.push_back({all[i], std::nullopt});
        if (all[i].kind == ClosestKind::intersecting) continue;
        const TrianglePair pair = all[i].triangles();
        result.back().direction = search.exact_pair().direction(pair.a, pair.b);
    }
    return result;
}

}  // namespace ecods
