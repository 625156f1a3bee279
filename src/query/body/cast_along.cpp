// Casts a body along nodes by the cast along a Way; computes the time from the leg and the time in the leg.
#include "query/body/cast_along.hpp"

#include "base/double_key.hpp"
#include "base/limits.hpp"
#include "ecods/turn.hpp"
#include "query/cast/way_time.hpp"

namespace ecods {

std::optional<FirstContact> cast_along(const Posed<MeshShape>& a, std::span<const WayNode> nodes,
                                       const Posed<MeshShape>& b, double max_time, const Ask& ask) {
    const double latest = require_time(max_time);
    const std::size_t leg_count = nodes.size() - 1;
    const std::span<const WayNode> begun = nodes.first(legs_begun(latest, leg_count) + 1);
    const auto met = cast(Way<MeshShape>(*a.what, a.pose, {begun.begin(), begun.end()}), b, ask);
    if (!met) return std::nullopt;
    FirstContact contact = met->contact;
    contact.time = time_on_way(met->leg, contact.time, leg_count);
    return key_of(contact.time) <= key_of(latest) ? std::optional(contact) : std::nullopt;
}

}  // namespace ecods
