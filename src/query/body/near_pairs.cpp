#include "query/body/near_pairs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "base/arithmetic.hpp"
#include "base/next.hpp"
#include "geometry/find_invalid.hpp"
#include "query/distance/surface_distance.hpp"

namespace ecods {
namespace {

constexpr double underflow = 0x1p-1000;
constexpr double least_time = 0x1p-900;

double sum_of(const Vec3& v) {
    return (std::abs(v[0]) + std::abs(v[1])) + std::abs(v[2]);
}

PairList all_pairs(const Posed<MeshShape>& a, const Posed<MeshShape>& b) {
    PairList pairs;
    for (std::uint32_t i = 0; i < a.what->mesh().triangles().size(); ++i) {
        for (std::uint32_t j = 0; j < b.what->mesh().triangles().size(); ++j) pairs.push_back({i, j});
    }
    return pairs;
}

std::optional<PairList> list_within(const Posed<MeshShape>& a, const Posed<MeshShape>& b, double d, std::size_t most,
                                    QueryMemory& memory) {
    const double up = d * (1 + 8 * two_u);
    if (!is_finite(up)) return all_pairs(a, b);
    return surface::pairs_within(a, b, up, most, memory);
}

bool is_known(const Place& place) {
    return is_finite(place.error) && is_finite(place.point[0]) && is_finite(place.point[1]) &&
           is_finite(place.point[2]);
}

}  // namespace

Place place_on(const Line& line, double s) {
    const Vec3 step = line.is_ray ? line.b : Vec3(line.b - line.a);
    const double size = sum_of(line.a) + s * (sum_of(line.b) + (line.is_ray ? 0 : sum_of(line.a)));
    return {line.a + s * step, 8 * two_u * size + underflow};
}

std::optional<PairList> NearLine::list(double from, double to, std::size_t most) const {
    const Place first = place_on(line_, from), last = place_on(line_, std::max(next_up(to), least_time));
    const bool are_finite = is_known(first) && is_known(last);
    const std::array<Vec3, 2> ends = are_finite ? std::array{first.point, last.point} : std::array{line_.a, line_.a};
    const MeshShape segment(Mesh::create({ends[0], ends[1]}, {Triangle{0, 1, 1}}));
    const Posed<MeshShape> part(segment, Pose());
    if (!are_finite) return all_pairs(part, boundary_);
    return list_within(part, boundary_, p_.upper() + std::max(first.error, last.error), most, memory_);
}

std::optional<PairList> NearWay::list(double from, double to, std::size_t most) const {
    const double half = std::max((next_up(to) - from) / 2, least_time), middle = from + half;
    Pose pose = a_.pose;
    pose.t += middle * motion_;
    const Place place{pose.t, 9 * two_u * (sum_of(a_.pose.t) + middle * sum_of(motion_)) + underflow};
    if (!is_known(place)) return all_pairs(a_, b_);
    // The body is at most `reach` from its place at the middle time, at all times within `half` of that time.
    const double reach = half * (1 + 8 * two_u) * sum_of(motion_);
    return list_within({*a_.what, pose}, b_, p_.upper() + (reach + place.error), most, memory_);
}

}  // namespace ecods
