#include "query/body/rounded_way.hpp"

#include <array>
#include <utility>

#include "base/double_key.hpp"
#include "exact/measure/distance/name_features.hpp"
#include "exact/point/posed_point.hpp"

namespace ecods {

exact::ScaledLongVector RoundedWay::corner(const Posed<MeshShape>& body, std::uint32_t triangle, std::size_t i) const {
    const Mesh& mesh = body.what->mesh();
    return exact::posed_point(body.pose, mesh.vertices()[mesh.triangles()[triangle][i]]);
}

std::optional<NearTimes> RoundedWay::times(const TrianglePair& pair) const {
    std::array<exact::ScaledLongVector, 6> corners;
    for (std::size_t i = 0; i < 3; ++i) {
        corners[i] = corner(a_, pair.a, i);
        corners[3 + i] = corner(b_, pair.b, i);
    }
    auto interval = exact::RoundedContact(corners, motion_, p_).interval();
    if (!interval || key_of(interval->last.rounded) < 0) return std::nullopt;
    NearTimes times{*std::move(interval), {}, {}};
    exact::name_features(times.first, times.interval.first.features, pair);
    exact::name_features(times.last, times.interval.last.features, pair);
    return times;
}

void RoundedWay::add(const PairList& pairs) {
    for (const TrianglePair& pair : pairs) {
        if (!seen_.insert(std::uint64_t{pair.a} << 32 | pair.b).second) continue;
        if (auto found = times(pair)) found_.push_back(*std::move(found));
    }
}

}  // namespace ecods
