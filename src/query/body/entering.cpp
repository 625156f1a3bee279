// Computes the first time at which a body enters the interior of another one, and the last pose at which it is free
// before.
#include "query/cast/entering.hpp"

#include <cstdint>

#include "base/limits.hpp"
#include "ecods/cast.hpp"
#include "ecods/error.hpp"
#include "ecods/intersection.hpp"
#include "ecods/solid.hpp"
#include "exact/measure/round/long_rounding.hpp"
#include "exact/point/posed_point.hpp"
#include "geometry/find_invalid.hpp"
#include "query/body/posed_body.hpp"
#include "query/body/sliding_edges.hpp"
#include "query/intersection/asking.hpp"
#include "query/intersection/query_memory.hpp"

namespace ecods {
namespace {

Feature face_of(std::uint32_t triangle) noexcept {
    return {Feature::Kind::face, triangle, 0};
}

// Returns true for a relation of two bodies without common inner points of solids or of triangles.
bool is_free(Relation relation) noexcept {
    return relation == Relation::apart || relation == Relation::touching;
}

std::optional<FirstEntry> of_solids(const PosedBody& a, const Vec3& motion, const PosedBody& b, double end,
                                    QueryMemory& memory) {
    const Posed<Solid> p = a.solid(), q = b.solid();
    const Relation at_start = as_part(memory, [&] { return relation(p, q, memory); });
    if (!is_free(at_start)) return FirstEntry{0, no_feature, no_feature};
    if (is_zero(motion)) return std::nullopt;
    SlidingSolids solids(p, motion, q);
    const auto found = first_entry(solids.mesh(0), motion, solids.mesh(1), end, &solids, memory);
    if (!found) return std::nullopt;
    return FirstEntry{found->time, face_of(solids.name(0, found->triangles.a)),
                      face_of(solids.name(1, found->triangles.b))};
}

}  // namespace

std::optional<FirstEntry> entering(const Posed<MeshShape>& a, const Vec3& motion, const Posed<MeshShape>& b,
                                   double max_time, const Ask& ask) {
    const double end = require_time(max_time);
    validate_motion(motion);
    Asking asking(ask);
    QueryMemory& memory = asking.memory();
    return as_one_query(memory, [&]() -> std::optional<FirstEntry> {
        if (are_surfaces(*a.what, *b.what)) {
            if (is_zero(motion)) return std::nullopt;
            const auto found = first_entry(a, motion, b, end, nullptr, memory);
            if (!found) return std::nullopt;
            return FirstEntry{found->time, face_of(found->triangles.a), face_of(found->triangles.b)};
        }
        const PosedBody p(a), q(b);
        if (!p.has_inside() || !q.has_inside()) {
            throw NotSupported("entering: both bodies must be surfaces, or both solids with inner points");
        }
        return of_solids(p, motion, q, end, memory);
    });
}

std::optional<Pose> pose_before(const Posed<MeshShape>& a, const Vec3& motion, const Posed<MeshShape>& b, double time,
                                const Ask& ask) {
    validate_motion(motion);
    if (key_of(time) > key_of(1.0)) throw invalid_time(time);
    const double latest = require_time(time);
    Asking asking(ask);
    QueryMemory& memory = asking.memory();
    const exact::ScaledLongVector start = exact::exact_vector(a.pose.t), step = exact::exact_vector(motion);
    const auto free_at = [&](const exact::ScaledInteger& s) -> std::optional<Pose> {
        const Pose pose{a.pose.R, exact::round_point(plus(start, times(step, s)), 1.0)};
        if (!is_finite(pose) || !is_free(relation(Posed<MeshShape>(*a.what, pose), b, memory))) return std::nullopt;
        return pose;
    };
    // Tries the pose at the time of entry, then the poses at (1 - 2^-k) times that time for k from 52 down to 0.
    return as_one_query(memory, [&]() -> std::optional<Pose> {
        constexpr int most = 53;
        for (int k = most; k >= 0; --k) {
            const exact::ScaledInteger part(exact::Integer((std::int64_t{1} << k) - (k == most ? 0 : 1)), -k);
            if (auto pose = free_at(part * exact::ScaledInteger(latest))) return pose;
        }
        return std::nullopt;
    });
}

}  // namespace ecods
