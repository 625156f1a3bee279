// Implements rounded.hpp by the functions for the cores, with the exact sum of the radii as a margin.
#include "ecods/rounded.hpp"

#include <limits>
#include <optional>
#include <utility>

#include "base/double_key.hpp"
#include "base/limits.hpp"
#include "base/next.hpp"
#include "exact/simplex/common_pose.hpp"
#include "query/body/core_distance.hpp"
#include "query/body/posed_body.hpp"
#include "query/body/rounded_pair.hpp"
#include "query/body/small_pair.hpp"
#include "query/convex/convex_core.hpp"
#include "query/convex/solid_pair.hpp"
#include "query/distance/surface_distance.hpp"
#include "query/intersection/asking.hpp"
#include "query/intersection/query_memory.hpp"

namespace ecods {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double double_max = std::numeric_limits<double>::max();

// Returns bounds of max(0, D - margin) from `bounds`, the bounds of D.
DistanceBounds reduced(const DistanceBounds& bounds, const exact::ExactSum& margin) {
    const auto is_infinite = [](double x) { return key_of(x) == infinity_key; };
    DistanceBounds result = bounds;
    if (!is_infinite(bounds.lower)) result.lower = positive_part((-margin).plus(bounds.lower).lower());
    if (!is_infinite(bounds.upper)) result.upper = positive_part((-margin).plus(bounds.upper).upper());
    return result;
}

using ConvexPair = std::pair<Posed<ConvexSolid>, Posed<ConvexSolid>>;

// Returns the cores as convex solids, which may be flat, if both cores are convex; otherwise nullopt. The search for
// the distance of convex solids need not read all triangles at the least distance.
std::optional<ConvexPair> convex_pair(const RoundedPair& pair) {
    const auto is_convex = [](const Posed<MeshShape>& core) {
        return convex::is_convex_core(*core.what) && exact::is_regular(core.pose.R);
    };
    const auto& [a, b] = pair;
    if (are_surfaces(*a.core.what, *b.core.what) || !is_convex(a.core) || !is_convex(b.core)) return std::nullopt;
    return ConvexPair{convex::convex_core(a.core), convex::convex_core(b.core)};
}

// Do the same as within() and distance() of core_distance.hpp, but search convex cores as convex solids if the limit or
// the margin is positive.
bool is_within(const RoundedPair& pair, const exact::Limit& limit, const Ask& ask) {
    const auto cores = convex_pair(pair);
    if (!cores || limit.sum.sign() <= 0) return cores::within(pair.a.core, pair.b.core, limit, ask);
    Asking asking(ask);
    return as_one_query(asking.memory(), [&] {
        return convex::within(cores->first, cores->second, limit, asking.memory(), asking.witness());
    });
}
double distance_beyond(const RoundedPair& pair, const exact::ExactSum& margin, const Ask& ask) {
    const auto cores = convex_pair(pair);
    if (!cores || margin.sign() <= 0) return cores::distance(pair.a.core, pair.b.core, margin, ask);
    Asking asking(ask);
    return as_one_query(asking.memory(), [&] {
        return convex::distance_beyond(cores->first, cores->second, margin, asking.memory(), asking.witness());
    });
}

// Adds a query that was decided without a search to the counts.
void count_decided(Asking& asking) {
    QueryCounts& counts = QueryMemoryAccess::state(asking.memory()).counts;
    ++counts.queries;
    ++counts.distances.enclosures;
}

}  // namespace

// Counts the query, and sets the witness to the triangles of the closest features, as the search does.
void RoundedPair::count_found(const RoundedSegments& found, const Ask& ask) {
    Asking asking(ask);
    count_decided(asking);
    asking.witness() = {found.names().a.triangle, found.names().b.triangle};
}

// Returns the sign of the distance of the bodies minus max_distance if doubles decide it, and counts the query;
// otherwise nullopt.
std::optional<int> RoundedPair::filtered(double max_distance, const Ask& ask) const {
    const auto sign = SmallPair(*this).compare(max_distance);
    if (sign) {
        Asking asking(ask);
        count_decided(asking);
    }
    return sign;
}

bool RoundedPair::intersects(const Ask& ask) const {
    if (const auto sign = filtered(0, ask)) return *sign < 0;
    return is_within(*this, exact::Limit{radii().sum()}, ask);
}

double RoundedPair::distance(const Ask& ask) const {
    SmallPair small(*this);
    if (const auto sign = small.compare(0); sign && *sign < 0) {
        Asking asking(ask);
        count_decided(asking);
        return 0;
    }
    const auto segments = small.find_closest();
    if (const auto gap = segments ? segments->signed_distance() : std::nullopt) {
        count_found(*segments, ask);
        return positive_part(*gap);
    }
    return distance_beyond(*this, radii().sum(), ask);
}

bool RoundedPair::within(double max_distance, const Ask& ask) const {
    require_distance(max_distance);
    if (key_of(max_distance) == infinity_key) return true;
    if (const auto sign = filtered(max_distance, ask)) return *sign < 0;
    return is_within(*this, exact::Limit{radii().sum().plus(max_distance)}, ask);
}

ClosestPoints RoundedPair::closest(const Ask& ask) const {
    const auto segments = SmallPair(*this).find_closest();
    if (auto points = segments ? segments->signed_closest() : std::nullopt) {
        count_found(*segments, ask);
        points->distance = positive_part(points->distance);
        return *points;
    }
    return cores::closest(a.core, b.core, radii(), ask);
}

// Returns bounds of the distance of the rounded bodies. For convex cores, bounds cost as much as the distance. For
// other cores, bounds of the cores' distance minus the margin are returned if they are within the tolerance. Otherwise
// the distance is rounded to nearest, and one comparison says on which side of the real one it is.
DistanceBounds RoundedPair::distance_bounds(const DistanceTolerance& tolerance, const Ask& ask) const {
    surface::require_valid(tolerance);
    const exact::ExactSum margin = radii().sum();
    if (margin.sign() == 0) return ecods::distance_bounds(a.core, b.core, tolerance, ask);
    SmallPair small(*this);
    const auto segments = small.find_closest();
    if (const auto bounds = segments ? segments->distance_bounds() : std::nullopt) {
        count_found(*segments, ask);
        return *bounds;
    }
    Asking asking(ask);
    const Ask in_memory(asking.memory(), asking.witness());
    if (!convex::is_convex_core(*a.core.what) || !convex::is_convex_core(*b.core.what)) {
        DistanceTolerance of_cores = tolerance;
        if (key_of(tolerance.max_distance) != infinity_key)
            of_cores.max_distance = margin.plus(tolerance.max_distance).upper();
        const DistanceBounds rough = reduced(ecods::distance_bounds(a.core, b.core, of_cores, in_memory), margin);
        const bool is_far = key_of(rough.lower) > key_of(tolerance.max_distance);
        if (is_far || surface::is_narrow(rough, tolerance)) return rough;
    }
    const double nearest = distance(in_memory);
    if (key_of(nearest) == 0) return {0, 0};
    if (key_of(nearest) == infinity_key) return {double_max, infinity};
    const DistanceBounds beside{next_down(nearest), next_up(nearest)};
    if (surface::is_narrow(beside, tolerance)) return beside;
    const bool is_above = is_within(*this, exact::Limit{margin.plus(nearest)}, in_memory);
    return is_above ? DistanceBounds{next_down(nearest), nearest} : DistanceBounds{nearest, next_up(nearest)};
}

bool intersects(const Posed<Rounded>& a, const Posed<Rounded>& b, const Ask& ask) {
    return RoundedPair{a, b}.intersects(ask);
}
bool intersects(const Posed<Rounded>& a, const Posed<MeshShape>& b, const Ask& ask) {
    return RoundedPair{a, b}.intersects(ask);
}
bool intersects(const Posed<MeshShape>& a, const Posed<Rounded>& b, const Ask& ask) {
    return RoundedPair{a, b}.intersects(ask);
}

Relation relation(const Posed<Rounded>& a, const Posed<Rounded>& b, const Ask& ask) {
    return RoundedPair{a, b}.relation(ask);
}
Relation relation(const Posed<Rounded>& a, const Posed<MeshShape>& b, const Ask& ask) {
    return RoundedPair{a, b}.relation(ask);
}
Relation relation(const Posed<MeshShape>& a, const Posed<Rounded>& b, const Ask& ask) {
    return RoundedPair{a, b}.relation(ask);
}

double distance(const Posed<Rounded>& a, const Posed<Rounded>& b, const Ask& ask) {
    return RoundedPair{a, b}.distance(ask);
}
double distance(const Posed<Rounded>& a, const Posed<MeshShape>& b, const Ask& ask) {
    return RoundedPair{a, b}.distance(ask);
}
double distance(const Posed<MeshShape>& a, const Posed<Rounded>& b, const Ask& ask) {
    return RoundedPair{a, b}.distance(ask);
}

bool within(const Posed<Rounded>& a, const Posed<Rounded>& b, double max_distance, const Ask& ask) {
    return RoundedPair{a, b}.within(max_distance, ask);
}
bool within(const Posed<Rounded>& a, const Posed<MeshShape>& b, double max_distance, const Ask& ask) {
    return RoundedPair{a, b}.within(max_distance, ask);
}
bool within(const Posed<MeshShape>& a, const Posed<Rounded>& b, double max_distance, const Ask& ask) {
    return RoundedPair{a, b}.within(max_distance, ask);
}

ClosestPoints closest(const Posed<Rounded>& a, const Posed<Rounded>& b, const Ask& ask) {
    return RoundedPair{a, b}.closest(ask);
}
ClosestPoints closest(const Posed<Rounded>& a, const Posed<MeshShape>& b, const Ask& ask) {
    return RoundedPair{a, b}.closest(ask);
}
ClosestPoints closest(const Posed<MeshShape>& a, const Posed<Rounded>& b, const Ask& ask) {
    return RoundedPair{a, b}.closest(ask);
}

DistanceBounds distance_bounds(const Posed<Rounded>& a, const Posed<Rounded>& b, const DistanceTolerance& tolerance,
                               const Ask& ask) {
    return RoundedPair{a, b}.distance_bounds(tolerance, ask);
}
DistanceBounds distance_bounds(const Posed<Rounded>& a, const Posed<MeshShape>& b, const DistanceTolerance& tolerance,
                               const Ask& ask) {
    return RoundedPair{a, b}.distance_bounds(tolerance, ask);
}
DistanceBounds distance_bounds(const Posed<MeshShape>& a, const Posed<Rounded>& b, const DistanceTolerance& tolerance,
                               const Ask& ask) {
    return RoundedPair{a, b}.distance_bounds(tolerance, ask);
}

}  // namespace ecods
