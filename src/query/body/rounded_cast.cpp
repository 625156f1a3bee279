// Implements casts of rounded bodies, and casts to a distance. Let p be the sum of the radii and of the distance in
// question. Bodies that are further apart than this distance at the start first reach it when their cores reach the
// distance p. Since p > 0, the cores are then apart, and closest to each other on their boundaries.
#include <limits>

#include "base/double_key.hpp"
#include "base/limits.hpp"
#include "ecods/cast.hpp"
#include "ecods/rounded.hpp"
#include "exact/measure/round/long_rounding.hpp"
#include "exact/measure/round/squared_distance.hpp"
#include "exact/point/posed_point.hpp"
#include "geometry/find_invalid.hpp"
#include "query/body/near_pairs.hpp"
#include "query/body/posed_body.hpp"
#include "query/body/rounded_pair.hpp"
#include "query/body/rounded_way.hpp"
#include "query/intersection/asking.hpp"

namespace ecods {
namespace {

// Returns the first contact of the pairs `found` if its real time is at most `latest`: the least rounded time, then the
// first features; otherwise nullopt. A pair's time may round to `latest` and be later; then another pair with the same
// rounded time must be in time.
std::optional<FirstContact> first_by(double latest, const std::vector<NearTimes>& found) {
    const NearTimes* best = nullptr;
    const auto key = [](const NearTimes& times) { return key_of(times.interval.first.rounded); };
    bool is_in_time = false;
    for (const NearTimes& times : found) {
        if (best != nullptr && key(times) > key(*best)) continue;
        if (best == nullptr || key(times) < key(*best)) is_in_time = false;
        if (best == nullptr || key(times) < key(*best) || rank(times.first) < rank(best->first)) best = &times;
        is_in_time = is_in_time || key(times) < key_of(latest) ||
                     (key(times) == key_of(latest) &&
                      exact::compare(times.interval.first.time, exact::ScaledInteger(latest)) <= 0);
    }
    if (!is_in_time) return std::nullopt;
    return FirstContact{best->interval.first.rounded, best->first.kind, best->first.a, best->first.b};
}

std::optional<FirstContact> cast_boundaries(const Posed<MeshShape>& a, const exact::ScaledLongVector& motion,
                                            const Posed<MeshShape>& b, const exact::ExactSum& p, double latest,
                                            QueryMemory& memory) {
    if (exact::is_zero(motion)) return std::nullopt;
    const Vec3 rounded_motion = exact::round_point(motion, exact::ScaledInteger(1.0));
    const NearWay near(a, rounded_motion, b, p, memory);
    RoundedWay way(a, motion, b, p);
    std::optional<FirstContact> contact;
    search_earliest(
        latest, [&](double from, double to, std::size_t most) { return near.list(from, to, most); },
        [&](const PairList& pairs) {
            way.add(pairs);
            contact = first_by(latest, way.found());
            return contact ? contact->time : std::numeric_limits<double>::infinity();
        });
    return contact;
}

std::optional<FirstContact> cast_to(const RoundedPair& bodies, const Vec3& motion, double distance, double max_time,
                                    const Ask& ask) {
    require_finite_distance(distance);
    return bodies.cast(motion, distance, max_time, ask);
}

}  // namespace

std::optional<FirstContact> RoundedPair::cast(const Vec3& motion, double distance, double max_time,
                                              const Ask& ask) const {
    if (radii().sum().plus(distance).sign() == 0) return ecods::cast(a.core, motion, b.core, max_time, ask);
    const double latest = require_time(max_time);
    validate_motion(motion);
    return cast_along(exact::exact_vector(motion), distance, latest, ask);
}

std::optional<FirstContact> RoundedPair::cast_along(const exact::ScaledLongVector& motion, double distance,
                                                    double latest, const Ask& ask) const {
    const exact::ExactSum p = radii().sum().plus(distance);
    Asking asking(ask);
    QueryMemory& memory = asking.memory();
    const BodyPairAsked bodies(a.core, b.core);
    return as_one_query(memory, [&]() -> std::optional<FirstContact> {
        const Ask part(memory, asking.witness());
        if (within(distance, part)) {
            const ClosestPoints at = closest(part);
            return FirstContact{0, at.kind, at.a, at.b};
        }
        auto contact = cast_boundaries(bodies.a.boundary(), motion, bodies.b.boundary(), p, latest, memory);
        if (contact) bodies.rename(*contact);
        return contact;
    });
}

std::optional<FirstContact> cast(const Posed<Rounded>& a, const Vec3& motion, const Posed<Rounded>& b, double max_time,
                                 const Ask& ask) {
    return RoundedPair{a, b}.cast(motion, 0, max_time, ask);
}
std::optional<FirstContact> cast(const Posed<Rounded>& a, const Vec3& motion, const Posed<MeshShape>& b,
                                 double max_time, const Ask& ask) {
    return RoundedPair{a, b}.cast(motion, 0, max_time, ask);
}
std::optional<FirstContact> cast(const Posed<MeshShape>& a, const Vec3& motion, const Posed<Rounded>& b,
                                 double max_time, const Ask& ask) {
    return RoundedPair{a, b}.cast(motion, 0, max_time, ask);
}

std::optional<FirstContact> cast_to_distance(const Posed<MeshShape>& a, const Vec3& motion, const Posed<MeshShape>& b,
                                             double distance, double max_time, const Ask& ask) {
    return cast_to(RoundedPair{a, b}, motion, distance, max_time, ask);
}
std::optional<FirstContact> cast_to_distance(const Posed<Rounded>& a, const Vec3& motion, const Posed<Rounded>& b,
                                             double distance, double max_time, const Ask& ask) {
    return cast_to(RoundedPair{a, b}, motion, distance, max_time, ask);
}
std::optional<FirstContact> cast_to_distance(const Posed<Rounded>& a, const Vec3& motion, const Posed<MeshShape>& b,
                                             double distance, double max_time, const Ask& ask) {
    return cast_to(RoundedPair{a, b}, motion, distance, max_time, ask);
}
std::optional<FirstContact> cast_to_distance(const Posed<MeshShape>& a, const Vec3& motion, const Posed<Rounded>& b,
                                             double distance, double max_time, const Ask& ask) {
    return cast_to(RoundedPair{a, b}, motion, distance, max_time, ask);
}

}  // namespace ecods
